/**
 * Jacobians: column k is the twist of the TCP, in root axes, per unit rate of joint k; linear part first. Column-major.
 *
 * The finite difference is the one that the product computes with; the geometric Jacobian is its check and a lesson, and
 * shares nothing with it but linkFrames.
 * @import { Chain } from './chain.js'
 */
import { requirePosture, requireRoom } from './checks.js';
import { createWork, writeDifferences, writeFrames } from './differences.js';
import { linkFrames } from './forward.js';
import { compose } from './pose.js';

/**
 * The quotient errs by the curvature, about h/2 forward and h²/6 central, and by rounding, about 1e-16/h times the few
 * roundings of a product of frames. The sum is least near 3e-8 and 1e-5; forward stands a little above, where it is less
 * at the mercy of the rounding (measured on a UR5: 4e-8 against the geometric one, central 2e-11).
 */
export const DEFAULT_STEP = { forward: 1e-7, central: 1e-5 };

/**
 * ∂p_i/∂x_k ≈ (p_i(x + h e_k) − p_i(x)) / h. Orientation differences are rotation vectors.
 * @param {Chain} chain
 * @param {ArrayLike<number>} q
 * @param {object} [options]
 * @param {'forward' | 'central'} [options.method]
 * @param {number} [options.step]  radians; a slide steps by this times the chain's characteristic length
 * @param {Float64Array} [options.out]
 * @returns {Float64Array} 6 · n
 */
export function finiteDifferenceJacobian(chain, q, options = {}) {
  const { method = 'forward', out: J = new Float64Array(6 * chain.dof) } = options;
  if (method !== 'forward' && method !== 'central') {
    throw new RangeError(`Expected the method to be 'forward' or 'central', got '${method}'.`);
  }
  const { step = DEFAULT_STEP[method] } = options;
  if (!(step > 0 && step < Infinity)) throw new RangeError(`Expected a positive step, got ${step}.`);
  requirePosture(chain, q);
  requireRoom(J, 6 * chain.dof);
  const work = createWork(chain.dof);
  const slideStep = step * chain.characteristicLength;
  writeFrames(chain.packed, q, work);
  writeDifferences(chain.packed, work, step, slideStep, J);
  if (method === 'central') {
    const backward = new Float64Array(J.length);
    writeDifferences(chain.packed, work, -step, -slideStep, backward);
    for (let i = 0; i < J.length; i++) J[i] = (J[i] + backward[i]) / 2;
  }
  return J;
}

/**
 * A turning joint moves the TCP by axis × arm and turns it about the axis; a sliding one moves it along the axis
 * (Siciliano et al., section 3.1.3). Joint i turns about z of frame i − 1 in a standard chain, of frame i in a modified.
 * @param {Chain} chain
 * @param {ArrayLike<number>} q
 * @param {Float64Array} [out]
 * @returns {Float64Array} 6 · n
 */
export function geometricJacobian(chain, q, out = new Float64Array(6 * chain.dof)) {
  requireRoom(out, 6 * chain.dof);
  const frames = linkFrames(chain, q);
  const T_base_tcp = compose(frames.subarray(16 * chain.dof), chain.tool);
  chain.joints.forEach(({ type }, i) => {
    const frame = 16 * (chain.convention === 'standard' ? i : i + 1);
    const [x, y, z] = frames.subarray(frame + 8, frame + 11);
    const arm = [12, 13, 14].map((k) => T_base_tcp[k] - frames[frame + k]);
    const turns = type === 'revolute';
    const linear = turns ? [y * arm[2] - z * arm[1], z * arm[0] - x * arm[2], x * arm[1] - y * arm[0]] : [x, y, z];
    out.set([...linear, ...(turns ? [x, y, z] : [0, 0, 0])], 6 * i);
  });
  return out;
}
