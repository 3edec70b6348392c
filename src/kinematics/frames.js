/**
 * The loop that writes down every frame of a posture. Both conventions pass through it (packed.js).
 * @import { Packed } from './packed.js'
 *
 * @typedef {object} FrameOptions
 * @property {Float64Array} turns   3 · n, filled: cos and sin of θ + q, and d + q, of every joint
 * @property {boolean} isRelative   positions from the origin of `start` instead of the chain's root
 * @property {boolean} isAtJoints   frame i after joint i has moved, before its link (where a modified table has it), instead
 *   of at the far end of the link (where a standard table has it, and where joint i + 1 moves)
 */
import { COS_THETA, COS_TWIST, LENGTH, OFFSET, ROW, SIN_THETA, SIN_TWIST, SLIDES } from './packed.js';

/**
 * @param {Packed} packed
 * @param {ArrayLike<number>} q
 * @param {Float64Array} frames  16 · (n + 1), filled: `start`, frame 1, … frame n
 * @param {FrameOptions} options
 */
export function writeFrames({ start, rows }, q, frames, { turns, isRelative, isAtJoints }) {
  let x0 = start[0];
  let x1 = start[1];
  let x2 = start[2];
  let y0 = start[4];
  let y1 = start[5];
  let y2 = start[6];
  let z0 = start[8];
  let z1 = start[9];
  let z2 = start[10];
  let p0 = isRelative ? 0 : start[12];
  let p1 = isRelative ? 0 : start[13];
  let p2 = isRelative ? 0 : start[14];
  write(frames, 0, x0, x1, x2, y0, y1, y2, z0, z1, z2, p0, p1, p2);
  for (let i = 0, at = 0, to = 16; at < rows.length; i++, at += ROW, to += 16) {
    let cos = rows[at + COS_THETA];
    let sin = rows[at + SIN_THETA];
    let d = rows[at + OFFSET];
    if (rows[at + SLIDES] === 1) {
      d += q[i];
    } else {
      const c = Math.cos(q[i]);
      const s = Math.sin(q[i]);
      const turned = cos * c - sin * s;
      sin = sin * c + cos * s;
      cos = turned;
    }
    turns[3 * i] = cos;
    turns[3 * i + 1] = sin;
    turns[3 * i + 2] = d;
    // Rz(θ) Tz(d)
    const v0 = cos * y0 - sin * x0;
    const v1 = cos * y1 - sin * x1;
    const v2 = cos * y2 - sin * x2;
    x0 = cos * x0 + sin * y0;
    x1 = cos * x1 + sin * y1;
    x2 = cos * x2 + sin * y2;
    p0 += d * z0;
    p1 += d * z1;
    p2 += d * z2;
    if (isAtJoints) write(frames, to, x0, x1, x2, v0, v1, v2, z0, z1, z2, p0, p1, p2);
    // Tx(a) Rx(α)
    const a = rows[at + LENGTH];
    const ca = rows[at + COS_TWIST];
    const sa = rows[at + SIN_TWIST];
    p0 += a * x0;
    p1 += a * x1;
    p2 += a * x2;
    y0 = ca * v0 + sa * z0;
    y1 = ca * v1 + sa * z1;
    y2 = ca * v2 + sa * z2;
    z0 = ca * z0 - sa * v0;
    z1 = ca * z1 - sa * v1;
    z2 = ca * z2 - sa * v2;
    if (!isAtJoints) write(frames, to, x0, x1, x2, y0, y1, y2, z0, z1, z2, p0, p1, p2);
  }
}

/**
 * @param {Float64Array} out
 * @param {number} at
 * @param {number} x0
 * @param {number} x1
 * @param {number} x2
 * @param {number} y0
 * @param {number} y1
 * @param {number} y2
 * @param {number} z0
 * @param {number} z1
 * @param {number} z2
 * @param {number} p0
 * @param {number} p1
 * @param {number} p2
 */
function write(out, at, x0, x1, x2, y0, y1, y2, z0, z1, z2, p0, p1, p2) {
  out[at] = x0;
  out[at + 1] = x1;
  out[at + 2] = x2;
  out[at + 3] = 0;
  out[at + 4] = y0;
  out[at + 5] = y1;
  out[at + 6] = y2;
  out[at + 7] = 0;
  out[at + 8] = z0;
  out[at + 9] = z1;
  out[at + 10] = z2;
  out[at + 11] = 0;
  out[at + 12] = p0;
  out[at + 13] = p1;
  out[at + 14] = p2;
  out[at + 15] = 1;
}
