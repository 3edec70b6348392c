/**
 * All the ways in which the page writes an orientation: Euler angles by the names of those who use them, quaternions, axis
 * and angle, rotation vector, and the 24 sequences one by one. A form knows what its numbers are called, so that no triple
 * of angles is ever shown without its name.
 *
 * @import { Units } from './document.js'
 * @import { EulerSequence } from '../kinematics/orientations/eulerAngles.js'
 *
 * @typedef {'locked' | 'noTurn' | 'halfTurn'} Freedom  why the numbers are not the only ones
 *
 * @typedef {object} Reading
 * @property {readonly number[]} values  as many as the form has labels, in document units
 * @property {Freedom | null} freedom
 * @property {0 | 2 | null} setToZero    the angle that was free, if it is locked
 *
 * @typedef {object} OrientationForm
 * @property {string} id
 * @property {'named' | 'other' | 'moving' | 'fixed'} group
 * @property {string} name              stands beside the numbers
 * @property {readonly string[]} labels of the numbers, in their order
 * @property {readonly ('angle' | 'none')[]} quantities
 * @property {string} [product]         of three turns: what is multiplied, the first factor about an axis of the fixed frame
 * @property {EulerSequence} [sequence]
 * @property {(T: Float64Array, units: Units) => Reading} read
 */
import { axisAngleOf, rotationVectorOf } from '../kinematics/orientations/axisAngle.js';
import { EULER_SEQUENCES } from '../kinematics/orientations/eulerAngles.js';
import { EULER_NAMES } from '../kinematics/orientations/eulerNames.js';
import { quaternionOf } from '../kinematics/orientations/quaternion.js';
import { eulerNumbers } from './eulerNumbers.js';
import { fromKernel } from './units.js';

/**
 * "Rz(A) · Ry(B) · Rx(C)"
 * @param {EulerSequence} sequence
 * @param {readonly string[]} labels
 */
function productOf(sequence, labels) {
  const turns = Array.from(sequence.toLowerCase(), (axis, i) => `R${axis}(${labels[i]})`);
  return (sequence === sequence.toLowerCase() ? turns.reverse() : turns).join(' · ');
}

/**
 * @param {string} id
 * @param {OrientationForm['group']} group
 * @param {string} name
 * @param {EulerSequence} sequence
 * @param {readonly string[]} labels
 * @returns {OrientationForm}
 */
const angles = (id, group, name, sequence, labels) => ({
  id,
  group,
  name,
  labels,
  quantities: ['angle', 'angle', 'angle'],
  sequence,
  product: productOf(sequence, labels),
  read(T, units) {
    const { values, setToZero } = eulerNumbers(sequence, T, units);
    return { values, setToZero, freedom: setToZero === null ? null : 'locked' };
  },
});

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
});

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
};

const isMoving = (/** @type {EulerSequence} */ sequence) => sequence === sequence.toUpperCase();
const GREEK = ['α', 'β', 'γ']; // the first, the second and the third turn

/** @type {readonly OrientationForm[]} */
export const ORIENTATION_FORMS = [
  angles('wpr', 'named', 'FANUC WPR', 'xyz', ['W', 'P', 'R']),
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
