/**
 * KAREL text → tokens. A line end is no token: each token says whether it begins a line (`fresh`), and a line that ends with
 * & goes on in the next. Comments hang on the token that follows them. Never throws: what is no KAREL becomes a diagnostic
 * and is left out.
 *
 * @typedef {object} Token
 * @property {'word' | 'integer' | 'real' | 'string' | 'system' | 'sign' | 'directive' | 'end'} type
 * @property {string} text    as written; of a string, its value; of a directive, what follows its name
 * @property {string} upper   the same in capitals, by which words and signs are told; of a directive, its name
 * @property {number} value   of a number
 * @property {number} start
 * @property {number} end
 * @property {boolean} fresh  begins a line
 * @property {ScannedComment[]} comments
 *
 * @typedef {{ text: string, start: number, end: number, trailing: boolean }} ScannedComment
 * @typedef {(code: string, message: string, start: number, end: number) => void} Report
 */
import { finished, PIECE } from '../slices.js';
import { MAX_INTEGER } from '../tree.js';
import { MAX_STRING_LENGTH } from '../words.js';

const SPACE = /[ \t\f\v\u00a0\ufeff]+/y;
const LINE_END = /\r\n|\r|\n/y;
const WORD = /[A-Za-z][A-Za-z0-9_]*/y;
const SYSTEM = /\$[A-Za-z][A-Za-z0-9_]*/y;
const REAL = /(?:\d+\.(?!\.)\d*|\.\d+)(?:[Ee][+-]?\d+)?|\d+[Ee][+-]?\d+/y;
const INTEGER = /\d+/y;
const SIGN = />=<|<>|<=|>=|::|\.\.|[-+*/=<>:@#,.;()[\]&]/y;
const DIRECTIVE = /%[ \t]*([A-Za-z_][A-Za-z0-9_]*)((?:'[^'\r\n]*'|(?!--)[^\r\n'])*)/y;
const COMMENT = /--[^\r\n]*/y;
const STRING = /'(?:[^'\r\n]|'')*'/y;
const OPEN_STRING = /'[^\r\n]*/y;
/** What other languages mean by characters that KAREL does not know. @type {Readonly<Record<string, string>>} */
const CHARACTERS = {
  '"': " A text stands in single quotes: 'text'.",
  '%': ' The rest of a division is MOD.',
  '!': ' Unequal is <>, and the opposite is NOT.',
};

/** Tokens. */
const SOME = 20 * PIECE;
const LARGEST_REAL = 3.4028235e38;

/** @param {string} text @param {Report} report @returns {Token[]} the last is `end` */
export const scan = (text, report) => finished(scanInSlices(text, report));

/** The same, some tokens at a time. @param {string} text @param {Report} report @returns {Generator<null, Token[]>} */
export function* scanInSlices(text, report) {
  /** @type {Token[]} */
  const tokens = [];
  /** @type {ScannedComment[]} */
  let comments = [];
  let at = 0;
  let fresh = true;
  let joined = false;

  const matched = (/** @type {RegExp} */ pattern) => {
    pattern.lastIndex = at;
    return pattern.exec(text);
  };
  /** @param {Token['type']} type @param {string} tokenText @param {number} length @param {number} [value] */
  const push = (type, tokenText, length, value = 0) => {
    const upper = type === 'string' || type === 'directive' ? tokenText : tokenText.toUpperCase();
    const token = {
      type,
      text: tokenText,
      upper,
      value,
      start: at,
      end: at + length,
      fresh: fresh && !joined,
      comments,
    };
    tokens.push(token);
    comments = [];
    fresh = joined = false;
    return token;
  };

  let told = 0;
  while (at < text.length) {
    if (tokens.length - told > SOME) {
      told = tokens.length;
      yield null;
    }
    let match;
    if ((match = matched(SPACE))) {
      // between tokens
    } else if ((match = matched(LINE_END))) {
      fresh = true;
    } else if ((match = matched(COMMENT))) {
      const [whole] = match;
      const trailing = !fresh && tokens.length > 0;
      comments.push({ text: commentText(whole.slice(2)), start: at, end: at + whole.length, trailing });
    } else if ((match = matched(STRING))) {
      const value = match[0].slice(1, -1).replaceAll("''", "'");
      if (value.length > MAX_STRING_LENGTH) {
        const expected = `Expected a string of at most ${MAX_STRING_LENGTH} characters, got ${value.length}.`;
        report('string-too-long', expected, at, at + match[0].length);
      }
      push('string', value, match[0].length);
    } else if ((match = matched(OPEN_STRING))) {
      report(
        'string-not-closed',
        "Expected ' at the end of the string, got the end of the line.",
        at,
        at + match[0].length,
      );
      push('string', match[0].slice(1).trimEnd(), match[0].length);
    } else if ((match = matched(WORD))) {
      push('word', match[0], match[0].length);
    } else if ((match = matched(SYSTEM))) {
      push('system', match[0].slice(1), match[0].length);
    } else if ((match = matched(REAL))) {
      const value = Math.fround(Number(match[0]));
      const exact = Number(match[0]);
      if (!(exact <= LARGEST_REAL)) {
        report('real-too-large', `Expected a real of at most 3.4028235E38, got ${match[0]}.`, at, at + match[0].length);
      }
      push('real', match[0], match[0].length, Number.isFinite(value) ? exact : LARGEST_REAL);
    } else if ((match = matched(INTEGER))) {
      const value = Number(match[0]);
      if (value > MAX_INTEGER) {
        report(
          'integer-too-large',
          `Expected a whole number up to ${MAX_INTEGER}, got ${match[0]}.`,
          at,
          at + match[0].length,
        );
      }
      push('integer', match[0], match[0].length, Math.min(value, MAX_INTEGER));
    } else if ((match = matched(DIRECTIVE))) {
      const token = push('directive', match[2].trim().replace(/;$/, '').trimEnd(), match[0].trimEnd().length);
      token.upper = match[1].toUpperCase();
    } else if ((match = matched(SIGN))) {
      if (match[0] === '&') {
        const [rest] = /^[ \t]*(--[^\r\n]*)?(\r\n|\r|\n|$)?/.exec(text.slice(at + 1, at + 400)) ?? [''];
        if (rest.trim() !== '' || /[\r\n]/.test(rest) || at + 1 + rest.length >= text.length) joined = true;
        else report('continuation', 'Expected the end of the line after &, got more.', at, at + 1);
      } else push('sign', match[0], match[0].length);
    } else {
      match = [String.fromCodePoint(text.codePointAt(at) ?? 0)];
      const message = `Expected KAREL, got the character ${JSON.stringify(match[0])}.${CHARACTERS[match[0]] ?? ''}`;
      report('character', message, at, at + match[0].length);
    }
    at += match[0].length;
  }
  joined = false;
  fresh = true;
  push('end', '', 0);
  return tokens;
}

/** The text of a comment: one blank after the dashes is form. @param {string} text */
const commentText = (text) => (text.startsWith(' ') ? text.slice(1) : text).trimEnd();
