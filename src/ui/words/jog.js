/** Joint values. */

export const JOG = {
  title: 'Jog',
  home: 'Go to home',
  zero: 'Go to zero',
  zeroShort: 'Zero',
  mode: 'What is jogged',
  joints: 'Joints',
  jointsTitle: 'Move one joint at a time',
  tool: 'Tool',
  toolTitle: 'Move the tool along and about the axes of a frame',
  buttons: 'Buttons',
  pendant: 'Pendant numbers',
  keep: 'Stop at limits',
  keepsNow: 'Joints stop at their limits.',
  keepsNot: 'Joints may go beyond their limits.',
  slider: (/** @type {number} */ joint) => `Joint ${joint}`,
  field: (/** @type {number} */ joint, /** @type {string} */ unit) => `Joint ${joint}, ${unit}`,
  keys: 'Arrow keys step; with Shift coarse, with Alt or Ctrl fine. Home goes home.',
  outside: (/** @type {string} */ joint, /** @type {string} */ limits) =>
    `${joint} stands outside its limits, ${limits}.`,
  outsideShort: (/** @type {string} */ value) => `${value}, outside`,
  stops: (/** @type {string} */ joint, /** @type {string} */ limits) => `${joint} stops: ${limits}.`,
  notZero: (/** @type {string} */ joint, /** @type {string} */ limits, /** @type {string} */ value) =>
    `${joint} cannot stand at zero (${limits}); it is at ${value}.`,
  between: (/** @type {string} */ lower, /** @type {string} */ upper) => `${lower} to ${upper}`,
  atMost: (/** @type {string} */ upper) => `at most ${upper}`,
  atLeast: (/** @type {string} */ lower) => `at least ${lower}`,
  atHome: 'The arm is at home.',
  atZero: 'All joints are at zero.',
};
