/**
 * Conditions, which wait and handlers watch, and condition handlers. AND and OR stand between the terms of a condition and
 * are never mixed; a term is a comparison, a port, an edge of a port, or something that happens.
 *
 * @import { Body, Clause, Conditions, Expression, Setting, Statement, Term } from '../tree.js'
 * @import { Cursor } from './cursor.js'
 */
import { isPort, OCCURRENCES } from '../ports.js';
import { expectWord, readBody } from './blocks.js';
import { readDesignator, readExpression, readList } from './expressions.js';

/** @typedef {(cursor: Cursor) => Statement | null} ReadStatement */

/** @param {Cursor} cursor @returns {Conditions} */
export function readConditions(cursor) {
  const terms = [readTerm(cursor)];
  /** @type {'AND' | 'OR' | undefined} */
  let operator;
  while (cursor.isWord('AND') || cursor.isWord('OR')) {
    const token = cursor.advance();
    const next = /** @type {'AND' | 'OR'} */ (token.upper);
    if (operator && operator !== next) {
      const message = `Expected ${operator} between all terms of a condition, got ${next}: AND and OR cannot be mixed.`;
      cursor.report('error', 'mixed-conditions', message, token.start, token.end);
    }
    operator ??= next;
    terms.push(readTerm(cursor));
  }
  return { ...(operator && { operator }), terms };
}

/** @param {Cursor} cursor @returns {Term} */
function readTerm(cursor) {
  const from = cursor.position();
  const token = cursor.peek();
  if (token.type === 'word' && Object.hasOwn(OCCURRENCES, token.upper)) {
    const bracket = OCCURRENCES[token.upper] && cursor.isSign('[', 1);
    if (bracket || !cursor.isSign('=', 1)) {
      cursor.advance();
      if (!bracket || cursor.peek().fresh) return cursor.node(from, { kind: 'occurrence', name: token.upper });
      const argument = cursor.bracketed('[', () => (cursor.takeSign('*') ? '*' : readExpression(cursor)), ']');
      return cursor.node(from, {
        kind: 'occurrence',
        name: token.upper,
        argument: /** @type {'*' | Expression} */ (argument),
      });
    }
  }
  /** `DIN[1]+` is an edge if nothing follows that could be added. */
  const isEdge = () => {
    if (!cursor.isSign('+') && !cursor.isSign('-')) return false;
    const next = cursor.peek(1);
    return (
      next.fresh ||
      next.type === 'end' ||
      (next.type === 'sign' && next.upper !== '(') ||
      /^(AND|OR|DO|UNTIL|ENDMOVE|THEN)$/.test(next.upper)
    );
  };
  const expression = readExpression(cursor, { withoutLogic: true, stops: isEdge });
  if (isEdge() && cursor.continues()) {
    if (expression.kind !== 'index' || !isPort(expression)) return cursor.fail('a port before + or -', cursor.peek());
    const rising = cursor.advance().upper === '+';
    return cursor.node(from, { kind: 'edge', port: expression, rising });
  }
  return expression;
}

/** `WITH $SCAN_TIME = 30, …` @param {Cursor} cursor @returns {Setting[]} */
export function readSettings(cursor) {
  cursor.needWord('WITH');
  return readList(cursor, () => {
    const variable = readDesignator(cursor);
    cursor.needSign('=');
    return { variable, value: readExpression(cursor) };
  });
}

/** `WHEN … DO …`, again and again. @param {Cursor} cursor @param {readonly string[]} enders @param {ReadStatement} readStatement @returns {Clause[]} */
export function readClauses(cursor, enders, readStatement) {
  /** @type {Clause[]} */
  const clauses = [];
  while (cursor.isWord('WHEN')) {
    const from = cursor.position();
    cursor.advance();
    const conditions = readConditions(cursor);
    expectWord(cursor, 'DO');
    clauses.push(cursor.node(from, { conditions, actions: readActions(cursor, enders, readStatement) }));
  }
  return clauses;
}

/** Actions may be listed with commas. @param {Cursor} cursor @param {readonly string[]} enders @param {ReadStatement} readStatement @returns {Body} */
function readActions(cursor, enders, readStatement) {
  const ends = ['WHEN', ...enders];
  /** @type {Statement[]} */
  const actions = [];
  do actions.push(...readBody(cursor, ends, readAction, () => cursor.isSign(',')));
  while (cursor.takeSign(','));
  return actions;

  /** @param {Cursor} inner */
  function readAction(inner) {
    const statement = readStatement(inner);
    if (inner.isSign(',')) inner.afterLabel();
    return statement;
  }
}

/** `CONDITION[n]: … ENDCONDITION` @param {Cursor} cursor @param {ReadStatement} readStatement @returns {Statement} */
export function readHandler(cursor, readStatement) {
  const from = cursor.position();
  cursor.advance();
  const number = cursor.bracketed('[', () => readExpression(cursor), ']');
  cursor.takeSign(':');
  while (cursor.takeSign(';'));
  const settings = cursor.isWord('WITH') ? { settings: readSettings(cursor) } : {};
  while (cursor.takeSign(';'));
  const clauses = readClauses(cursor, ['ENDCONDITION'], readStatement);
  if (clauses.length === 0) cursor.fail('WHEN');
  cursor.needWord('ENDCONDITION');
  return cursor.node(from, { kind: 'condition', number, ...settings, clauses });
}
