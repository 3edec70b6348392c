/**
 * A posture that was found without regard to limits or full turns, brought to where a person would write it down: inside the
 * limits where full turns can do that, as near as may be to a posture that is asked for, or else to zero.
 *
 * @import { Chain } from './chain.js'
 * @import { Packed } from './packed.js'
 *
 * @typedef {object} LimitMargin   the joint with the least room to its limits, as a share of its range
 * @property {number} joint  from 0
 * @property {number} room   radians or metres to the nearer limit; negative past it
 * @property {number} share  the same, over half the range: 1 in the middle, 0 at a limit, negative past it
 */
import { excessOf, isSlide } from './limits.js';

const FULL_TURN = 2 * Math.PI;

/** Past a limit by no more than this (radians, arm lengths) is at it: a solution has not more digits. */
const AT_LIMIT = 1e-10;

/**
 * @param {Packed} packed
 * @param {number} i
 * @param {number} value
 * @param {number} near   where, of all full turns that are allowed, the value should be
 * @param {number} slack  radians or metres past a limit that count as at it
 * @returns {number}
 */
function bestTurn(packed, i, value, near, slack) {
  const low = packed.lower[i];
  const high = packed.upper[i];
  const turned = isSlide(packed, i) ? value : value + FULL_TURN * Math.round((near - value) / FULL_TURN);
  if (turned >= low && turned <= high) return turned;
  if (excessOf(packed, i, value).by > slack) return turned;
  if (isSlide(packed, i)) return Math.min(high, Math.max(low, value));
  const most = Math.floor((high + slack - turned) / FULL_TURN);
  const least = Math.ceil((low - slack - turned) / FULL_TURN);
  return Math.min(high, Math.max(low, turned + FULL_TURN * Math.min(most, Math.max(least, 0))));
}

/**
 * @param {Chain} chain
 * @param {Float64Array} q  changed in place
 * @param {ArrayLike<number>} [near]
 * @returns {boolean} whether it is inside the limits
 */
export function writeBestTurns({ packed, dof, characteristicLength }, q, near) {
  let isInside = true;
  for (let i = 0; i < dof; i++) {
    const slack = AT_LIMIT * (isSlide(packed, i) ? characteristicLength : 1);
    q[i] = bestTurn(packed, i, q[i], near?.[i] ?? 0, slack);
    if (!(q[i] >= packed.lower[i] && q[i] <= packed.upper[i])) isInside = false;
  }
  return isInside;
}

/**
 * @param {Chain} chain
 * @param {ArrayLike<number>} q
 * @returns {LimitMargin | null} null if no joint has two limits
 */
export function limitMarginOf({ packed, dof }, q) {
  /** @type {LimitMargin | null} */
  let least = null;
  for (let joint = 0; joint < dof; joint++) {
    const [low, high] = [packed.lower[joint], packed.upper[joint]];
    if (low === -Infinity || high === Infinity) continue;
    const room = Math.min(q[joint] - low, high - q[joint]);
    const share = high > low ? room / ((high - low) / 2) : Math.min(room, 0);
    if (!least || share < least.share) least = { joint, room, share };
  }
  return least;
}
