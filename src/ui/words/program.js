/** Recorded postures. */

export const PROGRAM = {
  title: 'Recorded postures',
  record: 'Record here',
  empty: 'Nothing recorded yet',
  emptyDetail: 'Move the arm, record where it stands, and do it again: two postures make a motion.',
  go: (/** @type {string} */ name) => `Move the arm to ${name}`,
  name: (/** @type {number} */ index) => `Name of posture ${index}`,
  remove: (/** @type {string} */ name) => `Delete ${name}`,
  went: (/** @type {string} */ name) => `The arm is at ${name}.`,
  removed: (/** @type {string} */ name) => `${name} is deleted.`,
  renamed: (/** @type {string} */ name) => `It is called ${name} now.`,
  recorded: (/** @type {string} */ name) => `Recorded as ${name}.`,
  one: 'One more posture, and controller code can be written for the motion between them.',
  saveCsv: 'Save as CSV',
  openCsv: 'Open CSV…',
  openCsvTitle: 'Joint values from a table, one posture in each row',
  toCode: 'See the controller code',
  heads: { name: 'posture', values: 'joint values' },
};
