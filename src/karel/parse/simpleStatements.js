/**
 * Statements that hold no others. Each reader begins at its first word and ends behind its last.
 *
 * @import { Expression, Item, Statement } from '../tree.js'
 * @import { Cursor } from './cursor.js'
 */
import { readConditions } from './conditions.js';
import { readDesignator, readExpression, readList } from './expressions.js';

/** @param {Cursor} cursor @returns {Statement} */
export function readGoto(cursor) {
  const from = cursor.position();
  if (cursor.advance().upper === 'GO') cursor.needWord('TO');
  return cursor.node(from, { kind: 'goto', label: cursor.needName('a label').text });
}

/** @param {Cursor} cursor @returns {Statement} */
export function readReturn(cursor) {
  const from = cursor.position();
  cursor.advance();
  if (!cursor.isSign('(') || !cursor.continues()) return cursor.node(from, { kind: 'return' });
  const value = cursor.bracketed('(', () => readExpression(cursor), ')');
  return cursor.node(from, { kind: 'return', value });
}

/** @param {Cursor} cursor @returns {Statement} */
export function readHalt(cursor) {
  const from = cursor.position();
  const kind = cursor.advance().upper === 'ABORT' ? 'abort' : 'pause';
  const task = cursor.continues() && cursor.takeWord('PROGRAM') ? { task: readBracketedNumber(cursor) } : {};
  return cursor.node(from, { kind: /** @type {'abort' | 'pause'} */ (kind), ...task });
}

/** `[n]` @param {Cursor} cursor */
const readBracketedNumber = (cursor) => cursor.bracketed('[', () => readExpression(cursor), ']');

/** @param {Cursor} cursor @returns {Statement} */
export function readDelay(cursor) {
  const from = cursor.position();
  cursor.advance();
  return cursor.node(from, { kind: 'delay', milliseconds: readExpression(cursor) });
}

/** @param {Cursor} cursor @returns {Statement} */
export function readWait(cursor) {
  const from = cursor.position();
  cursor.advance();
  cursor.needWord('FOR');
  return cursor.node(from, { kind: 'wait', conditions: readConditions(cursor) });
}

/** @param {Cursor} cursor @returns {Statement} */
export function readPulse(cursor) {
  const from = cursor.position();
  cursor.advance();
  const port = readDesignator(cursor);
  cursor.needWord('FOR');
  const milliseconds = readExpression(cursor);
  const nowait = cursor.continues() && cursor.takeWord('NOWAIT') && /** @type {{ nowait: true }} */ ({ nowait: true });
  return cursor.node(from, { kind: 'pulse', port, milliseconds, ...nowait });
}

/** @param {Cursor} cursor @returns {Statement} */
export function readTransfer(cursor) {
  const from = cursor.position();
  const kind = cursor.advance().upper === 'WRITE' ? 'write' : 'read';
  const device = cursor.isSign('(') ? null : readDesignator(cursor);
  const file = device && { file: device.kind === 'name' ? device.name : device };
  const items = cursor.bracketed('(', () => (cursor.isSign(')') ? [] : readList(cursor, () => readItem(cursor))), ')');
  if (items.length === 0) cursor.fail(`something to ${kind.toUpperCase()}`);
  return cursor.node(from, { kind: /** @type {'write' | 'read'} */ (kind), ...file, items });
}

/** @param {Cursor} cursor @returns {Item} */
function readItem(cursor) {
  const from = cursor.position();
  if (cursor.takeWord('CR')) return cursor.node(from, { kind: 'new-line' });
  const value = readExpression(cursor);
  /** @type {Expression[]} */
  const formats = [];
  while (formats.length < 2 && cursor.takeSign('::')) formats.push(readExpression(cursor));
  return formats.length ? cursor.node(from, { kind: 'format', value, formats }) : value;
}

/** @param {Cursor} cursor @returns {Statement} */
export function readHandlerControl(cursor) {
  const from = cursor.position();
  const action = /** @type {'ENABLE' | 'DISABLE' | 'PURGE'} */ (cursor.advance().upper);
  cursor.needWord('CONDITION');
  return cursor.node(from, { kind: 'handler-control', action, number: readBracketedNumber(cursor) });
}

/** @param {Cursor} cursor @returns {Statement} */
export function readSignal(cursor) {
  const from = cursor.position();
  cursor.advance();
  const what = cursor.peek().upper;
  if (what !== 'EVENT' && what !== 'SEMAPHORE') return cursor.fail('EVENT or SEMAPHORE');
  cursor.advance();
  return cursor.node(from, { kind: 'signal', what, number: readBracketedNumber(cursor) });
}

/** @param {Cursor} cursor @returns {Statement} */
export function readTimer(cursor) {
  const from = cursor.position();
  const action = /** @type {'CONNECT' | 'DISCONNECT'} */ (cursor.advance().upper);
  cursor.needWord('TIMER');
  if (action === 'CONNECT') cursor.needWord('TO');
  return cursor.node(from, { kind: 'timer', action, variable: readDesignator(cursor) });
}

/** @param {Cursor} cursor @returns {Statement} */
export function readAction(cursor) {
  const from = cursor.position();
  const action = /** @type {'NOABORT'} */ (cursor.advance().upper);
  return cursor.node(from, { kind: 'action', action });
}
