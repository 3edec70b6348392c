/**
 * From any posture to a singular one, and along the singular ones to the nearest: the two walks of the search in
 * singularity.js. Postures here are in homogeneous scale, x: a turning joint's value in radians, a slide's over L.
 *
 * With r the freedoms of the arm, a posture is singular where singular value r is 0, that is, where the numbers
 * c_ab = u_aᵀ J v_b (a, b ≥ r; u and v the singular vectors here, held) all vanish together. All are 0 already but c_rr, the
 * singular value; their gradients say what moves along with it. Often the singular postures are a surface, with one
 * gradient across it (the elbow of a 6R arm); of redundant arms they are thinner sets, with several. Nothing has to be known
 * of that beforehand: damped normal equations use whatever gradients there are.
 *
 * @import { Chain } from '../chain.js'
 * @import { Part } from './homogeneous.js'
 * @import { Svd } from './singularValues.js'
 *
 * @typedef {object} Ground   what is walked on
 * @property {Chain} chain
 * @property {number} L      metres
 * @property {number} first  first row of the Jacobian that counts
 * @property {number} freedoms  r
 * @property {Float64Array} lower  limits of x
 * @property {Float64Array} upper
 * @property {Float64Array} q    room: the posture of x
 * @property {Float64Array} J    room: the Jacobian at x, homogeneous
 * @property {Float64Array} A    room: the rows of it that count
 * @property {Svd} svd           room: of A
 * @property {Float64Array} u    room: 6
 * @property {Float64Array} gradient  room, as are the following: of singular value r
 * @property {Float64Array} H       n · n
 * @property {Float64Array} system  n · n
 * @property {Float64Array} right   n
 * @property {Float64Array} step    n
 * @property {Uint8Array} isHeld    n: joints at a limit that would be stepped over
 */
import { solveCholesky } from '../cholesky.js';
import { RANK_TOLERANCE, freedomsOf, homogenise, rowsOfPart, selectRows } from './homogeneous.js';
import { geometricJacobian } from '../jacobian.js';
import { isSlide } from '../limits.js';
import { writeMotionDerivative } from './motionDerivative.js';
import { createSvd, decompose } from './singularValues.js';

/** Steps to a singular posture: four to eight in practice, some thirty where the singular value has a double zero. */
const DESCENT_STEPS = 60;
/** Steps back to one after a step along them; if it takes more, that step was too long. */
const BACK_STEPS = 10;
/** Near enough: the rounding of a Jacobian. */
const ZERO = 1e-15;
/** Steps may be this long, radians. */
const LONGEST_STEP = 0.5;
/** Steps along the singular postures, and how often one is halved. */
const SLIDE_STEPS = 40;
const HALVINGS = 6;
/** A gradient much smaller than the square root of this is taken for none while walking along singular postures. */
const ALONG = 1e-11;
/** The walk along them ends where the way left is this short, radians (the distance is then right to its square); or, at first,
 * where a step is worth so little. */
const ARRIVED = 1e-7;
const LITTLE = 0.01;

/**
 * @param {Chain} chain
 * @param {Part} part
 * @param {number} L  metres
 * @param {boolean} withinLimits
 * @returns {Ground}
 */
export function createGround(chain, part, L, withinLimits) {
  const { dof, packed } = chain;
  const { first, rows } = rowsOfPart(part);
  const scaled = (/** @type {Float64Array} */ limits, /** @type {number} */ none) =>
    limits.map((limit, i) => (withinLimits ? limit / (isSlide(packed, i) ? L : 1) : none));
  return {
    chain,
    L,
    first,
    freedoms: freedomsOf(chain)[part],
    lower: scaled(packed.lower, -Infinity),
    upper: scaled(packed.upper, Infinity),
    q: new Float64Array(dof),
    J: new Float64Array(6 * dof),
    A: new Float64Array(rows * dof),
    svd: createSvd(rows, dof),
    u: new Float64Array(6),
    gradient: new Float64Array(dof),
    H: new Float64Array(dof * dof),
    system: new Float64Array(dof * dof),
    right: new Float64Array(dof),
    step: new Float64Array(dof),
    isHeld: new Uint8Array(dof),
  };
}

/**
 * Singular value r at x; leaves the Jacobian and its decomposition in the rooms.
 * @param {Ground} ground
 * @param {Float64Array} x
 * @returns {number}
 */
export function smallestAt({ chain, L, first, freedoms, q, J, A, svd }, x) {
  for (let i = 0; i < q.length; i++) q[i] = isSlide(chain.packed, i) ? x[i] * L : x[i];
  homogenise(chain, geometricJacobian(chain, q, J), L);
  selectRows(J, first, A);
  return decompose(A, svd).values[freedoms - 1];
}

/** Whether a singular value from smallestAt is nought. @param {Ground} ground @param {number} smallest */
export const isNought = ({ svd }, smallest) => smallest <= RANK_TOLERANCE * Math.max(1, svd.values[0]);

/**
 * The gradient of c_ab = u_aᵀ J v_b where smallestAt was last.
 * @param {Ground} ground
 * @param {number} a
 * @param {number} b
 * @param {Float64Array} out  n, filled
 */
export function writeGradient({ svd, J, u, first, q }, a, b, out) {
  u.fill(0);
  for (let i = 0; i < svd.rows; i++) u[first + i] = svd.U[a * svd.rows + i];
  writeMotionDerivative(J, u, svd.V, b * q.length, out);
}

