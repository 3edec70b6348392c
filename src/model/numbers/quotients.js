/**
 * The Jacobian as a quotient of differences, and how far it is from the one by geometry as the step changes: truncation falls
 * with the step (slope 1 forward, 2 central), the rounding of subtracted poses grows as it shrinks (slope −1).
 *
 * @import { Chain } from '../../kinematics/chain.js'
 * @import { DifferenceMethod, Quotient } from './jacobianView.js'
 */
import { tcpPose } from '../../kinematics/forward.js';
import { finiteDifferenceJacobian, geometricJacobian } from '../../kinematics/jacobian.js';
import { isSlide } from '../../kinematics/limits.js';
import { poseDifference } from '../../kinematics/pose.js';

/**
 * (p(q + h e_k) − p(q)) / h, or (p(q + h e_k) − p(q − h e_k)) / 2h, with p from whole forward kinematics; of the orientation the
 * rotation vector from one to the other. A slide's step is h times the arm's characteristic length, so that an arm drawn in
 * other units gets the same numbers.
 * @param {Chain} chain
 * @param {ArrayLike<number>} q
 * @param {DifferenceMethod} method
 * @param {number} step  radians
 * @returns {Float64Array} 6 · n, as finiteDifferenceJacobian
 */
export function subtractedJacobian(chain, q, method, step) {
  const { dof, packed, characteristicLength } = chain;
  const J = new Float64Array(6 * dof);
  const T_here = tcpPose(chain, q);
  const apart = new Float64Array(6);
  for (let k = 0; k < dof; k++) {
    const h = isSlide(packed, k) ? step * characteristicLength : step;
    const at = (/** @type {number} */ by) => {
      const moved = Float64Array.from(q);
      moved[k] += by;
      return tcpPose(chain, moved);
    };
    poseDifference(method === 'central' ? at(-h) : T_here, at(h), apart);
    const width = method === 'central' ? 2 * h : h;
    for (let i = 0; i < 6; i++) J[6 * k + i] = apart[i] / width;
  }
  return J;
}

/**
 * @param {Chain} chain
 * @param {ArrayLike<number>} q
 * @param {{ method: DifferenceMethod, quotient: Quotient, step: number }} how
 */
export const jacobianByDifference = (chain, q, { method, quotient, step }) =>
  quotient === 'poses'
    ? subtractedJacobian(chain, q, method, step)
    : finiteDifferenceJacobian(chain, q, { method, step });

/**
 * The largest difference of an entry, with lengths over the characteristic length, so that it is a pure number.
 * @param {Chain} chain
 * @param {ArrayLike<number>} A  6 · n
 * @param {ArrayLike<number>} B
 */
export function largestDifference({ packed, dof, characteristicLength: L }, A, B) {
  let largest = 0;
  for (let k = 0; k < dof; k++) {
    const isSliding = isSlide(packed, k);
    for (let i = 0; i < 6; i++) {
      const difference = Math.abs(A[6 * k + i] - B[6 * k + i]);
      const unit = i < 3 ? (isSliding ? 1 : 1 / L) : isSliding ? L : 1;
      largest = Math.max(largest, difference * unit);
    }
  }
  return largest;
}

/** Exponents of ten of the steps that are plotted, and how many of them there are to a decade. */
export const PLOTTED = { least: -14, most: 0, perDecade: 4 };

/**
 * How far off each quotient is, for steps from 1e-14 to 1 rad.
 * @param {Chain} chain
 * @param {ArrayLike<number>} q
 * @param {Quotient} quotient
 * @returns {{ steps: number[], forward: number[], central: number[] }} differences as largestDifference counts
 */
export function errorCurves(chain, q, quotient) {
  const { least, most, perDecade } = PLOTTED;
  const steps = Array.from({ length: (most - least) * perDecade + 1 }, (_, i) => 10 ** (least + i / perDecade));
  const G = geometricJacobian(chain, q);
  const errors = (/** @type {DifferenceMethod} */ method) =>
    steps.map((step) => largestDifference(chain, jacobianByDifference(chain, q, { method, quotient, step }), G));
  return { steps, forward: errors('forward'), central: errors('central') };
}
