/**
 * The frames that a pendant offers to move the tool in, seen from the world.
 *
 * @import { Chain } from '../../kinematics/chain.js'
 * @import { JogFrame } from './jog.js'
 */
import { tcpPose } from '../../kinematics/forward.js';
import { poseOfAxes } from '../aim/handleAxes.js';

/**
 * @param {Chain} chain
 * @param {Float64Array} q
 * @param {JogFrame} frame
 * @param {Float64Array} T_world_user  the active user frame
 * @returns {Float64Array} column-major; where it is does not matter
 */
export const jogFramePose = (chain, q, frame, T_world_user) =>
  poseOfAxes(frame, chain, tcpPose(chain, q), T_world_user);
