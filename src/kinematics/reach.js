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
 *
 * @typedef {{ across: number, slope: number, rise: number, along: number, travel: number }} Link  from axis point i to
 *   i + 1: the squared distance is across² + (slope · s_{i+1})² + (rise · s_{i+1} − s_i + along ± travel)²
 */
import { COS_TWIST, LENGTH, OFFSET, ROW, SIN_TWIST, SLIDES } from './packed.js';
import { skewness } from './pose.js';

const ROUNDS = 100; // brings the sum within a thousandth of the least, which is as much as a verdict needs
const FIRST_FLOOR = 0.1; // of the sum before
const LAST_FLOOR = 1e-12;

/** Metres; an arm that reaches no farther than this has no length to speak of. */
const NOTHING = 1e-9;

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
 * The distances between the axis points at places `s`, a slide at its farther end; unlimited slides stand at zero.
 * @param {Link[]} links
 * @param {Float64Array} s
 * @param {Float64Array} distances  filled
 * @returns {number} their sum
 */
function measure(links, s, distances) {
  let sum = 0;
  for (let i = 0; i < links.length; i++) {
    const { across, slope, rise, along, travel } = links[i];
    const next = i + 1 < s.length ? s[i + 1] : 0;
    const side = slope * next;
    const height = Math.abs(rise * next - s[i] + along) + (travel === Infinity ? 0 : travel);
    distances[i] = Math.sqrt(across * across + side * side + height * height);
    sum += distances[i];
  }
  return sum;
}

/**
 * The places that make Σ weight_i · distance_i² least with every slide in mid-travel: tridiagonal normal equations.
 * @param {Link[]} links
 * @param {Float64Array} weights
 * @param {Float64Array} diagonal  room
 * @param {Float64Array} below     room
 * @param {Float64Array} s         filled
 */
function solveWeighted(links, weights, diagonal, below, s) {
  const n = links.length;
  diagonal.fill(0);
  s.fill(0);
  for (let i = 0; i < n; i++) {
    const { slope, rise, along } = links[i];
    diagonal[i] += weights[i];
    s[i] += weights[i] * along;
    if (i === n - 1) break;
    diagonal[i + 1] += weights[i] * (slope * slope + rise * rise);
    below[i + 1] = -weights[i] * rise;
    s[i + 1] -= weights[i] * rise * along;
  }
  for (let i = 1; i < n; i++) {
    const factor = below[i] / diagonal[i - 1];
    diagonal[i] -= factor * below[i];
    s[i] -= factor * s[i - 1];
  }
  s[n - 1] /= diagonal[n - 1];
  for (let i = n - 2; i >= 0; i--) s[i] = (s[i] - below[i + 1] * s[i + 1]) / diagonal[i];
}

/**
 * @param {Link[]} links
 * @returns {{ along: number, sum: number }} where on the first axis the shoulder is, and the least sum found
 */
function shorten(links) {
  const [distances, weights, diagonal, below, s] = Array.from({ length: 5 }, () => new Float64Array(links.length));
  let least = measure(links, s, distances);
  let along = 0;
  weights.fill(1);
  for (let round = 0; round < ROUNDS; round++) {
    solveWeighted(links, weights, diagonal, below, s);
    const sum = measure(links, s, distances);
    if (sum < least) [least, along] = [sum, s[0]];
    const floor = sum * FIRST_FLOOR * (LAST_FLOOR / FIRST_FLOOR) ** (round / ROUNDS);
    if (floor === 0) break;
    for (let i = 0; i < weights.length; i++) weights[i] = 1 / Math.max(distances[i], floor);
  }
  return { along, sum: least };
}

/**
 * The characteristic length is half the reach that the arm has while every unlimited slide stands at zero, or 1 m if that is
 * nothing: it grows with the arm, in every unit, and does not depend on which of the many valid tables describes it.
 * @param {Packed} packed
 * @returns {{ shoulder: readonly [number, number, number], reach: number, characteristicLength: number }}
 */
export function measureReach(packed) {
  const { start } = packed;
  const links = linksOf(packed);
  const { along, sum } = shorten(links);
  const isUnlimited = links.some(({ travel }) => travel === Infinity);
  return {
    shoulder: Object.freeze([
      start[12] + along * start[8],
      start[13] + along * start[9],
      start[14] + along * start[10],
    ]),
    // no vector grows by more than this under a transform whose axes are not quite orthonormal
    reach: isUnlimited ? Infinity : sum * Math.sqrt(1 + skewness(start)),
    characteristicLength: sum > NOTHING ? sum / 2 : 1,
  };
}
