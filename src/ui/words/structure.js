/** Joints, units and convention of the whole table. */

export const STRUCTURE = {
  menu: (/** @type {string} */ joint) => `${joint}: type, place, remove`,
  menuOf: (/** @type {number} */ joint, /** @type {string} */ type) => `Joint ${joint}, ${type}: change or add`,
  add: 'Add joint',
  type: {
    revolute: 'Turns (revolute)',
    prismatic: 'Slides (prismatic)',
    continuous: 'Turns without end (continuous)',
  },
  clears: 'Its limits, home and controller values are cleared.',
  clearsLimits: 'Its limits are cleared.',
  typed: {
    revolute: (/** @type {string} */ joint) => `${joint} turns now.`,
    prismatic: (/** @type {string} */ joint) => `${joint} slides now.`,
    continuous: (/** @type {string} */ joint) => `${joint} turns without end now.`,
  },
  addAfter: (/** @type {string} */ joint) => `Add a joint after ${joint}`,
  added: (/** @type {string} */ joint) => `${joint} is added. Its zeros do not move the arm yet.`,
  duplicate: (/** @type {string} */ joint) => `Duplicate ${joint}`,
  duplicated: (/** @type {string} */ joint, /** @type {string} */ copy) =>
    `${copy} is a copy of ${joint}, at its home.`,
  up: (/** @type {string} */ joint) => `Move ${joint} up`,
  down: (/** @type {string} */ joint) => `Move ${joint} down`,
  moved: (/** @type {string} */ joint, /** @type {number} */ place) => `${joint} is joint ${place} now.`,
  remove: (/** @type {string} */ joint) => `Remove ${joint}`,
  removed: (/** @type {string} */ joint) => `${joint} is removed, and its value in every recorded posture.`,
  unitsHint: 'Converts the numbers; the robot stays.',
  unit: (/** @type {string} */ name, /** @type {string} */ sign) =>
    `${name[0].toUpperCase()}${name.slice(1)} (${sign})`,
  converted: (/** @type {string} */ unit) => `The numbers are in ${unit} now; the robot is the same.`,
  convention: 'Convention:',
};
