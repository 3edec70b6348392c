/**
 * What inverse kinematics answered, in a sentence with numbers, and how far the tool is from the target.
 *
 * @import { RobotDoc } from '../model/document.js'
 * @import { AimAnswer } from '../model/aim.js'
 */
import { poseDifference } from '../kinematics/pose.js';
import { fromKernel } from '../model/units.js';
import { jointNumber, poseNumber, unitOf, withUnit } from './format.js';
import { quantityOf } from '../model/document.js';
import { TEXT } from './strings.js';

/** @param {RobotDoc} robot @param {number} metres */
const length = ({ units }, metres) =>
  withUnit(poseNumber(fromKernel('length', metres, units), units.length), units.length);

/** @param {RobotDoc} robot @param {number} radians */
const angle = ({ units }, radians) =>
  withUnit(poseNumber(fromKernel('angle', radians, units), units.angle), units.angle);

/**
 * @param {RobotDoc} robot
 * @param {AimAnswer} answer
 * @returns {string}
 */
export function verdictInWords(robot, { result }) {
  const distance = length(robot, result.positionError);
  const turn = angle(robot, result.orientationError);
  switch (result.status) {
    case 'converged':
      return TEXT.aim.reached(distance, turn);
    case 'subspace':
      return TEXT.aim.subspace(TEXT.verdict.task[result.task.name](turn));
    case 'unreachable':
      return TEXT.verdict.unreachable(length(robot, result.beyond));
    case 'outside-limits': {
      const { joint, by } = result.limit;
      const unit = unitOf(robot.joints[joint], robot.units);
      const past = fromKernel(quantityOf(robot.joints[joint], 'home'), by, robot.units);
      return TEXT.verdict.outsideLimits(`J${joint + 1}`, withUnit(jointNumber(past, unit), unit));
    }
    case 'stalled':
    case 'budget':
      return robot.joints.length < 6
        ? TEXT.verdict.fewJoints(robot.joints.length, distance, turn)
        : TEXT.verdict.notFound(distance, turn);
    default: {
      /** @type {never} */
      const unknown = result;
      throw new TypeError(`Unknown answer: ${JSON.stringify(unknown)}`);
    }
  }
}

/** Nearer than this the screen shows zeros: the tool counts as being there. */
const THERE_METRES = 5e-6;
const THERE_RADIANS = 8e-5;

/**
 * @param {RobotDoc} robot
 * @param {Float64Array} T_base_tcp
 * @param {Float64Array} T_base_target
 * @param {boolean} isAsked    whether someone aims, or the target follows the tool
 * @param {AimAnswer | null} answer
 * @returns {{ text: string, tone: 'quiet' | 'good' | 'bad', isThere: boolean }}
 */
export function differenceInWords(robot, T_base_tcp, T_base_target, isAsked, answer) {
  const difference = poseDifference(T_base_tcp, T_base_target);
  const metres = Math.hypot(difference[0], difference[1], difference[2]);
  const radians = Math.hypot(difference[3], difference[4], difference[5]);
  const isThere = metres < THERE_METRES && radians < THERE_RADIANS;
  if (!isAsked) return { text: TEXT.aim.following, tone: 'quiet', isThere };
  if (isThere) return { text: TEXT.aim.reached(length(robot, metres), angle(robot, radians)), tone: 'good', isThere };
  if (answer && !answer.isMet) return { text: verdictInWords(robot, answer), tone: 'bad', isThere };
  const stillMet = answer?.status === 'subspace' && metres < THERE_METRES;
  if (answer && stillMet) return { text: verdictInWords(robot, answer), tone: 'good', isThere };
  return { text: TEXT.aim.toGo(length(robot, metres), angle(robot, radians)), tone: 'quiet', isThere };
}
