/**
 * J x = b for the rates of the joints that move the tool as wanted. Six joints: by elimination with row pivots, and the sign
 * of the determinant tells the branch. Any other number, or a singular posture: the least squares that are nearest to what x
 * was, by a damped step repeated on what is left, so that a joint that makes no difference stays as it was.
 *
 * @typedef {object} ToolSystem
 * @property {number} determinant   of six joints, its rows in arm lengths; 0 in a singular posture and for any other number
 * @property {(b: Float64Array, x: Float64Array) => void} solve   x: a guess, replaced
 */
import { solveAgain, solveCholesky } from '../kinematics/cholesky.js';

/** Determinants below this are of singular postures as far as digits tell; rows in arm lengths. */
const SINGULAR = 1e-9;

const DAMPING = 1e-9;
const REPEATS = 4;

const rows = 6;

/**
 * @param {number} dof
 * @returns {ToolSystem & { set: (J: Float64Array, length: number) => void }}  set: takes a Jacobian and the arm's length
 */
export function createToolSystem(dof) {
  const own = new Float64Array(rows * dof);
  const LU = new Float64Array(36);
  const order = new Uint8Array(6);
  const H = new Float64Array(dof * dof);
  const gradient = new Float64Array(dof);
  const rest = new Float64Array(6);
  const z = new Float64Array(6);
  let scale = 1;
  const system = {
    determinant: 0,
    /** @param {Float64Array} J @param {number} length */
    set(J, length) {
      scale = 1 / length;
      for (let at = 0; at < own.length; at += 6) {
        for (let k = 0; k < 6; k++) own[at + k] = k < 3 ? J[at + k] * scale : J[at + k];
      }
      const determinant = dof === 6 ? eliminate(own, LU, order) : 0;
      system.determinant = Math.abs(determinant) < SINGULAR ? 0 : determinant;
      if (system.determinant === 0) {
        for (let i = 0; i < dof; i++) {
          for (let j = 0; j <= i; j++) {
            let sum = 0;
            for (let k = 0; k < 6; k++) sum += own[6 * i + k] * own[6 * j + k];
            H[dof * i + j] = sum;
          }
        }
      }
    },
    /** @param {Float64Array} b @param {Float64Array} x */
    solve(b, x) {
      if (system.determinant !== 0) {
        for (let i = 0; i < 6; i++) {
          const row = order[i];
          let sum = row < 3 ? b[row] * scale : b[row];
          for (let j = 0; j < i; j++) sum -= LU[6 * j + i] * z[j];
          z[i] = sum;
        }
        for (let i = 5; i >= 0; i--) {
          let sum = z[i];
          for (let j = i + 1; j < 6; j++) sum -= LU[6 * j + i] * x[j];
          x[i] = sum / LU[6 * i + i];
        }
        return;
      }
      for (let repeat = 0; repeat < REPEATS; repeat++) {
        for (let k = 0; k < 6; k++) {
          let sum = k < 3 ? b[k] * scale : b[k];
          for (let i = 0; i < dof; i++) sum -= own[6 * i + k] * x[i];
          rest[k] = sum;
        }
        for (let i = 0; i < dof; i++) {
          let sum = 0;
          for (let k = 0; k < 6; k++) sum += own[6 * i + k] * rest[k];
          gradient[i] = sum;
        }
        if (repeat === 0) {
          if (!solveCholesky(H, gradient, gradient, DAMPING)) return;
        } else solveAgain(gradient, gradient);
        for (let i = 0; i < dof; i++) x[i] += gradient[i];
      }
    },
  };
  return system;
}

/**
 * A = P⁻¹ L U, columns one after another.
 * @param {Float64Array} A  36
 * @param {Float64Array} LU  36, filled
 * @param {Uint8Array} order   which row of A each row is
 * @returns {number} the determinant
 */
function eliminate(A, LU, order) {
  LU.set(A);
  for (let i = 0; i < 6; i++) order[i] = i;
  let determinant = 1;
  for (let k = 0; k < 6; k++) {
    let pivot = k;
    for (let i = k + 1; i < 6; i++) if (Math.abs(LU[6 * k + i]) > Math.abs(LU[6 * k + pivot])) pivot = i;
    const value = LU[6 * k + pivot];
    if (value === 0) return 0;
    if (pivot !== k) {
      [order[k], order[pivot]] = [order[pivot], order[k]];
      for (let j = 0; j < 6; j++) [LU[6 * j + k], LU[6 * j + pivot]] = [LU[6 * j + pivot], LU[6 * j + k]];
      determinant = -determinant;
    }
    determinant *= value;
    for (let i = k + 1; i < 6; i++) {
      const factor = LU[6 * k + i] / value;
      LU[6 * k + i] = factor;
      if (factor === 0) continue;
      for (let j = k + 1; j < 6; j++) LU[6 * j + i] -= factor * LU[6 * j + k];
    }
  }
  return determinant;
}
