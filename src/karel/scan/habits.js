/**
 * Habits of other languages: what a fault comes from where a person writes as one does there, and how KAREL has it.
 *
 * @import { Token } from './scanner.js'
 */

const WORDS = new Map([
  ['ELSEIF', 'There is no such word: behind ELSE stands an IF of its own, with its own ENDIF.'],
  ['ELIF', 'There is no such word: behind ELSE stands an IF of its own, with its own ENDIF.'],
  ['RETURN', 'A value stands in parentheses: RETURN(value).'],
]);

/** By signs that follow each other. */
const SIGNS = new Map([
  ['==', 'KAREL compares with one "=".'],
  [':=', 'KAREL assigns with "=" alone.'],
  ['+=', 'KAREL has it in full: i = i + 1.'],
  ['-=', 'KAREL has it in full: i = i - 1.'],
  ['++', 'KAREL has it in full: i = i + 1.'],
  ['//', 'A remark begins with two hyphens: --.'],
  ['/*', 'A remark begins with two hyphens: --.'],
  ['**', 'KAREL has no powers: multiply, or use EXP and LN.'],
]);

/**
 * @param {readonly Token[]} tokens
 * @param {number} at  the one that was not expected
 * @returns {string} with a blank before it; empty where nothing is known
 */
export function habitAt(tokens, at) {
  const [before, token, after] = [tokens[at - 1], tokens[at], tokens[at + 1]];
  const pairOf = (/** @type {Token | undefined} */ a, /** @type {Token | undefined} */ b) =>
    a?.type === 'sign' && b?.type === 'sign' && a.end === b.start ? SIGNS.get(a.text + b.text) : undefined;
  const isFirst = at === 1 && before.type === 'word' && token.type === 'word' && !token.fresh;
  const hint =
    pairOf(before, token) ??
    pairOf(token, after) ??
    (before?.type === 'word' && !token.fresh ? WORDS.get(before.upper) : undefined) ??
    (isFirst ? 'A program begins with PROGRAM and its name.' : undefined);
  return hint ? ` ${hint}` : '';
}
