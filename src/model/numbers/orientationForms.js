/**
 * All the ways in which the page writes an orientation: Euler angles by the names of those who use them, quaternions, axis
 * and angle, rotation vector, and the 24 sequences one by one. A form knows what its numbers are called, so that no triple
 * of angles is ever shown without its name.
 *
 * @import { Freedom, LengthFault, OrientationForm } from './orientationNumbers.js'
 * @import { EulerSequence } from '../../kinematics/orientations/eulerAngles.js'
 */
import {
  axisAngleOf,
  poseFromAxisAngle,
  poseFromRotationVector,
  rotationVectorOf,
} from '../../kinematics/orientations/axisAngle.js';
import { EULER_SEQUENCES } from '../../kinematics/orientations/eulerAngles.js';
import { EULER_NAMES } from '../../kinematics/orientations/eulerNames.js';
import { poseFromQuaternion, quaternionOf } from '../../kinematics/orientations/quaternion.js';
import { WPR, angleForm as angles } from './angleForm.js';
import { QUATERNION_TOLERANCE } from '../documentRules.js';
import { fromKernel, toKernel } from '../units.js';

const ORIGIN = [0, 0, 0];

/** @param {string} id @param {string} name @param {readonly number[]} order @returns {OrientationForm} */
const quaternion = (id, name, order) => ({
  id,
  group: 'other',
  name,
  labels: order.map((k) => 'xyzw'[k]),
  quantities: order.map(() => 'none'),
  read(T) {
    const xyzw = quaternionOf(T);
    return { values: order.map((k) => xyzw[k]), setToZero: null, freedom: null };
  },
  write(values) {
    const fault = lengthFault('quaternion', values, 4);
    if (fault) return { T: null, fault };
    const xyzw = [0, 0, 0, 0];
    order.forEach((k, i) => (xyzw[k] = values[i]));
    return { T: poseFromQuaternion(ORIGIN, xyzw), fault: null };
  },
});

/**
 * @param {LengthFault['of']} of
 * @param {readonly number[]} values
 * @param {number} count  the first so many are to have the length 1 together
 * @returns {LengthFault | null}
 */
function lengthFault(of, values, count) {
  const length = Math.hypot(...values.slice(0, count));
  if (Math.abs(length - 1) <= QUATERNION_TOLERANCE) return null;
  const mended = length > 0 ? values.map((value, i) => (i < count ? value / length : value)) : null;
  return { of, length, mended };
}

/** @param {number} angle in [0, π] @returns {Freedom | null} */
const freedomOf = (angle) => (angle === 0 ? 'noTurn' : angle === Math.PI ? 'halfTurn' : null);

/** @type {OrientationForm} */
const AXIS_ANGLE = {
  id: 'axis-angle',
  group: 'other',
  name: 'Axis and angle',
  labels: ['x', 'y', 'z', 'angle'],
  quantities: ['none', 'none', 'none', 'angle'],
  read(T, units) {
    const { axis, angle } = axisAngleOf(T);
    return { values: [...axis, fromKernel('angle', angle, units)], setToZero: null, freedom: freedomOf(angle) };
  },
  write(values, units) {
    const fault = lengthFault('axis', values, 3);
    if (fault) return { T: null, fault };
    return { T: poseFromAxisAngle(ORIGIN, values.slice(0, 3), toKernel('angle', values[3], units)), fault: null };
  },
};

/** @type {OrientationForm} */
const ROTATION_VECTOR = {
  id: 'rotation-vector',
  group: 'other',
  name: 'Rotation vector',
  labels: ['rx', 'ry', 'rz'],
  quantities: ['angle', 'angle', 'angle'],
  read(T, units) {
    const vector = Array.from(rotationVectorOf(T), (value) => fromKernel('angle', value, units));
    const isHalf = axisAngleOf(T).angle === Math.PI;
    return { values: vector, setToZero: null, freedom: isHalf ? 'halfTurn' : null };
  },
  write(values, units) {
    const vector = values.map((value) => toKernel('angle', value, units));
    return { T: poseFromRotationVector(ORIGIN, vector), fault: null };
  },
};

const isMoving = (/** @type {EulerSequence} */ sequence) => sequence === sequence.toUpperCase();
const GREEK = ['α', 'β', 'γ']; // the first, the second and the third turn

/** @type {readonly OrientationForm[]} */
export const ORIENTATION_FORMS = [
  WPR,
  angles('abc', 'named', 'KUKA ABC', 'ZYX', ['A', 'B', 'C']),
  angles('rpy', 'named', 'URDF rpy', 'xyz', ['r', 'p', 'y']),
  angles('roll-pitch-yaw', 'named', 'Roll-pitch-yaw', 'xyz', ['roll', 'pitch', 'yaw']),
  angles('zyz-euler', 'named', 'ZYZ', 'ZYZ', GREEK),
  quaternion('xyzw', 'Quaternion xyzw', [0, 1, 2, 3]),
  quaternion('wxyz', 'Quaternion wxyz', [3, 0, 1, 2]),
  AXIS_ANGLE,
  ROTATION_VECTOR,
  ...EULER_SEQUENCES.map((sequence) =>
    isMoving(sequence)
      ? angles(sequence, 'moving', `${sequence} Euler`, sequence, GREEK)
      : angles(sequence, 'fixed', `${sequence.toUpperCase()} fixed`, sequence, GREEK),
  ),
];

/** @param {string} id */
export const orientationForm = (id) => ORIENTATION_FORMS.find((form) => form.id === id) ?? ORIENTATION_FORMS[0];

/** Who else writes a form, by the kernel's list: "KUKA A B C". @param {OrientationForm} form */
export const usersOf = ({ sequence, labels }) =>
  EULER_NAMES.filter((entry) => entry.sequence === sequence && entry.angles.join() !== labels.join()).map(
    ({ name, angles: own }) => `${name} ${own.join(' ')}`,
  );
