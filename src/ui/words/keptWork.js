/** Work of an earlier visit. */

export const KEPT_WORK = {
  offer: (/** @type {string} */ when, /** @type {string} */ robot, /** @type {number} */ more) =>
    `Your work of ${when} on “${robot}” is still here${more === 0 ? '' : ` (1 of ${more + 1})`}.`,
  someTime: 'an earlier visit',
  restore: 'Restore',
  discard: 'Discard',
  later: 'Not now: it stays here for the next visit',
  restored: (/** @type {string} */ robot) => `${robot} is restored. Undo brings back what was open.`,
  discarded: (/** @type {string} */ robot) => `${robot} is discarded.`,
  damaged: 'Work of an earlier visit is damaged and cannot be opened here. What is left of it can be saved as a file.',
  newer: 'Work of an earlier visit was kept by a newer Denavit, which this one cannot read. It can be saved as a file.',
  notKept: 'This browser keeps no work for this page (storage is full or off): it is lost when the tab closes.',
  saveFile: 'Save as a file',
  spoiltFile: 'kept-work.xml',
};
