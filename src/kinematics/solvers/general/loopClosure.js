/**
 * Newton's method on the closed loop E_1(q_1) … E_6(q_6) · goal⁻¹ = 1 of six joints, in dual quaternions: what is left over is a
 * small twist, and the columns of its Jacobian are the lines of the joints where they have been moved to. Lengths are in
 * units of the arm's characteristic length; a slide is half a way, a turn a half angle, as in dualQuaternion.js.
 *
 * @typedef {object} Loop
 * @property {Float64Array} lines   8 · 6
 * @property {readonly boolean[]} slides
 * @property {Float64Array} goal    8
 */
import { factorise, nullVector, rankOf, solveFactorised } from './completePivoting.js';
import { solveCholesky } from '../../cholesky.js';
import { conjugate, DQ, multiply } from './dualQuaternion.js';

const JOINTS = 6;

/** Rounding leaves this much of a closed loop open, and usually less. */
const GRAIN = 2e-15;

/** Less than this is closed, whatever kept the rest from vanishing. */
const CLOSED = 1e-11;

/** No step moves a joint farther (radians, arm lengths): the start is believed to be near. */
const LONGEST_STEP = 0.5;

/** Pivots smaller than this, compared with the largest, are not divided by. */
const SMALLEST_PIVOT = 1e-14;

const products = new Float64Array(DQ * (JOINTS + 1));
const scratch = new Float64Array(DQ);
const inverse = new Float64Array(DQ);
const twist = new Float64Array(6);
const jacobian = new Float64Array(36);
const step = new Float64Array(6);
const lowest = new Float64Array(6);

/** What is left open at q goes to `twist`, the Jacobian to `jacobian`. @param {Loop} loop @param {Float64Array} q @returns {number} */
function measure({ lines, slides, goal }, q) {
  products.fill(0, 0, DQ);
  products[0] = 1;
  for (let i = 0; i < JOINTS; i++) {
    const at = DQ * i;
    const next = at + DQ;
    multiply(products, at, lines, at, scratch, 0);
    conjugate(products, at, inverse, 0);
    multiply(scratch, 0, inverse, 0, products, next);
    for (let k = 0; k < 3; k++) {
      jacobian[6 * k + i] = products[next + 1 + k];
      jacobian[6 * (k + 3) + i] = products[next + 5 + k];
    }
    const c = slides[i] ? 1 : Math.cos(q[i] / 2);
    const s = slides[i] ? q[i] / 2 : Math.sin(q[i] / 2);
    for (let k = 0; k < DQ; k++) products[next + k] = c * products[at + k] + s * scratch[k];
  }
  conjugate(goal, 0, inverse, 0);
  multiply(products, DQ * JOINTS, inverse, 0, scratch, 0);
  const sign = scratch[0] < 0 ? -2 : 2;
  let open = Math.abs(Math.min(0, Math.abs(scratch[0]) - 0.9)); // a half turn away has no small vector part
  for (let k = 0; k < 3; k++) {
    twist[k] = -sign * scratch[1 + k];
    twist[k + 3] = -sign * scratch[5 + k];
    open = Math.max(open, Math.abs(twist[k]), Math.abs(twist[k + 3]));
  }
  return open;
}

/**
 * How far from closed the loop is at q: the largest part of the twist that is left over, in radians and arm lengths.
 * @param {Loop} loop
 * @param {Float64Array} q
 */
export const gapAt = (loop, q) => measure(loop, q);

/**
 * From a posture that is nearly a solution to the solution.
 * @param {Loop} loop
 * @param {Float64Array} q  radians and arm lengths; changed in place
 * @param {number} most  steps
 * @param {number} [grain]  what is good enough; 0 is as good as it gets
 * @returns {boolean} whether the loop is closed
 */
export function closeLoop(loop, q, most, grain = GRAIN) {
  let open = measure(loop, q);
  let least = Infinity;
  for (let k = 0; k < most; k++) {
    if (open < least) {
      least = open;
      lowest.set(q);
      if (open <= grain) break;
    } else if (least < CLOSED) break;
    if (factorise(jacobian) < SMALLEST_PIVOT) break;
    solveFactorised(jacobian, twist, step);
    let longest = 0;
    for (let i = 0; i < JOINTS; i++) longest = Math.max(longest, Math.abs(step[i]));
    const share = Math.min(1, LONGEST_STEP / longest);
    for (let i = 0; i < JOINTS; i++) q[i] += share * step[i];
    open = measure(loop, q);
  }
  if (open < least) least = open;
  else q.set(lowest);
  return least <= CLOSED;
}

/**
 * How the joints can move at q, to first order, without opening the loop, if they can at all.
 * @param {Loop} loop
 * @param {Float64Array} q
 * @param {Float64Array} direction  6, filled: the joint that moves most moves by 1
 * @returns {number} the last pivot of the Jacobian over its first: how near to singular
 */
export function freeDirection(loop, q, direction) {
  measure(loop, q);
  const ratio = factorise(jacobian);
  nullVector(jacobian, Math.min(JOINTS - 1, rankOf(jacobian, SMALLEST_PIVOT)), JOINTS - 1, direction);
  const most = direction.reduce((largest, value) => Math.max(largest, Math.abs(value)), 0);
  for (let i = 0; i < JOINTS; i++) direction[i] /= most;
  return ratio;
}

const OTHERS = JOINTS - 1;
const H = new Float64Array(OTHERS * OTHERS);
const gradient = new Float64Array(OTHERS);
const steps = new Float64Array(OTHERS);

/** Of squares of order 1: keeps the system solvable where more than one motion is free. */
const DAMPING = 1e-14;

/**
 * The loop closed with one joint held where it is, by least squares: from beside a solution to another one, if there is.
 * @param {Loop} loop
 * @param {Float64Array} q  changed in place
 * @param {number} held
 * @returns {boolean} whether the loop is closed
 */
export function closeLoopHolding(loop, q, held) {
  for (let k = 0; k < 20; k++) {
    if (measure(loop, q) <= CLOSED) return true;
    for (let i = 0; i < OTHERS; i++) {
      const column = i < held ? i : i + 1;
      gradient[i] = 0;
      for (let row = 0; row < 6; row++) gradient[i] += jacobian[6 * row + column] * twist[row];
      for (let j = 0; j <= i; j++) {
        H[OTHERS * i + j] = i === j ? DAMPING : 0;
        for (let row = 0; row < 6; row++) {
          H[OTHERS * i + j] += jacobian[6 * row + column] * jacobian[6 * row + (j < held ? j : j + 1)];
        }
      }
    }
    if (!solveCholesky(H, gradient, steps)) return false;
    for (let i = 0; i < OTHERS; i++) q[i < held ? i : i + 1] += steps[i];
  }
  return measure(loop, q) <= CLOSED;
}
