/**
 * The target as a 4 × 4 matrix in document units. A matrix that is nearly a pose is refused, with how far it is from one;
 * the nearest rotation is there for whoever asks for it.
 *
 * @import { RobotDoc } from '../document.js'
 *
 * @typedef {object} MatrixFault
 * @property {'bottom-row' | 'skew' | 'left-handed'} kind
 * @property {number} by    how far from orthonormal: the largest entry of RᵀR − 1
 * @property {readonly number[] | null} mended  16 numbers, row by row; null where nothing is near
 */
import { poseFromXyzwpr, xyzwprOf } from './aim.js';
import { isPose } from '../../kinematics/pose.js';
import { rowsOf } from '../numbers/poseRows.js';
import { fromKernel, toKernel } from '../units.js';

const BOTTOM = [0, 0, 0, 1];

/** Farther from orthonormal than this, "nearest" is a guess. */
const NEAR = 0.2;

/** @param {RobotDoc} robot @param {readonly number[]} target  X Y Z W P R @returns {number[][]} rows, lengths in document units */
export const targetRows = (robot, target) =>
  rowsOf(poseFromXyzwpr(robot, target)).map((row, i) =>
    i < 3 ? row.with(3, fromKernel('length', row[3], robot.units)) : row,
  );

/**
 * @param {RobotDoc} robot
 * @param {readonly number[]} given  16 numbers, row by row, or 12 without the last row
 * @returns {{ target: readonly number[], fault: null } | { target: null, fault: MatrixFault }}
 */
export function targetFromMatrix(robot, given) {
  const rows = given.length === 12 ? [...given, ...BOTTOM] : given;
  if (rows.slice(12).some((value, k) => value !== BOTTOM[k])) {
    return { target: null, fault: { kind: 'bottom-row', by: 0, mended: null } };
  }
  const T = Float64Array.from({ length: 16 }, (_, k) => rows[4 * (k % 4) + (k >> 2)]);
  for (const k of [12, 13, 14]) T[k] = toKernel('length', T[k], robot.units);
  if (isPose(T)) {
    const lengths = [3, 7, 11].map((k) => rows[k]);
    return { target: [...lengths, ...xyzwprOf(robot, T).slice(3)], fault: null };
  }
  const by = skewOf(T);
  if (determinantOf(T) <= 0) return { target: null, fault: { kind: 'left-handed', by, mended: null } };
  return { target: null, fault: { kind: 'skew', by, mended: by < NEAR ? withNearest(rows, T) : null } };
}

/** @param {Float64Array} T */
function skewOf(T) {
  let most = 0;
  for (const i of [0, 4, 8]) {
    for (const j of [0, 4, 8]) {
      const product = T[i] * T[j] + T[i + 1] * T[j + 1] + T[i + 2] * T[j + 2];
      most = Math.max(most, Math.abs(product - (i === j ? 1 : 0)));
    }
  }
  return most;
}

/** @param {Float64Array} T */
const determinantOf = (T) => {
  const c = cofactors(T);
  return T[0] * c[0] + T[4] * c[4] + T[8] * c[8];
};

/** Of the upper left 3 × 3, where they stand in T. @param {Float64Array} T */
function cofactors(T) {
  const c = new Float64Array(11);
  for (let i = 0; i < 3; i++) {
    for (let j = 0; j < 3; j++) {
      const [r, s] = [(i + 1) % 3, (i + 2) % 3];
      const [u, v] = [4 * ((j + 1) % 3), 4 * ((j + 2) % 3)];
      c[4 * j + i] = T[u + r] * T[v + s] - T[v + r] * T[u + s];
    }
  }
  return c;
}

/**
 * The rotation nearest to the upper left 3 × 3 (Newton's iteration for the polar factor, R ← (R + R⁻ᵀ) / 2), in the rows.
 * @param {readonly number[]} rows
 * @param {Float64Array} T
 */
function withNearest(rows, T) {
  const R = T.slice();
  for (let turn = 0; turn < 8; turn++) {
    const c = cofactors(R);
    const d = determinantOf(R);
    for (const k of [0, 1, 2, 4, 5, 6, 8, 9, 10]) R[k] = (R[k] + c[k] / d) / 2;
  }
  return rows.map((value, k) => (k < 12 && k % 4 < 3 ? R[4 * (k % 4) + (k >> 2)] : value));
}
