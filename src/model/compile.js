/**
 * Document → kernel: the one place where the document's units become metres and radians. Nothing flows back.
 *
 * @import { JointDoc, PoseDoc, RobotDoc, Units } from './document.js'
 * @import { Chain } from '../kinematics/chain.js'
 */
import { createChain } from '../kinematics/chain.js';
import { poseFromRollPitchYaw } from '../kinematics/orientation.js';
import { poseFromQuaternion } from '../kinematics/orientations/quaternion.js';
import { isSliding, limitsOf, quantityOf } from './document.js';
import { fromKernel, toKernel } from './units.js';

/**
 * @param {RobotDoc} robot
 * @returns {Chain} base and tool included
 */
export function compileRobot({ convention, base, tool, joints, units }) {
  return createChain({
    convention,
    base: compilePose(base, units),
    tool: compilePose(tool, units),
    joints: joints.map((joint) => compileJoint(joint, units)),
  });
}

/** @param {JointDoc} joint @param {Units} units */
function compileJoint(joint, units) {
  const { lower, upper } = limitsOf(joint);
  const limit = quantityOf(joint, 'lower');
  return {
    type: isSliding(joint) ? /** @type {const} */ ('prismatic') : /** @type {const} */ ('revolute'),
    theta: toKernel('angle', joint.theta, units),
    d: toKernel('length', joint.d, units),
    a: toKernel('length', joint.a, units),
    alpha: toKernel('angle', joint.alpha, units),
    lower: toKernel(limit, lower, units),
    upper: toKernel(limit, upper, units),
  };
}

/**
 * @param {PoseDoc} pose
 * @param {Units} units
 * @returns {Float64Array} column-major, metres
 */
export function compilePose({ xyz, rpy, quaternion }, units) {
  const position = xyz.map((value) => toKernel('length', value, units));
  if (quaternion) return poseFromQuaternion(position, quaternion);
  return poseFromRollPitchYaw(
    position,
    (rpy ?? [0, 0, 0]).map((value) => toKernel('angle', value, units)),
  );
}

/**
 * Joint values of the document → of the kernel.
 * @param {RobotDoc} robot
 * @param {readonly number[]} posture
 */
export const compilePosture = ({ joints, units }, posture) =>
  Float64Array.from(joints, (joint, i) => toKernel(quantityOf(joint, 'home'), posture[i], units));

/**
 * Joint values that the kernel found → of the document.
 * @param {RobotDoc} robot
 * @param {ArrayLike<number>} q
 */
export const postureFromKernel = ({ joints, units }, q) =>
  joints.map((joint, i) => fromKernel(quantityOf(joint, 'home'), q[i], units));

/**
 * How each joint's link is drawn, in metres.
 * @param {RobotDoc} robot
 */
export const compileLinkStyles = ({ joints, units }) =>
  joints.map(({ link: { kind, color, ...sizes } }) => ({
    kind,
    color,
    ...Object.fromEntries(Object.entries(sizes).map(([name, value]) => [name, toKernel('length', value, units)])),
  }));
