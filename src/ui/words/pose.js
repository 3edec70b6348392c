/** Where the tool is. */

export const POSE = {
  title: 'Tool pose',
  frame: 'in world',
  convention: 'FANUC WPR',
  conventionDetail: 'Rz(R) · Ry(P) · Rx(W)',
  copy: 'Copy the pose',
  copied: 'The pose is copied.',
  copyFailed: 'The browser does not allow copying here.',
  spoken: (/** @type {string} */ numbers) => `The tool is at ${numbers}.`,
};
