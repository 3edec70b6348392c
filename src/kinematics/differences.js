/**
 * The hot loop under the finite-difference Jacobian and inverse kinematics: all frames of a posture, then a difference
 * quotient for each joint that costs two small products instead of a whole forward kinematics. With J_i the frame that
 * joint i moves in and U_i the TCP seen from the frame that it moves, T(q + h e_i) = J_i · Z_i(q_i + h) · U_i: the prefixes
 * J_i are by-products of forward kinematics, the suffixes U_i grow from the tool backwards.
 *
 * Positions here are seen from the origin of the chain's `start` frame, in root axes: a Jacobian does not depend on where
 * the arm stands, and digits lost to a far-away base would be lost to every quotient.
 *
 * @import { Packed } from './packed.js'
 * @import { Pose } from './pose.js'
 *
 * @typedef {object} Work   what one posture left behind
 * @property {Float64Array} frames  16 · (n + 1): the frame that each joint moves in, then the flange
 * @property {Float64Array} turns   3 · n: cos and sin of θ + q, and d + q
 * @property {Pose} tcp
 */
import { writeFrames } from './frames.js';
import { COS_TWIST, LENGTH, ROW, SIN_TWIST, SLIDES } from './packed.js';
import { compose, poseDifference } from './pose.js';

/** sin² of an angle below which sin x / x is 1 − x²/6 to the last digit. */
const SMALL = 1e-8;

/**
 * A slide steps by no less than this share of a step in proportion to all the lengths in the table, be the arm that they
 * add up to ever so small: the positions that the step adds to have no finer digits.
 */
const SLIDE_GRAIN = 0.1;

const moved = new Float64Array(16);
const difference = new Float64Array(6);

/** @param {number} dof @returns {Work} */
export const createWork = (dof) => ({
  frames: new Float64Array(16 * (dof + 1)),
  turns: new Float64Array(3 * dof),
  tcp: new Float64Array(16),
});

/**
 * Forward kinematics that keeps what the differences need.
 * @param {Packed} packed
 * @param {ArrayLike<number>} q
 * @param {Work} work
 */
export function writeWork(packed, q, { frames, turns, tcp }) {
  writeFrames(packed, q, frames, { turns, isRelative: true, isAtJoints: false });
  const flange = frames.length - 16;
  for (let k = 0; k < 16; k++) tcp[k] = frames[flange + k];
  if (packed.hasTool) compose(tcp, packed.tool, tcp);
}

/**
 * (p_i(x + h e_k) − p_i(x)) / h for every joint k at the posture that `writeWork` was given last; for the orientation,
 * the rotation vector from T(x) to T(x + h e_k), over h. A negative step differs backwards.
 * @param {Packed} packed
 * @param {Work} work
 * @param {number} step   radians
 * @param {number} slideStep  metres
 * @param {Float64Array} J  6 · n, column-major
 */
