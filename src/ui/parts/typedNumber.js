/**
 * What a person typed into a field of the document → a number, or why it is none, or the question what was meant. Plain
 * numbers are read at once; the first text that is none fetches expressionAnswer.js, and until that is here the answer is
 * that one has to wait.
 *
 * @import { Answer, Measure } from './numberText.js'
 */
import { readNumber } from './numberText.js';
import { TEXT } from '../strings.js';

/** What a plain number is while it is being typed: a sign, a point, an exponent to come. */
const BEGUN = /^[+\-−–]?(\d+\.?\d*|\.\d*)?([eE][+\-−–]?)?$/;

/** What a plain number may be; an expression of the same text would be nothing, or no better. */
const OUT_OF_RANGE = [TEXT.number.tooSmall, TEXT.number.tooLarge];

/** @typedef {(text: string, measure: Measure) => Answer<number>} AnswerExpression */

/** @typedef {(text: string, value: number, measure: Measure) => boolean} AgreesWith */

/** @type {{ answerExpression: AnswerExpression, agrees: AgreesWith } | null} */
let expressions = null;
let hasFailed = false;
/** @type {Promise<void> | null} */
let coming = null;

/** Fetches what expressions need, unless it is here or on its way. @returns {Promise<void>} that never fails */
export function fetchExpressions() {
  coming ??= import('./expressionAnswer.js').then(
    (module) => {
      expressions = module;
    },
    () => {
      hasFailed = true;
      coming = null; // and the next text tries again
    },
  );
  return coming;
}

/**
 * @param {string} text
 * @param {Measure} measure
 * @returns {Answer<number>}
 */
export function readTyped(text, measure) {
  const plain = readNumber(text);
  if (plain.reason === null || text.trim() === '' || OUT_OF_RANGE.includes(plain.reason)) return plain;
  if (expressions) return expressions.answerExpression(text, measure);
  if (BEGUN.test(text.trim())) return plain;
  if (hasFailed) {
    hasFailed = false;
    return { value: null, reason: TEXT.number.notLoaded };
  }
  return { value: null, reason: null, ready: fetchExpressions() };
}

/**
 * The same for a limit, which may be taken away.
 * @param {string} text
 * @param {Measure} measure
 * @returns {Answer<number | undefined>}
 */
export const readTypedLimit = (text, measure) =>
  text.trim() === '' ? { value: undefined, reason: null } : readTyped(text, measure);

/**
 * Whether a text that a file has beside a number comes to that number; where that cannot be told yet, when to ask again.
 * @param {string} text
 * @param {number} value
 * @param {Measure} measure
 * @returns {boolean | Promise<void>}
 */
export const agreesWith = (text, value, measure) =>
  expressions ? expressions.agrees(text, value, measure) : hasFailed || fetchExpressions();
