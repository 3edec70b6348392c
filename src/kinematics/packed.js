/**
 * A chain's numbers as the hot loops want them, whatever convention its table is written in.
 *
 * A standard row is Rz(θ) Tz(d) Tx(a) Rx(α); a modified (Craig) row i is Rx(α_{i−1}) Tx(a_{i−1}) Rz(θ_i) Tz(d_i). Either way
 * the whole chain is  base · Z_1(q_1) X_1 · Z_2(q_2) X_2 · … · Z_n(q_n) X_n · tool  with Z = Rz(θ) Tz(d) and X = Tx(a) Rx(α): a
 * modified table only has its first X before the first joint (it goes into `start`) and none after the last.
 *
 * The trigonometry of the constants is done here, once, and exactly for right angles; at q = 0 it stays exact, since
 * cos(θ + q) = cos θ cos q − sin θ sin q.
 *
 * @import { Convention, Joint } from './joint.js'
 * @import { Pose } from './pose.js'
 *
 * @typedef {object} Packed   for this folder only, never to be written to
 * @property {Pose} base
 * @property {Pose} start     the frame that joint 1 moves in, seen from the world
 * @property {Pose} tool
 * @property {boolean} hasTool  false if the TCP is the flange itself
 * @property {boolean} isModified
 * @property {Float64Array} rows  ROW numbers for each joint, at the offsets below
 * @property {Float64Array} lower
 * @property {Float64Array} upper
 */
import { exactCosine, exactSine } from './angles.js';
import { compose, identity } from './pose.js';

/** One joint's place in `rows`, and what stands where in it: Z first, X after it. */
export const ROW = 8;
export const COS_THETA = 0;
export const SIN_THETA = 1;
export const OFFSET = 2;
export const LENGTH = 3;
export const COS_TWIST = 4;
export const SIN_TWIST = 5;
export const SLIDES = 6;

/** A bound for loops over joints: an index that the compiler knows to be small costs nothing to check. */
export const MOST_JOINTS = 64;

/**
 * @param {Convention} convention
 * @param {readonly Joint[]} joints
 * @param {Pose} base
 * @param {Pose} tool
 * @returns {Packed}
 */
export function pack(convention, joints, base, tool) {
  if (joints.length > MOST_JOINTS)
    throw new RangeError(`Expected at most ${MOST_JOINTS} joints, got ${joints.length}.`);
  const isModified = convention === 'modified';
  const rows = new Float64Array(ROW * joints.length);
  joints.forEach(({ type, theta, d }, i) => {
    const link = isModified ? joints[i + 1] : joints[i];
    rows.set(
      [
        exactCosine(theta),
        exactSine(theta),
        d,
        link?.a ?? 0,
        exactCosine(link?.alpha ?? 0),
        exactSine(link?.alpha ?? 0),
        Number(type === 'prismatic'),
      ],
      ROW * i,
    );
  });
  const [{ a, alpha }] = joints;
  const [c, s] = [exactCosine(alpha), exactSine(alpha)];
  const unit = identity();
  return Object.freeze({
    base: base.slice(),
    start: isModified ? compose(base, Float64Array.of(1, 0, 0, 0, 0, c, s, 0, 0, -s, c, 0, a, 0, 0, 1)) : base.slice(),
    tool: tool.slice(),
    isModified,
    hasTool: tool.some((value, i) => value !== unit[i]),
    rows,
    lower: Float64Array.from(joints, ({ lower }) => lower),
    upper: Float64Array.from(joints, ({ upper }) => upper),
  });
}
