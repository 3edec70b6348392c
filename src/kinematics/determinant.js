/**
 * The determinant of the Jacobian of an arm with six joints. Its sign tells apart branches of solutions: it changes where two of
 * them meet.
 *
 * @import { Chain } from './chain.js'
 */
import { geometricJacobian } from './jacobian.js';

const N = 6;
const J = new Float64Array(N * N);

/**
 * By Gaussian elimination with row pivots.
 * @param {Chain} chain  of six joints
 * @param {ArrayLike<number>} q
 * @returns {number} m³ for six turning joints; 0 at a singularity
 */
export function determinantAt(chain, q) {
  geometricJacobian(chain, q, J);
  let product = 1;
  for (let k = 0; k < N; k++) {
    let pivot = k;
    for (let i = k + 1; i < N; i++) if (Math.abs(J[N * k + i]) > Math.abs(J[N * k + pivot])) pivot = i;
    if (J[N * k + pivot] === 0) return 0;
    if (pivot !== k) {
      product = -product;
      for (let j = k; j < N; j++) [J[N * j + k], J[N * j + pivot]] = [J[N * j + pivot], J[N * j + k]];
    }
    product *= J[N * k + k];
    for (let i = k + 1; i < N; i++) {
      const factor = J[N * k + i] / J[N * k + k];
      for (let j = k + 1; j < N; j++) J[N * j + i] -= factor * J[N * j + k];
    }
  }
  return product;
}
