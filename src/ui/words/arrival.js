/** What came in, by whichever way: opened, refused, or not what can be opened. */

export const ARRIVAL = {
  notOpened: (/** @type {string} */ name) => `${name} was not opened`,
  stillHere: (/** @type {string} */ robot) => `${robot} is still here, unchanged.`,
  opened: (/** @type {string} */ name) => `${name} is open.`,
  openedWith: (/** @type {string} */ name) => `${name} is open, with remarks`,
  chain: (/** @type {string} */ name, /** @type {string} */ base, /** @type {string} */ tip) =>
    `${name} is open, from ${base} to ${tip}.`,
  other: 'Other base or tip…',
  another: 'Choose another file',
  copyReport: 'Copy report',
  reportCopied: 'The report is copied.',
  tooLarge: (/** @type {string} */ size) => `The file is ${size}; a robot file is at most 1 MB.`,
  unreadable: (/** @type {string} */ reason) => `The browser could not read the file: ${reason}`,
  megabytes: (/** @type {string} */ n) => `${n} MB`,
  pasted: 'The pasted text',
  dropped: 'The dropped text',
  several: (/** @type {number} */ count) => `A set of ${count} files`,
  severalFiles: (/** @type {number} */ count) => `${count} files came at once; expected one robot file at a time.`,
  folder: 'This is a folder; expected one robot file.',
  nothing: 'Nothing that could be read came with this; expected a robot file.',
  what: 'What was dropped',
  link: 'This is the address of something, not the thing itself; expected a robot file. Download it first, then drop the file.',
  intoField: 'What was pasted is a robot file; the field is as it was.',
  openPasted: 'Open it',
  plainText: 'This is text that does not begin with "<"; expected a robot file, or the text of one.',
};

/** The page while a file is held over it. */
export const DROP = {
  here: 'Drop the file to open it',
  formats: 'A robot file (XML, URDF). Undo brings back what is open now.',
  several: 'One file at a time',
  severalDetail: 'Several files are held here; a robot is one file.',
  barred: 'Close the dialog first',
  barredDetail: 'Then drop the file again.',
};
