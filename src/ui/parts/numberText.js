/**
 * What a person typed → a number, or the reason why it is none. Never Number(text): that takes '' for 0 and '0x10' for 16.
 *
 * @import { Units } from '../../model/document.js'
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
import { TEXT } from '../strings.js';
import { LARGEST_NUMBER } from '../../model/documentRules.js';
import { commonAngle, convertAngle } from '../../model/units.js';

/**
 * @template Value
 * @typedef {{ value: Value, reason: null, text?: string, note?: string } | Refused | Waiting} Answer  text: to be kept
 */

const NUMBER = /^[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?$/;
const DECIMAL_COMMA = /^[+-]?\d*,\d+$/;

/**
 * @param {string} text
 * @returns {{ value: number, reason: null } | { value: null, reason: string }}
 */
export function readNumber(text) {
  const typed = text.trim().replace(/[−–]/g, '-');
  if (typed === '') return { value: null, reason: TEXT.number.empty };
  if (DECIMAL_COMMA.test(typed)) return { value: null, reason: TEXT.number.comma(typed.replace(',', '.')) };
  if (!NUMBER.test(typed)) return { value: null, reason: TEXT.number.notANumber(text.trim()) };
  const value = Number(typed);
  if (value === 0 && /^[^eE]*[1-9]/.test(typed)) return { value: null, reason: TEXT.number.tooSmall };
  if (!(Math.abs(value) <= LARGEST_NUMBER)) return { value: null, reason: TEXT.number.tooLarge };
  return { value, reason: null };
}

/**
 * An angle that is a common fraction of π to the last bit, as it is written: π/2, −3π/4.
 * @param {number} radians
 * @returns {string | null}
 */
export function fractionOfPi(radians) {
  const common = commonAngle(convertAngle(radians, 'rad', 'deg'));
  if (common?.value !== radians) return null;
  return common.text.replace('*pi', 'π').replace('pi', 'π').replace('-', '−');
}
