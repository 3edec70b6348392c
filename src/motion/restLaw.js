/**
 * The laws by which a way is covered from rest to rest, by name.
 *
 * @import { MotionLimits } from './doubleS.js'
 * @import { TimeLaw } from './timeLaw.js'
 *
 * @typedef {'trapezoid' | 'doubleS' | 'cubic' | 'quintic'} LawName
 */
import { doubleS } from './doubleS.js';
import { cubicLaw, leastDuration, quinticLaw } from './polynomialLaws.js';
import { timeLaw } from './timeLaw.js';

/** @type {Record<LawName, (way: number, limits: MotionLimits) => TimeLaw>} */
const LAWS = {
  trapezoid: (way, { rate, acceleration }) => doubleS(0, way, { rate, acceleration }),
  doubleS: (way, limits) => doubleS(0, way, limits),
  cubic: (way, limits) => cubicLaw(0, way, leastDuration('cubic', way, limits)),
  quintic: (way, limits) => quinticLaw(0, way, leastDuration('quintic', way, limits)),
};

/**
 * The quickest of its kind within limits.
 * @param {LawName} name
 * @param {number} way   0 or more
 * @param {MotionLimits} limits
 * @returns {TimeLaw}
 */
export function restLaw(name, way, limits) {
  return way === 0 ? timeLaw(0, 0, []) : LAWS[name](way, limits);
}
