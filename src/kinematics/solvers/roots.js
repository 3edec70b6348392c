/**
 * Real roots of the small equations of closed-form inverse kinematics. At the edge of what an arm can reach two roots
 * meet: there rounding alone decides between two, one and none. So a discriminant that is as small as rounding gives
 * one root, and one that is a little negative gives it too: whoever asks checks what comes of it.
 */

/** Relative discriminants below this are rounding: it parts two angles by no more than 1e-7. */
const ONE = 1e-14;

/** Negative ones down to this may come from a goal that is rounded. */
const NONE = -1e-8;

/** By how much a sum of numbers of order 1 may be off. */
const GRAIN = 1e-15;

/**
 * The angles with a cos x + b sin x = c; both a and b zero is for the caller to exclude.
 * @param {number} a
 * @param {number} b
 * @param {number} c
 * @param {number} [size]  of what c is the difference of
 * @returns {number[]} 0, 1 or 2
 */
export function turnRoots(a, b, c, size = 0) {
  const radius = Math.hypot(a, b);
  const cosine = c / radius;
  const square = (1 - cosine) * (1 + cosine);
  const noise = (GRAIN * size) / radius;
  if (!(square >= NONE - noise)) return [];
  const middle = Math.atan2(b, a);
  if (square < ONE + noise) return [c < 0 ? middle + Math.PI : middle];
  const half = Math.atan2(Math.sqrt(square), cosine);
  return [middle + half, middle - half];
}

/**
 * a x² + b x + c = 0, a perhaps zero.
 * @param {number} a
 * @param {number} b
 * @param {number} c
 * @param {number} [size]  of what c is the difference of
 * @returns {number[]} 0, 1 or 2
 */
export function quadraticRoots(a, b, c, size = 0) {
  const largest = Math.max(Math.abs(a), Math.abs(b), Math.abs(c));
  if (Math.abs(a) <= 1e-14 * largest) return Math.abs(b) <= 1e-14 * largest ? [] : [-c / b];
  const half = b / 2;
  const square = half * half - a * c;
  const scale = half * half + Math.abs(a * c);
  const noise = GRAIN * Math.abs(a) * size;
  if (square < NONE * scale - noise) return [];
  if (square <= ONE * scale + noise) return [-half / a];
  const larger = -(half + (half < 0 ? -1 : 1) * Math.sqrt(square));
  return [larger / a, c / larger];
}

/** @param {readonly number[]} p ascending @param {number} x */
const at = (p, x) => p.reduceRight((sum, coefficient) => sum * x + coefficient, 0);

/**
 * The only root of a monotone piece: Newton's steps, halving where they leave it.
 * @param {readonly number[]} p
 * @param {readonly number[]} slope
 * @param {number} low
 * @param {number} high
 */
function rootBetween(p, slope, low, high) {
  const rises = at(p, high) > 0;
  let x = (low + high) / 2;
  for (let i = 0; i < 100; i++) {
    const value = at(p, x);
    if (value === 0) return x;
    if (value > 0 === rises) high = x;
    else low = x;
    const next = x - value / at(slope, x);
    const to = next > low && next < high ? next : (low + high) / 2;
    if (Math.abs(to - x) <= 1e-16 * Math.abs(x) || to === low || to === high) return to;
    x = to;
  }
  return x;
}

/** Beyond ±1 by a little, so that a root on the seam is not lost between two pieces. */
const END = 1 + 1 / 64;

/**
 * Roots between about −1 and 1: a polynomial is monotone between the roots of its derivative.
 * @param {readonly number[]} p ascending coefficients
 * @returns {number[]} in order; a double root once
 */
function rootsNearZero(p) {
  const scale = p.reduce((sum, value) => sum + Math.abs(value), 0);
  const degree = p.findLastIndex((value) => Math.abs(value) > 1e-15 * scale);
  if (degree < 1) return [];
  if (degree === 1) return Math.abs(p[0]) <= END * Math.abs(p[1]) ? [-p[0] / p[1]] : [];
  const slope = p.slice(1, degree + 1).map((value, i) => value * (i + 1));
  const turning = rootsNearZero(slope);
  const ends = [-END, ...turning, END];
  const values = ends.map((x) => at(p, x) / scale);
  const isZero = values.map((value, i) => Math.abs(value) < ONE && i > 0 && i <= turning.length);
  /** @type {number[]} */
  const roots = [];
  for (let i = 0; i < ends.length; i++) {
    const value = values[i];
    const isInside = i > 0 && i <= turning.length;
    const touches =
      isInside && Math.abs(value) < -NONE && value * values[i - 1] > 0 && value * values[i + 1] > 0 && !isZero[i];
    if (isZero[i] || touches) roots.push(ends[i]);
    if (i + 1 < ends.length && !isZero[i] && !isZero[i + 1] && value * values[i + 1] < 0) {
      roots.push(rootBetween(p, slope, ends[i], ends[i + 1]));
    }
  }
  return roots;
}

/**
 * All real roots of a polynomial of degree 4 at most, a double one once.
 * @param {readonly number[]} p ascending coefficients
 * @returns {number[]}
 */
export function polynomialRoots(p) {
  const near = rootsNearZero(p).filter((x) => Math.abs(x) <= 1);
  const far = rootsNearZero([...p].reverse()).filter((x) => Math.abs(x) < 1 && x !== 0);
  return near.concat(far.map((x) => 1 / x));
}

/**
 * The angles with c0 + c1 cos x + s1 sin x + c2 cos 2x + s2 sin 2x = 0, through the tangent of the half angle, the
 * circle cut in two so that it never grows.
 * @param {number} c0
 * @param {number} c1
 * @param {number} s1
 * @param {number} c2
 * @param {number} s2
 * @returns {number[]} 0 to 4, a double one once
 */
export function doubleTurnRoots(c0, c1, s1, c2, s2) {
  /** @type {number[]} */
  const roots = [];
  for (const [a, b, from] of [
    [c1, s1, 0],
    [-c1, -s1, Math.PI],
  ]) {
    // (1 + t²)² times the sum, cos = (1 − t²) / (1 + t²), sin = 2t / (1 + t²)
    const p = [c0 + a + c2, 2 * b + 4 * s2, 2 * c0 - 6 * c2, 2 * b - 4 * s2, c0 - a + c2];
    for (const t of rootsNearZero(p)) {
      const x = from + 2 * Math.atan(t);
      const isSeam = Math.abs(t) > 1 - 1e-6;
      if (Math.abs(t) <= 1 + 1e-6 && !(isSeam && roots.some((other) => Math.abs(Math.sin((x - other) / 2)) < 1e-6)))
        roots.push(x);
    }
  }
  return roots;
}
