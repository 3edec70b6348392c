/**
 * How far a posture leaves the tool from where it should be.
 *
 * @import { Chain } from './chain.js'
 *
 * @typedef {object} Tolerances
 * @property {number} positionTolerance     m
 * @property {number} orientationTolerance  rad
 */
import { tcpPose } from './forward.js';
import { poseDifference } from './pose.js';

const T = new Float64Array(16);
const difference = new Float64Array(6);

/**
 * @param {Chain} chain
 * @param {ArrayLike<number>} T_base_goal
 * @param {Float64Array} q
 * @returns {{ positionError: number, orientationError: number }}
 */
export function errorsAt(chain, T_base_goal, q) {
  poseDifference(tcpPose(chain, q, T), T_base_goal, difference);
  const [x, y, z, rx, ry, rz] = difference;
  return { positionError: Math.sqrt(x * x + y * y + z * z), orientationError: Math.sqrt(rx * rx + ry * ry + rz * rz) };
}

/**
 * @param {Chain} chain
 * @param {ArrayLike<number>} T_base_goal
 * @param {Float64Array} q
 * @param {Tolerances} tolerances
 */
export function isWithin(chain, T_base_goal, q, { positionTolerance, orientationTolerance }) {
  const { positionError, orientationError } = errorsAt(chain, T_base_goal, q);
  return positionError <= positionTolerance && orientationError <= orientationTolerance;
}
