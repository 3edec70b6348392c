/**
 * What the functions share that make a pose of numbers as people type them: the refusal of anything that is no number, and
 * the finish, so that poses that are the same look the same.
 * @import { Pose } from '../pose.js'
 */

/**
 * Throws unless `values` are so many finite numbers.
 * @param {ArrayLike<number>} values
 * @param {number} count
 * @param {string} name  what they are, for the message
 */
export function requireNumbers(values, count, name) {
  if (values === null || typeof values !== 'object')
    throw new TypeError(`Expected ${name} to be ${count} numbers, got ${values === null ? null : typeof values}.`);
  if (values.length !== count) throw new RangeError(`Expected ${name} to be ${count} numbers, got ${values.length}.`);
  for (let i = 0; i < count; i++) {
    if (!Number.isFinite(values[i]))
      throw new RangeError(`Expected ${name} to be finite, got ${values[i]} at index ${i}.`);
  }
}

/**
 * Puts the position and the bottom row beside the axes that stand in `out`, and turns −0 into 0.
 * @param {Pose} out  filled up
 * @param {ArrayLike<number>} xyz metres
 * @returns {Pose} out
 */
export function finishPose(out, xyz) {
  out[12] = xyz[0];
  out[13] = xyz[1];
  out[14] = xyz[2];
  out[15] = 1;
  out[3] = out[7] = out[11] = 0;
  for (let i = 0; i < 15; i++) out[i] += 0;
  return out;
}
