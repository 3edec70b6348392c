/**
 * An expression → a number of the document, or the reason why it is none, or the question which of two was meant. It is
 * fetched, with the parser of mathjs, when the first text that is no plain number is typed.
 *
 * The parser makes a tree of known words only (expressionTokens.js); this file walks it and knows no other kind of node, so nothing
 * that mathjs could do besides is within reach. Each part carries its units, so that 12 in + 0.4 m is right and 2 m + 90 deg is refused.
 *
 * @import { LengthUnit, Units } from '../../model/document.js'
 * @import { Node } from './expressionTree.js'
 *
 * @typedef {object} Part
 * @property {number} value   in units of the document, where it has one
 * @property {number} length  the power of a length in it; likewise the next
 * @property {number} angle
 * @property {boolean} hasPi  without a unit, and made with π
 *
 * @typedef {object} Evaluated
 * @property {number} value
 * @property {boolean} isBare     without a unit
 * @property {boolean} isUnclear  an angle in degrees that looks like one in radians
 * @property {boolean} hasBareTurns  somewhere the sine of a number without a unit was taken
 */
import { LARGEST_NUMBER } from '../../model/documentRules.js';
import { convertAngle, convertLength, fromInches } from '../../model/units.js';
import { FUNCTIONS, UNITS, readTokens } from './expressionTokens.js';
import { tidy, turnFunction } from './expressionNumbers.js';
import { parse } from './expressionTree.js';
import { EXPRESSION } from '../words/expression.js';

/** What is against an expression, in a sentence. */
class Against extends Error {}

/** @param {string} reason @returns {never} */
function refuse(reason) {
  throw new Against(reason);
}

/**
 * @param {string} typed
 * @param {'length' | 'angle'} quantity  what is wanted
 * @param {Units} units  of numbers that have none
 * @returns {{ found: Evaluated, reason: null } | { found: null, reason: string }}
 */
export function evaluate(typed, quantity, units) {
  const { tokens, reason } = readTokens(typed);
  if (reason !== null) return { found: null, reason };
  try {
    const walk = { units, hasBareTurns: false };
    const part = partOf(treeOf(tokens.map(({ text }) => text).join(' ')), walk);
    const value = tidy(part.value) + 0; // no minus zero
    if (part.length !== (quantity === 'length' ? 1 : 0) || part.angle !== (quantity === 'angle' ? 1 : 0)) {
      if (part.length !== 0 || part.angle !== 0) refuse(wrongUnit(part, quantity));
    }
    if (!(Math.abs(value) <= LARGEST_NUMBER)) refuse(EXPRESSION.tooLarge);
    const isUnclear = quantity === 'angle' && units.angle === 'deg' && part.hasPi && part.angle === 0 && value !== 0;
    return {
      found: { value, isUnclear, isBare: part.length === 0 && part.angle === 0, hasBareTurns: walk.hasBareTurns },
      reason: null,
    };
  } catch (error) {
    if (error instanceof Against) return { found: null, reason: error.message };
    throw error;
  }
}

/** @param {string} text */
function treeOf(text) {
  try {
    return parse(text);
  } catch (error) {
    if (error instanceof SyntaxError) return refuse(EXPRESSION.incomplete);
    throw error;
  }
}

/** @param {Part} part @param {'length' | 'angle'} wanted */
function wrongUnit({ length, angle }, wanted) {
  if (wanted === 'angle' && length === 1 && angle === 0) return EXPRESSION.lengthForAngle;
  if (wanted === 'length' && length === 0 && angle === 1) return EXPRESSION.angleForLength;
  return EXPRESSION.neither(wanted);
}

/** @typedef {{ units: Units, hasBareTurns: boolean }} Walk */

/** @param {Node} node @param {Walk} walk @returns {Part} */
function partOf(node, walk) {
  const args = node.args ?? [];
  switch (node.type) {
    case 'ConstantNode':
      if (typeof node.value === 'number') return bare(node.value);
      break;
    case 'SymbolNode':
      if (node.name === 'pi') return { ...bare(Math.PI), hasPi: true };
      break;
    case 'ParenthesisNode':
      return node.content ? partOf(node.content, walk) : refuse(EXPRESSION.incomplete);
    case 'OperatorNode':
      if (node.fn === 'multiply' && args[1].type === 'SymbolNode' && UNITS.includes(String(args[1].name))) {
        return inUnit(partOf(args[0], walk), String(args[1].name), walk.units);
      }
      return finite(
        operate(
          String(node.fn),
          args.map((arg) => partOf(arg, walk)),
        ),
      );
    case 'FunctionNode': {
      const name = String(/** @type {{ name?: unknown }} */ (node.fn).name);
      if (args.length === 1 && FUNCTIONS.includes(name)) return finite(apply(name, partOf(args[0], walk), walk));
      break;
    }
  }
  return refuse(EXPRESSION.incomplete);
}

