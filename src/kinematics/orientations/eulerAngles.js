/**
 * Orientations as three turns about axes, in all 24 ways of doing it, to and from poses.
 *
 * A sequence is written as SciPy writes it. Upper case turns about the axes of the moving frame (intrinsic): ZYX is
 * Rz(first) · Ry(second) · Rx(third). Lower case turns about the axes of the fixed frame (extrinsic): zyx is
 * Rx(third) · Ry(second) · Rz(first). So xyz is ZYX read the other way round. MuJoCo's `eulerseq` has the cases swapped.
 *
 * Ranges: the outer angles are in (−π, π]; the middle one in [−π/2, π/2] where the three axes differ (Tait–Bryan angles) and
 * in [0, π] where the first comes back (proper Euler angles).
 *
 * Gimbal lock: at the ends of the middle range the outer turns are about one line, and only their sum or difference means
 * anything. Then the turn that stands leftmost in the product, the one about an axis of the fixed frame, is 0, and the
 * other takes it all. That is the first angle of an intrinsic and the last of an extrinsic sequence: the yaw of W P R, the A
 * of KUKA's A B C (so that the two stay the same numbers), α in Craig (section 2.8, the degenerate cases).
 *
 * One formula serves all sequences, as in Shoemake, "Euler Angle Conversion" (Graphics Gems IV, 1994): with axes i, j and
 * the remaining axis m, and s = 1 where i, j, m is a cyclic order, else −1, the columns of Ri(a) · Rj(b) are
 *
 *   column i: (cos b, sin a sin b, −s cos a sin b)     column j: (0, cos a, s sin a)
 *   column m: (s sin b, −s sin a cos b, cos a cos b)    with components along i, j, m
 *
 * and the last turn mixes two of them and leaves the third as it is: column m if it is about m, column i if it is about i.
 *
 * @import { Pose } from '../pose.js'
 *
 * @typedef {'XYX' | 'XZX' | 'YXY' | 'YZY' | 'ZXZ' | 'ZYZ' | 'XYZ' | 'XZY' | 'YXZ' | 'YZX' | 'ZXY' | 'ZYX'} IntrinsicSequence
 * @typedef {IntrinsicSequence | Lowercase<IntrinsicSequence>} EulerSequence
 *
 * @typedef {object} EulerReading
 * @property {Float64Array} angles      3, radians, in the order of the sequence
 * @property {boolean} isGimbalLock     whether one outer angle was set to 0, since any other would do as well
 * @property {number} lockDistance      how far the middle angle is from gimbal lock, radians: the outer angles change by
 *   about 1/lockDistance of any change of the orientation, rounding included
 */
import { exactCosine, exactSine } from '../angles.js';
import { requireRoom } from '../checks.js';
import { show } from '../joint.js';
import { requirePose } from '../pose.js';
import { finishPose, requireNumbers } from './poseInput.js';

/** The twelve sequences about moving axes, then the twelve about fixed axes. @type {readonly EulerSequence[]} */
export const EULER_SEQUENCES = Object.freeze(
  /** @type {const} */ ([
    ...['XYX', 'XZX', 'YXY', 'YZY', 'ZXZ', 'ZYZ', 'XYZ', 'XZY', 'YXZ', 'YZX', 'ZXY', 'ZYX'],
    ...['xyx', 'xzx', 'yxy', 'yzy', 'zxz', 'zyz', 'xyz', 'xzy', 'yxz', 'yzx', 'zxy', 'zyx'],
  ]),
);

/**
 * sin or cos of the middle angle up to which the outer turns count as about one line. That is a little above what rounding
 * makes of an exact lock in a product of eight frames (1.2e-15 in 50,000 of them), and no more: what is called locked here
 * is off by up to this much.
 */
const LOCK = 8 * Number.EPSILON;

/** Which axes turn, as they stand in the product Ri(a) · Rj(b) · Rk(c). @param {EulerSequence} sequence */
function axesOf(sequence) {
  const [first, j, third] = Array.from(sequence.toLowerCase(), (letter) => 'xyz'.indexOf(letter));
  const isExtrinsic = sequence === sequence.toLowerCase();
  const i = isExtrinsic ? third : first;
  const m = 3 - i - j;
  const sign = (j - i + 3) % 3 === 1 ? 1 : -1;
  const isProper = first === third;
  // p and q: the two columns that the last turn mixes
  return Object.freeze({ i, j, m, sign, isProper, isExtrinsic, p: isProper ? j : i, q: isProper ? m : j });
}

const AXES = new Map(EULER_SEQUENCES.map((sequence) => [sequence, axesOf(sequence)]));

/** @param {EulerSequence} sequence */
function requireAxes(sequence) {
  const axes = AXES.get(sequence);
  if (axes) return axes;
  throw new RangeError(`Expected a sequence such as 'ZYX' (moving axes) or 'zyx' (fixed axes), got ${show(sequence)}.`);
}

