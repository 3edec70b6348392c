/**
 * The only file that converts between document units and kernel units (metres, radians).
 * @import { AngleUnit, LengthUnit, Units } from './document.js'
 */
const RADIANS_PER_DEGREE = Math.PI / 180;

export const toRadians = (/** @type {number} */ degrees) => degrees * RADIANS_PER_DEGREE;
export const toDegrees = (/** @type {number} */ radians) => radians / RADIANS_PER_DEGREE;

/** How many of the unit make a metre: a whole number, so that dividing rounds only once (0.1 + 0.2 mm stay honest). */
const PER_METRE = { mm: 1000, cm: 100, m: 1 };

/**
 * A document's number of a quantity → metres or radians.
 * @example
 * toKernel('length', 431.8, { length: 'mm', angle: 'deg' }) // → 0.4318
 * toKernel('angle', 90, { length: 'mm', angle: 'deg' }) // → Math.PI / 2
 * @param {'length' | 'angle'} quantity
 * @param {number} value
 * @param {Units} units
 */
export function toKernel(quantity, value, { length, angle }) {
  if (quantity === 'length') return value / PER_METRE[length];
  return angle === 'deg' ? toRadians(value) : value;
}

/**
 * Metres or radians → a document's number, for answers of the kernel (a posture that inverse kinematics found, a pose to
 * show). Never used to bring a document's own numbers back: the trip loses digits.
 * @example
 * fromKernel('length', 0.4318, { length: 'mm', angle: 'deg' }) // → 431.8
 * @param {'length' | 'angle'} quantity
 * @param {number} value
 * @param {Units} units
 */
export function fromKernel(quantity, value, { length, angle }) {
  if (quantity === 'length') return value * PER_METRE[length];
  return angle === 'deg' ? toDegrees(value) : value;
}

/** Seconds → milliseconds, for the few interfaces of the browser that want them. */
export const toMilliseconds = (/** @type {number} */ seconds) => seconds * 1000;
export const fromMilliseconds = (/** @type {number} */ milliseconds) => milliseconds / 1000;
