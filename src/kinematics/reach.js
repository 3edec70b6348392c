/**
 * How far an arm can reach, as a bound that can be proven, and the length that weighs metres against radians.
 *
 * Choose a point on every joint axis. The distance between the points on two neighbouring axes is fixed by the link (a
 * slide changes it by no more than its travel), so no posture puts the TCP farther from the point on the first axis, the
 * *shoulder*, than the sum of these distances. This holds for any choice of points; the ones chosen make the sum small,
 * so that neither offsets along parallel axes nor the common normals, kilometres away, of nearly parallel ones count.
 *
 * The sum is convex in the places s_i of the points along their axes. It is minimised by iteratively reweighted least
 * squares (Weiszfeld): a tridiagonal system each time, with a floor under the distances that shrinks, since where axes
 * cross, as in a wrist, the best distance is zero and the sum has a kink.
 *
 * @import { Packed } from './packed.js'
 * @import { Pose } from './pose.js'
 *
 * @typedef {{ across: number, slope: number, rise: number, along: number, travel: number }} Link  from axis point i to
 *   i + 1: the squared distance is across² + (slope · s_{i+1})² + (rise · s_{i+1} − s_i + along ± travel)²
 */
import { COS_TWIST, LENGTH, OFFSET, ROW, SIN_TWIST, SLIDES } from './packed.js';

const ROUNDS = 60;
const FIRST_FLOOR = 0.1; // of the sum before
const LAST_FLOOR = 1e-12;

/**
 * What the chain's links are, from shoulder to TCP. Unlimited slides have infinite travel about q = 0.
 * @param {Packed} packed
 * @returns {Link[]}
 */
function linksOf({ rows, tool, lower, upper }) {
  return Array.from(lower, (low, i) => {
    const at = ROW * i;
    const high = upper[i];
    const slides = rows[at + SLIDES] === 1;
    const isLimited = Number.isFinite(low) && Number.isFinite(high);
    const link = {
      across: rows[at + LENGTH],
      slope: rows[at + SIN_TWIST],
      rise: rows[at + COS_TWIST],
      along: rows[at + OFFSET] + (slides && isLimited ? (low + high) / 2 : 0),
      travel: slides ? (high - low) / 2 : 0,
    };
    if (i < lower.length - 1) return link;
    // the TCP is a point, not an axis: where X_n · tool puts it
    const [x, y, z] = [tool[12], tool[13], tool[14]];
    const side = link.rise * y - link.slope * z;
    const height = link.slope * y + link.rise * z;
    return { ...link, across: Math.hypot(link.across + x, side), along: link.along + height, slope: 0, rise: 0 };
  });
}

/**
 * @param {Link} link
 * @param {number} s
 * @param {number} next
 * @param {number} travel
 */
const distance = ({ across, slope, rise, along }, s, next, travel) =>
  Math.hypot(across, slope * next, Math.abs(rise * next - s + along) + travel);

/**
 * Solve the tridiagonal normal equations of Σ weight_i · squared distance_i, with the slides in mid-travel.
 * @param {Link[]} links
 * @param {number[]} weights
 */
function leastSquares(links, weights) {
  const n = links.length;
  const diagonal = new Float64Array(n);
  const below = new Float64Array(n);
  const s = new Float64Array(n);
  links.forEach(({ slope, rise, along }, i) => {
    const weight = weights[i];
    diagonal[i] += weight;
    s[i] += weight * along;
    if (i === n - 1) return;
    diagonal[i + 1] += weight * (slope * slope + rise * rise);
    below[i + 1] -= weight * rise;
    s[i + 1] -= weight * rise * along;
  });
  for (let i = 1; i < n; i++) {
    const factor = below[i] / diagonal[i - 1];
    diagonal[i] -= factor * below[i];
    s[i] -= factor * s[i - 1];
  }
  for (let i = n - 1; i >= 0; i--) s[i] = (s[i] - (i < n - 1 ? below[i + 1] * s[i + 1] : 0)) / diagonal[i];
  return s;
}

/**
 * A rigid transform typed with six decimals stretches lengths by up to a millionth; the proof must not miss that.
 * @param {Pose} T
 */
function stretch(T) {
  let square = 0;
  for (let i = 0; i < 3; i++) {
    for (let j = 0; j < 3; j++) {
      const product = T[4 * i] * T[4 * j] + T[4 * i + 1] * T[4 * j + 1] + T[4 * i + 2] * T[4 * j + 2];
      square += (product - (i === j ? 1 : 0)) ** 2;
    }
  }
  return Math.sqrt(1 + Math.sqrt(square));
}

/**
 * The characteristic length is half the reach that the arm has while every unlimited slide stands at zero, or 1 m if that is
 * nothing: it grows with the arm, in every unit, and does not depend on which of the many valid tables describes it.
 * @param {Packed} packed
 * @returns {{ shoulder: readonly [number, number, number], reach: number, characteristicLength: number }}
 */
export function measureReach(packed) {
  const links = linksOf(packed);
  const lengths = (/** @type {Float64Array} */ s) =>
    links.map((link, i) => distance(link, s[i], s[i + 1] ?? 0, Number.isFinite(link.travel) ? link.travel : 0));
  const sum = (/** @type {number[]} */ values) => values.reduce((total, value) => total + value, 0);

  let best = new Float64Array(links.length);
  let shortest = sum(lengths(best));
  let weights = links.map(() => 1);
  for (let round = 0; round < ROUNDS; round++) {
    const s = leastSquares(links, weights);
    const distances = lengths(s);
    const total = sum(distances);
    if (total < shortest) [best, shortest] = [s, total];
    if (total === 0) break;
    const floor = total * FIRST_FLOOR * (LAST_FLOOR / FIRST_FLOOR) ** (round / ROUNDS);
    weights = distances.map((length) => 1 / Math.max(length, floor));
  }

  const { start } = packed;
  const isUnlimited = links.some(({ travel }) => travel === Infinity);
  const along = best[0];
  return {
    shoulder: Object.freeze([
      start[12] + along * start[8],
      start[13] + along * start[9],
      start[14] + along * start[10],
    ]),
    reach: isUnlimited ? Infinity : shortest * stretch(start),
    characteristicLength: shortest > 0 ? shortest / 2 : 1,
  };
}
