/**
 * Statements: which reader is whose, assignments, and those that hold other statements. Each reader begins at its first word and ends behind its last.
 *
 * @import { Body, Case, Comment, Designator, Expression, Statement } from '../tree.js'
 * @import { Cursor } from './cursor.js'
 */
import { expectWord, readBody, recovered, withoutTrailing } from './blocks.js';
import { readHandler } from './conditions.js';
import { readDirective } from './directives.js';
import { readArguments, readDesignator, readExpression, readList, readReference } from './expressions.js';
import { readCloseStatement, readMove, readMotionControl, readOpenStatement, readSettingsAndMove } from './motion.js';
import {
  readGoto,
  readReturn,
  readHalt,
  readDelay,
  readWait,
  readPulse,
  readTransfer,
  readHandlerControl,
  readSignal,
  readTimer,
  readAction,
} from './simpleStatements.js';

/** @type {Expression} */
const MISSING = { kind: 'integer', value: 0 };

/** @param {Cursor} cursor @param {readonly string[]} enders @returns {Statement[]} */
export const readStatements = (cursor, enders) => cursor.deeper(() => readBody(cursor, enders, readStatement));

/** @type {Readonly<Record<string, (cursor: Cursor) => Statement>>} */
const READERS = {
  IF: readIf,
  SELECT: readSelect,
  FOR: readFor,
  WHILE: readWhile,
  REPEAT: readRepeat,
  GOTO: readGoto,
  GO: readGoto,
  RETURN: readReturn,
  ABORT: readHalt,
  PAUSE: readHalt,
  DELAY: readDelay,
  WAIT: readWait,
  PULSE: readPulse,
  OPEN: readOpenStatement,
  CLOSE: readCloseStatement,
  WRITE: readTransfer,
  READ: readTransfer,
  USING: readUsing,
  CONDITION: (cursor) => readHandler(cursor, readStatement),
  ENABLE: readHandlerControl,
  DISABLE: readHandlerControl,
  PURGE: readHandlerControl,
  SIGNAL: readSignal,
  CONNECT: readTimer,
  DISCONNECT: readTimer,
  MOVE: (cursor) => readMove(cursor, readStatement),
  WITH: (cursor) => readSettingsAndMove(cursor, readStatement),
  CANCEL: readMotionControl,
  STOP: readMotionControl,
  RESUME: readMotionControl,
  HOLD: readMotionControl,
  UNHOLD: readMotionControl,
  ATTACH: readMotionControl,
  RELEASE: readMotionControl,
  RELAX: readMotionControl,
  NOABORT: readAction,
  NOPAUSE: readAction,
  NOMESSAGE: readAction,
  UNPAUSE: readAction,
  CONTINUE: readAction,
  RESTORE: readAction,
};

/** @param {Cursor} cursor @returns {Statement | null} */
export function readStatement(cursor) {
  const token = cursor.peek();
  if (token.type === 'directive') return readDirective(cursor);
  if (token.type === 'system') return readAssignment(cursor);
  if (token.type !== 'word') return cursor.fail('a statement');
  // A port or a variable may carry the name of a statement's word; assigning to it tells.
  if (Object.hasOwn(READERS, token.upper) && !cursor.isSign('=', 1))
    return cursor.deeper(() => READERS[token.upper](cursor));
  const from = cursor.position();
  if (cursor.isSign('::', 1)) {
    const name = cursor.needName('a label').text;
    cursor.advance();
    const label = cursor.node(from, { kind: /** @type {const} */ ('label'), name });
    cursor.afterLabel();
    return label;
  }
  const reference = readReference(cursor);
  if (reference.kind === 'call' && !cursor.isSign('=')) return reference;
  if (cursor.isSign('=') && cursor.continues()) {
    if (reference.kind === 'call')
      cursor.fail('a variable before "="; parentheses are for arguments, brackets for indices');
    return finishAssignment(cursor, from, /** @type {Designator} */ (reference));
  }
  if (reference.kind === 'name')
    return cursor.node(from, { kind: /** @type {const} */ ('call'), name: reference.name, args: [] });
  return cursor.fail('"="');
}

/** @param {Cursor} cursor @returns {Statement} */
function readAssignment(cursor) {
  const from = cursor.position();
  const target = readDesignator(cursor);
  return finishAssignment(cursor, from, target);
}

