/**
 * The instruction of one line. What does not begin as a known one is kept as it is.
 *
 * @import { TpCursor } from './cursor.js'
 * @import { TpAction, TpCall, TpInstruction, TpOperand, TpRegister, TpRun, TpWord, TpSystem } from './tree.js'
 */
import { isMotion, readMotion } from './motion.js';
import { BANKS, readExpression, readOperand, readRegister } from './operands.js';

/** Modal values that are assigned by their name alone. */
const SETTINGS = /(UFRAME_NUM|UTOOL_NUM|OVERRIDE|JOINT_MAX_SPEED|LINEAR_MAX_SPEED)(?=\s*=)/y;
const PROGRAM = /[A-Za-z_][A-Za-z0-9_$-]*/y;
const BARE = /(ELSE|ENDIF|ENDFOR|END|ABORT|PAUSE)\s*$/y;

/** Functions that controllers may have as an option: an assignment by them is not known here. */
const FUNCTION =
  /.*\b(?:A?SIN|A?COS|A?TAN2?|SQRT?|ABS|EXP|LN|ROUND|TRUNC|MIN|MAX|STRLEN|FINDSTR|SUBSTR)\b(?=\s*[[(]|\s+S?R\[)/y;

/** @type {readonly (readonly [RegExp, (cursor: TpCursor) => TpInstruction])[]} by how they begin */
const READERS = [
  [/!/y, (cursor) => ({ kind: 'remark', text: cursor.rest() })],
  [/--/y, readOtherRemark],
  [/\/\//y, (cursor) => ({ kind: 'disabled', text: cursor.rest() })],
  [/LBL(?=\[)/y, (cursor) => ({ kind: 'label', label: labelHere(cursor, 3) })],
  [/IF\b/y, readIf],
  [/SELECT\b/y, readSelect],
  [/ELSE(?=\s*,)/y, (cursor) => (cursor.needSign(','), { kind: 'case-else', action: readAction(cursor) })],
  [/=(?!=)/y, (cursor) => ({ kind: 'case', choice: readOperand(cursor), action: readBehindComma(cursor) })],
  [/FOR\b/y, readFor],
  [/WAIT\b/y, readWait],
  [/SKIP\s+CONDITION\b/y, (cursor) => ({ kind: 'skip-condition', condition: readExpression(cursor) })],
  [/OFFSET\s+CONDITION\b/y, (cursor) => readOffsetCondition(cursor, false)],
  [/TOOL_OFFSET\s+CONDITION\b/y, (cursor) => readOffsetCondition(cursor, true)],
  [/UALM\[/y, (cursor) => ({ kind: 'alarm', number: closed(cursor) })],
  [/PAYLOAD\[/y, (cursor) => ({ kind: 'payload', number: closed(cursor) })],
  [/MESSAGE\[/y, (cursor) => ({ kind: 'message', text: cursor.need(/([^\]]*)\]/y, 'a text and "]"')[1] })],
];

/** @param {TpCursor} cursor @returns {TpInstruction} */
export function readInstruction(cursor) {
  if (cursor.isAtEnd()) return { kind: 'blank' };
  const from = cursor.position();
  if (isMotion(cursor)) return readMotion(cursor);
  for (const [pattern, read] of READERS) if (cursor.take(pattern)) return read(cursor);
  const action = readKnownAction(cursor);
  if (action) return action;
  cursor.goTo(from);
  return { kind: 'unknown', text: cursor.rest() };
}

/** @param {TpCursor} cursor @returns {TpAction | null} null where none begins here */
function readKnownAction(cursor) {
  const bare = cursor.take(BARE);
  if (bare) return { kind: /** @type {'end'} */ (bare[1].toLowerCase()) };
  if (cursor.take(/JMP\b/y)) return { kind: 'jump', label: readRegister(cursor, ['LBL']) };
  if (cursor.take(/CALL\b/y)) return readCall(cursor, 'call');
  if (cursor.take(/RUN\b/y)) return readCall(cursor, 'run');
  const target = readTarget(cursor);
  if (!target) return null;
  cursor.needSign('=');
  if (cursor.look(FUNCTION)) return null;
  return { kind: 'assign', target, value: readValue(cursor) };
}

/** What follows `=`, to the end; a unit that the value's kind has anyway is passed. @param {TpCursor} cursor @returns {TpOperand} */
function readValue(cursor) {
  const value = readExpression(cursor);
  cursor.take(/%|\(?sec\)?/y);
  return value;
}

/** @param {TpCursor} cursor @returns {TpRegister | TpWord | TpSystem | null} */
function readTarget(cursor) {
  const setting = cursor.take(SETTINGS);
  if (setting) return { kind: 'word', word: setting[1] };
  if (cursor.look(/\$/y)) return /** @type {TpSystem} */ (readOperand(cursor));
  const name = cursor.look(/([A-Z_]+)\[/y)?.[1];
  // Another bank than those known, or a bank with something else than "=" behind it, is an instruction that is not known.
  return name !== undefined && BANKS.has(name) && name !== 'LBL' && name !== 'P' ? readRegister(cursor) : null;
}

/** @param {TpCursor} cursor @param {'call' | 'run'} kind @returns {TpCall | TpRun} */
function readCall(cursor, kind) {
  const program = cursor.look(/SR\[/y)
    ? readRegister(cursor, ['SR'])
    : cursor.need(PROGRAM, 'the name of a program')[0];
  if (!cursor.takeSign('(')) return { kind, program, args: [] };
  /** @type {TpOperand[]} */
  const args = [];
  while (!cursor.takeSign(')')) {
    if (args.length) cursor.needSign(',');
    args.push(readExpression(cursor));
  }
  return {
    kind,
    program,
    args,
    ...(args.length === 0 && /** @type {{ parentheses: true }} */ ({ parentheses: true })),
  };
}

/** @param {TpCursor} cursor @returns {TpAction} */
const readAction = (cursor) => readKnownAction(cursor) ?? cursor.fail('JMP, CALL or an assignment');

/** @param {TpCursor} cursor */
function readBehindComma(cursor) {
  cursor.needSign(',');
  return readAction(cursor);
}

/** @param {TpCursor} cursor @param {number} length  of the word before the bracket */
function labelHere(cursor, length) {
  cursor.goTo(cursor.position() - length);
  return readRegister(cursor, ['LBL']);
}

/** @param {TpCursor} cursor */
function closed(cursor) {
  const value = readOperand(cursor);
  cursor.take(/:[^\]]*/y);
  cursor.needSign(']');
  return value;
}

/** `--eg:text` @param {TpCursor} cursor @returns {TpInstruction} */
function readOtherRemark(cursor) {
  const language = cursor.take(/([a-z]{2}):/y);
  return { kind: 'remark', text: cursor.rest(), language: language?.[1] ?? '' };
}

/** @param {TpCursor} cursor @returns {TpInstruction} */
function readIf(cursor) {
  const condition = readExpression(cursor);
  if (cursor.take(/,?\s*THEN\b/y)) return { kind: 'if-then', condition };
  return { kind: 'if', condition, action: readBehindComma(cursor) };
}

/** @param {TpCursor} cursor @returns {TpInstruction} */
function readSelect(cursor) {
  const value = readOperand(cursor);
  cursor.needSign('=');
  return { kind: 'select', value, choice: readOperand(cursor), action: readBehindComma(cursor) };
}

/** @param {TpCursor} cursor @returns {TpInstruction} */
function readFor(cursor) {
  const variable = readRegister(cursor, ['R']);
  cursor.needSign('=');
  const from = readOperand(cursor);
  const down = cursor.need(/TO\b|DOWNTO\b/y, 'TO or DOWNTO')[0] === 'DOWNTO';
  return {
    kind: 'for',
    variable,
    from,
    to: readOperand(cursor),
    ...(down && /** @type {{ down: true }} */ ({ down })),
  };
}

/** @param {TpCursor} cursor @returns {TpInstruction} */
function readWait(cursor) {
  const from = cursor.position();
  // WAIT 1.00(sec) or WAIT R[1]: a time; everything else is compared with something.
  const seconds = cursor.look(/[\dR.]/y) && readOperand(cursor);
  if (seconds && (cursor.take(/\(sec\)/y) || cursor.isAtEnd())) return { kind: 'wait', seconds };
  cursor.goTo(from);
  const condition = readExpression(cursor);
  if (!cursor.takeSign(',') && !cursor.look(/TIMEOUT/y)) return { kind: 'wait-for', condition };
  cursor.need(/TIMEOUT\b/y, 'TIMEOUT');
  cursor.needSign(',');
  return { kind: 'wait-for', condition, timeout: readRegister(cursor, ['LBL']) };
}

/** @param {TpCursor} cursor @param {boolean} isTool @returns {TpInstruction} */
function readOffsetCondition(cursor, isTool) {
  const found = readRegister(cursor, ['PR', 'VR']);
  // An offset may be seen from a frame: kept by being unknown.
  return { kind: 'offset-condition', isTool, register: found };
}
