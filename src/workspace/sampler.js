/**
 * Places of the TCP for postures spread evenly over the joints' ranges, some tens of millions a second: the first picture of
 * a workspace, and the witness that a map of it leaves nothing out.
 *
 * Posture t has joint k at the share {s_k + t · α_k} of its range ({} is the fractional part; s_k comes from the seed): a
 * low-discrepancy sequence, whose α are powers of the root of x^(m+1) = x + 1 (M. Roberts 2018, after Kronecker and Weyl).
 * From one posture to the next every joint turns by the same angle, or by that less its whole range, so its cosine and sine
 * follow by one rotation each: no trigonometry and no chance in the loop. Rounding is taken out at the start of every block.
 *
 * @import { Chain } from '../kinematics/chain.js'
 * @import { Ranges } from './placement.js'
 *
 * @typedef {object} SampleOptions
 * @property {boolean} [withLimits]  of turning joints; slides always keep theirs
 * @property {number} [seed]
 *
 * @typedef {object} Sampler
 * @property {Ranges} ranges
 * @property {(from: number, out: Float32Array) => void} fill  the places of postures from, from + 1, … seen from the chain's
 *   root: x, y, z each. Any slice may be asked for, in any order; the answer is always the same.
 * @property {(index: number, q?: Float64Array) => Float64Array} postureAt  of all joints; those that do not move the TCP are
 *   at zero, or at the limit that is nearest to it
 */
import { requireWhole } from '../kinematics/checks.js';
import { writeCosSin } from '../kinematics/cosSin.js';
import { isSlide } from '../kinematics/limits.js';
import * as packing from '../kinematics/packed.js';
import { createRandom } from '../kinematics/random.js';
import { rangesOf } from './placement.js';

const { ROW, COS_THETA, SIN_THETA, OFFSET, LENGTH, COS_TWIST, SIN_TWIST } = packing;

/** Postures between two fresh starts: their places stay in the processor's nearest memory. */
const BLOCK = 1024;

const places = { x: new Float64Array(BLOCK), y: new Float64Array(BLOCK), z: new Float64Array(BLOCK) };
const room = new Float64Array(4);

/** The root of x^(m+1) = x + 1. @param {number} m */
function generalGolden(m) {
  let root = 2;
  for (let i = 0; i < 60; i++) root = (1 + root) ** (1 / (m + 1));
  return root;
}

/** @param {number} value */
const fraction = (value) => value - Math.floor(value);

/**
 * What joint i and the link behind it do to the places in the block.
 * @param {Chain['packed']} packed
 * @param {number} i
 * @param {{ low: number, range: number, share: number, stride: number }} run  share of the range at the start, and per step
 */
function passTurn({ rows }, i, { low, range, share, stride }) {
  const at = ROW * i;
  const a = rows[at + LENGTH];
  const ca = rows[at + COS_TWIST];
  const sa = rows[at + SIN_TWIST];
  const d = rows[at + OFFSET];
  writeCosSin(low + range * share, room, 0);
  let c = rows[at + COS_THETA] * room[0] - rows[at + SIN_THETA] * room[1];
  let s = rows[at + SIN_THETA] * room[0] + rows[at + COS_THETA] * room[1];
  const steps = room;
  writeCosSin(range * stride, steps, 0);
  writeCosSin(range * (stride - 1), steps, 2);
  const { x, y, z } = places;
  let u = share;
  for (let k = 0; k < BLOCK; k++) {
    const across = x[k] + a;
    const v = y[k];
    const w = z[k];
    const side = ca * v - sa * w;
    x[k] = c * across - s * side;
    y[k] = s * across + c * side;
    z[k] = sa * v + ca * w + d;
    u += stride;
    const rounds = u | 0; // 1 if the range has been passed; a branch would be guessed wrongly as often as not
    u -= rounds;
    const cs = steps[2 * rounds];
    const sn = steps[2 * rounds + 1];
    const next = c * cs - s * sn;
    s = s * cs + c * sn;
    c = next;
  }
}

