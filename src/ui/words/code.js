/** Controller code. */

export const CODE = {
  title: 'FANUC KAREL + TP',
  empty: 'No motion to write yet',
  emptyDetail: 'Controller code is written from recorded postures. Record two or more of them.',
  toProgram: 'Record postures',
  files: 'Files',
  copy: 'Copy this file',
  copied: (/** @type {string} */ name) => `${name} is copied.`,
  save: 'Save both files',
  saved: (/** @type {string} */ names) => `Saved: ${names}.`,
  text: (/** @type {string} */ name) => `Text of ${name}`,
  notes: 'Before you use it',
};
