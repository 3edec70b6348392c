/** Where the tool is: what the first minute needs. The rest is in numbers.js, fetched with the menus. */

export const POSE = {
  title: 'Tool pose',
  frame: 'in world',
  convention: 'FANUC WPR',
  conventionDetail: 'Rz(R) · Ry(P) · Rx(W)',
  chooseFrames: 'Whose pose, and seen from where',
  chooseForm: 'How the orientation is written',
  tabs: 'Shown as',
  tab: { pose: 'Pose', matrix: 'Matrix' },
  tabDetail: { pose: 'Position and orientation', matrix: '4 × 4 matrix', links: 'Link transforms' },
  copy: 'Copy the pose',
  copyMore: 'Copy as…',
  copyFailed: 'The browser does not allow copying here.',
  configuration: 'FANUC and KUKA configuration',
  locked: (/** @type {string} */ first, /** @type {string} */ last, /** @type {string} */ zero) =>
    `${first} and ${last} turn about one axis here; ${zero} is 0.`,
  spoken: (/** @type {string} */ numbers) => `The tool is at ${numbers}.`,
};
