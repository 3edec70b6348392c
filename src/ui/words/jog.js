/** Joint values. */

export const JOG = {
  title: 'Jog',
  home: 'Go to home',
  slider: (/** @type {number} */ joint) => `Joint ${joint}`,
  field: (/** @type {number} */ joint, /** @type {string} */ unit) => `Joint ${joint}, ${unit}`,
  outside: (/** @type {string} */ joint, /** @type {string} */ limits) =>
    `${joint} stands outside its limits, ${limits}.`,
  stops: (/** @type {string} */ joint, /** @type {string} */ limits) => `${joint} stops: ${limits}.`,
  between: (/** @type {string} */ lower, /** @type {string} */ upper) => `${lower} to ${upper}`,
  atMost: (/** @type {string} */ upper) => `at most ${upper}`,
  atLeast: (/** @type {string} */ lower) => `at least ${lower}`,
  atHome: 'The arm is at home.',
};
