/**
 * What a person typed into a field of the document → a number, or why it is none, or the question what was meant. Plain
 * numbers are read at once; the first text that is none fetches expressionAnswer.js, and until that is here the answer is
 * that one has to wait.
 *
 * @import { Units } from '../model/document.js'
 *
 * @typedef {{ readonly quantity: 'length' | 'angle', readonly units: Units }} Measure  what is wanted, and the document's units
 * @typedef {{ readonly label: string, readonly text: string }} Way  out of a refusal or a question: a text to type instead
 *
 * @typedef {object} Refused
 * @property {null} value
 * @property {string} reason      a sentence that says all
 * @property {string} [title]     what is wrong or asked, in few words; `hint` then says the rest of it
 * @property {string} [hint]
 * @property {readonly Way[]} [ways]
 * @property {boolean} [isQuestion]
 *
 * @typedef {{ value: null, reason: null, ready: Promise<void> }} Waiting
 */
import { readNumber } from './numberText.js';
import { TEXT } from './strings.js';

/**
 * @template Value
 * @typedef {{ value: Value, reason: null, text?: string, note?: string } | Refused | Waiting} Answer  text: to be kept
 */

/** @typedef {(text: string, measure: Measure) => Answer<number>} AnswerExpression */

/** @type {AnswerExpression | null} */
let answerExpression = null;
let hasFailed = false;
/** @type {Promise<void> | null} */
let coming = null;

/** Fetches what expressions need, unless it is here or on its way. @returns {Promise<void>} that never fails */
export function fetchExpressions() {
  coming ??= import('./expressionAnswer.js').then(
    (module) => {
      answerExpression = module.answerExpression;
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
  if (plain.reason === null || text.trim() === '') return plain;
  if (answerExpression) return answerExpression(text, measure);
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
