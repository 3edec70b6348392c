/**
 * The hot loop under the finite-difference Jacobian and inverse kinematics: all frames of a posture, then a difference
 * quotient for each joint that costs two small products instead of a whole forward kinematics.
 *
 * With J_i the frame that joint i moves in, Z_i what the joint does, and U_i the TCP seen from the frame that it moves,
 *
 *   T(q) = J_i · Z_i(q_i) · U_i   and so   T(q + h e_i) − T(q) = J_i · (Z_i(q_i + h) − Z_i(q_i)) · U_i .
 *
 * The J_i are by-products of forward kinematics, the U_i grow from the tool backwards; and the difference is taken in the
 * middle, where it is Z_i(h) − 1 and keeps all its digits: outside, it is what two nearly equal poses leave of theirs. What
 * is computed is (p(x + h e_i) − p(x)) / h to the last digits, curvature and all, without the noise of subtracting. Of the
 * orientation nothing has to be multiplied out: T(q + h e_i) is T(q) turned by h about z of J_i.
 *
 * Positions here are seen from the origin of the chain's `start` frame, in root axes: a Jacobian does not depend on where
 * the arm stands, and digits lost to a far-away base would be lost to every position.
 *
 * @import { Packed } from './packed.js'
 * @import { Pose } from './pose.js'
 *
 * @typedef {object} Work   what one posture left behind
 * @property {Float64Array} frames  16 · (n + 1): the frame that each joint moves in, then the flange; no bottom rows
 * @property {Float64Array} turns   3 · n: cos and sin of θ + q, and d + q
 * @property {Pose} tcp
 *
 * @typedef {object} Step   h, made ready
 * @property {number} sine   of h
 * @property {number} fall   cos h − 1, with all its digits
 * @property {number} turn   the rotation vector's length over h: 1, unless h is more than half a turn
 * @property {number} per    1 / h
 */
import { writeAxes, writeTurns } from './frames.js';
import * as packing from './packed.js';
import { compose } from './pose.js';

// the module's own: see frames.js
const { ROW, LENGTH, COS_TWIST, SIN_TWIST, SLIDES, MOST_JOINTS } = packing;

/** @param {number} dof @returns {Work} */
export const createWork = (dof) => ({
  frames: new Float64Array(16 * (dof + 1)),
  turns: new Float64Array(3 * dof),
  tcp: Float64Array.of(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1),
});

/**
 * @param {number} h  radians; negative to differ backwards
 * @returns {Step}
 */
export function createStep(h) {
  const sine = Math.sin(h);
  const fall = -2 * Math.sin(h / 2) ** 2;
  return { sine, fall, turn: Math.abs(h) < 3 ? 1 : Math.atan2(sine, 1 + fall) / h, per: 1 / h };
}

/**
 * Forward kinematics that keeps what the differences need.
 * @param {Packed} packed
 * @param {ArrayLike<number>} q
 * @param {Work} work
 */
export function writeWork(packed, q, { frames, turns, tcp }) {
  writeTurns(packed, q, turns);
  writeAxes(packed, turns, frames, true);
  const flange = frames.length - 16;
  for (let k = 0; k < 12; k += 4) {
    tcp[k] = frames[flange + k];
    tcp[k + 1] = frames[flange + k + 1];
    tcp[k + 2] = frames[flange + k + 2];
  }
  tcp[12] = frames[flange + 12];
  tcp[13] = frames[flange + 13];
  tcp[14] = frames[flange + 14];
  if (packed.hasTool) compose(tcp, packed.tool, tcp);
}

/**
 * (p_i(x + h e_k) − p_i(x)) / h for every joint k at the posture that `writeWork` was given last; for the orientation,
 * the rotation vector from T(x) to T(x + h e_k), over h. What a slide does is in proportion to its step, so that its
 * quotient is the same for any.
 * @param {Packed} packed
 * @param {Work} work
 * @param {Step} step
 * @param {Float64Array} J  6 · n, column-major
 */
export function writeDifferences({ rows, lower, tool }, { frames, turns }, { sine, fall, turn, per }, J) {
  // the TCP seen from the frame that joint i + 1 moves in
  let s0 = tool[12];
  let s1 = tool[13];
  let s2 = tool[14];
  const n = Math.min(lower.length, MOST_JOINTS);
  for (let i = n - 1; i >= 0; i--) {
    const at = ROW * i;
    const t = 3 * i;
    const f = 16 * i;
    const to = 6 * i;
    const ca = rows[at + COS_TWIST];
    const sa = rows[at + SIN_TWIST];
    const cos = turns[t];
    const sin = turns[t + 1];
    // U = Tx(a) Rx(α) · S, then S = Z · U
    const u0 = s0 + rows[at + LENGTH];
    const u1 = ca * s1 - sa * s2;
    s2 = sa * s1 + ca * s2 + turns[t + 2];
    s0 = cos * u0 - sin * u1;
    s1 = sin * u0 + cos * u1;
    if (rows[at + SLIDES] === 1) {
      J[to] = frames[f + 8];
      J[to + 1] = frames[f + 9];
      J[to + 2] = frames[f + 10];
      J[to + 3] = 0;
      J[to + 4] = 0;
      J[to + 5] = 0;
    } else {
      // (Rz(h) − 1) S / h, seen from joint i
      const d0 = (fall * s0 - sine * s1) * per;
      const d1 = (sine * s0 + fall * s1) * per;
      J[to] = frames[f] * d0 + frames[f + 4] * d1;
      J[to + 1] = frames[f + 1] * d0 + frames[f + 5] * d1;
      J[to + 2] = frames[f + 2] * d0 + frames[f + 6] * d1;
      J[to + 3] = frames[f + 8] * turn;
      J[to + 4] = frames[f + 9] * turn;
      J[to + 5] = frames[f + 10] * turn;
    }
  }
}
