/**
 * MOVE in all its forms, the statements that stop and resume motion, hands, and OPEN and CLOSE, which files share with hands.
 * KAREL of controllers since R-30iA does not move; older programs do.
 *
 * @import { Conditions, MotionAction, MoveTarget, Setting, Statement } from '../tree.js'
 * @import { Cursor } from './cursor.js'
 * @import { ReadStatement } from './conditions.js'
 */
import { readClauses, readConditions, readSettings } from './conditions.js';
import { readDesignator, readExpression, readList, readPathPart } from './expressions.js';

/** @param {Cursor} cursor @param {ReadStatement} readStatement @returns {Statement} */
export function readSettingsAndMove(cursor, readStatement) {
  const from = cursor.position();
  const settings = readSettings(cursor);
  while (cursor.takeSign(';'));
  if (!cursor.isWord('MOVE')) cursor.fail('MOVE');
  return readMove(cursor, readStatement, { from, settings });
}

/**
 * @param {Cursor} cursor
 * @param {ReadStatement} readStatement
 * @param {{ from: number, settings: Setting[] }} [before]
 * @returns {Statement}
 */
export function readMove(cursor, readStatement, before) {
  const from = before?.from ?? cursor.position();
  cursor.advance();
  const target = readTarget(cursor);
  const nowait = cursor.continues() && cursor.takeWord('NOWAIT') && /** @type {{ nowait: true }} */ ({ nowait: true });
  const settings = before && { settings: before.settings };
  if (!(cursor.continues() && cursor.takeSign(',')))
    return cursor.node(from, { kind: 'move', ...settings, target, ...nowait });

  const when = readClauses(cursor, ['UNTIL', 'ENDMOVE'], readStatement);
  /** @type {Conditions[]} */
  const until = [];
  while (cursor.takeWord('UNTIL')) {
    until.push(readConditions(cursor));
    while (cursor.takeSign(';') || cursor.takeSign(','));
  }
  if (when.length + until.length === 0) cursor.fail('WHEN or UNTIL');
  cursor.needWord('ENDMOVE');
  const handlers = { ...(when.length && { when }), ...(until.length && { until }) };
  return cursor.node(from, { kind: 'move', ...settings, target, ...nowait, ...handlers });
}

/** @param {Cursor} cursor @returns {MoveTarget} */
function readTarget(cursor) {
  const value = () => readExpression(cursor);
  const by = () => (cursor.needWord('BY'), value());
  const { upper } = cursor.peek();
  switch (upper) {
    case 'TO': {
      cursor.advance();
      const position = value();
      return { to: 'TO', position, ...(cursor.continues() && cursor.takeWord('VIA') && { via: value() }) };
    }
    case 'NEAR': {
      cursor.advance();
      const position = value();
      return { to: 'NEAR', position, by: by() };
    }
    case 'AWAY':
    case 'RELATIVE':
      cursor.advance();
      return { to: upper, by: value() };
    case 'ABOUT': {
      cursor.advance();
      const vector = value();
      return { to: 'ABOUT', vector, by: by() };
    }
    case 'AXIS': {
      cursor.advance();
      const axis = value();
      return { to: 'AXIS', axis, by: by() };
    }
    case 'ALONG':
      cursor.advance();
      return { to: 'ALONG', path: readPathPart(cursor) };
    default:
      return cursor.fail('TO, NEAR, AWAY, RELATIVE, ABOUT, AXIS or ALONG');
  }
}

/** CANCEL FILE, HOLD, RELAX HAND … @param {Cursor} cursor @returns {Statement} */
export function readMotionControl(cursor) {
  const from = cursor.position();
  const { upper } = cursor.advance();
  if (upper === 'CANCEL' && cursor.continues() && cursor.takeWord('FILE')) {
    return cursor.node(from, { kind: 'cancel-file', file: readDesignator(cursor) });
  }
  if (upper === 'RELAX') return readHand(cursor, from, 'RELAX');
  const action = /** @type {MotionAction} */ (upper);
  const groups = cursor.continues() && cursor.takeWord('GROUP') ? { groups: readGroups(cursor) } : {};
  return cursor.node(from, { kind: 'motion-control', action, ...groups });
}

/** @param {Cursor} cursor */
const readGroups = (cursor) => cursor.bracketed('[', () => readList(cursor, () => readExpression(cursor)), ']');

/** @param {Cursor} cursor @param {number} from @param {'OPEN' | 'CLOSE' | 'RELAX'} action @returns {Statement} */
function readHand(cursor, from, action) {
  cursor.needWord('HAND');
  return cursor.node(from, { kind: 'hand', action, number: readExpression(cursor) });
}

/** @param {Cursor} cursor @returns {Statement} */
export function readOpenStatement(cursor) {
  const from = cursor.position();
  cursor.advance();
  if (cursor.isWord('HAND')) return readHand(cursor, from, 'OPEN');
  cursor.needWord('FILE');
  const file = readDesignator(cursor);
  const [usage, path] = cursor.bracketed(
    '(',
    () => {
      const first = readExpression(cursor);
      cursor.needSign(',');
      return [first, readExpression(cursor)];
    },
    ')',
  );
  return cursor.node(from, { kind: 'open-file', file, usage, path });
}

/** @param {Cursor} cursor @returns {Statement} */
export function readCloseStatement(cursor) {
  const from = cursor.position();
  cursor.advance();
  if (cursor.isWord('HAND')) return readHand(cursor, from, 'CLOSE');
  cursor.needWord('FILE');
  return cursor.node(from, { kind: 'close-file', file: readDesignator(cursor) });
}
