/**
 * Orientations as people and controllers write them, to and from poses.
 *
 * Roll, pitch, yaw: R = Rz(yaw) · Ry(pitch) · Rx(roll), turns about fixed axes x, y, z in that order (Craig, section 2.8,
 * "X–Y–Z fixed angles"). The same rotation is FANUC's W P R (roll, pitch, yaw), KUKA's C B A and the rpy of URDF.
 * @import { Pose } from './pose.js'
 */
import { exactCosine, exactSine } from './angles.js';

/**
 * cos(pitch) below which roll and yaw turn about the same line and only their sum or difference means anything. Three
 * decades above the rounding of a product of six frames, and no more: what is called locked here is off by at most this.
 */
const GIMBAL_LOCK = 1e-12;

/** @param {ArrayLike<number>} values @param {number} count @param {string} name */
function requireNumbers(values, count, name) {
  if (values.length !== count) throw new RangeError(`Expected ${name} to be ${count} numbers, got ${values.length}.`);
  for (let i = 0; i < count; i++) {
    if (!Number.isFinite(values[i]))
      throw new RangeError(`Expected ${name} to be finite, got ${values[i]} at index ${i}.`);
  }
}

/** Adding 0 turns −0 into 0, so that poses that are the same look the same. @param {number[][]} columns @returns {Pose} */
const fromColumns = (columns) =>
  Float64Array.from(columns.flatMap(([x, y, z], i) => [x + 0, y + 0, z + 0, i === 3 ? 1 : 0]));

/**
 * Right angles are exact.
 * @example
 * Array.from(poseFromRollPitchYaw([1, 2, 3], [0, 0, Math.PI / 2])) // → [0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0, 1, 2, 3, 1]
 * @param {ArrayLike<number>} xyz metres
 * @param {ArrayLike<number>} rpy roll, pitch, yaw in radians
 * @returns {Pose}
 */
export function poseFromRollPitchYaw(xyz, rpy) {
  requireNumbers(xyz, 3, 'a position');
  requireNumbers(rpy, 3, 'roll, pitch, yaw');
  const [cr, cp, cy] = [rpy[0], rpy[1], rpy[2]].map(exactCosine);
  const [sr, sp, sy] = [rpy[0], rpy[1], rpy[2]].map(exactSine);
  // Craig, equation 2.64
  return fromColumns([
    [cy * cp, sy * cp, -sp],
    [cy * sp * sr - sy * cr, sy * sp * sr + cy * cr, cp * sr],
    [cy * sp * cr + sy * sr, sy * sp * cr - cy * sr, cp * cr],
    [xyz[0], xyz[1], xyz[2]],
  ]);
}

/**
 * Pitch is in [−π/2, π/2], roll and yaw in (−π, π]. At gimbal lock (pitch ±π/2) yaw is 0 and roll takes the whole turn.
 * Roll and pitch are read after turning back by the yaw that was chosen, so that the three together give the orientation
 * again to the last digits, however near the lock it is.
 * @example
 * rollPitchYawOf(poseFromRollPitchYaw([0, 0, 0], [0, Math.PI / 2, 0])) // → [0, Math.PI / 2, 0]
 * @param {ArrayLike<number>} T
 * @returns {[number, number, number]} roll, pitch, yaw in radians
 */
export function rollPitchYawOf(T) {
  const isLocked = Math.hypot(T[0], T[1]) < GIMBAL_LOCK;
  const yaw = isLocked ? 0 : Math.atan2(T[1] + 0, T[0]);
  const cy = isLocked ? 1 : Math.cos(yaw);
  const sy = isLocked ? 0 : Math.sin(yaw);
  const pitch = Math.atan2(-T[2], Math.max(0, cy * T[0] + sy * T[1]));
  const roll = Math.atan2(sy * T[8] - cy * T[9] + 0, cy * T[5] - sy * T[4]);
  return [roll + 0, pitch + 0, yaw + 0];
}

/**
 * The quaternion need not have unit length; its length is divided out. q and −q are the same orientation.
 * @example
 * Array.from(poseFromQuaternion([0, 0, 0], [0, 0, 1, 1]).subarray(0, 3)) // → [0, 1, 0]
 * @param {ArrayLike<number>} xyz metres
 * @param {ArrayLike<number>} xyzw
 * @returns {Pose}
 */
export function poseFromQuaternion(xyz, xyzw) {
  requireNumbers(xyz, 3, 'a position');
  requireNumbers(xyzw, 4, 'a quaternion');
  const largest = Math.max(...Array.from(xyzw, Math.abs));
  if (largest === 0) throw new RangeError('Expected a quaternion that is not zero, got 0 0 0 0.');
  const [x, y, z, w] = Array.from(xyzw, (v) => v / largest); // so that no square over- or underflows
  const k = 2 / (x * x + y * y + z * z + w * w);
  return fromColumns([
    [1 - k * (y * y + z * z), k * (x * y + w * z), k * (x * z - w * y)],
    [k * (x * y - w * z), 1 - k * (x * x + z * z), k * (y * z + w * x)],
    [k * (x * z + w * y), k * (y * z - w * x), 1 - k * (x * x + y * y)],
    [xyz[0], xyz[1], xyz[2]],
  ]);
}
