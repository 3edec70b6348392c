/**
 * An orientation as numbers: what every form of writing it knows. The forms themselves are in orientationForms.js.
 *
 * @import { Units } from '../document.js'
 * @import { EulerSequence } from '../../kinematics/orientations/eulerAngles.js'
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
 * @property {(values: readonly number[], units: Units) => Written} write  the way back; the position is the origin
 *
 * @typedef {object} LengthFault   a quaternion or an axis has the length 1, and is not made so unasked
 * @property {'quaternion' | 'axis'} of
 * @property {number} length
 * @property {readonly number[] | null} mended  divided by its length; null if there is none
 *
 * @typedef {{ T: Float64Array, fault: null } | { T: null, fault: LengthFault }} Written
 */
export {};
