/**
 * Jacobians: column k is the twist of the TCP, in root axes, per unit rate of joint k; linear part first. Column-major.
 *
 * The finite difference is the one that the product computes with; the geometric Jacobian is its check and a lesson, and
 * shares nothing with it but linkFrames.
 * @import { Chain } from './chain.js'
 * @import { Work } from './differences.js'
 */
import { requirePosture, requireRoom } from './checks.js';
import { createWork, writeDifferences, writeWork } from './differences.js';
import { linkFrames } from './forward.js';

/**
 * The quotient errs by the curvature, about h/2 forward and h²/6 central, and by rounding, about 1e-16/h times the few
 * roundings of a product of frames. The sum is least near 3e-8 and 1e-5; forward stands a little above, where it is less
 * at the mercy of the rounding (measured on a UR5: 4e-8 against the geometric one, central 2e-11).
 */
export const DEFAULT_STEP = { forward: 1e-7, central: 1e-5 };

/**
 * Room for each number of joints, used again and again: nothing here calls back, so no two calls are ever inside.
 * @type {{ work: Work, backward: Float64Array, frames: Float64Array }[]}
 */
const rooms = [];
const roomFor = (/** @type {number} */ dof) =>
  (rooms[dof] ??= {
    work: createWork(dof),
    backward: new Float64Array(6 * dof),
    frames: new Float64Array(16 * (dof + 1)),
  });

/**
 * ∂p_i/∂x_k ≈ (p_i(x + h e_k) − p_i(x)) / h, or (p_i(x + h e_k) − p_i(x − h e_k)) / 2h. Orientation differences are rotation
 * vectors. Allocates nothing when `out` is given.
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
  requirePosture(chain.dof, q);
  requireRoom(J, 6 * chain.dof);
  const { work, backward } = roomFor(chain.dof);
  const slideStep = step * chain.characteristicLength;
  writeWork(chain.packed, q, work);
  writeDifferences(chain.packed, work, step, slideStep, J);
  if (method === 'central') {
    // The mean of both quotients is the central one.
    writeDifferences(chain.packed, work, -step, -slideStep, backward);
    for (let i = 0; i < J.length; i++) J[i] = (J[i] + backward[i]) / 2;
  }
  return J;
}

/**
 * A turning joint moves the TCP by axis × arm and turns it about the axis; a sliding one moves it along the axis
 * (Siciliano et al., section 3.1.3). Joint i turns about z of frame i − 1 in a standard chain, of frame i in a modified one.
 * @param {Chain} chain
 * @param {ArrayLike<number>} q
 * @param {Float64Array} [out]
 * @returns {Float64Array} 6 · n
 */
export function geometricJacobian(chain, q, out = new Float64Array(6 * chain.dof)) {
  const { dof, joints, convention, packed } = chain;
  requireRoom(out, 6 * dof);
  const { frames: F } = roomFor(dof);
  linkFrames(chain, q, F);
  const [tx, ty, tz] = [packed.tool[12], packed.tool[13], packed.tool[14]];
  const flange = 16 * dof;
  const px = F[flange] * tx + F[flange + 4] * ty + F[flange + 8] * tz + F[flange + 12];
  const py = F[flange + 1] * tx + F[flange + 5] * ty + F[flange + 9] * tz + F[flange + 13];
  const pz = F[flange + 2] * tx + F[flange + 6] * ty + F[flange + 10] * tz + F[flange + 14];
  for (let i = 0, to = 0; i < dof; i++, to += 6) {
    const frame = 16 * (convention === 'standard' ? i : i + 1);
    const x = F[frame + 8];
    const y = F[frame + 9];
    const z = F[frame + 10];
    const turns = joints[i].type === 'revolute';
    const armX = px - F[frame + 12];
    const armY = py - F[frame + 13];
    const armZ = pz - F[frame + 14];
    out[to] = turns ? y * armZ - z * armY : x;
    out[to + 1] = turns ? z * armX - x * armZ : y;
    out[to + 2] = turns ? x * armY - y * armX : z;
    out[to + 3] = turns ? x : 0;
    out[to + 4] = turns ? y : 0;
    out[to + 5] = turns ? z : 0;
  }
  return out;
}
