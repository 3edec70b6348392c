/**
 * What type an operator gives for operands of two types, or null where they do not go together.
 *
 * @import { BinaryOperator } from '../tree.js'
 * @import { Type } from './types.js'
 */
import * as types from './types.js';

/** @param {BinaryOperator} operator @param {Type} left @param {Type} right @returns {Type | null} */
export function binaryType(operator, left, right) {
  if (types.isUnknown(left) || types.isUnknown(right)) return RELATIONS.has(operator) ? types.BOOLEAN : types.UNKNOWN;
  const whole = types.isWhole(left) && types.isWhole(right);
  const numbers = types.isNumber(left) && types.isNumber(right);
  const vectors = left.kind === 'VECTOR' && right.kind === 'VECTOR';
  const same = left.kind === right.kind ? left.kind : null;
  switch (operator) {
    case '+':
    case '-':
      if (operator === '+' && same === 'STRING') return types.STRING;
      if (vectors) return types.VECTOR;
      return whole ? types.INTEGER : numbers ? types.REAL : null;
    case '*':
    case '/':
      if (left.kind === 'VECTOR' && types.isNumber(right)) return types.VECTOR;
      if (operator === '*' && right.kind === 'VECTOR' && types.isNumber(left)) return types.VECTOR;
      // Two INTEGERs divided by / give a REAL: by the manual's table, not seen on a controller.
      return whole && operator === '*' ? types.INTEGER : numbers ? types.REAL : null;
    case 'DIV':
    case 'MOD':
      return whole ? types.INTEGER : null;
    case 'AND':
    case 'OR':
      return same === 'BOOLEAN' ? types.BOOLEAN : whole ? types.INTEGER : null;
    case ':':
      if (types.isPosition(left) && right.kind === 'VECTOR') return types.VECTOR;
      return types.isPosition(left) && types.isPosition(right) ? types.POSITION : null;
    case '@':
      return vectors ? types.REAL : null;
    case '#':
      return vectors ? types.VECTOR : null;
    case '>=<':
      return types.isPosition(left) && types.isPosition(right) ? types.BOOLEAN : null;
    case '=':
    case '<>':
      return numbers || vectors || same === 'STRING' || same === 'BOOLEAN' || same === 'CONFIG' ? types.BOOLEAN : null;
    default:
      return numbers || same === 'STRING' ? types.BOOLEAN : null;
  }
}

const RELATIONS = new Set(['=', '<>', '<', '>', '<=', '>=', '>=<']);