/** @param {number} value @returns {Part} */
const bare = (value) => ({ value, length: 0, angle: 0, hasPi: false });

/** @param {Part} part */
function finite(part) {
  if (!Number.isFinite(part.value)) refuse(EXPRESSION.tooLarge);
  return part;
}

/** @param {Part} part @param {string} unit @param {Units} units @returns {Part} */
function inUnit({ value, length, angle }, unit, units) {
  if (length !== 0 || angle !== 0) refuse(EXPRESSION.unitTwice(unit));
  switch (unit) {
    case 'deg':
    case 'rad':
      return { value: convertAngle(value, unit, units.angle), length: 0, angle: 1, hasPi: false };
    case 'in':
      return { value: fromInches(value, units.length), length: 1, angle: 0, hasPi: false };
    default: {
      const from = /** @type {LengthUnit} */ (unit); // the others of UNITS
      return { value: convertLength(value, from, units.length), length: 1, angle: 0, hasPi: false };
    }
  }
}

/** @param {string} name @param {Part[]} parts @returns {Part} */
function operate(name, [x, y]) {
  switch (name) {
    case 'unaryMinus':
      return { ...x, value: -x.value };
    case 'unaryPlus':
      return x;
    case 'add':
      return sum(x, y);
    case 'subtract':
      return sum(x, { ...y, value: -y.value });
    case 'multiply':
      return product(x, y, 1);
    case 'divide':
      return y.value === 0 ? refuse(EXPRESSION.byZero) : product(x, y, -1, x.value / y.value);
    case 'pow':
      return power(x, y);
    default:
      return refuse(EXPRESSION.incomplete);
  }
}

/** @param {Part} x @param {Part} y @returns {Part} */
function sum(x, y) {
  if (x.length !== y.length || x.angle !== y.angle) {
    const isBare = [x, y].some(({ length, angle }) => length === 0 && angle === 0);
    refuse(isBare ? EXPRESSION.halfUnits : EXPRESSION.mixed);
  }
  return { ...x, value: x.value + y.value, hasPi: x.hasPi || y.hasPi };
}

/** @param {Part} x @param {Part} y @param {1 | -1} sign @param {number} [value] @returns {Part} */
const product = (x, y, sign, value = x.value * y.value) => ({
  value,
  length: x.length + sign * y.length,
  angle: x.angle + sign * y.angle,
  hasPi: x.hasPi || y.hasPi,
});

/** @param {Part} x @param {Part} y @returns {Part} */
function power(x, y) {
  if (y.length !== 0 || y.angle !== 0) refuse(EXPRESSION.exponent);
  const value = x.value ** y.value;
  if (x.value === 0 && y.value < 0) refuse(EXPRESSION.byZero);
  if (Number.isNaN(value)) refuse(EXPRESSION.notReal(EXPRESSION.rootOfNegative));
  return { value, length: x.length * y.value, angle: x.angle * y.value, hasPi: x.hasPi || y.hasPi };
}

/** @param {string} name @param {Part} x @param {Walk} walk @returns {Part} */
function apply(name, x, walk) {
  if (name === 'abs') return { ...x, value: Math.abs(x.value) };
  if (name === 'sqrt') {
    if (x.value < 0) refuse(EXPRESSION.notReal(EXPRESSION.rootOfNegative));
    return { ...x, value: Math.sqrt(x.value), length: x.length / 2, angle: x.angle / 2 };
  }
  if (name === 'sin' || name === 'cos' || name === 'tan') return bare(turn(name, x, walk));
  if (x.length !== 0 || x.angle !== 0) refuse(EXPRESSION.ratioNeeded(name));
  const radians = ARCS[/** @type {keyof typeof ARCS} */ (name)](x.value);
  if (Number.isNaN(radians)) refuse(EXPRESSION.notReal(`${name}(${tidy(x.value)})`));
  return { value: convertAngle(radians, 'rad', walk.units.angle), length: 0, angle: 1, hasPi: false };
}

const ARCS = { asin: Math.asin, acos: Math.acos, atan: Math.atan };

/** @param {'sin' | 'cos' | 'tan'} name @param {Part} x @param {Walk} walk */
function turn(name, { value, length, angle, hasPi }, walk) {
  const isBare = angle === 0;
  if (length !== 0 || (angle !== 0 && angle !== 1)) refuse(EXPRESSION.angleNeeded(name));
  if (isBare && hasPi && walk.units.angle === 'deg') refuse(EXPRESSION.turnUnclear(name));
  walk.hasBareTurns ||= isBare && value !== 0;
  const result = turnFunction(name, convertAngle(value, walk.units.angle, 'deg'));
  return Number.isNaN(result) ? refuse(EXPRESSION.notReal(`${name}(90°)`)) : result;
}
