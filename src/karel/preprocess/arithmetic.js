/**
 * `%eval` and `%if`: whole numbers with the operators of C, and comparisons of what is no number as texts. What cannot be
 * calculated is the text itself, as the preprocessor has it, and counts as true.
 */

/** By how tightly they bind, loosest first. */
const LEVELS = [['||'], ['&&'], ['|'], ['^'], ['&'], ['==', '!='], ['<=', '>=', '<', '>'], ['+', '-'], ['*', '/', '%']];
const TOKEN = /\s*(\|\||&&|==|!=|<=|>=|[-+*/%<>|^&!~()]|[^-+*/%<>|^&!~()=\s]+(?:\s+[^-+*/%<>|^&!~()=\s]+)*)\s*/y;

/** @type {Readonly<Record<string, (a: number, b: number) => number>>} */
const CALCULATE = {
  '||': (a, b) => Number(a !== 0 || b !== 0),
  '&&': (a, b) => Number(a !== 0 && b !== 0),
  '|': (a, b) => a | b,
  '^': (a, b) => a ^ b,
  '&': (a, b) => a & b,
  '+': (a, b) => a + b,
  '-': (a, b) => a - b,
  '*': (a, b) => Math.imul(a, b),
  '/': (a, b) => (b === 0 ? NaN : Math.trunc(a / b)),
  '%': (a, b) => (b === 0 ? NaN : a % b),
};

/** @type {Readonly<Record<string, (a: number | string, b: number | string) => boolean>>} */
const COMPARE = {
  '==': (a, b) => a === b,
  '!=': (a, b) => a !== b,
  '<=': (a, b) => a <= b,
  '>=': (a, b) => a >= b,
  '<': (a, b) => a < b,
  '>': (a, b) => a > b,
};

/** @param {string} text  expanded already @returns {string} */
export function calculated(text) {
  const tokens = tokensOf(text);
  if (!tokens) return text;
  let at = 0;
  const failed = new Error('This is no calculation.');

  /** @param {number} level @returns {number | string} */
  function binary(level) {
    if (level === LEVELS.length) return unary();
    let left = binary(level + 1);
    while (LEVELS[level].includes(tokens?.[at] ?? '')) {
      const operator = /** @type {string[]} */ (tokens)[at++];
      const right = binary(level + 1);
      if (operator in COMPARE) {
        const isNumeric = typeof left === 'number' && typeof right === 'number';
        left = Number(isNumeric ? COMPARE[operator](left, right) : COMPARE[operator](String(left), String(right)));
      } else left = CALCULATE[operator](needNumber(left), needNumber(right));
    }
    return left;
  }

  /** @returns {number | string} */
  function unary() {
    const token = tokens?.[at++];
    if (token === undefined) throw failed;
    if (token === '-') return -needNumber(unary());
    if (token === '+') return needNumber(unary());
    if (token === '!') return Number(needNumber(unary()) === 0);
    if (token === '~') return ~needNumber(unary());
    if (token === '(') {
      const inner = binary(0);
      if (tokens?.[at++] !== ')') throw failed;
      return inner;
    }
    if (token === ')' || LEVELS.flat().includes(token)) throw failed;
    return /^\d+$/.test(token) ? Number(token) : token;
  }

  /** @param {number | string} value */
  function needNumber(value) {
    if (typeof value !== 'number' || Number.isNaN(value)) throw failed;
    return value;
  }

  try {
    const value = binary(0);
    return at === tokens.length && typeof value === 'number' && !Number.isNaN(value) ? String(value) : text;
  } catch (error) {
    if (error !== failed) throw error;
    return text;
  }
}

/** @param {string} text @returns {string[] | null} */
function tokensOf(text) {
  const tokens = [];
  TOKEN.lastIndex = 0;
  while (TOKEN.lastIndex < text.length) {
    const match = TOKEN.exec(text);
    if (!match) return null;
    tokens.push(match[1]);
  }
  return tokens;
}
