/**
 * Orientations as this page and FANUC write them, to and from poses: roll, pitch, yaw, which are W P R.
 *
 * R = Rz(yaw) · Ry(pitch) · Rx(roll), turns about fixed axes x, y, z in that order (Craig, section 2.8, "X–Y–Z fixed angles"). It is
 * the rpy of URDF, and KUKA's A B C read the other way round. The other sequences are in eulerAngles.js, and whose they are
 * in eulerNames.js; quaternions and rotation vectors are in quaternion.js and axisAngle.js.
 * @import { Pose } from './pose.js'
 */
import { eulerAnglesOf, poseFromEulerAngles } from './orientations/eulerAngles.js';
import { requireNumbers } from './orientations/poseInput.js';

/**
 * Right angles are exact.
 * @example
 * Array.from(poseFromRollPitchYaw([1, 2, 3], [0, 0, Math.PI / 2])) // → [0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0, 1, 2, 3, 1]
 * @param {ArrayLike<number>} xyz metres
 * @param {ArrayLike<number>} rpy roll, pitch, yaw in radians
 * @returns {Pose}
 */
export function poseFromRollPitchYaw(xyz, rpy) {
  requireNumbers(rpy, 3, 'roll, pitch, yaw');
  return poseFromEulerAngles(xyz, rpy, 'xyz');
}

/**
 * Pitch is in [−π/2, π/2], roll and yaw in (−π, π]. At gimbal lock (pitch ±π/2) yaw is 0 and roll takes the whole turn.
 * @example
 * rollPitchYawOf(poseFromRollPitchYaw([0, 0, 0], [0, Math.PI / 2, 0])) // → [0, Math.PI / 2, 0]
 * @param {ArrayLike<number>} T
 * @returns {[number, number, number]} roll, pitch, yaw in radians
 */
export function rollPitchYawOf(T) {
  const [roll, pitch, yaw] = eulerAnglesOf(T, 'xyz').angles;
  return [roll, pitch, yaw];
}
