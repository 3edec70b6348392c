/** The dialog in which a table of postures is looked at before it is taken. */

export const POSTURES = {
  title: (/** @type {string} */ name) => `Postures of ${name}`,
  read: (/** @type {number} */ rows, /** @type {string} */ units) =>
    `${rows} ${rows === 1 ? 'row' : 'rows'}; the values are shown in ${units}, the units of the document.`,
  noUnits: (/** @type {string} */ units) => `The file has no head that names joints and units; it is read as ${units}.`,
  unused: (/** @type {string} */ heads) => `Not used: ${heads}.`,
  mode: 'The list of recorded postures',
  modes: { add: 'Add to it', replace: 'Replace it' },
  line: 'Line',
  name: 'Name',
  joint: (/** @type {number} */ joint) => `J${joint}`,
  effect: 'What happens',
  fate: {
    new: 'is added',
    changed: 'gets these values',
    same: 'stays as it is',
    moves: 'the arm moves there',
    refused: 'is not taken',
  },
  preview: 'What will be read',
  refused: (/** @type {number} */ count) =>
    count === 1
      ? 'One row is not taken; the reason stands below it.'
      : `${count} rows are not taken; the reasons stand below them.`,
  goes: (/** @type {number} */ count) =>
    count === 1 ? 'One posture that is recorded now goes.' : `${count} postures that are recorded now go.`,
  apply: (/** @type {number} */ count) => (count === 1 ? 'Take one row' : `Take ${count} rows`),
  cancel: 'Cancel',
  done: (/** @type {number} */ count) => (count === 1 ? 'One posture is read.' : `${count} postures are read.`),
};
