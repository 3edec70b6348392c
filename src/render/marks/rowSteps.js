/**
 * A row of the table carried out: the poses that frame i−1 passes through on its way to frame i.
 *
 * @import { Motion } from '../../model/robot/rowMotions.js'
 * @import { Chain } from '../../kinematics/chain.js'
 * @import { Pose } from '../../kinematics/pose.js'
 *
 * @typedef {object} Passage
 * @property {number} constant   what the row says, metres or radians
 * @property {number} value      with the joint value, where the motion is the joint's
 * @property {boolean} isVariable
 * @property {Pose} before       the moving frame in the world
 * @property {Pose} after
 *
 * @typedef {Motion & Passage} RowStep
 */
import { poseFromRollPitchYaw } from '../../kinematics/orientation.js';
import { compose, translation } from '../../kinematics/pose.js';
import { ROW_MOTIONS } from '../../model/robot/rowMotions.js';

/**
 * @param {Chain} chain
 * @param {Float64Array} frames  of linkFrames
 * @param {ArrayLike<number>} q
 * @param {number} index         of the joint
 * @returns {RowStep[]} four, in the order of the convention
 */
export function rowSteps(chain, frames, q, index) {
  const joint = chain.joints[index];
  /** @type {Pose} */
  let before = frames.slice(16 * index, 16 * index + 16);
  return ROW_MOTIONS[chain.convention].map((motion) => {
    const constant = joint[motion.field];
    const isVariable = motion.field === (joint.type === 'prismatic' ? 'd' : 'theta');
    const value = isVariable ? constant + q[index] : constant;
    const step = { ...motion, constant, value, isVariable, before, after: carried(before, motion, value) };
    before = step.after;
    return step;
  });
}

/**
 * A frame moved along, or turned about, one of its own axes.
 * @param {Pose} T
 * @param {Motion} motion
 * @param {number} amount
 * @returns {Pose}
 */
export function carried(T, { turns, axis }, amount) {
  const along = axis === 'x' ? [amount, 0, 0] : [0, 0, amount];
  return compose(T, turns ? poseFromRollPitchYaw([0, 0, 0], along) : translation(along));
}
