/**
 * The target's numbers as they are in a frame, as a controller shows them in its user frame. The session keeps them in the world.
 *
 * @import { RobotDoc } from '../document.js'
 */
import { compose, invert } from '../../kinematics/pose.js';
import { poseFromXyzwpr, xyzwprOf } from './aim.js';

/** What carrying a pose from frame to frame leaves behind, in any unit, is cut off after so many decimals. */
const DECIMALS = 10;

/** @param {RobotDoc} robot @param {Float64Array} T */
const numbersOf = (robot, T) => xyzwprOf(robot, T).map((value) => Number(value.toFixed(DECIMALS)) + 0);

/**
 * @param {RobotDoc} robot
 * @param {Float64Array | null} T_world_from  null: the world itself
 * @param {readonly number[]} target  X Y Z W P R in the world
 * @returns {readonly number[]} likewise, seen from the frame
 */
export const targetSeenFrom = (robot, T_world_from, target) =>
  T_world_from ? numbersOf(robot, compose(invert(T_world_from), poseFromXyzwpr(robot, target))) : target;

/**
 * @param {RobotDoc} robot
 * @param {Float64Array | null} T_world_from
 * @param {readonly number[]} seen  X Y Z W P R in that frame
 * @returns {readonly number[]} in the world
 */
export const targetGivenIn = (robot, T_world_from, seen) =>
  T_world_from ? xyzwprOf(robot, compose(T_world_from, poseFromXyzwpr(robot, seen))) : seen;
