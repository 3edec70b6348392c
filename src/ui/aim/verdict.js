/**
 * What inverse kinematics answered, in a sentence with numbers, and how far the tool is from the target.
 *
 * @import { RobotDoc } from '../../model/document.js'
 * @import { AimAnswer } from '../../model/aim/aim.js'
 */
import { gapBetween, isAtAnswer } from '../../model/aim/aim.js';
import { fromKernel } from '../../model/units.js';
import { jointNumber, poseNumber, unitOf, withUnit } from '../parts/format.js';
import { quantityOf } from '../../model/document.js';
import { TEXT } from '../strings.js';

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
  const { status, task, limit } = result;
  switch (status) {
    case 'converged':
      return TEXT.aim.reached(distance, turn);
    case 'subspace':
      return TEXT.aim.subspace(TEXT.verdict.task[task?.name ?? 'position'](turn));
    case 'unreachable':
      return unreachableInWords(robot, result);
    case 'outside-limits':
      return limit ? limitInWords(robot, limit) : TEXT.verdict.notFound(distance, turn);
    case 'stalled':
    case 'budget':
      return robot.joints.length < 6
        ? TEXT.verdict.fewJoints(robot.joints.length, distance, turn)
        : TEXT.verdict.notFound(distance, turn);
    default: {
      /** @type {never} */
      const unknown = status;
      throw new TypeError(`Unknown status: ${unknown}`);
    }
  }
}

/** @param {RobotDoc} robot @param {AimAnswer['result']} result */
function unreachableInWords(robot, { reason, beyondReach, shortBy, positionError }) {
  if (reason === 'orientation') return TEXT.verdict.orientation;
  if (beyondReach !== undefined) return TEXT.verdict.beyond(length(robot, beyondReach));
  return TEXT.verdict.distance(length(robot, shortBy ?? positionError));
}

/** @param {RobotDoc} robot @param {{ joint: number, by: number }} limit */
function limitInWords({ joints, units }, { joint, by }) {
  const past = fromKernel(quantityOf(joints[joint], 'home'), by, units);
  const unit = unitOf(joints[joint], units);
  return TEXT.verdict.outsideLimits(`J${joint + 1}`, withUnit(jointNumber(past, unit), unit));
}

/**
 * @param {RobotDoc} robot
 * @param {Float64Array} T_world_tcp
 * @param {Float64Array} T_world_target
 * @param {boolean} isAsked    whether someone aims, or the target follows the tool
 * @param {AimAnswer | null} answer
 * @param {readonly number[]} posture
 * @returns {{ text: string, tone: 'quiet' | 'good' | 'part' | 'bad', isThere: boolean }}
 */
export function differenceInWords(robot, T_world_tcp, T_world_target, isAsked, answer, posture) {
  const { metres, radians, isHere, isClosed: isThere } = gapBetween(T_world_tcp, T_world_target);
  if (!isAsked) return { text: TEXT.aim.following, tone: 'quiet', isThere };
  if (isThere) return { text: TEXT.aim.reached(length(robot, metres), angle(robot, radians)), tone: 'good', isThere };
  if (answer && !answer.isMet) {
    const stands = TEXT.aim.asNear(length(robot, metres), angle(robot, radians));
    const isNearest = isAtAnswer(answer, posture);
    return {
      text: [verdictInWords(robot, answer), isNearest && stands].filter(Boolean).join(' '),
      tone: 'bad',
      isThere,
    };
  }
  if (answer?.status === 'subspace' && isHere) return { text: verdictInWords(robot, answer), tone: 'part', isThere };
  return { text: TEXT.aim.toGo(length(robot, metres), angle(robot, radians)), tone: 'quiet', isThere };
}
