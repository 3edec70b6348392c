/** Robot files, opened and saved. */

export const FILES = {
  notOpened: (/** @type {string} */ name) => `${name} was not opened`,
  stillHere: (/** @type {string} */ robot) => `${robot} is still here, unchanged.`,
  opened: (/** @type {string} */ name) => `${name} is open.`,
  openedWith: (/** @type {string} */ name) => `${name} is open, with remarks`,
  saved: (/** @type {string} */ name) => `Saved as ${name}.`,
  another: 'Choose another file',
  copyReport: 'Copy report',
  reportCopied: 'The report is copied.',
  tooLarge: (/** @type {string} */ size) => `The file is ${size}; a robot file is at most 1 MB.`,
  unreadable: (/** @type {string} */ reason) => `The browser could not read the file: ${reason}`,
  megabytes: (/** @type {string} */ n) => `${n} MB`,
};