/**
 * H = Σ ∇c_ab ∇c_abᵀ, and the gradient of singular value r, where smallestAt was last.
 * @param {Ground} ground
 */
function gatherGradients(ground) {
  const { svd, freedoms, H, gradient, step: room } = ground;
  const n = gradient.length;
  H.fill(0);
  for (let a = freedoms - 1; a < svd.rows; a++) {
    for (let b = freedoms - 1; b < n; b++) {
      const out = a === freedoms - 1 && b === a ? gradient : room;
      writeGradient(ground, a, b, out);
      for (let i = 0; i < n; i++) for (let j = 0; j <= i; j++) H[i * n + j] += out[i] * out[j];
    }
  }
}

/**
 * Solves (H + damping · 1) step = right. A joint that stands at a limit and would be taken past it is held, and the others
 * are solved for again.
 * @param {Ground} ground
 * @param {Float64Array} x
 * @param {number} damping
 * @returns {boolean} false if there is no such step
 */
function solveStep({ H, system, right, step, isHeld, lower, upper }, x, damping) {
  const n = x.length;
  isHeld.fill(0);
  const wanted = right.slice();
  for (let round = 0; round <= n; round++) {
    for (let i = 0; i < n; i++) {
      right[i] = isHeld[i] ? 0 : wanted[i];
      for (let j = 0; j <= i; j++) system[i * n + j] = isHeld[i] || isHeld[j] ? 0 : H[i * n + j];
      system[i * n + i] += isHeld[i] ? 1 : damping;
    }
    if (!solveCholesky(system, right, step)) return false;
    let hasMore = false;
    for (let i = 0; i < n; i++) {
      if (isHeld[i] || !((step[i] < 0 && x[i] <= lower[i]) || (step[i] > 0 && x[i] >= upper[i]))) continue;
      isHeld[i] = 1;
      hasMore = true;
    }
    if (!hasMore) return true;
  }
  return false;
}

/** x + share · step, inside the limits. @param {Ground} ground @param {Float64Array} x @param {number} share @param {Float64Array} out */
function writeStepped({ step, lower, upper }, x, share, out) {
  for (let i = 0; i < x.length; i++) out[i] = Math.min(upper[i], Math.max(lower[i], x[i] + share * step[i]));
}

/**
 * Walks to a singular posture: Gauss–Newton steps on the c_ab, damped by the singular value itself, which keeps the fast
 * convergence whether there is one gradient or several (Fan & Yuan 2005).
 * @param {Ground} ground
 * @param {Float64Array} x  inside the limits; changed
 * @param {number} [steps]  at most
 * @returns {boolean} whether x is singular now
 */
export function descend(ground, x, steps = DESCENT_STEPS) {
  const { gradient, right, step } = ground;
  const tried = x.slice();
  let smallest = smallestAt(ground, x);
  for (let round = 0; round < steps && smallest > ZERO; round++) {
    gatherGradients(ground);
    for (let i = 0; i < x.length; i++) right[i] = -smallest * gradient[i];
    if (!solveStep(ground, x, smallest)) break;
    let share = Math.min(1, LONGEST_STEP / Math.hypot(...step));
    let next = Infinity;
    for (let halving = 0; halving < HALVINGS; halving++, share /= 2) {
      writeStepped(ground, x, share, tried);
      next = smallestAt(ground, tried);
      if (next < smallest) break;
    }
    if (!(next < smallest)) break;
    x.set(tried);
    smallest = next;
  }
  return isNought(ground, smallestAt(ground, x));
}

/** @param {Float64Array} x @param {Float64Array} y */
export function distance(x, y) {
  let square = 0;
  for (let i = 0; i < x.length; i++) square += (x[i] - y[i]) ** 2;
  return Math.sqrt(square);
}

/**
 * Walks along the singular postures to where none near by is nearer to `home`: what is left of the way home once the
 * directions that leave the singularity are taken out, then back onto it.
 * @param {Ground} ground
 * @param {Float64Array} x     singular; changed
 * @param {Float64Array} home
 * @param {boolean} isRough  a few steps will do, to be taken up again
 * @returns {number} the distance from x to home, radians
 */
export function approach(ground, x, home, isRough) {
  const { right, step } = ground;
  const tried = x.slice();
  const way = new Float64Array(x.length);
  let apart = distance(x, home);
  for (let round = 0; round < SLIDE_STEPS && apart > 0; round++) {
    smallestAt(ground, x);
    gatherGradients(ground);
    for (let i = 0; i < x.length; i++) right[i] = ALONG * (home[i] - x[i]);
    if (!solveStep(ground, x, ALONG)) break;
    way.set(step);
    if (Math.hypot(...way) < ARRIVED) break;
    let hasMoved = false;
    for (let halving = 0, share = 1; halving < HALVINGS && !hasMoved; halving++, share /= 2) {
      step.set(way);
      writeStepped(ground, x, share, tried);
      hasMoved = descend(ground, tried, BACK_STEPS) && distance(tried, home) < apart * (1 - 1e-12);
    }
    if (!hasMoved) break;
    x.set(tried);
    const before = apart;
    apart = distance(x, home);
    if (isRough && apart > before * (1 - LITTLE)) break;
  }
  return apart;
}
