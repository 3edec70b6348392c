/**
 * Orientations as unit quaternions (Euler parameters), to and from poses. The order is x, y, z, w, the scalar last, as in
 * URDF tools, ROS and three.js; ABB's q1 q2 q3 q4 are w, x, y, z.
 *
 * q and −q are the same orientation. The one that is returned has w ≥ 0 and, at a half turn (w = 0), its first component that
 * is not zero positive.
 * @import { Pose } from '../pose.js'
 */
import { requireRoom } from '../checks.js';
import { requirePose } from '../pose.js';
import { finishPose, requireNumbers } from './poseInput.js';

/**
 * The quaternion need not have unit length; its length is divided out.
 * @example
 * Array.from(poseFromQuaternion([0, 0, 0], [0, 0, 1, 1]).subarray(0, 3)) // → [0, 1, 0]
 * @param {ArrayLike<number>} xyz metres
 * @param {ArrayLike<number>} xyzw
 * @param {Pose} [out]
 * @returns {Pose}
 */
export function poseFromQuaternion(xyz, xyzw, out = new Float64Array(16)) {
  requireNumbers(xyz, 3, 'a position');
  requireNumbers(xyzw, 4, 'a quaternion');
  requireRoom(out, 16);
  const largest = Math.max(Math.abs(xyzw[0]), Math.abs(xyzw[1]), Math.abs(xyzw[2]), Math.abs(xyzw[3]));
  if (largest === 0) throw new RangeError('Expected a quaternion that is not zero, got 0 0 0 0.');
  // so that no square over- or underflows, and quarter and third turns are exact
  const x = xyzw[0] / largest;
  const y = xyzw[1] / largest;
  const z = xyzw[2] / largest;
  const w = xyzw[3] / largest;
  const k = 2 / (x * x + y * y + z * z + w * w);
  out[0] = 1 - k * (y * y + z * z);
  out[1] = k * (x * y + w * z);
  out[2] = k * (x * z - w * y);
  out[4] = k * (x * y - w * z);
  out[5] = 1 - k * (x * x + z * z);
  out[6] = k * (y * z + w * x);
  out[8] = k * (x * z + w * y);
  out[9] = k * (y * z - w * x);
  out[10] = 1 - k * (x * x + y * y);
  return finishPose(out, xyz);
}

/**
 * By the component that is largest, from which the others are divided (Shepperd, "Quaternion from Rotation Matrix", 1978):
 * as many right digits at every angle.
 * @example
 * Array.from(quaternionOf([0, 1, 0, 0, 0, 0, 1, 0, 1, 0, 0, 0, 0, 0, 0, 1])) // → [0.5, 0.5, 0.5, 0.5]
 * @param {ArrayLike<number>} T  a pose; its position does not matter
 * @param {Float64Array} [out]
 * @returns {Float64Array} x, y, z, w; of unit length
 */
export function quaternionOf(T, out = new Float64Array(4)) {
  requirePose(T, 'an orientation');
  requireRoom(out, 4);
  const trace = T[0] + T[5] + T[10];
  // 4w·(w, x, y, z), or the same with x, y or z as the factor
  let w = 1 + trace;
  let x = T[6] - T[9];
  let y = T[8] - T[2];
  let z = T[1] - T[4];
  if (trace < T[0] || trace < T[5] || trace < T[10]) {
    if (T[0] >= T[5] && T[0] >= T[10]) {
      w = x;
      x = 1 + T[0] - T[5] - T[10];
      y = T[1] + T[4];
      z = T[2] + T[8];
    } else if (T[5] >= T[10]) {
      w = y;
      x = T[1] + T[4];
      y = 1 + T[5] - T[0] - T[10];
      z = T[6] + T[9];
    } else {
      w = z;
      x = T[2] + T[8];
      y = T[6] + T[9];
      z = 1 + T[10] - T[0] - T[5];
    }
  }
  const leading = [w, x, y, z].find((value) => value !== 0) ?? 1;
  const length = Math.hypot(x, y, z, w) * Math.sign(leading);
  out[0] = x / length + 0;
  out[1] = y / length + 0;
  out[2] = z / length + 0;
  out[3] = w / length + 0;
  return out;
}
