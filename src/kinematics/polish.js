/**
 * The last digits of a posture that is nearly a solution: Newton's method on the whole pose, joint limits ignored, with the
 * exact Jacobian. Unlike the descents of dampedLeastSquares.js it goes nowhere: it stays by the solution that it was given.
 *
 * @import { Chain } from './chain.js'
 */
import { solveCholesky } from './cholesky.js';
import { tcpPose } from './forward.js';
import { geometricJacobian } from './jacobian.js';
import { poseDifference } from './pose.js';

/** Little more than rounding: arm lengths for the position, radians for the orientation. */
const GRAIN = 1e-14;

/** Newton doubles the digits at each step; more steps than this are no polishing. */
const STEPS = 12;

/** Of squares of order 1: only keeps the system of a singular posture solvable. */
const DAMPING = 1e-15;

const T = new Float64Array(16);
const residual = new Float64Array(6);

/** Arrays for each number of joints, used again and again: nothing here calls back. @type {ReturnType<typeof allocate>[]} */
const rooms = [];
const allocate = (/** @type {number} */ n) => ({
  J: new Float64Array(6 * n),
  H: new Float64Array(n * n),
  gradient: new Float64Array(n),
  step: new Float64Array(n),
  lowest: new Float64Array(n),
});

/**
 * The weighted residual at q, into `residual`.
 * @param {Chain} chain
 * @param {Float64Array} q
 * @param {ArrayLike<number>} goal
 * @returns {number} its largest part: arm lengths or radians
 */
function measure(chain, q, goal) {
  poseDifference(tcpPose(chain, q, T), goal, residual);
  let largest = 0;
  for (let k = 0; k < 6; k++) {
    if (k < 3) residual[k] /= chain.characteristicLength;
    largest = Math.max(largest, Math.abs(residual[k]));
  }
  return largest;
}

/**
 * @param {Chain} chain
 * @param {Float64Array} q
 * @param {ReturnType<typeof allocate>} room  `step` is filled, in radians and metres
 * @param {Float64Array | null} held
 * @returns {boolean}
 */
function solveStep(chain, q, { J, H, gradient, step }, held) {
  const n = chain.dof;
  const L = chain.characteristicLength;
  geometricJacobian(chain, q, J);
  for (let i = 0; i < n; i++) {
    const slides = chain.joints[i].type === 'prismatic';
    for (let k = 6 * i; k < 6 * i + 3; k++) if (!slides) J[k] /= L; // a slide counts in arm lengths: (m/m)
    gradient[i] = 0;
    for (let k = 0; k < 6; k++) gradient[i] += J[6 * i + k] * residual[k];
    for (let j = 0; j <= i; j++) {
      let sum = i === j ? DAMPING : 0;
      for (let k = 0; k < 6; k++) sum += J[6 * i + k] * J[6 * j + k];
      H[i * n + j] = sum;
    }
  }
  if (held) for (let i = 0; i < n; i++) for (let j = 0; j <= i; j++) H[i * n + j] += held[i] * held[j];
  if (!solveCholesky(H, gradient, step)) return false;
  for (let i = 0; i < n; i++) if (chain.joints[i].type === 'prismatic') step[i] *= L;
  return true;
}

/**
 * @param {Chain} chain
 * @param {ArrayLike<number>} T_base_goal
 * @param {Float64Array} q  changed in place, never for the worse
 * @param {number} [grain]  what is good enough; arm lengths and radians
 * @param {Float64Array | null} [held]  a direction in which it must not go, of length 1 in radians and arm lengths
 * @returns {number} how far it is from the pose now: the largest part of the difference, in arm lengths or radians
 */
export function polish(chain, T_base_goal, q, grain = GRAIN, held = null) {
  let error = measure(chain, q, T_base_goal);
  if (error <= grain) return error;
  const room = (rooms[chain.dof] ??= allocate(chain.dof));
  for (let k = 0; k < STEPS && error > grain; k++) {
    room.lowest.set(q);
    if (!solveStep(chain, q, room, held)) break;
    for (let i = 0; i < q.length; i++) q[i] += room.step[i];
    const now = measure(chain, q, T_base_goal);
    if (!(now < error)) {
      q.set(room.lowest);
      break;
    }
    error = now;
  }
  return error;
}
