/**
 * Take the tool to a target: the document's numbers in, inverse kinematics asked, an answer in the document's numbers out.
 *
 * @import { Doc, RobotDoc } from '../document.js'
 * @import { Chain } from '../../kinematics/chain.js'
 * @import { InverseResult } from '../../kinematics/inverse.js'
 *
 * @typedef {object} AimAnswer
 * @property {InverseResult['status']} status
 * @property {readonly number[]} posture      best joint values found, in document units
 * @property {InverseResult} result           the kernel's own answer: errors, iterations, why not
 * @property {boolean} isMet                  whether the arm may go there: the full pose, or the task that is named
 */
import { rollPitchYawOf, poseFromRollPitchYaw } from '../../kinematics/orientation.js';
import { inverseKinematics } from '../../kinematics/inverse.js';
import { poseDifference } from '../../kinematics/pose.js';
import { compilePosture, postureFromKernel } from '../compile.js';
import { fromKernel, toKernel } from '../units.js';

/**
 * X Y Z W P R (FANUC: R = Rz(R)·Ry(P)·Rx(W)) of a document → a pose.
 * @param {RobotDoc} robot
 * @param {readonly number[]} values  3 lengths, 3 angles, in document units
 * @returns {Float64Array} column-major, metres
 */
export const poseFromXyzwpr = ({ units }, [x, y, z, w, p, r]) =>
  poseFromRollPitchYaw(
    [x, y, z].map((value) => toKernel('length', value, units)),
    [w, p, r].map((value) => toKernel('angle', value, units)),
  );

/**
 * @param {RobotDoc} robot
 * @param {Float64Array} T  column-major, metres
 * @returns {number[]} X Y Z W P R in document units
 */
export const xyzwprOf = ({ units }, T) => [
  ...[T[12], T[13], T[14]].map((value) => fromKernel('length', value, units)),
  ...rollPitchYawOf(T).map((value) => fromKernel('angle', value, units)),
];

/**
 * @param {Doc} doc      the present posture is the seed, so the answer is the nearest that the search finds
 * @param {Chain} chain  compiled from `doc.robot`
 * @param {Float64Array} T_world_target
 * @returns {AimAnswer}
 */
export function aim({ robot, posture }, chain, T_world_target) {
  const result = inverseKinematics(chain, T_world_target, { seed: compilePosture(robot, posture) });
  return {
    status: result.status,
    posture: postureFromKernel(robot, result.q),
    result,
    isMet: result.status === 'converged' || result.status === 'subspace',
  };
}

/** Nearer than this the screen shows zeros in every unit: the tool counts as being there. */
const CLOSED_METRES = 5e-6;
const CLOSED_RADIANS = 5e-5;

/**
 * How far it is from one pose to another.
 * @param {Float64Array} T_world_from
 * @param {Float64Array} T_world_to
 */
export function gapBetween(T_world_from, T_world_to) {
  const [x, y, z, rx, ry, rz] = poseDifference(T_world_from, T_world_to);
  const [metres, radians] = [Math.hypot(x, y, z), Math.hypot(rx, ry, rz)];
  return {
    metres,
    radians,
    isHere: metres < CLOSED_METRES,
    isClosed: metres < CLOSED_METRES && radians < CLOSED_RADIANS,
  };
}

/** Whether the arm stands at the best posture that the answer found. @param {AimAnswer} answer @param {readonly number[]} posture */
export const isAtAnswer = (answer, posture) => answer.posture.every((value, i) => value === posture[i]);
