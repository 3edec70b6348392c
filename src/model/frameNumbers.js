/**
 * Any frame seen from any other: the frames of the table, the tool at the end and the world they stand in.
 *
 * @import { Chain } from '../kinematics/chain.js'
 * @import { RobotDoc } from './document.js'
 *
 * @typedef {'world' | 'tool' | 'flange' | number} FrameId  a number is that of the table's frame; 0 is the base
 */
import { linkFrames } from '../kinematics/forward.js';
import { compose, identity, invert } from '../kinematics/pose.js';

/**
 * The frames whose pose can be asked for, or that it can be seen from.
 * @param {RobotDoc} robot
 * @returns {FrameId[]}
 */
export const framesOf = ({ joints }) => ['tool', 'flange', ...joints.map((_, i) => i + 1), 0, 'world'];

/**
 * @param {FrameId} frame
 * @param {Float64Array} frames       from linkFrames
 * @param {Float64Array} T_world_tcp
 */
function seenFromWorld(frame, frames, T_world_tcp) {
  if (frame === 'world') return identity();
  if (frame === 'tool') return T_world_tcp;
  const at = frame === 'flange' ? frames.length - 16 : 16 * frame;
  return frames.slice(at, at + 16);
}

/**
 * T_from_frame
 * @param {FrameId} frame
 * @param {FrameId} from
 * @param {Float64Array} frames       from linkFrames
 * @param {Float64Array} T_world_tcp
 * @returns {Float64Array} column-major, metres
 */
export function frameSeenFrom(frame, from, frames, T_world_tcp) {
  if (frame === from) return identity();
  const T_world_frame = seenFromWorld(frame, frames, T_world_tcp);
  if (from === 'world') return T_world_frame;
  return compose(invert(seenFromWorld(from, frames, T_world_tcp)), T_world_frame);
}

/**
 * Every frame of the table seen from the world: the base, frame 1, … frame n.
 * @param {Chain} chain
 * @param {ArrayLike<number>} q
 */
export const linkFramesOf = (chain, q) => linkFrames(chain, q);
