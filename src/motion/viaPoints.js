/**
 * Ways past given points at given times: the cubic spline goes through them with a continuous acceleration; linear segments
 * with parabolic blends pass near them with a constant acceleration (Craig, Introduction to Robotics, section 7.3).
 *
 * @import { TimeLaw } from './timeLaw.js'
 */
import { timeLaw } from './timeLaw.js';

/** Blends that meet by more than this share of their segment find no room. */
const ROUNDING = 1e-12;

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
  const { rates, blends, lacking } = blendsOf(points, durations, acceleration);
  if (lacking) throw new RangeError(`acceleration: ${lacking(acceleration)}`);

  /** @type {{ duration: number, coefficients: number[] }[]} */
  const parts = [];
  let position = points[0];
  for (let i = 0; i <= n; i++) {
    const [before, after] = [i === 0 ? 0 : rates[i - 1], i === n ? 0 : rates[i]];
    const bend = blends[i] === 0 ? 0 : (after - before) / blends[i] / 2;
    parts.push({ duration: blends[i], coefficients: [position, before, bend] });
    position += ((before + after) / 2) * blends[i];
    if (i === n) break;
    const straight = straightTime(blends, durations, i);
    parts.push({ duration: Math.max(0, straight), coefficients: [position, rates[i]] });
    position += rates[i] * Math.max(0, straight);
  }
  return { law: timeLaw(points[0], points[n], parts), blends, rates };
}

/**
 * The rates between points, how long the blend about each takes, and whether they find room.
 * @param {readonly number[]} points
 * @param {readonly number[]} durations
 * @param {number} acceleration
 * @returns {{ rates: number[], blends: number[], lacking: ((acceleration: number) => string) | null }}   lacking: why not, in words
 */
export function blendsOf(points, durations, acceleration) {
  const n = durations.length;
  const ways = durations.map((_, i) => points[i + 1] - points[i]);
  const rates = ways.map((way, i) => way / durations[i]);
  const blends = points.map(() => 0);
  const count = n === 1 ? 2 : 1; // blends within the segment
  for (const [end, segment] of n === 1
    ? [[0, 0]]
    : [
        [0, 0],
        [n, n - 1],
      ]) {
    const [way, duration] = [Math.abs(ways[segment]), durations[segment]];
    const square = duration ** 2 - (2 * count * way) / acceleration;
    if (square < 0) {
      const least = (2 * count * way) / duration ** 2;
      return {
        rates,
        blends,
        lacking: (got) => `expected at least ${least} for ${ways[segment]} in ${duration} s, got ${got}.`,
      };
    }
    // (duration − √square) / count, without the difference of two that are nearly the same
    blends[end] = (2 * way) / acceleration / (duration + Math.sqrt(square));
    rates[segment] = ways[segment] / (duration - (count * blends[end]) / 2);
  }
  if (n === 1) blends[1] = blends[0];
  for (let i = 1; i < n; i++) blends[i] = Math.abs(rates[i] - rates[i - 1]) / acceleration;
  const full = durations.findIndex((duration, i) => straightTime(blends, durations, i) < -ROUNDING * duration);
  if (full < 0) return { rates, blends, lacking: null };
  const lacking = (/** @type {number} */ got) =>
    `${got} is too small for the blends about segment ${full + 1} of ${durations[full]} s; they would take ${durations[full] - straightTime(blends, durations, full)} s.`;
  return { rates, blends, lacking };
}

/** How long it is straight between two blends; below 0 where they meet. @param {readonly number[]} blends @param {readonly number[]} durations @param {number} i */
function straightTime(blends, durations, i) {
  const last = durations.length - 1;
  const lead = i === 0 ? blends[0] : blends[i] / 2;
  const tail = i === last ? blends[last + 1] : blends[i + 1] / 2;
  return durations[i] - lead - tail;
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
