/**
 * A chain as the lines that its joints turn about or slide along while every joint value is zero, whatever table describes
 * it. By the product of exponentials (Brockett 1984) the TCP seen from `start` is
 *
 *   T(q) = E_1(q_1) · E_2(q_2) · … · E_n(q_n) · home
 *
 * with E_i(q) the turn by q about line i, or the slide by q along it. So a question about the geometry of an arm (do three
 * axes meet, are they parallel) is one about lines, and has the same answer for every table that means the same arm.
 *
 * Everything is seen from the chain's `start`, the frame that joint 1 moves in: line 1 is the z axis through the origin, and
 * where the arm stands does not matter.
 *
 * @import { Chain } from './chain.js'
 * @import { Pose } from './pose.js'
 *
 * @typedef {object} Screws
 * @property {number} dof
 * @property {readonly boolean[]} slides
 * @property {Float64Array} axes    3 · n: unit directions
 * @property {Float64Array} points  3 · n: a point on each line, m
 * @property {Pose} home    the TCP at q = 0
 * @property {number} length  the chain's characteristic length, m: what small distances are compared with
 */
import { writeFrames } from './frames.js';
import { compose, identity, invert } from './pose.js';

/** @param {Chain} chain @returns {Screws} */
export function screwsOf({ packed, dof, joints, characteristicLength }) {
  const frames = new Float64Array(16 * (dof + 1));
  const turns = new Float64Array(3 * dof);
  const options = { turns, isRelative: true, isAtJoints: false };
  writeFrames({ ...packed, start: identity() }, new Float64Array(dof), frames, options);
  const axes = new Float64Array(3 * dof);
  const points = new Float64Array(3 * dof);
  for (let i = 0; i < dof; i++) {
    axes.set(frames.subarray(16 * i + 8, 16 * i + 11), 3 * i);
    points.set(frames.subarray(16 * i + 12, 16 * i + 15), 3 * i);
  }
  return {
    dof,
    slides: joints.map(({ type }) => type === 'prismatic'),
    axes,
    points,
    home: compose(frames.subarray(16 * dof), packed.tool),
    length: characteristicLength,
  };
}

/**
 * A goal seen from the chain's root, as the solvers want it: seen from `start`.
 * @param {Chain} chain
 * @param {ArrayLike<number>} T_base_goal
 * @returns {Pose}
 */
export const goalFromStart = ({ packed }, T_base_goal) => compose(invert(packed.start), T_base_goal);