/** Likewise, for a joint that slides. @type {typeof passTurn} */
function passSlide({ rows }, i, { low, range, share, stride }) {
  const at = ROW * i;
  const a = rows[at + LENGTH];
  const ca = rows[at + COS_TWIST];
  const sa = rows[at + SIN_TWIST];
  const c = rows[at + COS_THETA];
  const s = rows[at + SIN_THETA];
  const d = rows[at + OFFSET] + low;
  const { x, y, z } = places;
  let u = share;
  for (let k = 0; k < BLOCK; k++) {
    const across = x[k] + a;
    const side = ca * y[k] - sa * z[k];
    z[k] = sa * y[k] + ca * z[k] + d + range * u;
    x[k] = c * across - s * side;
    y[k] = s * across + c * side;
    u += stride;
    u -= u | 0;
  }
}

/**
 * The TCP seen from the far end of the last link that is moved by a joint that moves it: what comes behind stands still.
 * @param {Chain} chain
 * @param {number} last
 */
function placeBehind({ packed, dof }, last) {
  const { x, y, z } = places;
  [x[0], y[0], z[0]] = packed.tool.subarray(12, 15);
  for (let i = dof - 1; i > last; i--) {
    const still = { low: 0, range: 0, share: 0, stride: 0 };
    if (isSlide(packed, i)) passSlide(packed, i, still);
    else passTurn(packed, i, still);
  }
  return [x[0], y[0], z[0]];
}

/**
 * @param {Chain} chain
 * @param {SampleOptions} [options]
 * @returns {Sampler}
 */
export function createSampler(chain, { withLimits = true, seed = 1 } = {}) {
  requireWhole('seed', seed, -Infinity);
  const { packed, dof } = chain;
  const ranges = rangesOf(chain, withLimits);
  const golden = generalGolden(ranges.joints.length);
  const random = createRandom(seed);
  /** Of each joint of the chain; those that do not move the TCP stand still. */
  const runs = Array.from({ length: dof }, (_, i) => {
    const k = ranges.joints.indexOf(i);
    if (k < 0) return { low: 0, range: 0, start: 0, stride: 0 };
    const low = ranges.lower[k];
    return { low, range: ranges.upper[k] - low, start: random(), stride: fraction(golden ** -(k + 1)) };
  });

  const last = Math.max(-1, ...ranges.joints);
  const behind = placeBehind(chain, last);

  /** @param {number} index */
  function fillBlock(index) {
    places.x.fill(behind[0]);
    places.y.fill(behind[1]);
    places.z.fill(behind[2]);
    for (let i = last; i >= 0; i--) {
      const { low, range, start, stride } = runs[i];
      const run = { low, range, share: fraction(start + index * stride), stride };
      if (isSlide(packed, i)) passSlide(packed, i, run);
      else passTurn(packed, i, run);
    }
  }

  return {
    ranges,
    fill(from, out) {
      requireWhole('the first posture', from);
      const [a0, a1, a2, , b0, b1, b2, , c0, c1, c2, , p0, p1, p2] = packed.start;
      const { x, y, z } = places;
      const count = Math.floor(out.length / 3);
      for (let done = 0; done < count;) {
        const first = (from + done) % BLOCK;
        const last = Math.min(BLOCK, first + count - done);
        fillBlock(from + done - first);
        for (let k = first, to = 3 * done; k < last; k++, to += 3) {
          out[to] = a0 * x[k] + b0 * y[k] + c0 * z[k] + p0;
          out[to + 1] = a1 * x[k] + b1 * y[k] + c1 * z[k] + p1;
          out[to + 2] = a2 * x[k] + b2 * y[k] + c2 * z[k] + p2;
        }
        done += last - first;
      }
    },
    postureAt(index, q = new Float64Array(dof)) {
      const into = index % BLOCK;
      runs.forEach(({ low, range, start, stride }, i) => {
        const share = fraction(fraction(start + (index - into) * stride) + into * stride);
        q[i] = ranges.joints.includes(i)
          ? low + range * share
          : Math.min(packed.upper[i], Math.max(packed.lower[i], 0));
      });
      return q;
    },
  };
}
