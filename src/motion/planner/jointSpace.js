/**
 * The space in which a way around obstacles is looked for: one axis a joint, within its limits. How far two postures are apart is the
 * root of the squares of the angles, a slide's way counting by the arm's characteristic length as everywhere else.
 *
 * @import { Chain } from '../../kinematics/chain.js'
 *
 * @typedef {object} JointSpace
 * @property {number} dof
 * @property {Float64Array} lower   of what is searched: the limits, or where there are none half a turn beyond both ends
 * @property {Float64Array} upper
 * @property {Float64Array} weights  1 for a turn, 1 / characteristic length for a slide
 */

/** Beyond both ends an unlimited joint is searched this far: rad, and characteristic lengths. */
const BEYOND = Math.PI;

/**
 * @param {Chain} chain
 * @param {ArrayLike<number>} from
 * @param {ArrayLike<number>} to
 * @returns {JointSpace}
 */
export function jointSpace({ dof, joints, characteristicLength }, from, to) {
  const weights = Float64Array.from(joints, ({ type }) => (type === 'prismatic' ? 1 / characteristicLength : 1));
  const lower = Float64Array.from(joints, (joint, j) =>
    Math.max(joint.lower, Math.min(from[j], to[j]) - BEYOND / weights[j]),
  );
  const upper = Float64Array.from(joints, (joint, j) =>
    Math.min(joint.upper, Math.max(from[j], to[j]) + BEYOND / weights[j]),
  );
  for (let j = 0; j < dof; j++) {
    if (Number.isFinite(joints[j].lower)) lower[j] = joints[j].lower;
    if (Number.isFinite(joints[j].upper)) upper[j] = joints[j].upper;
  }
  return { dof, lower, upper, weights };
}

/** @param {JointSpace} space @param {ArrayLike<number>} one @param {ArrayLike<number>} other */
export function apart({ dof, weights }, one, other) {
  let sum = 0;
  for (let j = 0; j < dof; j++) {
    const way = weights[j] * (one[j] - other[j]);
    sum += way * way;
  }
  return Math.sqrt(sum);
}

/** The length of a way through postures. @param {JointSpace} space @param {readonly ArrayLike<number>[]} way */
export const lengthOf = (space, way) =>
  way.slice(1).reduce((sum, posture, i) => sum + apart(space, way[i], posture), 0);

/**
 * So much of the way from one posture to another.
 * @param {ArrayLike<number>} from
 * @param {ArrayLike<number>} to
 * @param {number} share
 */
export function between(from, to, share) {
  const posture = new Float64Array(to.length);
  for (let j = 0; j < posture.length; j++) posture[j] = from[j] + share * (to[j] - from[j]);
  return posture;
}
