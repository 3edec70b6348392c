/**
 * KAREL expressions. Precedence, tightest first, all left-associative: NOT · : @ # · * / AND DIV MOD · + - OR and signs ·
 * relations. In conditions, AND and OR stand between terms and are no operators (`withoutLogic`).
 *
 * @import { BinaryOperator, Call, Designator, Expression, Range } from '../tree.js'
 * @import { Cursor } from './cursor.js'
 */
import { isReserved, NAMES_ALL_THE_SAME } from '../words.js';

const RELATIONS = new Set(['=', '<>', '<', '>', '<=', '>=', '>=<']);
const SUMS = new Set(['+', '-', 'OR']);
const PRODUCTS = new Set(['*', '/', 'AND', 'DIV', 'MOD']);
const POSITIONS = new Set([':', '@', '#']);
/** More than any program has, and fewer than would be too deep a tree. */
const MAX_OPERATORS = 1000;
const MAX_SUFFIXES = 50;

const LOGIC = new Set(['AND', 'OR']);

/**
 * @param {Cursor} cursor
 * @param {{ withoutLogic?: boolean, stops?: () => boolean }} [options]  stops: what looks like an operator is none
 * @returns {Expression}
 */
export function readExpression(cursor, { withoutLogic = false, stops = () => false } = {}) {
  /** @param {Set<string>} operators @param {() => Expression} operand @returns {Expression} */
  const chain = (operators, operand) => {
    const from = cursor.position();
    let left = operand();
    for (let count = 0; ; count++) {
      const token = cursor.peek();
      if ((token.type !== 'sign' && token.type !== 'word') || !operators.has(token.upper)) return left;
      if (!cursor.continues() || (withoutLogic && LOGIC.has(token.upper)) || stops()) return left;
      if (count >= MAX_OPERATORS) cursor.fail(`at most ${MAX_OPERATORS} operators in a row`);
      cursor.advance();
      const operator = /** @type {BinaryOperator} */ (token.upper);
      left = cursor.node(from, { kind: 'binary', operator, left, right: operand() });
    }
  };
  /** A sign is that of the first product of its sum. @returns {Expression} */
  const signed = () => {
    const from = cursor.position();
    const token = cursor.peek();
    if (token.type === 'sign' && (token.upper === '-' || token.upper === '+')) {
      cursor.advance();
      const operator = token.upper;
      return cursor.node(from, { kind: 'unary', operator, operand: cursor.deeper(signedProduct) });
    }
    return product();
  };
  /** @returns {Expression} */
  const signedProduct = () => (cursor.isSign('-') || cursor.isSign('+') ? signed() : product());
  const product = () => chain(PRODUCTS, () => chain(POSITIONS, () => readFactor(cursor)));
  return cursor.deeper(() => chain(RELATIONS, () => chain(SUMS, signed)));
}

/** @param {Cursor} cursor @returns {Expression} */
function readFactor(cursor) {
  const from = cursor.position();
  const token = cursor.peek();
  switch (token.type) {
    case 'integer':
      cursor.advance();
      return cursor.node(from, { kind: 'integer', value: token.value });
    case 'real':
      cursor.advance();
      return cursor.node(from, { kind: 'real', value: token.value, ...decimalsOf(token.text, token.value) });
    case 'string':
      cursor.advance();
      return cursor.node(from, { kind: 'string', value: token.text });
    case 'system':
      return readDesignator(cursor);
    case 'word':
      if (token.upper === 'NOT') {
        cursor.advance();
        return cursor.node(from, { kind: 'unary', operator: 'NOT', operand: cursor.deeper(() => readFactor(cursor)) });
      }
      if (isReserved(token.upper) && !NAMES_ALL_THE_SAME.has(token.upper)) return cursor.fail('a value');
      return readReference(cursor);
    default:
      if (cursor.isSign('(')) return cursor.deeper(() => cursor.bracketed('(', () => readExpression(cursor), ')'));
      if (cursor.isSign('-') || cursor.isSign('+')) {
        // An operand with a sign of its own, as in `2 * -3`.
        cursor.advance();
        const operand = cursor.deeper(() => readFactor(cursor));
        return cursor.node(from, { kind: 'unary', operator: /** @type {'+' | '-'} */ (token.upper), operand });
      }
      return cursor.fail('a value');
  }
}

/** Digits that the number alone would not show. @param {string} text @param {number} value */
function decimalsOf(text, value) {
  const written = /^\d*\.(\d*)$/.exec(text)?.[1].length ?? 0;
  const needed = Math.max(1, String(value).split('.')[1]?.length ?? 0);
  return written > needed && written <= 20 && !String(value).includes('e') ? { decimals: written } : {};
}

