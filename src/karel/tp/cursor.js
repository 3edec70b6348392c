/**
 * Where the reader stands in one instruction. Whoever finds a fault throws it; whoever reads the line keeps its text and goes on
 * with the next.
 */

/** What is wrong in an instruction, and where. */
export class TpFault extends Error {
  /** @param {string} expected @param {string} got @param {number} at */
  constructor(expected, got, at) {
    super(`Expected ${expected}, got ${got}.`);
    this.at = at;
  }
}

/** @typedef {ReturnType<typeof createTpCursor>} TpCursor */

/** @param {string} text */
export function createTpCursor(text) {
  let at = 0;

  function skip() {
    while (text[at] === ' ' || text[at] === '\t') at++;
  }

  /** What comes next, if it is that; spaces before it are passed. @param {RegExp} pattern  sticky @returns {RegExpExecArray | null} */
  function look(pattern) {
    skip();
    pattern.lastIndex = at;
    return pattern.exec(text);
  }

  const cursor = {
    look,
    /** @param {RegExp} pattern  sticky */
    take(pattern) {
      const match = look(pattern);
      if (match) at = pattern.lastIndex;
      return match;
    },
    /** @param {RegExp} pattern @param {string} expected */
    need(pattern, expected) {
      return cursor.take(pattern) ?? cursor.fail(expected);
    },
    /** @param {string} sign */
    takeSign(sign) {
      skip();
      if (!text.startsWith(sign, at)) return false;
      at += sign.length;
      return true;
    },
    /** @param {string} sign */
    needSign(sign) {
      if (!cursor.takeSign(sign)) cursor.fail(`"${sign}"`);
    },
    position: () => at,
    /** @param {number} position */
    goTo: (position) => void (at = position),
    /** Everything from here on, without spaces around. */
    rest() {
      const rest = text.slice(at).trim();
      at = text.length;
      return rest;
    },
    isAtEnd() {
      skip();
      return at >= text.length;
    },
    /** @param {string} expected @returns {never} */
    fail(expected) {
      skip();
      const got = at >= text.length ? 'the end of the instruction' : `"${text.slice(at, at + 20).trimEnd()}"`;
      throw new TpFault(expected, got, at);
    },
  };
  return cursor;
}
