/**
 * Jacobians: column k is the twist of the TCP, in root axes, per unit rate of joint k; linear part first. Column-major.
 *
 * The finite difference is the one that the product computes with; the geometric Jacobian is its check and a lesson, and
 * shares nothing with it but linkFrames.
 * @import { Chain } from './chain.js'
 * @import { Work } from './differences.js'
 */
import { requirePosture, requireRoom } from './checks.js';
import { createStep, createWork, writeDifferences, writeWork } from './differences.js';
import { linkFrames } from './forward.js';
import * as packing from './packed.js';

const { MOST_JOINTS } = packing; // the module's own: see frames.js

/**
 * The quotient errs by the curvature: about h/2 forward and h²/6 central (measured on a UR5 against the geometric one: 5e-8
 * and 2e-11). Rounding adds nothing here (differences.js), so that smaller steps would do; but these are also what whole
 * forward kinematics could be subtracted with, where rounding adds some 1e-15 over h: the least sum of both is near them.
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
 * @param {number} [options.step]  radians; a slide's quotient is the same for any step
 * @param {Float64Array} [options.out]
 * @returns {Float64Array} 6 · n
 */
export function finiteDifferenceJacobian({ packed }, q, options = {}) {
  const dof = packed.lower.length; // as in forward.js
  const { method = 'forward', out: J = new Float64Array(6 * dof) } = options;
  if (method !== 'forward' && method !== 'central') {
    throw new RangeError(`Expected the method to be 'forward' or 'central', got '${method}'.`);
  }
  const { step = DEFAULT_STEP[method] } = options;
  if (!(step > 0 && step < Infinity)) throw new RangeError(`Expected a positive step, got ${step}.`);
  requirePosture(dof, q);
  requireRoom(J, 6 * dof);
  const { work, backward } = roomFor(dof);
  writeWork(packed, q, work);
  writeDifferences(packed, work, createStep(step), J);
  if (method === 'central') {
    // The mean of both quotients is the central one.
    writeDifferences(packed, work, createStep(-step), backward);
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
  const flange = 16 * dof;
  const tx = packed.tool[12];
  const ty = packed.tool[13];
  const tz = packed.tool[14];
  const px = F[flange] * tx + F[flange + 4] * ty + F[flange + 8] * tz + F[flange + 12];
  const py = F[flange + 1] * tx + F[flange + 5] * ty + F[flange + 9] * tz + F[flange + 13];
  const pz = F[flange + 2] * tx + F[flange + 6] * ty + F[flange + 10] * tz + F[flange + 14];
  const ahead = convention === 'standard' ? 0 : 16;
  const n = Math.min(dof, MOST_JOINTS);
  for (let i = 0; i < n; i++) {
    const frame = 16 * i + ahead;
    const to = 6 * i;
    const x = F[frame + 8];
    const y = F[frame + 9];
    const z = F[frame + 10];
    if (joints[i].type === 'prismatic') {
      out[to] = x;
      out[to + 1] = y;
      out[to + 2] = z;
      out[to + 3] = 0;
      out[to + 4] = 0;
      out[to + 5] = 0;
    } else {
      const armX = px - F[frame + 12];
      const armY = py - F[frame + 13];
      const armZ = pz - F[frame + 14];
      out[to] = y * armZ - z * armY;
      out[to + 1] = z * armX - x * armZ;
      out[to + 2] = x * armY - y * armX;
      out[to + 3] = x;
      out[to + 4] = y;
      out[to + 5] = z;
    }
  }
  return out;
}
