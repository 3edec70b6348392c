/**
 * The loops that write down every frame of a posture: first what each joint does, then one frame after another. Both
 * conventions pass through them (packed.js).
 *
 * Written for speed: nothing is called between the frames, so that they stay in registers; loops count joints up to a bound
 * that the compiler knows, so that it knows every index; and constants are the module's own, since imported ones are looked
 * up at every use. Together that is a third of the time.
 * @import { Packed } from './packed.js'
 *
 * @typedef {object} FrameOptions
 * @property {Float64Array} turns   3 · n, filled: cos and sin of θ + q, and d + q, of every joint
 * @property {boolean} isRelative   positions from the origin of `start` instead of the chain's root
 * @property {boolean} isAtJoints   frame i after joint i has moved, before its link (where a modified table has it), instead
 *   of at the far end of the link (where a standard table has it, and where joint i + 1 moves)
 */
import { writeCosSin } from './cosSin.js';
import * as packing from './packed.js';

const { ROW, COS_THETA, SIN_THETA, OFFSET, LENGTH, COS_TWIST, SIN_TWIST, SLIDES, MOST_JOINTS } = packing;

/**
 * @param {Packed} packed
 * @param {ArrayLike<number>} q
 * @param {Float64Array} turns  3 · n, filled: cos and sin of θ + q, and d + q, of every joint
 */
export function writeTurns({ rows, lower }, q, turns) {
  const n = Math.min(lower.length, MOST_JOINTS);
  for (let i = 0; i < n; i++) {
    const at = ROW * i;
    const t = 3 * i;
    const cos = rows[at + COS_THETA];
    const sin = rows[at + SIN_THETA];
    if (rows[at + SLIDES] === 1) {
      turns[t] = cos;
      turns[t + 1] = sin;
      turns[t + 2] = rows[at + OFFSET] + q[i];
    } else {
      writeCosSin(q[i], turns, t);
      const c = turns[t];
      const s = turns[t + 1];
      turns[t] = cos * c - sin * s;
      turns[t + 1] = sin * c + cos * s;
      turns[t + 2] = rows[at + OFFSET];
    }
  }
}

/**
 * The frames at the far ends of the links.
 * @param {Packed} packed
 * @param {Float64Array} turns   from writeTurns
 * @param {Float64Array} frames  16 · (n + 1), filled but for the bottom rows: `start`, frame 1, … frame n
 * @param {boolean} isRelative
 */
export function writeAxes({ start, rows, lower }, turns, frames, isRelative) {
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
  frames[0] = x0;
  frames[1] = x1;
  frames[2] = x2;
  frames[4] = y0;
  frames[5] = y1;
  frames[6] = y2;
  frames[8] = z0;
  frames[9] = z1;
  frames[10] = z2;
  frames[12] = p0;
  frames[13] = p1;
  frames[14] = p2;
  const n = Math.min(lower.length, MOST_JOINTS);
  for (let i = 0; i < n; i++) {
    const at = ROW * i;
    const t = 3 * i;
    const cos = turns[t];
    const sin = turns[t + 1];
    const d = turns[t + 2];
    const a = rows[at + LENGTH];
    const ca = rows[at + COS_TWIST];
    const sa = rows[at + SIN_TWIST];
    // Rz(θ), then the step d along z and a along the new x, then Rx(α)
    const v0 = cos * y0 - sin * x0;
    const v1 = cos * y1 - sin * x1;
    const v2 = cos * y2 - sin * x2;
    x0 = cos * x0 + sin * y0;
    x1 = cos * x1 + sin * y1;
    x2 = cos * x2 + sin * y2;
    p0 += d * z0 + a * x0;
    p1 += d * z1 + a * x1;
    p2 += d * z2 + a * x2;
    y0 = ca * v0 + sa * z0;
    y1 = ca * v1 + sa * z1;
    y2 = ca * v2 + sa * z2;
    z0 = ca * z0 - sa * v0;
    z1 = ca * z1 - sa * v1;
    z2 = ca * z2 - sa * v2;
    const to = 16 * i + 16;
    frames[to] = x0;
    frames[to + 1] = x1;
    frames[to + 2] = x2;
    frames[to + 4] = y0;
    frames[to + 5] = y1;
    frames[to + 6] = y2;
    frames[to + 8] = z0;
    frames[to + 9] = z1;
    frames[to + 10] = z2;
    frames[to + 12] = p0;
    frames[to + 13] = p1;
    frames[to + 14] = p2;
  }
}

/**
 * From the frames at the far ends of the links to those on the joints, in place: frame i − 1, moved by joint i.
 * @param {Float64Array} turns
 * @param {Float64Array} frames
 */
function moveToJoints(turns, frames) {
  for (let to = frames.length - 16, t = turns.length - 3; t >= 0; to -= 16, t -= 3) {
    for (let k = 0, from = to - 16; k < 3; k++, from++) {
      const x = frames[from];
      const y = frames[from + 4];
      const z = frames[from + 8];
      frames[to + k] = turns[t] * x + turns[t + 1] * y;
      frames[to + 4 + k] = turns[t] * y - turns[t + 1] * x;
      frames[to + 8 + k] = z;
      frames[to + 12 + k] = frames[from + 12] + turns[t + 2] * z;
    }
  }
}

/**
 * All of it.
 * @param {Packed} packed
 * @param {ArrayLike<number>} q
 * @param {Float64Array} frames  16 · (n + 1), filled: `start`, frame 1, … frame n
 * @param {FrameOptions} options
 */
export function writeFrames(packed, q, frames, { turns, isRelative, isAtJoints }) {
  writeTurns(packed, q, turns);
  writeAxes(packed, turns, frames, isRelative);
  if (isAtJoints) moveToJoints(turns, frames);
  for (let at = 0; at < frames.length; at += 16) {
    frames[at + 3] = 0;
    frames[at + 7] = 0;
    frames[at + 11] = 0;
    frames[at + 15] = 1;
  }
}
