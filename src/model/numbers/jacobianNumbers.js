/**
 * The Jacobian for the page: by geometry and as a quotient, along the axes of a frame, with lengths in the document's unit.
 * Turning joints count per radian whatever unit the document's angles have: a velocity is ω times a radius in radians only.
 *
 * @import { RobotDoc } from '../document.js'
 * @import { Chain } from '../../kinematics/chain.js'
 * @import { DifferenceMethod, JacobianFrame, JacobianView } from './jacobianView.js'
 */
import { tcpPose } from '../../kinematics/forward.js';
import { DEFAULT_STEP, geometricJacobian } from '../../kinematics/jacobian.js';
import { isSliding } from '../document.js';
import { poseOfAxes } from '../aim/handleAxes.js';
import { jacobianByDifference, largestDifference } from './quotients.js';
import { fromKernel, toKernel } from '../units.js';

/** Radians: a smaller step changes no angle of 1 rad; with a larger one a quotient is no derivative. */
export const STEP_LIMITS = { least: 1e-15, most: 1 };

/** The kernel's own, radians. */
export const defaultStep = (/** @type {DifferenceMethod} */ method) => DEFAULT_STEP[method];

/** @param {Pick<JacobianView, 'method' | 'step'>} view @returns {number} radians */
export const stepOf = ({ method, step }) => step ?? DEFAULT_STEP[method];

/**
 * The pose whose axes they are.
 * @param {Chain} chain
 * @param {ArrayLike<number>} q
 * @param {JacobianFrame} frame
 * @param {Float64Array | null} [T_world_user]  the active user frame
 */
export const axesAt = (chain, q, frame, T_world_user = null) =>
  poseOfAxes(frame, chain, tcpPose(chain, q), T_world_user);

/**
 * Vectors seen from the axes of a pose: each three numbers in turn.
 * @param {ArrayLike<number>} vectors  3 · m, along the world's axes
 * @param {ArrayLike<number>} T_world_frame
 */
export function seenAlong(vectors, T_world_frame) {
  const T = T_world_frame;
  return Float64Array.from(vectors, (_, i) => {
    const row = i % 3;
    const at = i - row;
    // Sums with a zero first, so that −0 is none.
    return 0 + T[4 * row] * vectors[at] + T[4 * row + 1] * vectors[at + 1] + T[4 * row + 2] * vectors[at + 2];
  });
}

/**
 * @param {Chain} chain
 * @param {ArrayLike<number>} q
 * @param {JacobianView} view
 * @param {Float64Array | null} [T_world_user]
 * @returns {{ geometric: Float64Array, numeric: Float64Array, largest: number }} along the axes of `view.frame`, metres and
 *   radians; the largest difference as quotients.js counts it
 */
export function jacobiansAt(chain, q, view, T_world_user = null) {
  const T = axesAt(chain, q, view.frame, T_world_user);
  const G = geometricJacobian(chain, q);
  const N = jacobianByDifference(chain, q, { ...view, step: stepOf(view) });
  return { geometric: seenAlong(G, T), numeric: seenAlong(N, T), largest: largestDifference(chain, N, G) };
}

/**
 * Six rows of n numbers.
 * @param {RobotDoc} robot
 * @param {ArrayLike<number>} J  6 · n, metres and radians
 * @returns {number[][]} lengths in the document's unit, angles in radians
 */
export const rowsInDocument = ({ joints, units }, J) =>
  Array.from({ length: 6 }, (_, i) =>
    joints.map((joint, k) => {
      const value = J[6 * k + i];
      if (isSliding(joint)) return i < 3 ? value : toKernel('length', value, units);
      return i < 3 ? fromKernel('length', value, units) : value;
    }),
  );
