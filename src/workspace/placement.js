/**
 * Where a posture puts the TCP, and which joints have anything to do with that. A joint whose axis always goes through the
 * TCP, such as the last one of most arms with six joints, moves it nowhere: a workspace has one dimension less to look at
 * for each of them.
 *
 * @import { Chain } from '../kinematics/chain.js'
 *
 * @typedef {object} Ranges   what the joints that move the TCP may do; entry k is of joint `joints[k]`
 * @property {readonly number[]} joints  from 0
 * @property {Float64Array} lower        finite
 * @property {Float64Array} upper
 * @property {readonly boolean[]} isClosed  a turning joint that makes a full turn, so that its range has no ends
 * @property {readonly boolean[]} slides
 *
 * @typedef {object} Placement   room for one posture: of the joints `ranges.joints` only, all others stand at zero
 * @property {Chain} chain
 * @property {Ranges} ranges
 * @property {Float64Array} q       of all joints
 * @property {Float64Array} place   the TCP, seen from the chain's root
 * @property {Float64Array} J       3 · m: what each of the joints does to it
 * @property {Float64Array} axes    3 · m: their directions
 * @property {Float64Array} turns
 * @property {Float64Array} frames
 */
import { writeAxes, writeTurns } from '../kinematics/frames.js';
import { isSlide } from '../kinematics/limits.js';
import { createRandom } from '../kinematics/random.js';

const FULL_TURN = 2 * Math.PI;

/** Limits this much less than a full turn apart (rad) still are one: what is typed in degrees is rounded. */
const NEARLY = 1e-9;

/** A joint that moves the TCP by less than this per radian or metre, in arm lengths, does not move it. */
const STILL = 1e-9;

/** Postures in which it is looked whether a joint moves the TCP; it would have to stand still in all of them by chance. */
const LOOKS = 8;

/**
 * Why an arm cannot be mapped, or null.
 * @param {Chain} chain
 * @returns {{ code: 'unlimited-slide', joint: number } | { code: 'nothing-moves' } | null}
 */
export function whyNotMapped(chain) {
  const joints = movingJoints(chain);
  if (joints.length === 0) return { code: 'nothing-moves' };
  const joint = joints.find(
    (i) => chain.joints[i].type === 'prismatic' && !Number.isFinite(chain.joints[i].upper - chain.joints[i].lower),
  );
  return joint === undefined ? null : { code: 'unlimited-slide', joint };
}

const NONE = new Float64Array(0);

/** @type {WeakMap<Chain, readonly number[]>} */
const known = new WeakMap();

/**
 * The joints that move the TCP in some posture.
 * @param {Chain} chain
 * @returns {readonly number[]}
 */
export function movingJoints(chain) {
  const found = known.get(chain);
  if (found) return found;
  const all = Array.from({ length: chain.dof }, (_, i) => i);
  const placement = roomFor(chain, { joints: all, lower: NONE, upper: NONE, isClosed: [], slides: [] });
  const random = createRandom(1);
  const most = new Float64Array(chain.dof);
  for (let look = 0; look < LOOKS; look++) {
    const x = Float64Array.from(all, () => (2 * random() - 1) * 3);
    writePlacement(placement, x);
    for (const i of all) most[i] = Math.max(most[i], Math.hypot(...placement.J.subarray(3 * i, 3 * i + 3)));
  }
  const joints = Object.freeze(
    all.filter((i) => most[i] > STILL * (chain.joints[i].type === 'prismatic' ? 1 : chain.characteristicLength)),
  );
  known.set(chain, joints);
  return joints;
}

/**
 * Slides keep their limits in any case: without them there is no end to what they reach.
 * @param {Chain} chain
 * @param {boolean} withLimits  of the turning joints
 * @returns {Ranges}
 */
export function rangesOf(chain, withLimits) {
  const joints = movingJoints(chain);
  const slides = joints.map((i) => chain.joints[i].type === 'prismatic');
  const bounds = joints.map((i, k) => {
    const { lower, upper } = chain.joints[i];
    if (slides[k] || (withLimits && upper - lower < FULL_TURN - NEARLY)) return [lower, upper, 0];
    const middle = withLimits && Number.isFinite(upper - lower) ? (lower + upper) / 2 : 0;
    return [middle - Math.PI, middle + Math.PI, 1];
  });
  return {
    joints,
    slides,
    lower: Float64Array.from(bounds, ([low]) => low),
    upper: Float64Array.from(bounds, ([, high]) => high),
    isClosed: bounds.map(([, , closed]) => closed === 1),
  };
}

/** @param {Chain} chain @param {Ranges} ranges @returns {Placement} */
function roomFor(chain, ranges) {
  const m = ranges.joints.length;
  return {
    chain,
    ranges,
    q: new Float64Array(chain.dof),
    place: new Float64Array(3),
    J: new Float64Array(3 * m),
    axes: new Float64Array(3 * m),
    turns: new Float64Array(3 * chain.dof),
    frames: new Float64Array(16 * (chain.dof + 1)),
  };
}

/** @param {Chain} chain @param {boolean} [withLimits] */
export const createPlacement = (chain, withLimits = true) => roomFor(chain, rangesOf(chain, withLimits));

/**
 * @param {Placement} placement  `q`, `place`, `J` and `axes` are filled
 * @param {ArrayLike<number>} x  a value for each of its joints
 */
export function writePlacement({ chain: { packed }, ranges: { joints }, q, place, J, axes, turns, frames }, x) {
  for (let k = 0; k < joints.length; k++) q[joints[k]] = x[k];
  writeTurns(packed, q, turns);
  writeAxes(packed, turns, frames, false);
  const { tool } = packed;
  const end = frames.length - 16;
  const px = frames[end] * tool[12] + frames[end + 4] * tool[13] + frames[end + 8] * tool[14] + frames[end + 12];
  const py = frames[end + 1] * tool[12] + frames[end + 5] * tool[13] + frames[end + 9] * tool[14] + frames[end + 13];
  const pz = frames[end + 2] * tool[12] + frames[end + 6] * tool[13] + frames[end + 10] * tool[14] + frames[end + 14];
  place[0] = px;
  place[1] = py;
  place[2] = pz;
  for (let k = 0; k < joints.length; k++) {
    const frame = 16 * joints[k];
    const at = 3 * k;
    const zx = frames[frame + 8];
    const zy = frames[frame + 9];
    const zz = frames[frame + 10];
    axes[at] = zx;
    axes[at + 1] = zy;
    axes[at + 2] = zz;
    if (isSlide(packed, joints[k])) {
      J[at] = zx;
      J[at + 1] = zy;
      J[at + 2] = zz;
    } else {
      const rx = px - frames[frame + 12];
      const ry = py - frames[frame + 13];
      const rz = pz - frames[frame + 14];
      J[at] = zy * rz - zz * ry;
      J[at + 1] = zz * rx - zx * rz;
      J[at + 2] = zx * ry - zy * rx;
    }
  }
}
