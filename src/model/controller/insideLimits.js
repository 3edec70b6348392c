/**
 * Joint values as code has them: with a controller's decimals, which may put one that stands at its limit past it. There the last
 * decimal goes the other way.
 *
 * @import { RobotDoc } from '../document.js'
 */
import { DECIMALS, rounded } from '../../karel/write/neutral.js';
import { limitsOf } from '../document.js';
import { pendantValues } from './controllerValues.js';
import { postureFromPendant } from './pendantNumbers.js';

/** Of the last decimal. */
const STEP = 10 ** -DECIMALS;

/**
 * The pendant's values of a posture; where rounding alone would put a joint past its limit, a value that is rounded to the inside.
 * @param {RobotDoc} robot
 * @param {readonly number[]} posture  in the document's units
 */
export function valuesInside(robot, posture) {
  const values = pendantValues(robot, posture);
  const isOutside = posture.map((value, i) => sideOfLimits(robot, i, value) !== 0);
  // a joint that is coupled to one that was changed is looked at again
  for (let turn = 0; turn < 2 * values.length; turn++) {
    const there = postureFromPendant(
      robot,
      values.map((value) => Math.fround(rounded(value))),
    );
    const past = there.findIndex((value, i) => !isOutside[i] && sideOfLimits(robot, i, value) !== 0);
    if (past < 0) break;
    const back = -sideOfLimits(robot, past, there[past]) * robot.joints[past].controller.sign;
    values[past] = rounded(rounded(values[past]) + back * STEP);
  }
  return values;
}

/** 1: above its upper limit; −1: below its lower. @param {RobotDoc} robot @param {number} index @param {number} value */
export function sideOfLimits({ joints }, index, value) {
  const { lower, upper } = limitsOf(joints[index]);
  return value > upper ? 1 : value < lower ? -1 : 0;
}
