/**
 * Operators as closures, chosen once by the types of their operands. DIV truncates; MOD takes the sign of its right operand;
 * / of two INTEGERs gives a REAL (by the manual's table, not seen on a controller). Sums and products of INTEGERs that do not fit
 * go on from the other end, since public hash functions that were run on controllers rely on it.
 *
 * @import { BinaryOperator } from '../tree.js'
 * @import { Type } from '../check/types.js'
 * @import { Evaluate } from './machine.js'
 */
import { isNumber, isPosition, isWhole } from '../check/types.js';
import { asPosition, composed, cross, dot, poseOf, transformed } from './positions.js';
import { Alarm, clipped, list, number, numbers, single, text, truth, whole } from './values.js';

/** How near positions are that >=< calls the same, mm and degrees. The controller has system variables for it: not verified. */
const NEAR = 1;

/** @param {BinaryOperator} operator @param {Evaluate} left @param {Evaluate} right @param {Type} leftType @param {Type} rightType @returns {Evaluate} */
export function compileBinary(operator, left, right, leftType, rightType) {
  if (isNumber(leftType) && isNumber(rightType))
    return ofNumbers(operator, left, right, isWhole(leftType) && isWhole(rightType));
  if (leftType.kind === 'BOOLEAN') return ofTruths(operator, left, right);
  if (leftType.kind === 'STRING') return ofTexts(operator, left, right);
  if (operator === '*' && rightType.kind === 'VECTOR')
    return (m, f) => scaled(numbers(right(m, f)), number(left(m, f)));
  if (leftType.kind === 'VECTOR') return ofVectors(operator, left, right);
  if (operator === '>=<' && leftType.kind === 'JOINTPOS' && rightType.kind === 'JOINTPOS')
    return (m, f) => areSame(numbers(left(m, f)), numbers(right(m, f)));
  if (isPosition(leftType)) return ofPositions(operator, placed(left, leftType), placed(right, rightType), rightType);
  return (m, f) => ofAnything(operator, left(m, f), right(m, f));
}

/** @param {BinaryOperator} operator @param {Evaluate} left @param {Evaluate} right @param {boolean} areWhole @returns {Evaluate} */
function ofNumbers(operator, left, right, areWhole) {
  switch (operator) {
    case '+':
      if (areWhole) return (m, f) => (number(left(m, f)) + number(right(m, f))) | 0;
      return (m, f) => single(number(left(m, f)) + number(right(m, f)));
    case '-':
      if (areWhole) return (m, f) => (number(left(m, f)) - number(right(m, f))) | 0;
      return (m, f) => single(number(left(m, f)) - number(right(m, f)));
    case '*':
      if (areWhole) return (m, f) => Math.imul(number(left(m, f)), number(right(m, f)));
      return (m, f) => single(number(left(m, f)) * number(right(m, f)));
    case '/':
      return (m, f) => single(number(left(m, f)) / nonZero(number(right(m, f))));
    case 'DIV':
      return (m, f) => whole(Math.trunc(number(left(m, f)) / nonZero(number(right(m, f)))) + 0);
    case 'MOD':
      return (m, f) => {
        const divisor = nonZero(number(right(m, f)));
        const rest = number(left(m, f)) % divisor;
        return rest !== 0 && rest < 0 !== divisor < 0 ? rest + divisor : rest + 0;
      };
    case 'AND':
      return (m, f) => number(left(m, f)) & number(right(m, f));
    case 'OR':
      return (m, f) => number(left(m, f)) | number(right(m, f));
    case '=':
      return (m, f) => number(left(m, f)) === number(right(m, f));
    case '<>':
      return (m, f) => number(left(m, f)) !== number(right(m, f));
    case '<':
      return (m, f) => number(left(m, f)) < number(right(m, f));
    case '>':
      return (m, f) => number(left(m, f)) > number(right(m, f));
    case '<=':
      return (m, f) => number(left(m, f)) <= number(right(m, f));
    default:
      return (m, f) => number(left(m, f)) >= number(right(m, f));
  }
}

/** @param {number} divisor */
function nonZero(divisor) {
  if (divisor === 0) throw new Alarm('division by zero', 'division');
  return divisor;
}

/** @param {BinaryOperator} operator @param {Evaluate} left @param {Evaluate} right @returns {Evaluate} */
function ofTruths(operator, left, right) {
  const both = (/** @type {(a: boolean, b: boolean) => boolean} */ join) =>
    /** @type {Evaluate} */ ((m, f) => join(truth(left(m, f)), truth(right(m, f))));
  if (operator === 'AND') return both((a, b) => a && b);
  if (operator === 'OR') return both((a, b) => a || b);
  return operator === '=' ? both((a, b) => a === b) : both((a, b) => a !== b);
}