/** A variable, a constant, a port, a call. @param {Cursor} cursor @returns {Designator | Call} */
export function readReference(cursor) {
  if (cursor.peek().type === 'system') return readDesignator(cursor);
  const from = cursor.position();
  if (cursor.isSign('(', 1) && !cursor.peek(1).fresh) {
    if (isReserved(cursor.peek().upper)) cursor.fail('a statement or a value');
    const { text } = cursor.advance();
    const call = cursor.node(from, { kind: /** @type {const} */ ('call'), name: text, ...readCallArguments(cursor) });
    return readSuffixes(cursor, from, call);
  }
  return readDesignator(cursor);
}

/** @param {Cursor} cursor @returns {Expression[]} */
export const readArguments = (cursor) =>
  cursor.bracketed('(', () => (cursor.isSign(')') ? [] : readList(cursor, () => readExpression(cursor))), ')');

/** @param {Cursor} cursor */
function readCallArguments(cursor) {
  /** @type {number[]} */
  const byValue = [];
  let count = 0;
  const readOne = () => {
    const isOpened = cursor.isSign('(');
    const arg = readExpression(cursor);
    if (isOpened && isDesignator(arg)) byValue.push(count);
    count++;
    return arg;
  };
  if (cursor.isSign(')', 1))
    cursor.fail('arguments; a routine without any is called by its name alone', cursor.peek(1));
  const args = cursor.bracketed('(', () => readList(cursor, readOne), ')');
  return { args, ...(byValue.length > 0 && { byValue }) };
}

/** @param {Expression} node */
const isDesignator = ({ kind }) => kind === 'name' || kind === 'system' || kind === 'index' || kind === 'field';

/** @template T @param {Cursor} cursor @param {() => T} read @returns {T[]} */
export function readList(cursor, read) {
  const list = [read()];
  while (cursor.takeSign(',')) list.push(read());
  return list;
}

/** @param {Cursor} cursor @returns {Designator} */
export function readDesignator(cursor) {
  const from = cursor.position();
  const token = cursor.peek();
  /** @type {Designator} */
  let target;
  if (token.type === 'system') {
    cursor.advance();
    target = cursor.node(from, { kind: 'system', name: token.text });
  } else {
    if (token.type !== 'word') cursor.fail('a variable');
    if (isReserved(token.upper) && !NAMES_ALL_THE_SAME.has(token.upper)) cursor.fail('a variable');
    cursor.advance();
    target = cursor.node(from, { kind: 'name', name: token.text });
  }
  return readSuffixes(cursor, from, target);
}

/** Indices and fields. @param {Cursor} cursor @param {number} from @template {Designator | Call} T @param {T} start @returns {T | Designator} */
function readSuffixes(cursor, from, start) {
  /** @type {T | Designator} */
  let target = start;
  for (let count = 0; cursor.continues(); count++) {
    if (count > MAX_SUFFIXES) cursor.fail(`at most ${MAX_SUFFIXES} indices and fields in a row`);
    if (cursor.isSign('[')) {
      if (isRange(cursor)) return target;
      const indices = cursor.bracketed('[', () => readList(cursor, () => readExpression(cursor)), ']');
      target = cursor.node(from, { kind: 'index', target, indices });
    } else if (cursor.isSign('.')) {
      cursor.advance();
      const token = cursor.peek();
      if (token.type !== 'word' && token.type !== 'system') cursor.fail('the name of a field');
      cursor.advance();
      const system = token.type === 'system' && /** @type {{ system: true }} */ ({ system: true });
      target = cursor.node(from, { kind: 'field', target, name: token.text, ...system });
    } else break;
  }
  return target;
}

/** So far brackets are looked through for it: text that opens brackets and never closes them is not to take long. */
const RANGE_AHEAD = 400;

/** Whether brackets here hold `a..b`, which only MOVE ALONG knows. @param {Cursor} cursor */
function isRange(cursor) {
  for (let ahead = 1, depth = 0; ahead < RANGE_AHEAD; ahead++) {
    if (cursor.peek(ahead).type === 'end') return false;
    if (cursor.isSign('[', ahead) || cursor.isSign('(', ahead)) depth++;
    if (depth === 0 && cursor.isSign('..', ahead)) return true;
    if (cursor.isSign(']', ahead) || cursor.isSign(')', ahead)) {
      if (depth === 0) return false;
      depth--;
    }
  }
  return false;
}

/** A path, or a part of it. @param {Cursor} cursor @returns {Designator | Range} */
export function readPathPart(cursor) {
  const from = cursor.position();
  const target = readDesignator(cursor);
  if (!cursor.isSign('[') || !cursor.continues()) return target;
  return cursor.bracketed(
    '[',
    () => {
      const first = readExpression(cursor);
      cursor.needSign('..');
      return cursor.node(from, { kind: 'range', target, from: first, to: readExpression(cursor) });
    },
    ']',
  );
}
