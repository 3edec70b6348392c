/**
 * A robot of ours as frames and axes, for formats that know no table. In them a joint moves its link about the z of a frame that
 * stands still in the link before, so that each row's constant part goes where the next joint is; nothing is rounded.
 *
 *   standard  A_i(q) = Z(q) · C_i  with  C_i = Rz(θ) Tz(d) Tx(a) Rx(α):  xyz = (a cos θ, a sin θ, d), rpy = (α, 0, θ)
 *   modified  A_i(q) = C_i · Z(q)  with  C_i = Rx(α) Tx(a) Tz(d) Rz(θ)
 *
 * @import { Pose } from '../kinematics/pose.js'
 * @import { Convention, RobotDoc, Units } from '../model/document.js'
 *
 * @typedef {{ readonly theta: number, readonly d: number, readonly a: number, readonly alpha: number }} Row
 */
import { exactCosine, exactSine } from '../kinematics/angles.js';
import { compose, identity } from '../kinematics/pose.js';
import { compilePose } from '../model/compile.js';
import { toKernel } from '../model/units.js';

/**
 * The constant part of a row.
 * @param {Row} row
 * @param {{ readonly convention: Convention, readonly units: Units }} of
 * @returns {Pose}
 */
export function constantOf(row, { convention, units }) {
  const [theta, alpha] = [row.theta, row.alpha].map((value) => toKernel('angle', value, units));
  const [d, a] = [row.d, row.a].map((value) => toKernel('length', value, units));
  const [ct, st, ca, sa] = [exactCosine(theta), exactSine(theta), exactCosine(alpha), exactSine(alpha)];
  return convention === 'standard'
    ? Float64Array.of(ct, st, 0, 0, -st * ca, ct * ca, sa, 0, st * sa, -ct * sa, ca, 0, a * ct, a * st, d, 1)
    : Float64Array.of(ct, ca * st, sa * st, 0, -st, ca * ct, sa * ct, 0, 0, -sa, ca, 0, a, -sa * d, ca * d, 1);
}

/**
 * @param {RobotDoc} robot
 * @returns {{ T_parent_joints: Pose[], T_last_flange: Pose, T_flange_tool: Pose }} the first parent is the world; a link's frame
 *   is that of its joint
 */
export function armFrames(robot) {
  const { joints, units, convention, base, tool } = robot;
  /** What stands between the joint before and the next. */
  let between = compilePose(base, units);
  const T_parent_joints = [];
  for (const joint of joints) {
    const constant = constantOf(joint, robot);
    T_parent_joints.push(convention === 'standard' ? between : compose(between, constant));
    between = convention === 'standard' ? constant : identity();
  }
  return { T_parent_joints, T_last_flange: between, T_flange_tool: compilePose(tool, units) };
}
