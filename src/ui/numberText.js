/**
 * What a person typed → a number, or the reason why it is none. Never Number(text): that takes '' for 0 and '0x10' for 16.
 */
import { TEXT } from './strings.js';
import { LARGEST_NUMBER } from '../model/documentRules.js';

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
  if (!(Math.abs(value) <= LARGEST_NUMBER)) return { value: null, reason: TEXT.number.tooLarge };
  return { value, reason: null };
}

/**
 * The same for a limit, which may be taken away.
 * @param {string} text
 * @returns {{ value: number | undefined, reason: null } | { value: null, reason: string }}
 */
export const readLimit = (text) => (text.trim() === '' ? { value: undefined, reason: null } : readNumber(text));