export function writeDifferences({ rows, tool }, { frames, turns, tcp }, step, slideStep, J) {
  const cosStep = Math.cos(step);
  const sinStep = Math.sin(step);
  let span = Math.abs(tool[12]) + Math.abs(tool[13]) + Math.abs(tool[14]);
  for (let at = 0, t = 2; at < rows.length; at += ROW, t += 3) span += Math.abs(turns[t]) + Math.abs(rows[at + LENGTH]);
  const leastSlide = SLIDE_GRAIN * span * step; // signed, as the steps are
  const slideBy = Math.abs(slideStep) > Math.abs(leastSlide) ? slideStep : leastSlide;
  // S: the TCP seen from the frame that joint i + 1 moves in
  let sx0 = tool[0];
  let sx1 = tool[1];
  let sx2 = tool[2];
  let sy0 = tool[4];
  let sy1 = tool[5];
  let sy2 = tool[6];
  let sz0 = tool[8];
  let sz1 = tool[9];
  let sz2 = tool[10];
  let sp0 = tool[12];
  let sp1 = tool[13];
  let sp2 = tool[14];
  const tx0 = tcp[0];
  const tx1 = tcp[1];
  const tx2 = tcp[2];
  const ty0 = tcp[4];
  const ty1 = tcp[5];
  const ty2 = tcp[6];
  const tz0 = tcp[8];
  const tz1 = tcp[9];
  const tz2 = tcp[10];
  for (
    let at = rows.length - ROW, f = frames.length - 32, t = turns.length - 3, to = J.length - 6;
    at >= 0;
    at -= ROW, f -= 16, t -= 3, to -= 6
  ) {
    // U = X · S
    const ca = rows[at + COS_TWIST];
    const sa = rows[at + SIN_TWIST];
    const up0 = sp0 + rows[at + LENGTH];
    const ux1 = ca * sx1 - sa * sx2;
    const uy1 = ca * sy1 - sa * sy2;
    const uz1 = ca * sz1 - sa * sz2;
    const up1 = ca * sp1 - sa * sp2;
    sx2 = sa * sx1 + ca * sx2;
    sy2 = sa * sy1 + ca * sy2;
    sz2 = sa * sz1 + ca * sz2;
    sp2 = sa * sp1 + ca * sp2;
    // Z(q + h)
    const cos = turns[t];
    const sin = turns[t + 1];
    const d = turns[t + 2];
    let c = cos;
    let s = sin;
    let along = d;
    let h = step;
    if (rows[at + SLIDES] === 1) {
      along = d + slideBy;
      h = along - d; // the step that was really taken
    } else {
      c = cos * cosStep - sin * sinStep;
      s = sin * cosStep + cos * sinStep;
    }
    const per = 1 / h;
    // T' = J_i · Z(q + h) · U, column by column
    const x0 = frames[f];
    const x1 = frames[f + 1];
    const x2 = frames[f + 2];
    const y0 = frames[f + 4];
    const y1 = frames[f + 5];
    const y2 = frames[f + 6];
    const z0 = frames[f + 8];
    const z1 = frames[f + 9];
    const z2 = frames[f + 10];
    let u = c * sx0 - s * ux1;
    let v = s * sx0 + c * ux1;
    const mx0 = x0 * u + y0 * v + z0 * sx2;
    const mx1 = x1 * u + y1 * v + z1 * sx2;
    const mx2 = x2 * u + y2 * v + z2 * sx2;
    u = c * sy0 - s * uy1;
    v = s * sy0 + c * uy1;
    const my0 = x0 * u + y0 * v + z0 * sy2;
    const my1 = x1 * u + y1 * v + z1 * sy2;
    const my2 = x2 * u + y2 * v + z2 * sy2;
    u = c * sz0 - s * uz1;
    v = s * sz0 + c * uz1;
    const mz0 = x0 * u + y0 * v + z0 * sz2;
    const mz1 = x1 * u + y1 * v + z1 * sz2;
    const mz2 = x2 * u + y2 * v + z2 * sz2;
    u = c * up0 - s * up1;
    v = s * up0 + c * up1;
    const w = sp2 + along;
    J[to] = (x0 * u + y0 * v + z0 * w + frames[f + 12] - tcp[12]) * per;
    J[to + 1] = (x1 * u + y1 * v + z1 * w + frames[f + 13] - tcp[13]) * per;
    J[to + 2] = (x2 * u + y2 * v + z2 * w + frames[f + 14] - tcp[14]) * per;
    // sin(angle) · axis = ½ Σ axis of T × axis of T'
    const r0 = 0.5 * (tx1 * mx2 - tx2 * mx1 + ty1 * my2 - ty2 * my1 + tz1 * mz2 - tz2 * mz1);
    const r1 = 0.5 * (tx2 * mx0 - tx0 * mx2 + ty2 * my0 - ty0 * my2 + tz2 * mz0 - tz0 * mz2);
    const r2 = 0.5 * (tx0 * mx1 - tx1 * mx0 + ty0 * my1 - ty1 * my0 + tz0 * mz1 - tz1 * mz0);
    const square = r0 * r0 + r1 * r1 + r2 * r2;
    if (rows[at + SLIDES] === 1) {
      // nothing turns: the same rotation, to the last bit, if it were multiplied out
      J[to + 3] = 0;
      J[to + 4] = 0;
      J[to + 5] = 0;
    } else if (square < SMALL && sinStep * sinStep < SMALL) {
      const scale = per * (1 + square / 6);
      J[to + 3] = r0 * scale;
      J[to + 4] = r1 * scale;
      J[to + 5] = r2 * scale;
    } else {
      moved.set([mx0, mx1, mx2, 0, my0, my1, my2, 0, mz0, mz1, mz2]);
      poseDifference(tcp, moved, difference);
      J[to + 3] = difference[3] * per;
      J[to + 4] = difference[4] * per;
      J[to + 5] = difference[5] * per;
    }
    // S of joint i = Z(q) · U
    let turned = cos * sx0 - sin * ux1;
    sx1 = sin * sx0 + cos * ux1;
    sx0 = turned;
    turned = cos * sy0 - sin * uy1;
    sy1 = sin * sy0 + cos * uy1;
    sy0 = turned;
    turned = cos * sz0 - sin * uz1;
    sz1 = sin * sz0 + cos * uz1;
    sz0 = turned;
    turned = cos * up0 - sin * up1;
    sp1 = sin * up0 + cos * up1;
    sp0 = turned;
    sp2 += d;
  }
}
