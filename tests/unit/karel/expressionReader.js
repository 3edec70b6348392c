/**
 * A second opinion on KAREL expressions: reads text into nested nodes by the manual's table of precedence, and knows
 * nothing of the printer. `{ head: '+', parts: ['a', 1] }` is a sum.
 *
 * @import { Expression } from '../../../src/karel/tree.js'
 * @typedef {string | number | { text: string } | { head: string, parts: Shape[] }} Shape
 */

const TOKEN = /\s*(?:('(?:[^']|'')*')|(\d+(?:\.\d+)?(?:E[+-]?\d+)?)|([A-Za-z]\w*)|(>=<|<>|<=|>=|[-+*/:@#<>=()[\],]))/uy;

/**
 * Books differ on what `-a * b` means: the sign may be that of the first term, or of the operand.
 * @param {string} text
 * @param {'of the first term' | 'of the operand'} signs
 * @returns {Shape}
 */
export function readExpression(text, signs) {
  const tokens = tokensOf(text);
  const node = (/** @type {string} */ head, /** @type {Shape[]} */ ...parts) => ({ head, parts });
  const isWord = (/** @type {unknown} */ token) => typeof token === 'string';
  let at = 0;
  const take = () => tokens[at++];
  const takes = (/** @type {string} */ token) => tokens[at] === token && Boolean(++at);
  const need = (/** @type {string} */ token) => {
    if (!takes(token)) throw new Error(`Expected ${token} at token ${at} of ${text}`);
  };

  /** @param {string[]} operators @param {() => Shape} operand @param {Shape} [first] @returns {Shape} */
  const chain = (operators, operand, first) => {
    let left = first ?? operand();
    while (isWord(tokens[at]) && operators.includes(String(tokens[at]))) left = node(String(take()), left, operand());
    return left;
  };
  const relation = () => chain(['<', '>', '=', '<>', '<=', '>=', '>=<'], sum);
  /** @returns {Shape} */
  const sum = () => {
    if (signs === 'of the operand') return chain(['+', '-', 'OR'], product);
    const sign = tokens[at] === '-' || tokens[at] === '+' ? String(take()) : null;
    return chain(['+', '-', 'OR'], product, sign ? node(sign, product()) : product());
  };
  const product = () => chain(['*', '/', 'AND', 'DIV', 'MOD'], position);
  const position = () => chain([':', '@', '#'], factor);
  /** @returns {Shape} */
  const factor = () => {
    if (takes('NOT')) return node('NOT', factor());
    if (signs === 'of the operand' && (tokens[at] === '-' || tokens[at] === '+')) return node(String(take()), factor());
    if (takes('(')) {
      const inner = relation();
      need(')');
      return inner;
    }
    const token = take();
    if (typeof token !== 'string') return token;
    if (!/^[A-Za-z]/.test(token)) throw new Error(`Unexpected ${token} in ${text}`);
    if (takes('(')) return node('call', token, ...list(')'));
    if (takes('[')) return node('index', token, ...list(']'));
    return token;
  };
  /** @param {string} close @returns {Shape[]} */
  const list = (close) => {
    const items = [relation()];
    while (takes(',')) items.push(relation());
    need(close);
    return items;
  };

  const whole = relation();
  if (at !== tokens.length) throw new Error(`Text left over in ${text}`);
  return whole;
}

/** @param {string} text @returns {(string | number | { text: string })[]} */
function tokensOf(text) {
  const tokens = [];
  TOKEN.lastIndex = 0;
  while (TOKEN.lastIndex < text.length) {
    const match = TOKEN.exec(text);
    if (!match) throw new Error(`No KAREL in ${text}`);
    const [, quotedText, number, word, sign] = match;
    if (quotedText) tokens.push({ text: quotedText.slice(1, -1).replaceAll("''", "'") });
    else tokens.push(number ? Number(number) : (word ?? sign));
  }
  return tokens;
}

/** The same nodes from a tree. @param {Expression} tree @returns {Shape} */
export function shapeOf(tree) {
  switch (tree.kind) {
    case 'string':
      return { text: tree.value };
    case 'name':
      return tree.name;
    case 'index':
      return { head: 'index', parts: [shapeOf(tree.target), ...tree.indices.map(shapeOf)] };
    case 'call':
      return { head: 'call', parts: [tree.name, ...tree.args.map(shapeOf)] };
    case 'field':
    case 'system':
      throw new Error(`This reader knows no ${tree.kind}.`);
    case 'unary':
      return { head: tree.operator, parts: [shapeOf(tree.operand)] };
    case 'binary':
      return { head: tree.operator, parts: [shapeOf(tree.left), shapeOf(tree.right)] };
    default:
      return tree.value;
  }
}
