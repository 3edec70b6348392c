/**
 * Which way the tool cannot go, or hardly, where the arm is at a singularity: what is drawn as a double arrow and said in a
 * line.
 *
 * @import { Chain } from '../../kinematics/chain.js'
 *
 * @typedef {object} LostDirection
 * @property {readonly number[] | null} along  unit vector, base axes; null if the lost motion is a turn alone
 * @property {readonly number[] | null} about  likewise, if it is no turn
 */
import { freedomsOf, ownPart } from '../../kinematics/measures/homogeneous.js';
import { lostMotion } from '../../kinematics/singularity.js';

/** Joint rates of norm 1 make so little of the twist, in homogeneous scale: the arm stands next to a singularity. */
const NEAR = 0.02;

/** A part of the motion that is less than this share of it is nothing to be drawn. */
const FAINT = 0.02;

/**
 * @param {Chain} chain
 * @param {ArrayLike<number>} q
 * @param {boolean} isStopped  a singularity is in the way already, be it ever so far by this measure
 * @returns {LostDirection | null} null where nothing is lost
 */
export function lostDirectionAt(chain, q, isStopped) {
  const part = ownPart(chain);
  if (freedomsOf(chain)[part] === 0) return null;
  const { linear, angular, singularValue, lengthScale } = lostMotion(chain, q, { part });
  if (!isStopped && singularValue > NEAR) return null;
  const unit = (/** @type {readonly number[]} */ vector, /** @type {number} */ scale) => {
    const length = Math.hypot(...vector);
    return length / scale < FAINT ? null : vector.map((value) => value / length);
  };
  return { along: unit(linear, lengthScale), about: unit(angular, 1) };
}