/** @param {BinaryOperator} operator @param {Evaluate} left @param {Evaluate} right @returns {Evaluate} */
function ofTexts(operator, left, right) {
  if (operator === '+') return (m, f) => clipped(text(left(m, f)) + text(right(m, f)));
  return (m, f) => compared(operator, text(left(m, f)), text(right(m, f)));
}

/** @template {string | number} T @param {BinaryOperator} operator @param {T} a @param {T} b */
function compared(operator, a, b) {
  const answers = { '=': a === b, '<>': a !== b, '<': a < b, '>': a > b, '<=': a <= b, '>=': a >= b };
  return answers[/** @type {keyof typeof answers} */ (operator)];
}

const scaled = (/** @type {number[]} */ vector, /** @type {number} */ factor) =>
  vector.map((value) => single(value * factor));

/** @param {BinaryOperator} operator @param {Evaluate} left @param {Evaluate} right @returns {Evaluate} */
function ofVectors(operator, left, right) {
  const both = (/** @type {(a: number[], b: number[]) => unknown} */ join) =>
    /** @type {Evaluate} */ ((m, f) => join(numbers(left(m, f)), numbers(right(m, f))));
  switch (operator) {
    case '+':
      return both((a, b) => a.map((value, i) => single(value + b[i])));
    case '-':
      return both((a, b) => a.map((value, i) => single(value - b[i])));
    case '@':
      return both(dot);
    case '#':
      return both(cross);
    case '=':
      return both((a, b) => a.every((value, i) => value === b[i]));
    case '<>':
      return both((a, b) => !a.every((value, i) => value === b[i]));
    case '/':
      return (m, f) => {
        const divisor = nonZero(number(right(m, f)));
        return numbers(left(m, f)).map((value) => single(value / divisor));
      };
    default:
      return (m, f) => scaled(numbers(left(m, f)), number(right(m, f)));
  }
}

/** Joint values as where they take the tool. @param {Evaluate} value @param {Type} type @returns {Evaluate} */
export const placed = (value, { kind }) =>
  kind === 'JOINTPOS' ? (m, f) => asPosition(value(m, f), 'XYZWPR', m) : value;

/** @param {BinaryOperator} operator @param {Evaluate} left @param {Evaluate} right @param {Type} rightType @returns {Evaluate} */
function ofPositions(operator, left, right, rightType) {
  if (operator === '>=<') return (m, f) => areNear(numbers(left(m, f)), numbers(right(m, f)));
  if (rightType.kind === 'VECTOR') return (m, f) => transformed(numbers(left(m, f)), numbers(right(m, f)));
  return (m, f) => composed(numbers(left(m, f)), numbers(right(m, f)));
}

/** Joints of arms, one by one. @param {number[]} a @param {number[]} b */
const areSame = (a, b) => a.length === b.length && a.every((value, i) => Math.abs(value - b[i]) <= NEAR);

/** @param {number[]} a @param {number[]} b */
function areNear(a, b) {
  const [S, T] = [poseOf(a), poseOf(b)];
  const isThere = Math.hypot(S[12] - T[12], S[13] - T[13], S[14] - T[14]) <= NEAR;
  const trace = [0, 1, 2, 4, 5, 6, 8, 9, 10].reduce((sum, i) => sum + S[i] * T[i], 0);
  return isThere && trace >= 1 + 2 * Math.cos(NEAR * (Math.PI / (2 * 90)));
}

/** Operands whose types nobody knows, of system variables. @param {BinaryOperator} operator @param {unknown} a @param {unknown} b */
function ofAnything(operator, a, b) {
  const constant = (/** @type {unknown} */ value) => /** @type {Evaluate} */ (() => value);
  if (typeof a === 'number' && typeof b === 'number') {
    return ofNumbers(operator, constant(a), constant(b), Number.isInteger(a) && Number.isInteger(b))(NOTHING, NOTHING);
  }
  if (typeof a === 'string' && typeof b === 'string')
    return ofTexts(operator, constant(a), constant(b))(NOTHING, NOTHING);
  if (typeof a === 'boolean') return ofTruths(operator, constant(a), constant(b))(NOTHING, NOTHING);
  return ofPositions(operator, constant(list(a)), constant(b), {
    kind: Array.isArray(b) && b.length === 3 ? 'VECTOR' : 'POSITION',
  })(NOTHING, NOTHING);
}

/** Closures over constants look at no machine. */
const NOTHING = /** @type {never} */ (null);