/** @param {Cursor} cursor @param {number} from @param {Designator} target @returns {Statement} */
function finishAssignment(cursor, from, target) {
  cursor.needSign('=');
  return cursor.node(from, { kind: 'assign', target, value: readExpression(cursor) });
}

/** @param {Cursor} cursor @param {readonly string[]} before */
const readHeader = (cursor, before) => recovered(cursor, () => readExpression(cursor), before, MISSING);

/** @param {Cursor} cursor @returns {Statement} */
function readIf(cursor) {
  const from = cursor.position();
  cursor.advance();
  const condition = readHeader(cursor, ['THEN']);
  expectWord(cursor, 'THEN');
  const then = readStatements(cursor, ['ELSE', 'ENDIF']);
  const otherwise = cursor.takeWord('ELSE') ? { else: readStatements(cursor, ['ENDIF']) } : {};
  cursor.needWord('ENDIF');
  return cursor.node(from, { kind: 'if', condition, then, ...otherwise });
}

/** @param {Cursor} cursor @returns {Statement} */
function readSelect(cursor) {
  const from = cursor.position();
  cursor.advance();
  const value = readHeader(cursor, ['OF']);
  expectWord(cursor, 'OF');
  /** @type {Comment[]} */
  const comments = [];
  /** @type {Case[]} */
  const cases = [];
  /** @type {{ else?: Body }} */
  let otherwise = {};
  while (true) {
    comments.push(...cursor.commentsHere());
    if (cursor.takeSign(';')) continue;
    const start = cursor.position();
    if (cursor.takeWord('CASE')) {
      const values = recovered(cursor, () => readArguments(cursor), [], [MISSING]);
      if (!cursor.takeSign(':')) recovered(cursor, () => void cursor.needSign(':'), [], undefined);
      const body = readStatements(cursor, ['CASE', 'ELSE', 'ENDSELECT']);
      cases.push(cursor.node(start, { values, body: [...comments.splice(0).map(withoutTrailing), ...body] }));
    } else if (cursor.takeWord('ELSE')) {
      cursor.takeSign(':');
      otherwise = { else: readStatements(cursor, ['ENDSELECT']) };
    } else break;
  }
  cursor.needWord('ENDSELECT');
  return cursor.node(from, { kind: 'select', value, cases, ...otherwise });
}

/** @param {Cursor} cursor @returns {Statement} */
function readFor(cursor) {
  const start = cursor.position();
  cursor.advance();
  const variable = recovered(cursor, () => readDesignator(cursor), ['TO', 'DOWNTO', 'DO'], { kind: 'name', name: 'i' });
  const from = recovered(cursor, () => (cursor.needSign('='), readExpression(cursor)), ['TO', 'DOWNTO', 'DO'], MISSING);
  const down = cursor.isWord('DOWNTO') && /** @type {{ down: true }} */ ({ down: true });
  if (!cursor.takeWord('DOWNTO') && !cursor.takeWord('TO'))
    recovered(cursor, () => void cursor.fail('TO or DOWNTO'), ['DO'], undefined);
  const to = readHeader(cursor, ['DO']);
  expectWord(cursor, 'DO');
  const body = readStatements(cursor, ['ENDFOR']);
  cursor.needWord('ENDFOR');
  return cursor.node(start, { kind: 'for', variable, from, ...down, to, body });
}

/** @param {Cursor} cursor @returns {Statement} */
function readWhile(cursor) {
  const from = cursor.position();
  cursor.advance();
  const condition = readHeader(cursor, ['DO']);
  expectWord(cursor, 'DO');
  const body = readStatements(cursor, ['ENDWHILE']);
  cursor.needWord('ENDWHILE');
  return cursor.node(from, { kind: 'while', condition, body });
}

/** @param {Cursor} cursor @returns {Statement} */
function readRepeat(cursor) {
  const from = cursor.position();
  cursor.advance();
  const body = readStatements(cursor, ['UNTIL']);
  cursor.needWord('UNTIL');
  return cursor.node(from, { kind: 'repeat', body, until: readExpression(cursor) });
}

/** @param {Cursor} cursor @returns {Statement} */
function readUsing(cursor) {
  const from = cursor.position();
  cursor.advance();
  const variables = recovered(cursor, () => readList(cursor, () => readDesignator(cursor)), ['DO'], []);
  expectWord(cursor, 'DO');
  const body = readStatements(cursor, ['ENDUSING']);
  cursor.needWord('ENDUSING');
  return cursor.node(from, { kind: 'using', variables, body });
}
