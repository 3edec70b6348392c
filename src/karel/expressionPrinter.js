/**
 * KAREL expressions as text, with the parentheses that the language needs and no others. Precedence, tightest first, all
 * left-associative (FANUC KAREL Reference Manual, operators; note that AND binds tighter than a comparison):
 *
 *   NOT · : @ # · * / AND DIV MOD · + - OR, signs · < > = <> <= >= >=<
 *
 * @import { Binary, BinaryOperator, Call, Designator, Expression, Range, Unary } from './tree.js'
 */
import { integerText, realText } from './numberText.js';
import { identifier, quoted, referenceName, word } from './words.js';

/** Where a long line may be broken. The printer takes these out again; no text that comes in can hold one. */
export const BREAK = '\0';

const SIGN_LEVEL = 4;
const RELATION_LEVEL = 5;

/** @type {Readonly<Record<BinaryOperator, number>>} the lower, the tighter; 0 is what needs no parentheses ever */
const LEVEL = {
  ...{ ':': 2, '@': 2, '#': 2 },
  ...{ '*': 3, '/': 3, AND: 3, DIV: 3, MOD: 3 },
  ...{ '+': SIGN_LEVEL, '-': SIGN_LEVEL, OR: SIGN_LEVEL },
  ...{ '<': RELATION_LEVEL, '>': RELATION_LEVEL, '=': RELATION_LEVEL, '<>': RELATION_LEVEL },
  ...{ '<=': RELATION_LEVEL, '>=': RELATION_LEVEL, '>=<': RELATION_LEVEL },
};

/** @param {Expression} expression @returns {number} */
function levelOf(expression) {
  if (expression.kind === 'binary') return LEVEL[expression.operator];
  if (expression.kind === 'unary') return expression.operator === 'NOT' ? 1 : SIGN_LEVEL;
  return 0;
}

/** In parentheses, unless it binds at least as tightly as `loosest`. @param {Expression} expression @param {number} loosest */
function operandText(expression, loosest) {
  const text = expressionText(expression);
  return levelOf(expression) > loosest ? `(${text})` : text;
}

/** @param {Expression} expression @returns {string} */
export function expressionText(expression) {
  switch (expression.kind) {
    case 'integer':
      return integerText(expression.value);
    case 'real':
      return realText(expression.value, expression.decimals);
    case 'string':
      return quoted(expression.value);
    case 'name':
    case 'system':
    case 'index':
    case 'field':
      return designatorText(expression);
    case 'call':
      if (expression.args.length > 0) return callText(expression);
      throw new RangeError(`Expected arguments for "${expression.name}"; without any, its value is a name.`);
    case 'unary':
      return unaryText(expression);
    case 'binary':
      return binaryText(expression);
    default: {
      /** @type {never} */
      const unknown = expression;
      throw new TypeError(`Expected an expression, got ${JSON.stringify(unknown)}.`);
    }
  }
}

/** @param {readonly string[]} texts */
export const listText = (texts) => texts.join(`, ${BREAK}`);

/** @param {Call} call */
export function callText({ name, args, byValue = [] }) {
  const texts = args.map((arg, i) => (byValue.includes(i) ? `(${expressionText(arg)})` : expressionText(arg)));
  return args.length ? `${identifier(name)}(${listText(texts)})` : identifier(name);
}

/** What can be assigned to: a name, with indices and fields. @param {Designator | Call} designator @returns {string} */
export function designatorText(designator) {
  switch (designator.kind) {
    case 'call':
      return callText(designator);
    case 'name':
      return referenceName(designator.name);
    case 'system':
      return `$${word(designator.name)}`;
    case 'field':
      return `${designatorText(designator.target)}.${designator.system ? '$' : ''}${word(designator.name)}`;
    case 'index': {
      const { target, indices } = designator;
      if (indices.length < 1 || indices.length > 3) {
        throw new RangeError(`Expected 1 to 3 indices, got ${indices.length}.`);
      }
      return `${designatorText(target)}[${listText(indices.map(expressionText))}]`;
    }
    default: {
      /** @type {never} */
      const unknown = designator;
      throw new TypeError(`Expected a variable, got ${JSON.stringify(unknown)}.`);
    }
  }
}

/** A path, or a part of it. @param {Designator | Range} part */
export const pathPartText = (part) =>
  part.kind === 'range'
    ? `${designatorText(part.target)}[${expressionText(part.from)}..${expressionText(part.to)}]`
    : designatorText(part);

/** A term of a condition, between AND and OR that are no operators. @param {Expression} term */
export function termText(term) {
  if (term.kind !== 'binary') return operandText(term, 1);
  if (LEVEL[term.operator] !== RELATION_LEVEL) return `(${expressionText(term)})`;
  return `${operandText(term.left, 1)} ${term.operator} ${BREAK}${operandText(term.right, 1)}`;
}

/**
 * The operand is always something simple or in parentheses: of `-a * b` books say it means -(a * b), and `--` would begin
 * a comment.
 * @param {Unary} unary
 */
function unaryText({ operator, operand }) {
  if (!['NOT', '+', '-'].includes(operator)) throw new RangeError(`Expected NOT, + or -, got "${operator}".`);
  return `${operator}${operator === 'NOT' ? ' ' : ''}${operandText(operand, 0)}`;
}

/** @param {Binary} binary */
function binaryText({ operator, left, right }) {
  const level = Object.hasOwn(LEVEL, operator) ? LEVEL[operator] : undefined;
  if (level === undefined) throw new RangeError(`Expected an operator of KAREL, got "${operator}".`);
  // a < b < c would be legal in some readings and is never meant: comparisons of comparisons show their parentheses.
  const loosestLeft = level === RELATION_LEVEL ? level - 1 : level;
  return `${operandText(left, loosestLeft)} ${operator} ${BREAK}${operandText(right, level - 1)}`;
}
