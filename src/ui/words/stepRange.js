/** Several steps of a program, chosen together. */

/** @typedef {(first: number, last: number) => string} OfRange */

const steps = (/** @type {number} */ first, /** @type {number} */ last) => `Steps ${first} to ${last}`;

export const STEP_RANGE = {
  several: 'Choose several steps',
  severalTitle: 'Choose several steps: press the first and the last (or Shift with ↑ and ↓)',
  severalOn: 'Press another step: all up to there are chosen.',
  card: steps,
  cardDetail: (/** @type {number} */ count) => `${count} steps`,
  together: 'chosen',
  act: {
    copy: 'Copy',
    paste: 'Paste steps',
    duplicate: 'Duplicate',
    disable: 'Pass over',
    enable: 'Carry out again',
    remove: 'Delete',
  },
  copyChosen: (/** @type {number} */ count) =>
    count === 1 ? 'Copy the chosen step' : `Copy the ${count} chosen steps`,
  actOn: (/** @type {string} */ act, /** @type {number} */ first, /** @type {number} */ last) =>
    `${act}: steps ${first} to ${last}`,
  chosen: /** @type {OfRange} */ ((first, last) => `${steps(first, last)} are chosen.`),
  moved: /** @type {OfRange} */ ((first, last) => `They are steps ${first} to ${last} now.`),
  removed: /** @type {OfRange} */ ((first, last) => `${steps(first, last)} are deleted.`),
  duplicated: /** @type {OfRange} */ ((first, last) => `The steps after them are copies of steps ${first} to ${last}.`),
  disabled: /** @type {OfRange} */ ((first, last) => `${steps(first, last)} are passed over.`),
  enabled: /** @type {OfRange} */ ((first, last) => `${steps(first, last)} are carried out again.`),
  copied: (/** @type {number} */ count) => (count === 1 ? 'The step is copied.' : `${count} steps are copied.`),
  pasted: /** @type {OfRange} */ (
    (first, last) => (first === last ? `Pasted as step ${first}.` : `Pasted as steps ${first} to ${last}.`)
  ),
  against: {
    other: 'There are no steps in the clipboard; copy some in a program first.',
    version: 'These steps were copied by another version of this page.',
    units:
      'These steps are in other units than this robot. Choose the same units here (in the bar above), and paste again.',
  },
};
