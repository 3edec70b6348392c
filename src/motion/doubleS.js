/**
 * The quickest way from one position and rate to another within limits of rate, acceleration and jerk, with no acceleration
 * at either end: the double S. Without a limit of jerk it is the trapezoid (linear segments with parabolic blends).
 *
 * From rate u to rate w it takes at least T(Δ), Δ = |w − u|: 2√(Δ/j) while the acceleration limit a is not reached
 * (Δ ≤ a²/j), else Δ/a + a/j; and covers (u + w)/2 · T. A double S goes from v₀ to a peak rate p, stays there, and goes on to v₁.
 * What it covers without staying, S(p), grows with p where p ≥ max(v₀, v₁, 0), and where p ≤ min(v₀, v₁, 0); these are the
 * peaks of quickest ways. So p is found by halving, or is the rate limit itself and the rest of the way is covered there.
 *
 * Source of the form: Biagiotti & Melchiorri, Trajectory Planning for Automatic Machines and Robots (2008), section 3.4; its
 * search for the peak is not used, since it does not find the quickest way in every case.
 *
 * @import { TimeLaw } from './timeLaw.js'
 *
 * @typedef {object} MotionLimits   all above 0
 * @property {number} rate
 * @property {number} acceleration
 * @property {number} [jerk]   absent: unlimited
 *
 * @typedef {{ duration: number, coefficients: number[] }} Part
 */
import { timeLaw } from './timeLaw.js';

/** Halvings of an interval until two doubles are neighbours, and some. */
const HALVINGS = 1100;

/**
 * @param {number} from
 * @param {number} to
 * @param {MotionLimits} limits
 * @param {{ rateBefore?: number, rateAfter?: number }} [ends]  rates at both ends; beyond the limit it is come back to it first
 * @returns {TimeLaw}
 */
export function doubleS(from, to, limits, { rateBefore = 0, rateAfter = 0 } = {}) {
  requireLimits(limits);
  for (const [name, value] of Object.entries({ from, to, rateBefore, rateAfter })) {
    if (!Number.isFinite(value)) throw new RangeError(`${name}: expected a finite number, got ${value}.`);
  }
  if (Math.abs(rateAfter) > limits.rate) {
    throw new RangeError(`rateAfter: expected at most the rate limit ${limits.rate}, got ${rateAfter}.`);
  }
  const peak = peakRate(to - from, rateBefore, rateAfter, limits);
  const rise = change(rateBefore, peak, limits);
  const fall = change(peak, rateAfter, limits);
  const covered = rise.covers + fall.covers;
  const stay = peak === 0 ? 0 : Math.max(0, (to - from - covered) / peak);
  return timeLaw(from, to, [
    ...forwards(rise.parts, from, rateBefore),
    { duration: stay, coefficients: [from + rise.covers, peak] },
    ...backwards(fall.parts, to, rateAfter),
  ]);
}

/** @param {MotionLimits} limits */
function requireLimits({ rate, acceleration, jerk = Infinity }) {
  for (const [name, value] of Object.entries({ rate, acceleration, jerk })) {
    const isRight = value > 0 && (name === 'jerk' || Number.isFinite(value));
    if (!isRight) throw new RangeError(`limits.${name}: expected a number above 0, got ${value}.`);
  }
}

/** @param {number} way @param {number} before @param {number} after @param {MotionLimits} limits */
function peakRate(way, before, after, limits) {
  const most = limits.rate;
  const covers = (/** @type {number} */ peak) =>
    change(before, peak, limits).covers + change(peak, after, limits).covers;
  const upper = Math.min(Math.max(before, after, 0), most);
  const lower = Math.max(Math.min(before, after, 0), -most);
  if (way === covers(upper)) return upper; // nothing to add to what has to be done anyway
  if (way >= covers(upper)) return way >= covers(most) ? most : halve(upper, most, (peak) => covers(peak) <= way);
  return way <= covers(-most) ? -most : -halve(-lower, most, (peak) => covers(-peak) >= way);
}

/**
 * The largest number for which something still holds, between two: of one for which it does and one for which it does not.
 * @param {number} low @param {number} high @param {(value: number) => boolean} holds
 */
function halve(low, high, holds) {
  for (let i = 0; i < HALVINGS; i++) {
    const middle = low + (high - low) / 2;
    if (middle <= low || middle >= high) break;
    if (holds(middle)) low = middle;
    else high = middle;
  }
  return low;
}

/**
 * From one rate to another in the least time.
 * @param {number} before @param {number} after @param {MotionLimits} limits
 * @returns {{ covers: number, parts: { duration: number, jerk: number, acceleration: number }[] }}  acceleration: at the beginning
 */
function change(before, after, { acceleration: a, jerk: j = Infinity }) {
  const delta = Math.abs(after - before);
  const sign = Math.sign(after - before);
  const ramp = j === Infinity ? 0 : delta * j <= a * a ? Math.sqrt(delta / j) : a / j;
  const most = j === Infinity ? a : Math.min(a, j * ramp);
  const hold = j !== Infinity && delta * j <= a * a ? 0 : delta / a - ramp;
  const jerk = j === Infinity ? 0 : sign * j;
  return {
    covers: ((before + after) / 2) * (2 * ramp + hold),
    parts: [
      { duration: ramp, jerk, acceleration: 0 },
      { duration: hold, jerk: 0, acceleration: sign * most },
      { duration: ramp, jerk: -jerk, acceleration: sign * most },
    ],
  };
}

/** @param {ReturnType<typeof change>['parts']} parts @param {number} position @param {number} rate @returns {Part[]} */
function forwards(parts, position, rate) {
  return parts.map(({ duration: t, jerk, acceleration }) => {
    const coefficients = [position, rate, acceleration / 2, jerk / 6];
    position += t * (rate + t * (acceleration / 2 + (t * jerk) / 6));
    rate += t * (acceleration + (t * jerk) / 2);
    return { duration: t, coefficients };
  });
}

/**
 * Reckoned from the end, so that it ends where it should to the last digit.
 * @param {ReturnType<typeof change>['parts']} parts @param {number} position @param {number} rate  both at the end @returns {Part[]}
 */
function backwards(parts, position, rate) {
  /** @type {Part[]} */
  const found = [];
  for (const { duration: t, jerk, acceleration } of [...parts].reverse()) {
    const rateThen = rate - t * (acceleration + (t * jerk) / 2);
    position -= t * (rateThen + t * (acceleration / 2 + (t * jerk) / 6));
    rate = rateThen;
    found.unshift({ duration: t, coefficients: [position, rate, acceleration / 2, jerk / 6] });
  }
  return found;
}
