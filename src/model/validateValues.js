/**
 * Checks of single values, each a generator of the issues it found. `owner` begins the sentence: 'Joint "joint_1"'.
 *
 * @import { PoseDoc } from './document.js'
 * @import { Issue } from './issues.js'
 * @typedef {Iterable<Issue>} Issues
 */
import { documentIssue } from './issues.js';
import { characterCount, ID_PATTERN, LARGEST_NUMBER, QUATERNION_TOLERANCE } from './documentRules.js';
import { shownText } from './shownText.js';

const RANGE = `${-LARGEST_NUMBER} to ${LARGEST_NUMBER}`;

/** A value of unknown type, for a message. @param {unknown} value */
export const shownValue = (value) => (typeof value === 'string' ? `"${shownText(value)}"` : shownText(String(value)));

/**
 * @param {string} owner @param {string} what @param {string} path @param {unknown} value
 * @returns {Issues}
 */
export function* checkNumber(owner, what, path, value) {
  if (typeof value === 'number' && Math.abs(value) <= LARGEST_NUMBER) return;
  const message = `${owner} has ${what} ${shownValue(value)}; expected a number from ${RANGE}.`;
  yield documentIssue('number', path, message);
}

/**
 * @param {string} owner @param {string} what @param {string} path @param {unknown} value
 * @returns {Issues}
 */
export function* checkPositive(owner, what, path, value) {
  if (typeof value === 'number' && value > 0 && value <= LARGEST_NUMBER) return;
  const message = `${owner} has ${what} ${shownValue(value)}; expected a number above 0 and up to ${LARGEST_NUMBER}.`;
  yield documentIssue('number', path, message);
}

/**
 * @param {string} owner @param {string} what @param {string} path @param {unknown} value
 * @param {readonly unknown[]} choices
 * @returns {Issues}
 */
export function* checkChoice(owner, what, path, value, choices) {
  if (choices.includes(value)) return;
  yield documentIssue('choice', path, `${owner} has ${what} ${shownValue(value)}; expected ${choices.join(', ')}.`);
}

/**
 * @param {string} owner @param {string} path @param {unknown} value
 * @returns {Issues}
 */
export function* checkId(owner, path, value) {
  if (typeof value === 'string' && ID_PATTERN.test(value)) return;
  const expected = 'a letter or _, then letters, digits or _, at most 64 characters';
  yield documentIssue('id', path, `${owner} has the id ${shownValue(value)}; expected ${expected}.`);
}

/**
 * @param {string} things  'joints'
 * @param {string} path  of the list
 * @param {readonly { readonly id: string }[]} list
 * @returns {Issues}
 */
export function* checkDifferentIds(things, path, list) {
  const seen = new Set();
  for (const [i, { id }] of list.entries()) {
    if (seen.has(id)) {
      const message = `Two ${things} have the id ${shownValue(id)}; expected a different id for each.`;
      yield documentIssue('id-taken', `${path}.${i}.id`, message);
    }
    seen.add(id);
  }
}

/**
 * @param {string} owner @param {string} what @param {string} path @param {unknown} value @param {number} longest
 * @returns {Issues}
 */
export function* checkText(owner, what, path, value, longest) {
  const length = typeof value === 'string' ? characterCount(value) : NaN;
  if (length <= longest) return;
  const came = typeof value === 'string' ? `of ${length} characters` : shownValue(value);
  const expected = Number.isFinite(longest) ? `a text of at most ${longest}` : 'a text';
  yield documentIssue('text-length', path, `${owner} has ${what} ${came}; expected ${expected}.`);
}

/**
 * @param {string} owner @param {string} path @param {PoseDoc} pose
 * @returns {Issues}
 */
export function* checkPose(owner, path, { xyz, rpy, quaternion }) {
  yield* checkVector(owner, 'xyz', `${path}.xyz`, xyz, 3);
  if (rpy) yield* checkVector(owner, 'rpy', `${path}.rpy`, rpy, 3);
  if (!quaternion) return;
  if (rpy) {
    const message = `${owner} has both rpy and a quaternion; expected one of them.`;
    yield documentIssue('orientation-twice', `${path}.quaternion`, message);
  }
  yield* checkVector(owner, 'quaternion', `${path}.quaternion`, quaternion, 4);
  const length = Math.hypot(...quaternion);
  if (Math.abs(length - 1) > QUATERNION_TOLERANCE) {
    const message = `${owner} has a quaternion of length ${length}; expected length 1.`;
    yield documentIssue('quaternion-length', `${path}.quaternion`, message);
  }
}

/**
 * @param {string} owner @param {string} what @param {string} path @param {readonly number[]} values
 * @param {number} length
 */
function* checkVector(owner, what, path, values, length) {
  if (values.length !== length) {
    const message = `${owner} has ${values.length} numbers in ${what}; expected ${length}.`;
    yield documentIssue('vector-length', path, message);
  }
  for (const value of values) yield* checkNumber(owner, `in ${what} the value`, path, value);
}
