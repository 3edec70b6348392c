/**
 * Any frame seen from any other: the frames of the table, the tool at the end and the world they stand in.
 *
 * @import { Chain } from '../../kinematics/chain.js'
 * @import { RobotDoc } from '../document.js'
 *
 * @typedef {'world' | 'tool' | 'flange' | 'user' | number} FrameId  a number is that of the table's frame; 0 is the base;
 *   user: the active user frame
 */
import { linkFrames } from '../../kinematics/forward.js';
import { compose, identity, invert } from '../../kinematics/pose.js';

/**
 * The frames whose pose can be asked for, or that it can be seen from.
 * @param {RobotDoc} robot
 * @param {boolean} hasUser  whether a user frame is active
 * @returns {FrameId[]}
 */
export const framesOf = ({ joints }, hasUser) => [
  'tool',
  'flange',
  ...joints.map((_, i) => i + 1),
  0,
  ...(hasUser ? [/** @type {const} */ ('user')] : []),
  'world',
];

/**
 * @param {FrameId} frame
 * @param {Float64Array} frames       from linkFrames
 * @param {Float64Array} T_world_tcp
 * @param {Float64Array} T_world_user
 */
function seenFromWorld(frame, frames, T_world_tcp, T_world_user) {
  if (frame === 'world') return identity();
  if (frame === 'user') return T_world_user;
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
 * @param {Float64Array} [T_world_user]
 * @returns {Float64Array} column-major, metres
 */
export function frameSeenFrom(frame, from, frames, T_world_tcp, T_world_user = identity()) {
  if (frame === from) return identity();
  const T_world_frame = seenFromWorld(frame, frames, T_world_tcp, T_world_user);
  if (from === 'world') return T_world_frame;
  return compose(invert(seenFromWorld(from, frames, T_world_tcp, T_world_user)), T_world_frame);
}

/**
 * Every frame of the table seen from the world: the base, frame 1, … frame n.
 * @param {Chain} chain
 * @param {ArrayLike<number>} q
 */
export const linkFramesOf = (chain, q) => linkFrames(chain, q);
