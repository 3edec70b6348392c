/** The dialog in which a pasted table is looked at before it fills the grid. */

export const PASTE = {
  title: 'Paste a table',
  text: 'The table as text',
  hint: 'From a spreadsheet, CSV, Markdown or LaTeX: one row for each joint.',
  format: {
    tabs: 'a spreadsheet',
    semicolons: 'CSV with semicolons',
    commas: 'CSV with commas',
    bars: 'Markdown',
    latex: 'LaTeX',
    blanks: 'columns with blanks between',
  },
  read: (/** @type {string} */ format, /** @type {number} */ rows, /** @type {number} */ columns) =>
    `Read as ${format}: ${rows} ${rows === 1 ? 'row' : 'rows'}, ${columns} ${columns === 1 ? 'column' : 'columns'}.`,
  order: 'The columns have no names; they are taken in the usual order. Change them where that is wrong.',
  piAsRadians: 'π is read in radians.',
  fault: {
    'too-long': 'This text is too long for a table of joints.',
    'too-many': 'This has too many rows or columns for a table of joints.',
    'no-table': 'There is no table in this yet.',
  },
  scope: 'What it fills',
  replace: 'The whole table',
  fill: (/** @type {string} */ cell) => `From ${cell} on`,
  lengths: 'Lengths in',
  angles: 'Angles in',
  convention: 'Convention',
  role: { theta: 'θ', d: 'd', a: 'a', alpha: 'α', offset: 'offset', none: 'not used' },
  column: (/** @type {number} */ column) => `Column ${column} is`,
  joint: 'Joint',
  preview: 'What the table will be',
  cell: {
    symbol: (/** @type {string} */ raw) => `“${raw}” has a symbol without a number.`,
    'two-variables': (/** @type {string} */ raw) => `“${raw}”: θ of this row is a variable already.`,
    minus: (/** @type {string} */ raw) => `“${raw}” takes the variable away; a table adds it.`,
    empty: 'is empty; a number is needed.',
  },
  at: (/** @type {number} */ joint, /** @type {string} */ field) => `J${joint}, ${field}:`,
  more: (/** @type {number} */ count) => `And ${count} more.`,
  joints: (/** @type {number} */ count) =>
    `A robot has two to six joints; this has ${count} ${count === 1 ? 'row' : 'rows'}.`,
  overflow: (/** @type {number} */ joint, /** @type {number} */ count) =>
    `From J${joint} on there is room for ${count} ${count === 1 ? 'row' : 'rows'} only.`,
  noColumns: 'Say of at least one column what it is.',
  changes: (/** @type {number} */ count) => (count === 1 ? 'One number changes.' : `${count} numbers change.`),
  count: (/** @type {number} */ from, /** @type {number} */ to) => `${from} joints become ${to}.`,
  types: (/** @type {string} */ joints) => `${joints}: another type, and with it limits and home are cleared.`,
  missing: (/** @type {string} */ names) => `No column is ${names}: those numbers stay.`,
  limitsStay: (/** @type {boolean} */ others) => `${others ? 'The other limits' : 'Limits'} and homes stay.`,
  short: (/** @type {string} */ length) => `The longest length is ${length}: look at the unit of the lengths.`,
  apply: 'Fill the table',
  cancel: 'Cancel',
  done: (/** @type {number} */ count) =>
    `The table is filled: ${count === 1 ? 'one number' : `${count} numbers`} changed.`,
};
