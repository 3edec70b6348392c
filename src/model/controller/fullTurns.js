/**
 * Which full turns a configuration means: turn numbers of FANUC, the bits of KUKA's T. An axis that neither counts is taken to be as
 * near to zero as its limits let it.
 *
 * @import { JointDoc, RobotDoc } from '../document.js'
 */
import { isSliding, limitsOf } from '../document.js';
import { convertAngle } from '../units.js';
import { pendantValues } from './controllerValues.js';
import { postureFromPendant } from './pendantNumbers.js';

/** Which axes the turn numbers of a FANUC configuration count, from 0. */
const TURN_AXES = [0, 3, 5];
const FULL_TURN = 360;

/** Past a limit by this it is at the limit, and decimals put it there; degrees. */
const LITTLE = 0.05;

/** How far a posture may be off and be the one that is meant: far less than a turn. Degrees. */
const SAME = 1;

/** A value without its full turns, in degrees. @param {number} value */
const within = (value) => value - FULL_TURN * Math.round(value / FULL_TURN);

/**
 * @param {RobotDoc} robot
 * @param {readonly number[]} posture
 * @param {readonly number[]} turns   of the axes that are counted
 * @returns {number[]} the same posture with as many full turns as are meant
 */
export function fanucTurns(robot, posture, turns) {
  const whole = convertAngle(FULL_TURN, 'deg', robot.units.angle);
  const little = convertAngle(LITTLE, 'deg', robot.units.angle);
  const uncounted = posture.map((value, i) => {
    const joint = robot.joints[i];
    return TURN_AXES.includes(i) || isSliding(joint) ? value : nearZero(joint, value, whole, little);
  });
  const pendant = pendantValues(robot, uncounted).map((value, i) => {
    const counted = TURN_AXES.indexOf(i);
    return counted < 0 ? value : within(value) + FULL_TURN * turns[counted];
  });
  return postureFromPendant(robot, pendant);
}

/**
 * @param {RobotDoc} robot
 * @param {readonly number[]} posture
 * @param {number} turn   bit by bit which axes are below zero
 */
export function kukaTurns(robot, posture, turn) {
  const pendant = pendantValues(robot, posture).map((value, i) => {
    const isNegative = ((turn >> i) & 1) === 1;
    const least = within(value);
    return least < 0 === isNegative || least === 0 ? least : least + (isNegative ? -FULL_TURN : FULL_TURN);
  });
  return postureFromPendant(robot, pendant);
}

/** Whether two postures have the same turns. @param {RobotDoc} robot @param {readonly number[]} one @param {readonly number[]} other */
export const haveSameTurns = ({ joints, units }, one, other) =>
  joints.every((joint, i) => isSliding(joint) || Math.abs(convertAngle(one[i] - other[i], units.angle, 'deg')) < SAME);

/** @param {JointDoc} joint @param {number} value @param {number} whole  turn @param {number} little  in units of the document, too */
function nearZero(joint, value, whole, little) {
  const { lower, upper } = limitsOf(joint);
  const least = value - whole * Math.round(value / whole);
  const past = (/** @type {number} */ one) => Math.max(0, lower - little - one, one - upper - little);
  return [least - whole, least + whole].reduce((best, one) => (past(one) < past(best) ? one : best), least);
}
