/**
 * How far a key moves a joint: arrows a step, page keys ten; with Shift ten times as far, with Alt or Ctrl a tenth.
 */

/** @type {Record<string, number>} */
const STEPS = { ArrowRight: 1, ArrowUp: 1, ArrowLeft: -1, ArrowDown: -1, PageUp: 10, PageDown: -10 };

const STEP = 10; // in least steps: 1°, 1 mm
const COARSE = 10;

/**
 * @param {KeyboardEvent} event
 * @returns {number | null} in least steps; null if the key is none of these
 */
export function stepsOf({ key, shiftKey, altKey, ctrlKey, metaKey }) {
  if (!Object.hasOwn(STEPS, key) || metaKey) return null;
  if (altKey || ctrlKey) return STEPS[key];
  return STEPS[key] * STEP * (shiftKey ? COARSE : 1);
}
