/**
 * Registers, ports and expressions of TP instructions. Outside of parentheses an operator chain binds as in parentheses: * / before
 * + -, then comparisons, AND, OR.
 *
 * @import { TpCursor } from './cursor.js'
 * @import { TpOperand, TpOperator, TpRegister } from './tree.js'
 */
import { number } from './tree.js';

/** Names that take brackets, and are read and set. */
export const BANKS = new Set(
  `R PR SR AR P LBL DI DO RI RO GI GO AI AO F M UI UO SI SO WI WO WSI WSO TIMER TIMER_OVERFLOW UFRAME UTOOL PL VR MSG`.split(
    ' ',
  ),
);

/** Values of inputs and outputs, timers and positions, and what the arm is set to. */
const WORDS = /(ON|OFF|LPOS|JPOS|START|STOP|RESET|ENABLE|DISABLE|TRUE|FALSE|ERR_NUM|UFRAME_NUM|UTOOL_NUM)\b(?!\[)/y;

const REGISTER = /([A-Z_]+)\[/y;
const NUMBER = /\d*\.?\d+(?:[Ee][+-]?\d+)?|\d+\./y;
const STRING = /'([^']*)'/y;
const SYSTEM = /\$[A-Z0-9_]+(?:\[[^\]]*\])?(?:\.\$?[A-Z0-9_]+(?:\[[^\]]*\])?)*/iy;

const MAX_DEPTH = 60;

/** @type {readonly (readonly [RegExp, boolean])[]} by how tightly they bind, least first */
const LEVELS = [
  [/\bOR\b|\|\|/y, true],
  [/\bAND\b|&&/y, true],
  [/<>|<=|>=|=|<|>/y, true],
  [/\+(?!\s*$)|-(?!\s*$)/y, true],
  [/\*|\/|\bDIV\b|\bMOD\b/y, true],
];

/** @param {TpCursor} cursor @param {number} [level] @param {number} [depth] @returns {TpOperand} */
export function readExpression(cursor, level = 0, depth = 0) {
  if (depth > MAX_DEPTH) cursor.fail(`at most ${MAX_DEPTH} parentheses in each other`);
  if (level === LEVELS.length) return readOperand(cursor, depth);
  let left = readExpression(cursor, level + 1, depth);
  for (let match = cursor.take(LEVELS[level][0]); match; match = cursor.take(LEVELS[level][0])) {
    const right = readExpression(cursor, level + 1, depth);
    left = { kind: 'binary', operator: /** @type {TpOperator} */ (match[0]), left, right };
  }
  return left;
}

/** @param {TpCursor} cursor @param {number} [depth] @returns {TpOperand} */
export function readOperand(cursor, depth = 0) {
  if (cursor.takeSign('(')) {
    const inner = readExpression(cursor, 0, depth + 1);
    cursor.needSign(')');
    return { kind: 'group', inner };
  }
  const sign = cursor.take(/[-+!]/y);
  if (sign) {
    if (depth > MAX_DEPTH) cursor.fail(`at most ${MAX_DEPTH} signs in each other`);
    const operator = /** @type {'-' | '+' | '!'} */ (sign[0]);
    return { kind: 'unary', operator, operand: readOperand(cursor, depth + 1) };
  }
  const digits = cursor.take(NUMBER);
  if (digits) return number(Number(digits[0]));
  const string = cursor.take(STRING);
  if (string) return { kind: 'string', value: string[1] };
  const system = cursor.take(SYSTEM);
  if (system) return { kind: 'system', name: system[0] };
  if (cursor.take(/PULSE\b/y)) {
    if (!cursor.takeSign(',')) return { kind: 'pulse' };
    const seconds = readOperand(cursor, depth + 1);
    cursor.take(/\(?sec\)?/y);
    return { kind: 'pulse', seconds };
  }
  const word = cursor.take(WORDS);
  // ON+ and OFF-: the edge.
  if (word)
    return { kind: 'word', word: word[1] + (cursor.take(/[+-](?=\s*(?:$|[,)]|AND\b|OR\b|TIMEOUT))/y)?.[0] ?? '') };
  if (cursor.look(REGISTER)) return readRegister(cursor, undefined, depth);
  return cursor.fail('a register, a port or a number');
}

/**
 * `R[…]`, any of the banks, or the one that is wanted.
 * @param {TpCursor} cursor
 * @param {readonly string[]} [wanted]
 * @param {number} [depth]
 * @returns {TpRegister}
 */
export function readRegister(cursor, wanted, depth = 0) {
  const from = cursor.position();
  const match = cursor.take(REGISTER);
  const isRight = match && BANKS.has(match[1]) && (wanted?.includes(match[1]) ?? true);
  if (!isRight) {
    cursor.goTo(from);
    return cursor.fail(wanted ? wanted.map((bank) => `${bank}[…]`).join(' or ') : 'a register or a port');
  }
  if (depth > MAX_DEPTH) cursor.fail(`at most ${MAX_DEPTH} brackets in each other`);
  const group = cursor.take(/GP(\d):/y);
  const index = cursor.look(/\.\.\./y) && cursor.take(/\.\.\./y) ? UNSET : readOperand(cursor, depth + 1);
  const element = cursor.takeSign(',') ? readOperand(cursor, depth + 1) : null;
  const comment = cursor.take(/:\s*([^\]]*)/y);
  cursor.needSign(']');
  return {
    ...{ kind: 'register', bank: match[1], index },
    ...(element && { element }),
    ...(group && { group: Number(group[1]) }),
    ...(comment && { comment: comment[1].trimEnd() }),
  };
}

/** `R[...]`: the number is not taught yet. @type {TpOperand} */
const UNSET = { kind: 'word', word: '...' };
