/** Choosing a robot. */

export const LIBRARY = {
  title: 'Choose a robot',
  search: 'Search by name, type or source',
  searchHint: '6R, KUKA, wrist …',
  list: 'Robots',
  found: (/** @type {number} */ n) => (n === 1 ? '1 robot' : `${n} robots`),
  none: (/** @type {string} */ text) => `No robot matches “${text}”.`,
  family: {
    textbook: 'Textbook arms',
    straightLines: 'SCARA, cylinder and gantry',
    industrial: 'Industrial arms',
    light: 'Light and collaborative arms',
  },
  facts: (/** @type {string} */ types, /** @type {number} */ n, /** @type {string} */ reach) =>
    `${types} · ${n} DOF · reach up to ${reach}`,
  isOpen: 'open now',
  chosen: (/** @type {string} */ robot) => `${robot} is open.`,
  freshTitle: 'New robot',
  freshName: 'New robot',
  fresh: (/** @type {number} */ n) => `New robot with ${n} joints`,
  joints: 'joints',
  freshHint: 'Starts from a table in which every joint moves the tool; undo brings your robot back.',
};
