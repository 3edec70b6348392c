/** What is said of an expression that a number cannot be made of, or of one that can be meant in two ways. */

const KNOWN =
  'numbers, + − * / ^, brackets, pi, sqrt, sin, cos, tan, asin, acos, atan, abs and mm, cm, m, in, deg, rad';

/** @param {string} text */
const quoted = (text) => `“${text}”`;

export const EXPRESSION = {
  tooLong: (/** @type {number} */ most) => `This is longer than ${most} characters.`,
  tooDeep: 'The brackets are nested too deep.',
  comma: (/** @type {string} */ mended) => `Decimals are written with a point: ${mended}.`,
  commas: 'A comma means nothing here: decimals are written with a point, and thousands are not set apart.',
  unknown: (/** @type {string} */ name) => `${quoted(name)} is not known here. A field takes ${KNOWN}.`,
  root: 'After √ comes a number, π or a bracket: √2, √(2 + 1).',
  brackets: 'A bracket is missing or left over.',
  twoUnits: (/** @type {string} */ one, /** @type {string} */ other) =>
    `${quoted(`${one} ${other}`)} are two units; a number has one.`,
  noSign: (/** @type {string} */ one, /** @type {string} */ other) =>
    `Between ${quoted(one)} and ${quoted(other)} a sign is missing.`,
  twoWays: (/** @type {string} */ one, /** @type {string} */ other) =>
    `${quoted(`/ ${one} ${other}`)} can be read in two ways; write * or brackets.`,
  functionBrackets: (/** @type {string} */ name) => `${quoted(name)} needs brackets: ${name}(…).`,
  loneUnit: (/** @type {string} */ unit) => `${quoted(unit)} stands behind a number: 2 ${unit}.`,
  unitPower: (/** @type {string} */ unit) => `A power of ${quoted(unit)} is neither a length nor an angle.`,
  incomplete: 'Something is missing here: a number, or what comes after a sign.',
  notReal: (/** @type {string} */ part) => `${part} is no real number.`,
  byZero: 'This divides by zero.',
  tooLarge: 'The number is too large; at most 1e9.',
  rootOfNegative: 'A root of a negative number',
  unitTwice: (/** @type {string} */ unit) =>
    `${quoted(unit)} belongs to the whole product before it, which has a unit already.`,
  mixed: 'Only lengths and lengths, angles and angles, or numbers without a unit can be added.',
  halfUnits: 'One part has a unit and the other has none; give both one.',
  exponent: 'An exponent has no unit.',
  angleNeeded: (/** @type {string} */ name) => `${name} is taken of an angle, not of a length.`,
  ratioNeeded: (/** @type {string} */ name) => `${name} is taken of a number without a unit.`,
  turnUnclear: (/** @type {string} */ name) =>
    `Degrees or radians? Write ${name}(… deg) or ${name}(… rad): the document’s angles are in degrees.`,
  lengthForAngle: 'This is a length; an angle is needed, in deg or rad.',
  angleForLength: 'This is an angle; a length is needed, in mm, cm, m or in.',
  neither: (/** @type {'length' | 'angle'} */ wanted) =>
    `The units of this make no ${wanted}; ${wanted === 'length' ? 'a length is in mm, cm, m or in' : 'an angle is in deg or rad'}.`,
  bareTurns: {
    deg: 'Angles without a unit are in degrees here.',
    rad: 'Angles without a unit are in radians here.',
  },

  ask: (/** @type {string} */ typed) => `${typed} among degrees: which is meant?`,
  radians: (/** @type {string} */ typed, /** @type {string} */ value) => `${typed} rad = ${value}`,
  notANumber: (/** @type {string} */ text) => `${quoted(text)} is not a number`,
  confused: (/** @type {string} */ letter, /** @type {string} */ digit) =>
    `Its letter ${letter} may be meant as ${digit}.`,
  use: (/** @type {string} */ text) => `Use ${text}`,
};
