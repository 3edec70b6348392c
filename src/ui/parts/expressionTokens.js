/**
 * What a person typed → the words of an expression, each of them known; anything else is refused by its name before a
 * parser sees it. Signs of mathematics (π √ − × ° ²) become plain ones, and what is left out between factors is filled in, so that the parser
 * decides nothing by rules that nobody knows: a unit belongs to the whole product before it (pi/2 rad), and 1/2pi, which
 * can be read in two ways, is refused.
 *
 * @typedef {'number' | 'constant' | 'function' | 'unit' | 'operator' | 'open' | 'close'} TokenKind
 * @typedef {{ readonly kind: TokenKind, readonly text: string }} Token
 */
import { EXPRESSION } from '../words/expression.js';

/** Longer is no number of a table. A robot file keeps texts up to 200. */
export const LONGEST_EXPRESSION = 120;
const DEEPEST = 12;

export const FUNCTIONS = ['sqrt', 'abs', 'sin', 'cos', 'tan', 'asin', 'acos', 'atan'];
export const UNITS = ['mm', 'cm', 'm', 'in', 'deg', 'rad'];

/** @type {readonly (readonly [RegExp, string])[]} */
const PLAIN_SIGNS = [
  [/[−–]/g, '-'],
  [/[×·⋅∙*]/g, '*'],
  [/[÷∕⁄]/g, '/'],
  [/[°º˚]/g, ' deg '],
  [/²/g, '^2'],
  [/³/g, '^3'],
  [/[πΠ]/g, ' pi '],
  [/√/g, ' √ '],
  [/["″]/g, ' in '],
];

const PATTERN = /\s*(?:(\d+\.?\d*(?:[eE][+-]?\d+)?|\.\d+(?:[eE][+-]?\d+)?)|([\p{L}\p{M}_]+)|(\S))/uy;

/** @param {string} typed @returns {{ tokens: Token[], reason: null } | { tokens: null, reason: string }} */
export function readTokens(typed) {
  if (typed.length > LONGEST_EXPRESSION) return refuse(EXPRESSION.tooLong(LONGEST_EXPRESSION));
  if (/\d,\d/.test(typed)) {
    const mended = typed.replace(/(\d),(?=\d)/g, '$1.');
    return refuse(readTokens(mended).tokens ? EXPRESSION.comma(mended) : EXPRESSION.commas);
  }
  const plain = PLAIN_SIGNS.reduce((text, [sign, word]) => text.replace(sign, word), typed).trim();
  /** @type {Token[]} */
  const tokens = [];
  let rooted = false; // a √ takes the number, constant or bracket that follows it
  let isClosing = 0; // how many brackets a √ has opened that close after the next operand
  let depth = 0;
  PATTERN.lastIndex = 0;
  while (PATTERN.lastIndex < plain.length) {
    const match = PATTERN.exec(plain);
    if (!match) break;
    const [, number, name, sign] = match;
    const token = number ? numberToken(number) : name ? wordToken(name) : signToken(sign);
    if (token === null) return refuse(EXPRESSION.unknown(name ?? sign));
    const { kind } = token;
    if (token.text === '√') {
      const against = rooted ? EXPRESSION.root : fillIn(tokens, { kind: 'function', text: 'sqrt' });
      if (against) return refuse(against);
      tokens.push({ kind: 'function', text: 'sqrt' });
      rooted = true;
      continue;
    }
    if (rooted && kind !== 'open') {
      if (kind !== 'number' && kind !== 'constant') return refuse(EXPRESSION.root);
      tokens.push({ kind: 'open', text: '(' });
      isClosing = 1;
    }
    const against = rooted ? null : fillIn(tokens, token);
    if (against) return refuse(against);
    rooted = false;
    tokens.push(token);
    if (isClosing) tokens.push({ kind: 'close', text: ')' });
    isClosing = 0;
    if (kind === 'open' && ++depth > DEEPEST) return refuse(EXPRESSION.tooDeep);
    if (kind === 'close' && --depth < 0) return refuse(EXPRESSION.brackets);
  }
  if (rooted) return refuse(EXPRESSION.root);
  if (depth !== 0) return refuse(EXPRESSION.brackets);
  const against = badOrder(tokens);
  return against ? refuse(against) : { tokens, reason: null };
}

/** @param {string} reason @returns {{ tokens: null, reason: string }} */
const refuse = (reason) => ({ tokens: null, reason });

/** @param {string} text @returns {Token} */
const numberToken = (text) => ({ kind: 'number', text });

/** @param {string} name @returns {Token | null} */
function wordToken(name) {
  const word = name.toLowerCase();
  if (word === 'pi') return { kind: 'constant', text: 'pi' };
  if (FUNCTIONS.includes(word)) return { kind: 'function', text: word };
  return UNITS.includes(name) ? { kind: 'unit', text: name } : null;
}

/** @param {string} sign @returns {Token | null} */
function signToken(sign) {
  if ('+-*/^√'.includes(sign)) return { kind: 'operator', text: sign };
  if (sign === '(') return { kind: 'open', text: sign };
  return sign === ')' ? { kind: 'close', text: sign } : null;
}

const ENDS = ['number', 'constant', 'unit', 'close'];
const BEGINS = ['number', 'constant', 'function', 'open'];

/**
 * Puts the sign of multiplication where none was typed.
 * @param {Token[]} tokens
 * @param {Token} next
 * @returns {string | null} why it cannot be put
 */
function fillIn(tokens, next) {
  const last = tokens.at(-1);
  if (!last || !ENDS.includes(last.kind)) return null;
  if (next.kind === 'unit') {
    if (last.kind === 'unit') return EXPRESSION.twoUnits(last.text, next.text);
  } else if (!BEGINS.includes(next.kind)) return null;
  else if (next.kind === 'number') return EXPRESSION.noSign(last.text, next.text);
  else if (isDivided(tokens)) return EXPRESSION.twoWays(last.text, next.text);
  tokens.push({ kind: 'operator', text: '*' });
  return null;
}

/** Whether the product that ends here has a division in it. @param {Token[]} tokens */
function isDivided(tokens) {
  let depth = 0;
  for (const { kind, text } of tokens.toReversed()) {
    if (kind === 'close') depth++;
    else if (kind === 'open' && --depth < 0) return false;
    else if (depth === 0 && kind === 'operator' && text !== '*' && text !== '^') return text === '/';
  }
  return false;
}

/** A unit stands behind what it measures, and nowhere else. @param {Token[]} tokens @returns {string | null} */
function badOrder(tokens) {
  for (const [i, { kind, text }] of tokens.entries()) {
    const next = tokens[i + 1];
    if (kind === 'function' && next?.kind !== 'open') return EXPRESSION.functionBrackets(text);
    if (kind !== 'unit') continue;
    if (i < 2 || tokens[i - 1].text !== '*') return EXPRESSION.loneUnit(text);
    if (next?.text === '^') return EXPRESSION.unitPower(text);
  }
  return null;
}
