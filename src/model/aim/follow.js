/**
 * The arm follows a pose that moves: what a drag of the tool asks at every frame. Pose in, posture in the document's own
 * numbers out, and what stands in the way. Between two frames of a drag the joint values stay as the kernel found them, so
 * that nothing is lost by writing them in degrees.
 *
 *     let following = startFollowing(doc, chain, keepsLimits);
 *     following = followTo(following, T_world_goal);      // at every frame, until `isOnItsWay` is false
 *     store.dispatch({ type: 'set-posture', posture: following.posture, gesture });
 *
 * @import { Doc, RobotDoc } from '../document.js'
 * @import { Chain } from '../../kinematics/chain.js'
 * @import { Followed } from '../../kinematics/follow.js'
 *
 * @typedef {object} Following
 * @property {RobotDoc} robot
 * @property {Chain} chain       with the limits that hold during this drag
 * @property {Float64Array} q
 * @property {Followed['bent']} bent
 * @property {readonly number[]} posture  q in document units
 * @property {Followed | null} answer     null before the first step
 * @property {number} fastest    the joint that turned or slid farthest in the last step
 *
 * @typedef {object} Hindrance   why the tool is not where it is wanted
 * @property {'limit' | 'reach' | 'orientation' | 'singularity' | 'part'} kind
 *   part: an arm with few joints has met of the pose what it can
 * @property {number | null} joint  the one at its limit, or the one that turns fast
 * @property {number} metres        from the wanted place
 * @property {number} radians       from the wanted orientation
 */
import { followPose } from '../../kinematics/follow.js';
import { limitsOf } from '../document.js';
import { compilePosture, compileRobot, postureFromKernel } from '../compile.js';

/** The farthest that a joint goes in one frame: radians, or characteristic lengths of a slide. */
export const MOST_STEP = 0.25;

/** Nearer than this nothing is said to be missing. */
const NOTHING = { metres: 1e-5, radians: 1e-4 };

/**
 * A joint that stands outside its limits is not thrown back inside by a drag; it goes no farther out than it stands. Where
 * limits are not kept there are none.
 * @param {RobotDoc} robot
 * @param {readonly number[]} posture
 * @param {boolean} keepsLimits
 * @returns {RobotDoc} the same if it can be followed as it is
 */
function withRoom(robot, posture, keepsLimits) {
  const joints = robot.joints.map((joint, i) => {
    const { lower, upper } = limitsOf(joint);
    if (lower === -Infinity && upper === Infinity) return joint;
    if (!keepsLimits) return { ...joint, lower: undefined, upper: undefined };
    if (posture[i] >= lower && posture[i] <= upper) return joint;
    return { ...joint, lower: Math.min(lower, posture[i]), upper: Math.max(upper, posture[i]) };
  });
  return joints.every((joint, i) => joint === robot.joints[i]) ? robot : { ...robot, joints };
}

/**
 * @param {Pick<Doc, 'robot' | 'posture'>} doc
 * @param {Chain} chain  compiled from `doc.robot`
 * @param {boolean} keepsLimits
 * @returns {Following}
 */
export function startFollowing({ robot, posture }, chain, keepsLimits) {
  const roomy = withRoom(robot, posture, keepsLimits);
  const q = compilePosture(robot, posture);
  return {
    robot,
    chain: roomy === robot ? chain : compileRobot(roomy),
    q,
    bent: null,
    posture,
    answer: null,
    fastest: 0,
  };
}

/**
 * One frame towards the goal.
 * @param {Following} following
 * @param {ArrayLike<number>} T_world_goal
 * @returns {Following}
 */
export function followTo(following, T_world_goal) {
  const { robot, chain, q, bent, posture } = following;
  const answer = followPose(chain, { q, bent }, T_world_goal, { mostStep: MOST_STEP });
  const values = postureFromKernel(robot, answer.q);
  let fastest = 0;
  const way = (/** @type {number} */ i) => Math.abs(answer.q[i] - q[i]);
  for (let i = 1; i < q.length; i++) if (way(i) > way(fastest)) fastest = i;
  return {
    ...following,
    q: answer.q,
    bent: answer.bent,
    // a joint that has not moved keeps its number to the last digit
    posture: values.map((value, i) => (answer.q[i] === q[i] ? posture[i] : value)),
    answer,
    fastest,
  };
}

/** Whether another frame will bring it nearer, with the goal where it is. @param {Following} following */
export const isOnItsWay = ({ answer }) => answer?.status === 'behind' || answer?.status === 'singularity';

/** Whether the goal is met, as far as the arm is asked to. @param {Following} following */
export const isThere = ({ answer }) => answer?.status === 'there';

/**
 * @param {Following} following
 * @returns {Hindrance | null} null if the tool is there, or will be
 */
export function hindranceOf({ answer, fastest }) {
  if (!answer || answer.status === 'behind') return null;
  const { status, joint = null, positionError: metres, orientationError: radians } = answer;
  if (status === 'there') {
    const isWhole = metres <= NOTHING.metres && radians <= NOTHING.radians;
    return isWhole ? null : { kind: 'part', joint: null, metres, radians };
  }
  return { kind: status, joint: status === 'singularity' ? fastest : joint, metres, radians };
}
