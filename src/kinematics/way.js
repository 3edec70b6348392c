/**
 * How far it is from posture to posture. Slides count in arm lengths, so that the answer is the same in every unit.
 * @import { Chain } from './chain.js'
 */
import { isSlide } from './limits.js';

const FULL_TURN = 2 * Math.PI;

/**
 * The way of one joint, full turns aside.
 * @param {Chain} chain
 * @param {number} i  the joint
 * @param {number} from
 * @param {number} to
 * @returns {number} radians or metres
 */
export function jointWay({ packed }, i, from, to) {
  const away = to - from;
  return isSlide(packed, i) ? away : away - FULL_TURN * Math.round(away / FULL_TURN);
}

/**
 * How far two postures are from being the same, full turns aside: the largest joint's way, in radians or arm lengths.
 * @param {Chain} chain
 * @param {ArrayLike<number>} a
 * @param {ArrayLike<number>} b
 */
export function wayBetween({ packed, dof, characteristicLength }, a, b) {
  let most = 0;
  for (let i = 0; i < dof; i++) {
    const away = b[i] - a[i];
    const way = isSlide(packed, i) ? away / characteristicLength : away - FULL_TURN * Math.round(away / FULL_TURN);
    most = Math.max(most, Math.abs(way));
  }
  return most;
}

/**
 * How far the joints have to go from one posture to another: the root of the sum of squares of radians and arm lengths.
 * @param {Chain} chain
 * @param {ArrayLike<number>} from
 * @param {ArrayLike<number>} to
 */
export function wayFrom({ packed, dof, characteristicLength }, from, to) {
  let squares = 0;
  for (let i = 0; i < dof; i++) {
    const way = (to[i] - from[i]) / (isSlide(packed, i) ? characteristicLength : 1);
    squares += way * way;
  }
  return Math.sqrt(squares);
}
