/**
 * What the joints have to hold when the tool presses on something: τ = Jᵀ F, gravity and friction aside (Siciliano et al.,
 * section 3.8).
 *
 * @import { Chain } from '../../kinematics/chain.js'
 * @import { JacobianFrame } from './jacobianView.js'
 */
import { geometricJacobian } from '../../kinematics/jacobian.js';
import { axesAt, seenAlong } from './jacobianNumbers.js';

/**
 * @param {Chain} chain
 * @param {ArrayLike<number>} q
 * @param {readonly number[]} wrench  Fx Fy Fz, N, and Mx My Mz, N·m, at the TCP
 * @param {JacobianFrame} frame       whose axes they are along
 * @param {Float64Array | null} [T_world_user]
 * @returns {number[]} N·m; N where a joint slides
 */
export function jointLoads(chain, q, wrench, frame, T_world_user = null) {
  const J = seenAlong(geometricJacobian(chain, q), axesAt(chain, q, frame, T_world_user));
  return Array.from({ length: chain.dof }, (_, k) => wrench.reduce((sum, value, i) => sum + J[6 * k + i] * value, 0));
}
