/**
 * Orientations written as three angles: the form of any Euler sequence, and FANUC's, with which the page starts. All the
 * forms are in orientationForms.js.
 *
 * @import { EulerSequence } from '../../kinematics/orientations/eulerAngles.js'
 * @import { OrientationForm } from './orientationNumbers.js'
 */
import { poseFromEulerAngles } from '../../kinematics/orientations/eulerAngles.js';
import { eulerNumbers } from './eulerNumbers.js';
import { toKernel } from '../units.js';

const ORIGIN = [0, 0, 0];

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
export const angleForm = (id, group, name, sequence, labels) => ({
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
  write(values, units) {
    const radians = values.map((value) => toKernel('angle', value, units));
    return { T: poseFromEulerAngles(ORIGIN, radians, sequence), fault: null };
  },
});

export const WPR = angleForm('wpr', 'named', 'FANUC WPR', 'xyz', ['W', 'P', 'R']);
