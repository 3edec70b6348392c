/**
 * Several numbers in one field, where one of them alone says nothing: a quaternion, an axis with its angle, a matrix. What
 * is nearly right is refused with a button that mends it, never mended unasked.
 *
 * @import { Change, Page } from '../page.js'
 * @import { Reasons } from './reasons.js'
 */
import { h } from './dom.js';
import { copyable } from './format.js';
import { readNumber } from './numberText.js';
import { editText } from './textEditor.js';

/**
 * @param {Page} page
 * @param {Reasons} reasons
 * @param {HTMLInputElement | HTMLTextAreaElement} input
 * @param {object} given
 * @param {readonly number[]} given.counts   how many numbers there may be
 * @param {(came: number) => string} given.wrongCount
 * @param {() => string} given.text
 * @param {() => string} [given.resting]  while nobody edits it
 * @param {(numbers: number[]) => { command: Change } | { reason: string }} given.take
 * @param {(numbers: number[]) => readonly number[] | null} given.mend  null if there is nothing to mend
 * @param {string} given.mendLabel
 * @param {() => string} given.done  the outcome in words
 */
export function severalField(page, reasons, input, { counts, wrongCount, text, resting, take, mend, mendLabel, done }) {
  const button = h('button', { type: 'button', class: 'btn btn-small btn-outline', hidden: true }, mendLabel);
  const read = (/** @type {string} */ typed) => readSeveral(typed, counts, wrongCount);
  const editor = editText(page, input, {
    text,
    ...(resting && { resting }),
    read(typed) {
      const found = read(typed);
      return 'reason' in found ? found : take(found.numbers);
    },
    onReason(reason) {
      reasons.set(input, reason);
      const found = read(input.value);
      button.hidden = reason === null || 'reason' in found || mend(found.numbers) === null;
    },
    onDone: done,
  });
  button.addEventListener('click', () => {
    const found = read(input.value);
    const mended = 'reason' in found ? null : mend(found.numbers);
    if (!mended) return;
    input.focus(); // the button goes with the reason
    editor.type(copyable(mended));
  });
  return { input, button, editor };
}

/**
 * @param {string} text
 * @param {readonly number[]} counts
 * @param {(came: number) => string} wrongCount
 * @returns {{ numbers: number[] } | { reason: string }}
 */
export function readSeveral(text, counts, wrongCount) {
  const parts = text
    .trim()
    .split(/[\s,;[\]]+/)
    .filter(Boolean);
  if (!counts.includes(parts.length)) return { reason: wrongCount(parts.length) };
  const numbers = [];
  for (const part of parts) {
    const { value, reason } = readNumber(part);
    if (reason !== null) return { reason };
    numbers.push(value);
  }
  return { numbers };
}
