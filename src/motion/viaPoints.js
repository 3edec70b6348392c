/**
 * Ways past given points at given times: the cubic spline goes through them with a continuous acceleration; linear segments
 * with parabolic blends pass near them with a constant acceleration (Craig, Introduction to Robotics, section 7.3).
 *
 * @import { TimeLaw } from './timeLaw.js'
 */
import { timeLaw } from './timeLaw.js';

/**
 * The cubic spline through points, with given rates at both ends.
 * @param {readonly number[]} points     2 or more
 * @param {readonly number[]} durations  s, above 0, one less
 * @param {{ rateBefore?: number, rateAfter?: number }} [ends]
 * @returns {TimeLaw}
 */
export function cubicSpline(points, durations, { rateBefore = 0, rateAfter = 0 } = {}) {
  requireVias(points, durations);
  const n = durations.length;
  // Equal accelerations at inner points: a tridiagonal system in the rates there.
  const rates = [...points.keys()].map((i) => (i === 0 ? rateBefore : i === n ? rateAfter : 0));
  const diagonal = rates.map(() => 1);
  for (let i = 1; i < n; i++) {
    const [h, k] = [durations[i - 1], durations[i]];
    const pull =
      3 * ((points[i] - points[i - 1]) * (k / h) + (points[i + 1] - points[i]) * (h / k)) -
      (i === 1 ? k * rateBefore : 0) -
      (i === n - 1 ? h * rateAfter : 0);
    const factor = i === 1 ? 0 : k / diagonal[i - 1];
    diagonal[i] = 2 * (h + k) - (i === 1 ? 0 : factor * durations[i - 2]);
    rates[i] = pull - factor * (i === 1 ? 0 : rates[i - 1]);
  }
  for (let i = n - 1; i >= 1; i--) {
    rates[i] = (rates[i] - (i === n - 1 ? 0 : durations[i - 1] * rates[i + 1])) / diagonal[i];
  }
  return timeLaw(
    points[0],
    points[n],
    durations.map((duration, i) => {
      const mean = (points[i + 1] - points[i]) / duration;
      const [u, w] = [rates[i], rates[i + 1]];
      return {
        duration,
        coefficients: [points[i], u, (3 * mean - 2 * u - w) / duration, (u + w - 2 * mean) / duration ** 2],
      };
    }),
  );
}

/**
 * Linear segments with parabolic blends: from rest at the first point to rest at the last, past the others without touching
 * them. The blends at both ends lie within their segments, so that the first and last points are met.
 * @param {readonly number[]} points     2 or more
 * @param {readonly number[]} durations  s, above 0, one less: from point to point
 * @param {number} acceleration  its size in every blend, above 0
 * @returns {{ law: TimeLaw, blends: number[], rates: number[] }}  how long the blend at each point takes, s; the rates between
 * @throws {RangeError} where the acceleration is too small for the blends to find room
 */
export function parabolicBlends(points, durations, acceleration) {
  requireVias(points, durations);
  if (!(acceleration > 0 && acceleration < Infinity)) {
    throw new RangeError(`acceleration: expected a number above 0, got ${acceleration}.`);
  }
  const n = durations.length;
  const ways = durations.map((_, i) => points[i + 1] - points[i]);
  const rates = ways.map((way, i) => way / durations[i]);
  const blends = points.map(() => 0);
  if (n === 1) {
    const blend = endBlend(ways[0], durations[0], acceleration, 2);
    blends.fill(blend);
    rates[0] = ways[0] / (durations[0] - blend);
  } else {
    blends[0] = endBlend(ways[0], durations[0], acceleration, 1);
    blends[n] = endBlend(ways[n - 1], durations[n - 1], acceleration, 1);
    rates[0] = ways[0] / (durations[0] - blends[0] / 2);
    rates[n - 1] = ways[n - 1] / (durations[n - 1] - blends[n] / 2);
  }
  for (let i = 1; i < n; i++) blends[i] = Math.abs(rates[i] - rates[i - 1]) / acceleration;

  /** @type {{ duration: number, coefficients: number[] }[]} */
  const parts = [];
  let position = points[0];
  for (let i = 0; i <= n; i++) {
    const [before, after] = [i === 0 ? 0 : rates[i - 1], i === n ? 0 : rates[i]];
    const bend = blends[i] === 0 ? 0 : (after - before) / blends[i] / 2;
    parts.push({ duration: blends[i], coefficients: [position, before, bend] });
    position += ((before + after) / 2) * blends[i];
    if (i === n) break;
    const lead = i === 0 ? blends[0] : blends[i] / 2;
    const tail = i === n - 1 ? blends[n] : blends[i + 1] / 2;
    const straight = durations[i] - lead - tail;
    if (straight < -1e-12 * durations[i]) {
      throw new RangeError(
        `acceleration: ${acceleration} is too small for the blends about segment ${i + 1} of ${durations[i]} s; they would take ${lead + tail} s.`,
      );
    }
    parts.push({ duration: Math.max(0, straight), coefficients: [position, rates[i]] });
    position += rates[i] * Math.max(0, straight);
  }
  return { law: timeLaw(points[0], points[n], parts), blends, rates };
}

/**
 * How long the blend from or to a rest takes, where it lies within its segment.
 * @param {number} way @param {number} duration @param {number} acceleration @param {1 | 2} count  blends in the segment
 */
function endBlend(way, duration, acceleration, count) {
  const square = duration ** 2 - (2 * count * Math.abs(way)) / acceleration;
  if (square < 0) {
    const least = (2 * count * Math.abs(way)) / duration ** 2;
    throw new RangeError(`acceleration: expected at least ${least} for ${way} in ${duration} s, got ${acceleration}.`);
  }
  return (duration - Math.sqrt(square)) / count;
}

/** @param {readonly number[]} points @param {readonly number[]} durations */
function requireVias(points, durations) {
  if (points.length < 2 || durations.length !== points.length - 1) {
    throw new RangeError(
      `Expected 2 or more points and one duration less, got ${points.length} and ${durations.length}.`,
    );
  }
  const bad =
    durations.find((duration) => !(duration > 0 && duration < Infinity)) ?? points.find((p) => !Number.isFinite(p));
  if (bad !== undefined) throw new RangeError(`Expected finite points, and durations above 0, got ${bad}.`);
}
