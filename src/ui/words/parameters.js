/** What is said against the query parameters of the address. */

/** @param {readonly string[]} values */
const either = (values) =>
  values.length < 2 ? values.join('') : `${values.slice(0, -1).join(', ')} or ${values[values.length - 1]}`;

export const PARAMETER = {
  notUnderstood: (/** @type {string} */ name, /** @type {string} */ text) => `?${name}=${text} is not understood.`,
  expected: {
    one: (/** @type {readonly string[]} */ values) => `Expected ${either(values)}.`,
    some: (/** @type {readonly string[]} */ values) => `Expected some of ${values.join(', ')}, with commas between.`,
    units: () => 'Expected a unit of length (mm, cm or m), one of angle (deg or rad), or both as in mm,deg.',
    numbers: () => 'Expected a number for each joint, with commas between, as in 0,45,-90.',
  },
  nearest: (/** @type {readonly string[]} */ names) => `Did you mean ${either(names)}?`,
  seeAll: 'See all robots',
  using: (/** @type {string} */ initial) => `Using ${initial}.`,
  twice: (/** @type {string} */ name, /** @type {string} */ text) =>
    `?${name} is given twice; the first counts: ${text}.`,
  unknown: (/** @type {readonly string[]} */ names, /** @type {number} */ more) =>
    names.length === 1 && more === 0
      ? `There is no ?${names[0]} parameter.`
      : `There are no parameters ${names.map((name) => `?${name}`).join(', ')}${more > 0 ? ` and ${more} more` : ''}.`,
  units: (/** @type {string} */ reason) => `?units was left out. ${reason}`,
  count: (/** @type {number} */ given, /** @type {number} */ joints, /** @type {string} */ robot) =>
    `?q was left out: it has ${given} ${given === 1 ? 'value' : 'values'}, and ${robot} has ${joints} joints.`,
  otherRobot: '?q was left out: it was meant for another robot.',
  outside: (/** @type {string} */ joints) => `?q puts ${joints} outside its limits; the arm stands there all the same.`,
};
