/**
 * Where the parser stands in its tokens, what it has complained about, and how it goes on after a fault: whoever finds one
 * reports it and throws `FAULT`; whoever can go on catches it and skips to a place that is known again.
 *
 * @import { Comment, Span } from '../tree.js'
 * @import { Token } from '../scan/scanner.js'
 *
 * @typedef {object} Diagnostic
 * @property {'error' | 'warning'} severity
 * @property {string} code
 * @property {string} message
 * @property {Span} span
 *
 * @typedef {(start: number, end: number) => Span} Locate  offsets of the tokens → a place in the text that was typed
 */
import { isReserved } from '../words.js';
import { habitAt } from '../scan/habits.js';

/** Thrown after the report, and always caught by the parser. */
export const FAULT = new Error('This text is no KAREL; the report says why.');

/** Deeper than any program, shallower than the stack. */
const MAX_DEPTH = 120;

/** One complaint a place is enough, and so many are enough for a file. */
const MAX_DIAGNOSTICS = 500;

/** @typedef {ReturnType<typeof createCursor>} Cursor */

/**
 * @param {readonly Token[]} tokens
 * @param {Locate} locate
 * @param {Diagnostic[]} diagnostics
 * @param {boolean} [macros]  whether the text is one for a preprocessor
 */
export function createCursor(tokens, locate, diagnostics, macros = false) {
  let at = 0;
  let depth = 0;
  let brackets = 0;
  let lastFaultAt = -1;
  let endNeeded = true;
  /** @type {Comment[]} */
  let swallowed = [];
  const taken = new Set();

  const peek = (ahead = 0) => tokens[Math.min(at + ahead, tokens.length - 1)];

  /** @param {Token} token @returns {Comment[]} those that nobody has taken yet */
  function commentsOf(token) {
    if (token.comments.length === 0 || taken.has(token)) return [];
    taken.add(token);
    return token.comments.map(({ text, start, end, trailing }) => ({
      ...{ kind: 'comment', text },
      ...(trailing && { trailing: true }),
      span: locate(start, end),
    }));
  }

  function advance() {
    const token = peek();
    for (const comment of commentsOf(token)) {
      delete comment.trailing;
      swallowed.push(comment);
    }
    if (at < tokens.length - 1) at++;
    return token;
  }

  /** @param {Diagnostic['severity']} severity @param {string} code @param {string} message @param {number} start @param {number} end */
  function report(severity, code, message, start, end) {
    if (diagnostics.length < MAX_DIAGNOSTICS) diagnostics.push({ severity, code, message, span: locate(start, end) });
  }

  /** What was expected, and what came instead. @param {string} expected @param {Token} [token] @returns {never} */
  function fail(expected, token = peek()) {
    if (at !== lastFaultAt) {
      report(
        'error',
        'syntax',
        `Expected ${expected}, got ${shownToken(token)}.${token === peek() ? habitAt(tokens, at) : ''}`,
        token.start,
        Math.max(token.end, token.start),
      );
    }
    lastFaultAt = at;
    throw FAULT;
  }

  const isSign = (/** @type {string} */ sign, ahead = 0) => peek(ahead).type === 'sign' && peek(ahead).upper === sign;
  const isWord = (/** @type {string} */ word, ahead = 0) => peek(ahead).type === 'word' && peek(ahead).upper === word;

  const cursor = {
    peek,
    advance,
    fail,
    report,
    isSign,
    isWord,
    locate,
    /** The words that end the blocks around this place, outermost first. */
    opened: /** @type {(readonly string[])[]} */ ([]),
    /** The next statement may stand on the same line. */
    afterLabel: () => void (endNeeded = false),
    /** Whether the statement that was read must be ended; asked once. */
    needsEnd() {
      const needed = endNeeded;
      endNeeded = true;
      return needed;
    },
    /** Whether a macro seems to be used here that nobody defined: a name with arguments where there can be no call. */
    isMacroUse: (ahead = 0) =>
      macros && isSign('(', ahead + 1) && !peek(ahead + 1).fresh && !isReserved(peek(ahead).upper),
    /** Leave it out. */
    skipMacroUse(what = 'a declaration') {
      const token = advance();
      const message = `Expected ${what}, got "${token.text}(…)": no macro of this name is known, and it is left out.`;
      report('warning', 'unknown-macro', message, token.start, token.end);
      for (let open = 0; peek().type !== 'end';) {
        if (isSign('(')) open++;
        if (isSign(')')) open--;
        advance();
        if (open <= 0) return;
      }
    },
    commentsHere: () => commentsOf(peek()),
    /** Comments inside of what was read since. */
    swallowedComments() {
      const comments = swallowed;
      swallowed = [];
      return comments;
    },
    position: () => at,
    /** Go back; the comments of what is read again are not given twice. @param {number} position */
    goTo: (position) => void (at = position),
    atEnd: () => peek().type === 'end',
    /** Whether what stands here belongs to the same statement as what was before. */
    continues: () => brackets > 0 || !peek().fresh,
    takeSign: (/** @type {string} */ sign) => isSign(sign) && Boolean(advance()),
    takeWord: (/** @type {string} */ word) => isWord(word) && Boolean(advance()),
    needSign: (/** @type {string} */ sign) => (isSign(sign) ? advance() : fail(`"${sign}"`)),
    needWord: (/** @type {string} */ word) => (isWord(word) ? advance() : fail(`"${word}"`)),
    /** A name that no word of the language is. @param {string} [what] */
    needName(what = 'a name') {
      const token = peek();
      if (token.type !== 'word') fail(what, token);
      if (isReserved(token.upper)) fail(`${what} (${token.upper} is a word of the language)`, token);
      return advance();
    },
    /** @template T @param {string} open @param {() => T} read @param {string} close @returns {T} */
    bracketed(open, read, close) {
      cursor.needSign(open);
      brackets++;
      try {
        const inner = read();
        if (!isSign(close)) fail(`"${close}"`);
        brackets--;
        advance();
        return inner;
      } catch (fault) {
        brackets = Math.max(0, brackets - 1);
        throw fault;
      }
    },
    /** @template T @param {() => T} read @returns {T} */
    deeper(read) {
      if (depth >= MAX_DEPTH) fail(`at most ${MAX_DEPTH} levels of nesting`);
      depth++;
      try {
        return read();
      } finally {
        depth--;
      }
    },
    /** Brackets left open by a fault are forgotten. */
    outside() {
      brackets = 0;
    },
    /** @template {object} T @param {number} from  position of its first token @param {T} node @returns {T & { span: Span }} */
    node(from, node) {
      const last = tokens[Math.max(from, at - 1)];
      return Object.assign(node, { span: locate(tokens[from].start, Math.max(last.end, tokens[from].end)) });
    },
    /** @param {Token} token */
    spanOf: (token) => locate(token.start, token.end),
  };
  return cursor;
}

/** @param {Token} token */
export function shownToken(token) {
  if (token.type === 'end') return 'the end of the text';
  if (token.type === 'string') return `the string '${token.text}'`;
  if (token.type === 'directive') return `%${token.upper}`;
  if (token.type === 'system') return `$${token.text}`;
  return `"${token.text}"`;
}
