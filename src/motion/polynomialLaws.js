/**
 * One polynomial from end to end, as textbooks have it: the cubic meets both positions and rates, the quintic accelerations
 * too. Between rests the cubic's largest rate is 3/2 and its largest acceleration 6 of the mean ones, D/T and D/T²; the
 * quintic's 15/8 and 10/√3, and its largest jerk 60 D/T³ (Lynch & Park, Modern Robotics, section 9.2).
 *
 * @import { MotionLimits } from './doubleS.js'
 * @import { TimeLaw } from './timeLaw.js'
 *
 * @typedef {object} EndStates   what is absent is 0
 * @property {number} [rateBefore]
 * @property {number} [rateAfter]
 * @property {number} [accelerationBefore]
 * @property {number} [accelerationAfter]
 */
import { timeLaw } from './timeLaw.js';

/** What the largest rate, acceleration and jerk of a way between rests are, over D/T, D/T² and D/T³. */
export const PEAKS = {
  cubic: { rate: 3 / 2, acceleration: 6, jerk: 12 },
  quintic: { rate: 15 / 8, acceleration: 10 / Math.sqrt(3), jerk: 60 },
};

/**
 * @param {number} from
 * @param {number} to
 * @param {number} duration  s, above 0; 0 only where there is no way to go
 * @param {EndStates} [ends]
 * @returns {TimeLaw}
 */
export function cubicLaw(from, to, duration, { rateBefore: u = 0, rateAfter: w = 0 } = {}) {
  requireDuration(from, to, duration);
  if (duration === 0) return timeLaw(from, to, []);
  const mean = (to - from) / duration;
  const coefficients = [from, u, (3 * mean - 2 * u - w) / duration, (u + w - 2 * mean) / duration ** 2];
  return timeLaw(from, to, [{ duration, coefficients }]);
}

/**
 * @param {number} from
 * @param {number} to
 * @param {number} duration  s, above 0; 0 only where there is no way to go
 * @param {EndStates} [ends]
 * @returns {TimeLaw}
 */
export function quinticLaw(from, to, duration, ends = {}) {
  requireDuration(from, to, duration);
  if (duration === 0) return timeLaw(from, to, []);
  const { rateBefore: u = 0, rateAfter: w = 0, accelerationBefore: a = 0, accelerationAfter: b = 0 } = ends;
  const [T, D] = [duration, to - from];
  const coefficients = [
    from,
    u,
    a / 2,
    (20 * D - (8 * w + 12 * u) * T - (3 * a - b) * T * T) / (2 * T ** 3),
    (-30 * D + (14 * w + 16 * u) * T + (3 * a - 2 * b) * T * T) / (2 * T ** 4),
    (12 * D - 6 * (w + u) * T - (a - b) * T * T) / (2 * T ** 5),
  ];
  return timeLaw(from, to, [{ duration, coefficients }]);
}

/**
 * The least time that a polynomial between rests takes within limits. The cubic's jerk is endless at both ends, where its
 * acceleration begins and ends at once, and what it is between is held to the limit all the same.
 * @example
 * leastDuration('cubic', 1, { rate: 1.5, acceleration: 100 }) // → 1
 * @param {'cubic' | 'quintic'} kind
 * @param {number} way
 * @param {MotionLimits} limits
 */
export function leastDuration(kind, way, { rate, acceleration, jerk = Infinity }) {
  const [D, peaks] = [Math.abs(way), PEAKS[kind]];
  return Math.max(
    (peaks.rate * D) / rate,
    Math.sqrt((peaks.acceleration * D) / acceleration),
    Math.cbrt((peaks.jerk * D) / jerk),
  );
}

/** @param {number} from @param {number} to @param {number} duration */
function requireDuration(from, to, duration) {
  if (duration > 0 && duration < Infinity) return;
  if (duration === 0 && from === to) return;
  throw new RangeError(`duration: expected a number of seconds above 0, got ${duration}.`);
}
