/**
 * A link that is dragged moves its joint: what is under the pointer goes round the joint's axis, or along it.
 *
 * @import { Vector } from './dragRays.js'
 * @import { Sight } from '../sight.js'
 * @import { Chain } from '../../kinematics/chain.js'
 */
import { linkFrames } from '../../kinematics/forward.js';
import { alongAxis } from './dragRays.js';
import { beginTurn } from './dragTurn.js';

/**
 * @param {object} begin
 * @param {Chain} begin.chain
 * @param {ArrayLike<number>} begin.q
 * @param {number} begin.joint
 * @param {Vector} begin.point  of the link, that was taken hold of
 * @param {Sight} begin.sight
 * @param {number} begin.x
 * @param {number} begin.y
 * @returns {((sight: Sight, x: number, y: number) => number | null) | null}  how far the joint has gone since, rad or m
 */
export function beginJoint({ chain, q, joint, point, sight, x, y }) {
  const frames = linkFrames(chain, q);
  // Joint i turns about z of frame i − 1 in a standard chain, of frame i in a modified one.
  const at = 16 * (joint + (chain.convention === 'standard' ? 0 : 1));
  const axis = [...frames.subarray(at + 8, at + 11)];
  if (chain.joints[joint].type !== 'prismatic') {
    return beginTurn({ centre: [...frames.subarray(at + 12, at + 15)], axis, point, sight, x, y });
  }
  const start = alongAxis(sight.ray(x, y), point, axis);
  if (start === null) return null;
  return (now, px, py) => {
    const along = alongAxis(now.ray(px, py), point, axis);
    return along === null ? null : along - start;
  };
}
