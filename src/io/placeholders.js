/**
 * What other formats ask for and a kinematic model does not have. Real values are the maker's; whatever stands for them is said in
 * the file and before it is saved.
 *
 * @import { JointDoc, Units } from '../model/document.js'
 */
import { limitsOf, quantityOf } from '../model/document.js';
import { toKernel } from '../model/units.js';

/** kg and kg m², N m or N, rad/s or m/s. */
export const PLACEHOLDERS = Object.freeze({ mass: 1, inertia: 0.01, effort: 1000, velocity: 1 });

/** How far a limit is that is not there while the other is, in radians or metres: farther than any arm goes. */
export const FAR = 1e6;

/**
 * Both limits of a joint, in radians or metres, for formats that want both.
 * @param {JointDoc} joint
 * @param {Units} units
 */
export function bothLimits(joint, units) {
  const ends = limitsOf(joint);
  const value = (/** @type {number} */ typed) => toKernel(quantityOf(joint, 'lower'), typed, units);
  const [lower, upper] = [value(ends.lower), value(ends.upper)];
  return {
    lower: lower === -Infinity ? Math.min(0, upper) - FAR : lower,
    upper: upper === Infinity ? Math.max(0, lower) + FAR : upper,
  };
}
