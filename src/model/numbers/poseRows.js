/**
 * Poses as people and scripts write them: 4 rows of 4 numbers, metres.
 */
import { isPose } from '../../kinematics/pose.js';

/** @param {ArrayLike<number>} T  column-major */
export const rowsOf = (T) => [0, 1, 2, 3].map((row) => [0, 1, 2, 3].map((column) => T[4 * column + row]));

/**
 * @param {readonly (readonly number[])[]} rows
 * @returns {Float64Array} column-major
 * @throws {RangeError} unless the rows are those of a rigid pose
 */
export function poseFromRows(rows) {
  if (!Array.isArray(rows) || rows.length !== 4 || !rows.every((row) => row?.length === 4)) {
    throw new RangeError('Expected a pose as 4 rows of 4 numbers, in metres.');
  }
  const T = Float64Array.from({ length: 16 }, (_, k) => rows[k % 4][Math.floor(k / 4)]);
  const wrong = T.findIndex((value) => !Number.isFinite(value));
  if (wrong >= 0) {
    throw new RangeError(
      `Expected numbers in the rows of a pose; row ${(wrong % 4) + 1} has ${rows[wrong % 4][wrong >> 2]}.`,
    );
  }
  if (!isPose(T)) {
    throw new RangeError('Expected a pose: a rotation in the upper left 3 × 3, and a last row of 0 0 0 1.');
  }
  return T;
}
