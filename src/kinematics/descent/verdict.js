/**
 * Why not: what can be said for certain about a goal that was not met.
 *
 * @import { Chain } from '../chain.js'
 *
 * @typedef {object} LimitVerdict   the joint that would have to go farthest past its limit
 * @property {number} joint   from 0
 * @property {number} by      radians or metres
 * @property {'lower' | 'upper'} bound
 *
 * @typedef {LimitVerdict & { weight: number }} Excess   weight: `by` in radians, or in characteristic lengths
 */
import { excessOf, isSlide } from '../limits.js';

/** Rounding of a product of frames is some 1e-15 of the numbers in it: three decades of room. */
const ROUNDING = 1e-12;

/** @param {Chain} chain @param {ArrayLike<number>} T_base_goal */
export function distanceFromShoulder({ shoulder }, T_base_goal) {
  const x = T_base_goal[12] - shoulder[0];
  const y = T_base_goal[13] - shoulder[1];
  const z = T_base_goal[14] - shoulder[2];
  return Math.sqrt(x * x + y * y + z * z);
}

/**
 * How far a goal is beyond what any posture could reach; 0 unless that is certain.
 * @param {Chain} chain
 * @param {ArrayLike<number>} T_base_goal
 * @param {number} positionTolerance
 */
export function beyondReach(chain, T_base_goal, positionTolerance) {
  const { shoulder, reach } = chain;
  const beyond = distanceFromShoulder(chain, T_base_goal) - reach;
  const far = Math.hypot(T_base_goal[12], T_base_goal[13], T_base_goal[14]);
  const doubt = positionTolerance + ROUNDING * (reach + far + Math.hypot(shoulder[0], shoulder[1], shoulder[2]));
  return beyond > doubt ? beyond : 0;
}

/**
 * What keeps a posture that was found without the limits from being an answer: the joint that is farthest past its own.
 * @param {Chain} chain
 * @param {ArrayLike<number>} q
 * @returns {Excess}
 */
export function worstExcess({ packed, characteristicLength, dof }, q) {
  /** @type {Excess} */
  let worst = { joint: 0, by: 0, bound: 'upper', weight: 0 };
  for (let joint = 0; joint < dof; joint++) {
    const { by, bound } = excessOf(packed, joint, q[joint]);
    const weight = by / (isSlide(packed, joint) ? characteristicLength : 1);
    if (weight > worst.weight) worst = { joint, by, bound, weight };
  }
  return worst;
}

/**
 * Of several postures, what keeps the one that is least outside from being an answer.
 * @param {Chain} chain
 * @param {readonly ArrayLike<number>[]} postures
 * @returns {Excess | null} null if there is no posture
 */
export function leastExcess(chain, postures) {
  /** @type {Excess | null} */
  let least = null;
  for (const q of postures) {
    const excess = worstExcess(chain, q);
    if (!least || excess.weight < least.weight) least = excess;
  }
  return least;
}

/** Whether the limits keep any joint from anything: not if every joint turns, and a full turn or more. @param {Chain} chain */
export const limitsBind = ({ joints }) =>
  joints.some(({ type, lower, upper }) =>
    type === 'prismatic' ? lower > -Infinity || upper < Infinity : upper - lower < 2 * Math.PI,
  );
