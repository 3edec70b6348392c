/** The bar at the top. */

export const BAR = {
  chooseRobot: 'Choose a robot',
  file: 'File',
  open: 'Open a robot file…',
  openDetail: 'XML or URDF; or drop it on the page',
  save: 'Save the robot as XML',
  saveDetail: 'Table, limits, recorded postures',
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
