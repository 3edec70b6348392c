/** The bar at the top. */

export const BAR = {
  chooseRobot: 'Choose a robot',
  file: 'File',
  open: 'Open a robot file…',
  openDetail: 'XML, URDF, SDFormat, rlkin; or drop it here',
  save: 'Save the robot as XML',
  saveDetail: 'Table, frames, targets, postures: everything',
  saveAs: 'Save as…',
  saveAsDetail: 'URDF and others, postures, a picture',
  share: 'Share',
  shareItem: 'Share a link…',
  shareDetail: 'The whole model in the address',
  help: 'Help: keys, conventions, about',
  undo: 'Undo',
  redo: 'Redo',
  theme: 'Colours: light or dark',
  themeNow: { light: 'Light colours.', dark: 'Dark colours.' },
  unitsOf: (/** @type {string} */ length, /** @type {string} */ angle) => `${length} · ${angle}`,
  unitsLabel: 'Units of the document',
};
