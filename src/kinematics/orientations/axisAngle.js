/**
 * Orientations as one turn about one axis, and as a rotation vector: that axis times the angle, as Universal Robots write
 * it (Rx, Ry, Rz, radians). To and from poses.
 *
 * Any turn can be given; what is returned is the shortest, with an angle in [0, π]. No turn has no axis: z is returned. A
 * half turn, an angle of Math.PI to the last digit, has two: the one whose first component that is not zero is positive is
 * returned, where what rounding leaves counts as zero, so that it does not decide.
 *
 * @import { Pose } from '../pose.js'
 *
 * @typedef {object} AxisAngle
 * @property {Float64Array} axis  3, of unit length
 * @property {number} angle  radians, in [0, π]
 */
import { exactCosine, exactSine } from '../angles.js';
import { requireRoom } from '../checks.js';
import { finishPose, requireNumbers } from './poseInput.js';
import { quaternionOf } from './quaternion.js';

/** What rounding may leave of a component that ought to be zero. */
const ZERO = 16 * Number.EPSILON;

const xyzw = new Float64Array(4);
const reading = { axis: new Float64Array(3), angle: 0 };

/**
 * Rodrigues' formula with the axis as it was typed: its length is divided out at the end, so that right angles about the
 * diagonals are as exact as those about x, y and z.
 * @param {ArrayLike<number>} xyz metres
 * @param {ArrayLike<number>} axis  of any length but zero
 * @param {number} angle radians
 * @param {Pose} out
 */
function turnedAbout(xyz, axis, angle, out) {
  const largest = Math.max(Math.abs(axis[0]), Math.abs(axis[1]), Math.abs(axis[2]));
  const x = axis[0] / largest;
  const y = axis[1] / largest;
  const z = axis[2] / largest;
  const square = x * x + y * y + z * z;
  const cosine = exactCosine(angle);
  const sine = exactSine(angle) / Math.sqrt(square);
  const v = (1 - cosine) / square;
  out[0] = 1 - v * (y * y + z * z);
  out[1] = v * x * y + sine * z;
  out[2] = v * x * z - sine * y;
  out[4] = v * x * y - sine * z;
  out[5] = 1 - v * (x * x + z * z);
  out[6] = v * y * z + sine * x;
  out[8] = v * x * z + sine * y;
  out[9] = v * y * z - sine * x;
  out[10] = 1 - v * (x * x + y * y);
  return finishPose(out, xyz);
}

/**
 * Right angles are exact about the axes x, y, z, half turns also about the diagonals between two of them.
 * @example
 * Array.from(poseFromAxisAngle([0, 0, 0], [0, 0, 2], Math.PI / 2).subarray(0, 3)) // → [0, 1, 0]
 * @param {ArrayLike<number>} xyz metres
 * @param {ArrayLike<number>} axis  its length is divided out
 * @param {number} angle radians
 * @param {Pose} [out]
 * @returns {Pose}
 */
export function poseFromAxisAngle(xyz, axis, angle, out = new Float64Array(16)) {
  requireNumbers(xyz, 3, 'a position');
  requireNumbers(axis, 3, 'an axis');
  if (!Number.isFinite(angle)) throw new RangeError(`Expected an angle to be finite, got ${angle}.`);
  requireRoom(out, 16);
  if (axis[0] === 0 && axis[1] === 0 && axis[2] === 0) {
    throw new RangeError('Expected an axis that is not zero, got 0 0 0.');
  }
  return turnedAbout(xyz, axis, angle, out);
}

/**
 * @example
 * axisAngleOf(poseFromAxisAngle([0, 0, 0], [0, -1, 0], Math.PI)).angle // → Math.PI
 * Array.from(axisAngleOf(poseFromAxisAngle([0, 0, 0], [0, -1, 0], Math.PI)).axis) // → [0, 1, 0]
 * @param {ArrayLike<number>} T  a pose; its position does not matter
 * @param {AxisAngle} [out]
 * @returns {AxisAngle}
 */
export function axisAngleOf(T, out = { axis: new Float64Array(3), angle: 0 }) {
  const { axis } = out;
  requireRoom(axis, 3);
  const [x, y, z, w] = quaternionOf(T, xyzw);
  const sine = Math.hypot(x, y, z);
  out.angle = 2 * Math.atan2(sine, w);
  if (sine === 0) {
    axis.set([0, 0, 1]);
    return out;
  }
  const leading = out.angle === Math.PI ? [x, y, z].find((value) => Math.abs(value) > ZERO) : 1;
  const largest = Math.max(Math.abs(x), Math.abs(y), Math.abs(z)) * Math.sign(leading ?? 1);
  // twice, since a length among the smallest numbers has no digits
  const length = Math.hypot(x / largest, y / largest, z / largest);
  axis[0] = x / largest / length + 0;
  axis[1] = y / largest / length + 0;
  axis[2] = z / largest / length + 0;
  return out;
}

/**
 * @example
 * Array.from(poseFromRotationVector([0, 0, 0], [0, 0, Math.PI / 2]).subarray(0, 3)) // → [0, 1, 0]
 * @param {ArrayLike<number>} xyz metres
 * @param {ArrayLike<number>} vector  axis times angle, radians; zero is no turn
 * @param {Pose} [out]
 * @returns {Pose}
 */
export function poseFromRotationVector(xyz, vector, out = new Float64Array(16)) {
  requireNumbers(xyz, 3, 'a position');
  requireNumbers(vector, 3, 'a rotation vector');
  requireRoom(out, 16);
  const angle = Math.hypot(vector[0], vector[1], vector[2]);
  if (!Number.isFinite(angle))
    throw new RangeError(`Expected the length of a rotation vector to be finite, got ${angle}.`);
  return turnedAbout(xyz, angle === 0 ? [0, 0, 1] : vector, angle, out);
}

/**
 * @example
 * Array.from(rotationVectorOf(poseFromRotationVector([0, 0, 0], [0.1, -0.2, 0.3]))) // → [0.1, -0.2, 0.3]
 * @param {ArrayLike<number>} T  a pose; its position does not matter
 * @param {Float64Array} [out]
 * @returns {Float64Array} 3, radians, of a length in [0, π]
 */
export function rotationVectorOf(T, out = new Float64Array(3)) {
  requireRoom(out, 3);
  const { axis, angle } = axisAngleOf(T, reading);
  out[0] = axis[0] * angle;
  out[1] = axis[1] * angle;
  out[2] = axis[2] * angle;
  return out;
}
