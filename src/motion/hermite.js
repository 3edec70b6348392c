/**
 * Polynomials of the fifth degree over a piece of a way, from values and their first two derivatives at both ends, and what
 * they cannot exceed in between.
 */
import { TERMS } from './posturePath.js';

/** A value and its first two derivatives, of every joint. @typedef {{ q: Float64Array, first: Float64Array, second: Float64Array }} Knot */

/**
 * @param {Knot} a
 * @param {Knot} b
 * @param {number} width   of the piece, in the unit that the derivatives are by
 * @param {Float64Array} out   6 a joint, filled: the polynomial in λ from 0 to 1
 */
export function writeHermite(a, b, width, out) {
  for (let i = 0, at = 0; i < a.q.length; i++, at += TERMS) {
    const [u, w] = [width * a.first[i], width * b.first[i]];
    const [c, d] = [(width * width * a.second[i]) / 2, (width * width * b.second[i]) / 2];
    const way = b.q[i] - a.q[i];
    out[at] = a.q[i];
    out[at + 1] = u;
    out[at + 2] = c;
    out[at + 3] = 10 * way - 6 * u - 4 * w - 3 * c + d;
    out[at + 4] = -15 * way + 8 * u + 7 * w + 3 * c - 2 * d;
    out[at + 5] = 6 * way - 3 * (u + w) - c + d;
  }
}

/** Bézier points of each power of λ: point j of λᵏ is C(j, k) / C(5, k). */
const POWERS = Array.from({ length: TERMS }, (_, k) =>
  Float64Array.from({ length: TERMS }, (__, j) => choose(j, k) / choose(5, k)),
);

/** How the differences of the Bézier points count for derivatives: 5, 5 · 4, … */
const FACTORS = [1, 5, 20, 60, 120, 120];

const points = new Float64Array(TERMS);

/**
 * @typedef {object} Span
 * @property {number} low     no value on the piece is below
 * @property {number} high
 * @property {Float64Array} derivatives   [k]: the size of none of the k-th derivatives by λ is above; [0]: of what is gone
 */

/** @returns {Span} */
export const createSpan = () => ({ low: 0, high: 0, derivatives: new Float64Array(TERMS) });

/**
 * A polynomial lies within the hull of its Bézier points, and its derivatives within those of their differences.
 * @param {Float64Array} coefficients
 * @param {number} at   6 from here
 * @param {Span} span   filled
 */
export function writeSpan(coefficients, at, span) {
  const { derivatives } = span;
  points.fill(coefficients[at]);
  for (let k = 1; k < TERMS; k++) {
    const c = coefficients[at + k];
    if (c !== 0) for (let j = k; j < TERMS; j++) points[j] += c * POWERS[k][j];
  }
  span.low = Math.min(points[0], points[1], points[2], points[3], points[4], points[5]);
  span.high = Math.max(points[0], points[1], points[2], points[3], points[4], points[5]);
  derivatives[0] = Math.max(span.high - points[0], points[0] - span.low);
  for (let k = 1; k < TERMS; k++) {
    let most = 0;
    for (let j = 0; j < TERMS - k; j++) {
      points[j] = points[j + 1] - points[j];
      most = Math.max(most, Math.abs(points[j]));
    }
    derivatives[k] = FACTORS[k] * most;
  }
}

/** @param {number} n @param {number} k */
function choose(n, k) {
  let found = 1;
  for (let i = 0; i < k; i++) found = (found * (n - i)) / (i + 1);
  return found;
}
