/**
 * An orientation as three angles of a document, and which of them was free to choose.
 *
 * @import { Units } from '../document.js'
 * @import { EulerSequence } from '../../kinematics/orientations/eulerAngles.js'
 */
import { eulerAnglesOf } from '../../kinematics/orientations/eulerAngles.js';
import { fromKernel } from '../units.js';

/**
 * At gimbal lock the first and the last turn are about one axis: the one about an axis of the fixed frame is then 0 (see
 * eulerAngles.js), which is the first of a sequence about moving axes and the last of one about fixed axes.
 * @param {EulerSequence} sequence
 * @param {Float64Array} T
 * @param {Units} units
 * @returns {{ values: number[], setToZero: 0 | 2 | null }} which of the three was free and is therefore 0
 */
export function eulerNumbers(sequence, T, units) {
  const { angles, isGimbalLock } = eulerAnglesOf(T, sequence);
  const isFixed = sequence === sequence.toLowerCase();
  return {
    values: Array.from(angles, (angle) => fromKernel('angle', angle, units)),
    setToZero: isGimbalLock ? (isFixed ? 2 : 0) : null,
  };
}
