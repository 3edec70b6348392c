/**
 * The frames that a pendant offers to move the tool in, seen from the world.
 *
 * @import { Chain } from '../kinematics/chain.js'
 * @import { Doc } from './document.js'
 * @import { JogFrame } from './jog.js'
 */
import { linkFrames, tcpPose } from '../kinematics/forward.js';
import { identity } from '../kinematics/pose.js';
import { compilePose } from './compile.js';
import { activeFrame } from './activeFrames.js';

/**
 * @param {Doc} doc
 * @param {Chain} chain  of the document
 * @param {Float64Array} q
 * @param {JogFrame} frame  the user frame is the one that is chosen; where none is, it is the world, as on a controller
 * @returns {Float64Array} column-major, metres
 */
export function jogFramePose(doc, chain, q, frame) {
  if (frame === 'tool') return tcpPose(chain, q);
  if (frame === 'base') return linkFrames(chain, q).slice(0, 16);
  const user = frame === 'user' ? activeFrame(doc, 'user') : null;
  return user ? compilePose(user, doc.robot.units) : identity();
}