/**
 * Right angles are exact.
 * @example
 * Array.from(poseFromEulerAngles([1, 2, 3], [Math.PI / 2, 0, 0], 'ZYX')) // → [0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0, 1, 2, 3, 1]
 * @param {ArrayLike<number>} xyz metres
 * @param {ArrayLike<number>} angles  3, radians, in the order of the sequence
 * @param {EulerSequence} sequence
 * @param {Pose} [out]
 * @returns {Pose}
 */
export function poseFromEulerAngles(xyz, angles, sequence, out = new Float64Array(16)) {
  const { i, j, m, sign, isExtrinsic, p, q } = requireAxes(sequence);
  requireNumbers(xyz, 3, 'a position');
  requireNumbers(angles, 3, 'Euler angles');
  requireRoom(out, 16);
  const a = isExtrinsic ? angles[2] : angles[0];
  const c = isExtrinsic ? angles[0] : angles[2];
  const cosA = exactCosine(a);
  const sinA = exactSine(a);
  const cosB = exactCosine(angles[1]);
  const sinB = exactSine(angles[1]);
  const cosC = exactCosine(c);
  const sinC = sign * exactSine(c);
  out[4 * i + i] = cosB;
  out[4 * i + j] = sinA * sinB;
  out[4 * i + m] = -sign * cosA * sinB;
  out[4 * j + i] = 0;
  out[4 * j + j] = cosA;
  out[4 * j + m] = sign * sinA;
  out[4 * m + i] = sign * sinB;
  out[4 * m + j] = -sign * sinA * cosB;
  out[4 * m + m] = cosA * cosB;
  for (let row = 0; row < 3; row++) {
    const u = out[4 * p + row];
    const v = out[4 * q + row];
    out[4 * p + row] = cosC * u + sinC * v;
    out[4 * q + row] = cosC * v - sinC * u;
  }
  return finishPose(out, xyz);
}

/** The angle of a direction, in (−π, π]. @param {number} y @param {number} x */
function angleOf(y, x) {
  const angle = Math.atan2(y + 0, x + 0);
  return angle === -Math.PI ? Math.PI : angle;
}

/**
 * The leftmost turn is read first; the others are read from what is left after turning back by the very number that was
 * read. So the three together give the orientation again to the last digits, however near the lock it is and however badly
 * that first angle is determined there.
 * @example
 * Array.from(eulerAnglesOf(poseFromEulerAngles([0, 0, 0], [0.1, 0.2, 0.3], 'ZYZ'), 'ZYZ').angles) // → [0.1, 0.2, 0.3]
 * eulerAnglesOf(poseFromEulerAngles([0, 0, 0], [0.1, 0, 0.3], 'ZYZ'), 'ZYZ').isGimbalLock // → true
 * @param {ArrayLike<number>} T  a pose; its position does not matter
 * @param {EulerSequence} sequence
 * @param {EulerReading} [out]
 * @returns {EulerReading}
 */
export function eulerAnglesOf(
  T,
  sequence,
  out = { angles: new Float64Array(3), isGimbalLock: false, lockDistance: NaN },
) {
  const { i, j, m, sign, isProper, isExtrinsic, p, q } = requireAxes(sequence);
  requirePose(T, 'an orientation');
  requireRoom(out.angles, 3);
  // the column that the last turn leaves alone: `along` i, and what the first turn turned, at the angle a
  const column = 4 * (isProper ? i : m);
  const along = T[column + i];
  const x = isProper ? -sign * T[column + m] : T[column + m];
  const y = isProper ? T[column + j] : -sign * T[column + j];
  const bend = Math.hypot(x, y);
  const isGimbalLock = bend <= LOCK;
  const a = isGimbalLock ? 0 : angleOf(y, x);
  const cosA = exactCosine(a);
  const sinA = exactSine(a);
  const across = Math.max(0, cosA * x + sinA * y);
  const b = isProper ? Math.atan2(across, along) : Math.atan2(sign * along, across);
  // row j of what is left, Rj(b) · Rk(c), is row j of Rk(c)
  const atP = cosA * T[4 * p + j] + sign * sinA * T[4 * p + m];
  const atQ = cosA * T[4 * q + j] + sign * sinA * T[4 * q + m];
  const c = isProper ? angleOf(-sign * atQ, atP) : angleOf(sign * atP, atQ);
  out.angles[0] = isExtrinsic ? c : a;
  out.angles[1] = b + 0;
  out.angles[2] = isExtrinsic ? a : c;
  out.isGimbalLock = isGimbalLock;
  out.lockDistance = Math.atan2(bend, Math.abs(along));
  return out;
}
