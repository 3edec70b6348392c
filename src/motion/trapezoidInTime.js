/**
 * Linear segments with parabolic blends in a time that is given, as textbooks have them: the rate between the blends or the
 * acceleration in them is given too, and the other follows (Spong, Hutchinson & Vidyasagar, Robot Modeling and Control, on
 * trajectory planning; Siciliano et al., Robotics, section 4.2.1).
 *
 * @import { TimeLaw } from './timeLaw.js'
 */
import { timeLaw } from './timeLaw.js';

/**
 * @param {number} from
 * @param {number} to
 * @param {number} duration  s, above 0
 * @param {{ rate: number } | { acceleration: number }} given  sizes, above 0
 * @returns {{ law: TimeLaw, blend: number, rate: number, acceleration: number }}  blend: how long each takes, s
 * @throws {RangeError} where there is no such way: with the least and the largest rate, or the least acceleration
 */
export function trapezoidInTime(from, to, duration, given) {
  if (!(duration > 0 && duration < Infinity)) {
    throw new RangeError(`duration: expected a number of seconds above 0, got ${duration}.`);
  }
  const way = Math.abs(to - from);
  const sign = Math.sign(to - from);
  const blend = 'rate' in given ? blendByRate(way, duration, given.rate) : blendBy(way, duration, given.acceleration);
  const rate = way === 0 ? 0 : way / (duration - blend);
  const acceleration = way === 0 ? 0 : rate / blend;
  const half = (sign * acceleration) / 2;
  const blended = half * blend * blend;
  const law = timeLaw(from, to, [
    { duration: blend, coefficients: [from, 0, half] },
    { duration: duration - 2 * blend, coefficients: [from + blended, sign * rate] },
    { duration: blend, coefficients: [to - blended, sign * rate, -half] },
  ]);
  return { law, blend, rate, acceleration };
}

/** @param {number} way @param {number} duration @param {number} rate */
function blendByRate(way, duration, rate) {
  const [least, most] = [way / duration, (2 * way) / duration];
  if (way === 0) return duration / 2;
  if (rate > least && rate <= most) return duration - way / rate;
  throw new RangeError(`rate: expected more than ${least} and at most ${most} for this way and time, got ${rate}.`);
}

/** @param {number} way @param {number} duration @param {number} acceleration */
function blendBy(way, duration, acceleration) {
  const least = (4 * way) / duration ** 2;
  if (way === 0) return duration / 2;
  if (acceleration >= least && acceleration < Infinity) {
    return duration / 2 - Math.sqrt(Math.max(0, duration ** 2 - (4 * way) / acceleration)) / 2;
  }
  throw new RangeError(`acceleration: expected at least ${least} for this way and time, got ${acceleration}.`);
}
