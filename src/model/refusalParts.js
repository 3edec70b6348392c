/**
 * What refusals are made of: each says what is wrong with one value of a command, or null.
 * @import { Issue } from './issues.js'
 */
import { LARGEST_NUMBER } from './documentRules.js';
import { shownText } from './shownText.js';

/** @param {string} code @param {string} path @param {string} message @returns {Issue} */
export const issue = (code, path, message) => ({ severity: 'error', code, path, message });

/** A value in a sentence: a text in quotes, a number with a true minus. @param {unknown} value */
export function shown(value) {
  if (typeof value === 'string') return `"${shownText(value)}"`;
  return typeof value === 'object' && value !== null ? 'an object' : String(value).replace('-', '−');
}

/** @param {'joint' | 'posture' | 'target' | 'frame' | 'program' | 'step' | 'obstacle'} what @param {number} index @param {number} count @param {number} [least] */
export function badIndex(what, index, count, least = 0) {
  if (Number.isInteger(index) && index >= least && index < count) return null;
  return issue(
    'index',
    what,
    `Expected ${what === 'obstacle' ? 'an' : 'a'} ${what} index from ${shown(least)} to ${count - 1}, got ${shown(index)}.`,
  );
}

/** @param {string} what @param {number | undefined} value @param {boolean} [mayBeAbsent] */
export function badNumber(what, value, mayBeAbsent = false) {
  if (value === undefined ? mayBeAbsent : Number.isFinite(value) && Math.abs(value) <= LARGEST_NUMBER) return null;
  return issue('number', what, `A ${what} is a number from −10⁹ to 10⁹; got ${shown(value)}.`);
}

/** @param {string} what @param {string} path @param {string} value @param {readonly string[]} choices */
export function badChoice(what, path, value, choices) {
  if (choices.includes(value)) return null;
  return issue('choice', path, `Expected ${choices.join(' or ')} as ${what}, got ${shown(value)}.`);
}

/** @param {readonly number[]} posture @param {number} count  of joints @returns {Issue | null} */
export function badPosture(posture, count) {
  if (!Array.isArray(posture) || posture.length !== count) {
    const came = Array.isArray(posture) ? posture.length : shown(posture);
    return issue('posture-length', 'posture', `Expected ${count} joint values, got ${came}.`);
  }
  return posture.reduce((found, value) => found ?? badNumber('joint value', value), /** @type {Issue | null} */ (null));
}
