/**
 * The targets of moves as controllers want them: joint values as well as a position with its configuration, or why it has none.
 *
 * @import { RobotDoc, StepTarget } from '../document.js'
 * @import { FollowedMove } from './followMoves.js'
 * @import { NeutralTarget } from '../../karel/write/neutral.js'
 * @import { Chain } from '../../kinematics/chain.js'
 *
 * @typedef {object} Surroundings   of a target
 * @property {RobotDoc} robot
 * @property {Chain} chain                  with the move's tool
 * @property {Float64Array} T_user_world
 * @property {'fanuc' | 'kuka'} brand       whose reasons are told
 */
import { dexterity } from '../../kinematics/dexterity.js';
import { tcpPose } from '../../kinematics/forward.js';
import { rollPitchYawOf } from '../../kinematics/orientation.js';
import { compose, poseDifference } from '../../kinematics/pose.js';
import { configurationAt } from '../aim/solutions.js';
import { compilePosture, postureFromKernel } from '../compile.js';
import { fromKernel } from '../units.js';
import { valuesBeside } from './besideSingular.js';
import { postureAlong } from './followMoves.js';
import { fanucTurns, haveSameTurns, kukaTurns } from './fullTurns.js';
import { valuesInside } from './insideLimits.js';

const CONTROLLER_UNITS = /** @type {const} */ ({ length: 'mm', angle: 'deg' });

/** One over the condition number, below which the decimals of a position cost the way to it more than those of joint values (decimalsCost.js). */
const SINGULAR = 0.02;

/** Degrees: an axis nearer than this to where its turn gets another number may be on either side of it, by the decimals of a position. */
const BORDER = 0.05;
const FANUC_TURN_AXES = [0, 3, 5];

const REASONS = {
  turns: 'an axis is turned so far there that its configuration does not tell by how much',
  border: 'an axis is there where its turn gets another number, and decimals leave open on which side',
  singular: 'the posture there is singular, or so nearly that the decimals of a position leave its joints open',
  'not-six-axes': 'configurations are for arms with six axes',
  prismatic: 'configurations are for arms whose axes all turn',
  'no-spherical-wrist': 'configurations are for arms whose last three axes meet',
  'no-shoulder': 'the first two axes are parallel, and the arm has no shoulder that a configuration could name',
  'no-elbow': 'the arm has no elbow that a configuration could name',
};

/** rad: a taught point on the way that is turned so little from the way itself is written as it was taught. */
const AS_TAUGHT = 1e-4;

/** Joint values as they were taught, if they were. @param {StepTarget} target */
export const taughtValues = (target) => (target.kind === 'posture' ? target.values : null);

/** x y z w p r in mm and degrees. @param {Float64Array} T */
export const controllerPosition = (T) => [
  ...[T[12], T[13], T[14]].map((value) => fromKernel('length', value, CONTROLLER_UNITS)),
  ...rollPitchYawOf(T).map((value) => fromKernel('angle', value, CONTROLLER_UNITS)),
];

/**
 * @param {Surroundings} surroundings
 * @param {Float64Array} q
 * @param {Float64Array} T_world_tcp
 * @param {{ taught: readonly number[] | null, isByJoints: boolean }} how  isByJoints: the move, so that which posture it ends
 *   in is not known from where it comes
 * @returns {NeutralTarget}
 */
export function targetAt({ robot, chain, T_user_world, brand }, q, T_world_tcp, { taught, isByJoints }) {
  const position = controllerPosition(compose(T_user_world, T_world_tcp));
  const posture = taught ?? postureFromKernel(robot, q);
  const joints = valuesBeside(robot, chain, compilePosture(robot, posture), valuesInside(robot, [...posture]));
  const { fanuc, kuka } = configurationAt(robot, chain, posture);
  const isSingular = isByJoints && 1 / dexterity(chain, q).conditionNumber < SINGULAR;
  if (isSingular && !taught && fanuc.text !== null)
    return { joints, position, fanuc: null, kuka: null, isJoint: false, reason: REASONS.singular };
  const onBorder = {
    fanuc: isByJoints && FANUC_TURN_AXES.some((axis) => isNear(joints[axis], 180)),
    kuka: isByJoints && joints.some((value) => isNear(value, 0)),
  };
  const isTold = (/** @type {readonly number[]} */ read) => !isByJoints || haveSameTurns(robot, posture, read);
  const told = {
    fanuc: fanuc.text === null || isTold(fanucTurns(robot, posture, turnsOf(fanuc.text))),
    kuka: kuka.turn === null || isTold(kukaTurns(robot, posture, kuka.turn)),
  };
  return {
    ...{ joints, position },
    fanuc: onBorder.fanuc || !told.fanuc ? null : fanuc.text,
    kuka: onBorder.kuka || !told.kuka || kuka.status === null ? null : { status: kuka.status, turn: kuka.turn },
    isJoint: taught !== null,
    reason: REASONS[fanuc.reason ?? (onBorder[brand] || told[brand] ? 'border' : 'turns')],
  };
}

/** The turn numbers behind the letters of a configuration. @param {string} text */
const turnsOf = (text) => text.split(',').slice(1).map(Number);

/**
 * The point that an arc passes, turned as the tool is there. Only its place makes the arc; with an orientation of its own, a
 * controller that heeds it would turn the tool otherwise than it was planned and verified.
 * @param {Surroundings} surroundings
 * @param {FollowedMove} followed
 * @param {Float64Array} T_world_via
 * @param {readonly number[] | null} taught
 * @returns {NeutralTarget}
 */
export function viaAt(surroundings, { path, way }, T_world_via, taught) {
  const q = postureAlong(path, way?.viaShare ?? 0);
  const T = tcpPose(surroundings.chain, q);
  T.set(T_world_via.subarray(12, 15), 12);
  const isAsTaught = Math.hypot(...poseDifference(T, T_world_via).subarray(3)) < AS_TAUGHT;
  return targetAt(surroundings, q, T, { taught: isAsTaught ? taught : null, isByJoints: false });
}

/** Whole turns aside. @param {number} value  degrees @param {number} border */
const isNear = (value, border) => Math.abs(value - border - 360 * Math.round((value - border) / 360)) < BORDER;
