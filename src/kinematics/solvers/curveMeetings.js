/**
 * Where two curves of the plane of joint 2 meet (profileCurves.js).
 * @import { Curve, Pair } from './profileCurves.js'
 *
 * @typedef {object} Meeting
 * @property {number} one    place on the first curve, 0 where it is free
 * @property {number} two
 * @property {boolean} isOneFree  the first curve is a single point: any place on it will do
 * @property {boolean} isTwoFree
 * @property {boolean} isOverlap  the curves lie on one another: this is one of infinitely many
 */
import { pointAt, slopeAt, times } from './profileCurves.js';
import { doubleTurnRoots, polynomialRoots, quadraticRoots, turnRoots } from './roots.js';

/** Below this (in arm lengths) a curve is a single point. */
const POINT = 1e-9;

/** An ellipse flatter than this is taken for flat; the error is polished away. */
const FLAT = 1e-6;

/**
 * Two that are both rather flat meet in pairs of points that come close together: likewise if the product of the two is
 * below this.
 */
const BOTH_FLAT = 1e-9;

/** What curves may miss each other by and still be said to meet: what comes of it is checked. */
const PLAUSIBLE = 1e-5;

/** A double root that only rounding made, far out where a polynomial is flat, is told by this. */
const FAR_OFF = 1e-3;

/** @param {Curve} curve */
const isPoint = ({ size, width }) => size < POINT && width < POINT;

/** @param {Curve} curve */
const isFlat = ({ size, width }) => width <= FLAT * size;

/** @param {Pair} a @param {Pair} b @returns {Pair} */
const less = (a, b) => [a[0] - b[0], a[1] - b[1]];

/**
 * @param {Curve} one
 * @param {Curve} two
 * @returns {Meeting[]}
 */
export function meetings(one, two) {
  if (isPoint(one) || isPoint(two)) return atPoint(one, two);
  const areFlat = one.width * two.width <= BOTH_FLAT * one.size * two.size;
  const found = isFlat(one) || isFlat(two) || areFlat ? alongFlat(one, two) : round(one, two);
  return found
    .map((some) => (some.isOverlap ? some : refined(one, two, some)))
    .filter((some) => {
      const point = pointAt(one, some.one);
      return Math.hypot(...less(point, pointAt(two, some.two))) < FAR_OFF * (1 + Math.hypot(...point));
    });
}

/** @param {number} a @param {number} b @param {Partial<Meeting>} [more] @returns {Meeting} */
const meeting = (a, b, more) => ({ one: a, two: b, isOneFree: false, isTwoFree: false, isOverlap: false, ...more });

/**
 * The places on a curve with `direction · point = value`; null if the curve does not move that way.
 * @param {Curve} curve
 * @param {Pair} direction
 * @param {number} value
 * @returns {number[] | null}
 */
function placesWhere({ kind, start, first, second, size }, direction, value) {
  const a = times(direction, first);
  const b = times(direction, second);
  if (Math.hypot(a, b) <= FLAT * size) return null;
  const from = times(direction, start);
  const scale = Math.abs(value) + Math.abs(from);
  return kind === 'turns' ? turnRoots(a, b, value - from, scale) : quadraticRoots(b, a, from - value, scale);
}

/**
 * The places of a curve that are all but at a point: of a flat one perhaps two, of a round one no more than one,
 * brought as near as it comes.
 * @param {Curve} curve
 * @param {Pair} point
 */
function placesAt(curve, point) {
  const isLevel = curve.kind === 'slides' && curve.second[1] !== 0 && Math.abs(curve.first[0]) > 0.1;
  const direction = isLevel ? curve.normal : curve.tangent;
  const missAt = (/** @type {number} */ x) => Math.hypot(...less(pointAt(curve, x), point));
  const places = (placesWhere(curve, direction, times(direction, point)) ?? [])
    .map((place) => nearestPlace(curve, point, place))
    .filter((x) => missAt(x) < PLAUSIBLE)
    .sort((a, b) => missAt(a) - missAt(b));
  return curve.width > 1e-4 * curve.size ? places.slice(0, 1) : places;
}

/**
 * By Gauss's steps, except from where the curve turns back.
 * @param {Curve} curve
 * @param {Pair} point
 * @param {number} from
 */
function nearestPlace(curve, point, from) {
  let x = from;
  for (let i = 0; i < 10; i++) {
    const slope = slopeAt(curve, x);
    const square = times(slope, slope);
    if (square < 1e-8 * curve.size ** 2) return x;
    const step = times(slope, less(pointAt(curve, x), point)) / square;
    x -= step;
    if (Math.abs(step) < 1e-15) return x;
  }
  return x;
}

/** @param {Curve} one @param {Curve} two @returns {Meeting[]} */
function atPoint(one, two) {
  const [isOne, isTwo] = [isPoint(one), isPoint(two)];
  const isOneFree = isOne && one.kind !== 'stays';
  const isTwoFree = isTwo && two.kind !== 'stays';
  if (isOne && isTwo) {
    const isMet = Math.hypot(...less(one.start, two.start)) < PLAUSIBLE;
    return isMet ? [meeting(0, 0, { isOneFree, isTwoFree })] : [];
  }
  return isOne
    ? placesAt(two, one.start).map((x) => meeting(0, x, { isOneFree }))
    : placesAt(one, two.start).map((x) => meeting(x, 0, { isTwoFree }));
}

/** How much a curve moves across a flat one. @param {Curve} curve @param {Curve} flat */
const reachAcross = ({ first, second, size }, { normal }) =>
  Math.hypot(times(normal, first), times(normal, second)) / size;

/** @param {Curve} one @param {Curve} two @returns {Meeting[]} */
function alongFlat(one, two) {
  const isTwoFlat = isFlat(one) === isFlat(two) ? reachAcross(one, two) >= reachAcross(two, one) : isFlat(two);
  const flat = isTwoFlat ? two : one;
  const other = isTwoFlat ? one : two;
  const level = times(flat.normal, flat.start);
  const pair = (/** @type {number} */ there, /** @type {number} */ here, isOverlap = false) =>
    isTwoFlat ? meeting(there, here, { isOverlap }) : meeting(here, there, { isOverlap });
  const onFlat = (/** @type {number} */ place) =>
    placesWhere(flat, flat.tangent, times(flat.tangent, pointAt(other, place))) ?? [];
  const places = placesWhere(other, flat.normal, level);
  if (places) return places.flatMap((place) => onFlat(place).map((here) => pair(place, here)));
  if (Math.abs(times(flat.normal, other.start) - level) > PLAUSIBLE) return [];
  const value = commonValue(flat, other);
  const [here] = placesWhere(flat, flat.tangent, value) ?? [];
  const [there] = placesWhere(other, flat.tangent, value) ?? [];
  return here === undefined || there === undefined ? [] : [pair(there, here, true)];
}

/**
 * Of two flat curves on one line: how far along it both come, well inside if they can.
 * @param {Curve} flat
 * @param {Curve} other
 */
function commonValue(flat, other) {
  const [a, b] = rangeAlong(flat, flat.tangent);
  const [c, d] = rangeAlong(other, flat.tangent);
  const low = Math.max(a, c);
  const high = Math.min(b, d);
  if (low > -Infinity && high < Infinity) return (low + high) / 2;
  return low > -Infinity ? low + 0.5 : high < Infinity ? high - 0.5 : 0;
}

/** @param {Curve} curve @param {Pair} direction @returns {Pair} */
function rangeAlong({ kind, start, first, second }, direction) {
  const [k, a, b] = [start, first, second].map((pair) => times(direction, pair));
  if (kind === 'turns') return [k - Math.hypot(a, b), k + Math.hypot(a, b)];
  if (b === 0) return [-Infinity, Infinity];
  const turn = k - (a * a) / (4 * b);
  return b > 0 ? [turn, Infinity] : [-Infinity, turn];
}

/** Whether two flat curves can only miss each other or lie on one another. @param {Curve} one @param {Curve} two */
export const lieAlong = (one, two) =>
  isFlat(one) && isFlat(two) && !isPoint(one) && !isPoint(two) && reachAcross(one, two) <= FLAT;

/** @param {Curve} one @param {Curve} two @returns {Meeting[]} */
function round(one, two) {
  if (one.kind === 'turns' && two.kind === 'turns') {
    if (areSame(one, two)) return [meeting(...acrossFrom(one, two, 0), { isOverlap: true })];
    return one.width > two.width
      ? acrossEllipse(one, two).map(([a, b]) => meeting(a, b))
      : acrossEllipse(two, one).map(([b, a]) => meeting(a, b));
  }
  if (one.kind === 'turns') return acrossEllipse(one, two).map(([a, b]) => meeting(a, b));
  if (two.kind === 'turns') return acrossEllipse(two, one).map(([b, a]) => meeting(a, b));
  return twoParabolas(one, two);
}

/**
 * Maps the ellipse to the unit circle; the other curve, mapped likewise, is on it where the square of its distance
 * from the centre is one. Everything is multiplied by the determinant, so that a thin ellipse blows nothing up.
 * @param {Curve} ellipse
 * @param {Curve} other
 * @returns {Pair[]} the place on the ellipse, and on the other
 */
function acrossEllipse(ellipse, other) {
  const { start, first, second } = ellipse;
  const determinant = first[0] * second[1] - first[1] * second[0];
  const map = (/** @type {Pair} */ [x, y]) =>
    /** @type {Pair} */ ([second[1] * x - second[0] * y, first[0] * y - first[1] * x]);
  const k = map(less(other.start, start));
  const a = map(other.first);
  const b = map(other.second);
  const [kk, ka, kb] = [times(k, k), times(k, a), times(k, b)];
  const [aa, ab, bb] = [times(a, a), times(a, b), times(b, b)];
  const places =
    other.kind === 'turns'
      ? doubleTurnRoots(kk + (aa + bb) / 2 - determinant ** 2, 2 * ka, 2 * kb, (aa - bb) / 2, ab)
      : polynomialRoots([kk - determinant ** 2, 2 * ka, aa + 2 * kb, 2 * ab, bb]);
  return places.map((place) => acrossFrom(ellipse, other, place));
}

/**
 * The place on an ellipse where another curve's place is.
 * @param {Curve} ellipse
 * @param {Curve} other
 * @param {number} place
 * @returns {Pair}
 */
function acrossFrom({ start, first, second }, other, place) {
  const [x, y] = less(pointAt(other, place), start);
  const sign = Math.sign(first[0] * second[1] - first[1] * second[0]);
  return [Math.atan2(sign * (first[0] * y - first[1] * x), sign * (second[1] * x - second[0] * y)), place];
}

/**
 * Whether two ellipses are one: their centres are, and the squares of their matrices.
 * @param {Curve} one
 * @param {Curve} two
 */
function areSame(one, two) {
  const square = (/** @type {Curve} */ { first: a, second: b }) => [
    a[0] ** 2 + b[0] ** 2,
    a[0] * a[1] + b[0] * b[1],
    a[1] ** 2 + b[1] ** 2,
  ];
  const other = square(two);
  const differences = [...less(one.start, two.start), ...square(one).map((value, i) => value - other[i])];
  return differences.every((value) => Math.abs(value) < POINT);
}

/**
 * Two slides that are not square to the turn between them: the heights give one place from the other.
 * @param {Curve} one
 * @param {Curve} two
 * @returns {Meeting[]}
 */
function twoParabolas(one, two) {
  // place on `one` = m + n · place on `two`
  const m = (two.start[0] - one.start[0]) / one.first[0];
  const n = two.first[0] / one.first[0];
  const a = (n * n - 1) / 2;
  const b = one.first[1] * n + m * n - two.first[1];
  const c = one.start[1] - two.start[1] + one.first[1] * m + (m * m) / 2;
  if (Math.max(Math.abs(a), Math.abs(b)) < POINT) {
    return Math.abs(c) < PLAUSIBLE ? [meeting(m, 0, { isOverlap: true })] : [];
  }
  return quadraticRoots(a, b, c).map((x) => meeting(m + n * x, x));
}

/**
 * Newton's steps on both places at once, as long as they help.
 * @param {Curve} one
 * @param {Curve} two
 * @param {Meeting} from
 */
function refined(one, two, from) {
  let best = from;
  let miss = less(pointAt(one, best.one), pointAt(two, best.two));
  for (let i = 0; i < 4; i++) {
    const a = slopeAt(one, best.one);
    const b = slopeAt(two, best.two);
    const determinant = a[1] * b[0] - a[0] * b[1];
    if (Math.abs(determinant) < 1e-6 * one.size * two.size) return best;
    const next = {
      ...best,
      one: best.one + (b[1] * miss[0] - b[0] * miss[1]) / determinant,
      two: best.two + (a[1] * miss[0] - a[0] * miss[1]) / determinant,
    };
    const nextMiss = less(pointAt(one, next.one), pointAt(two, next.two));
    if (!(Math.hypot(...nextMiss) < Math.hypot(...miss) / 2)) return best;
    best = next;
    miss = nextMiss;
  }
  return best;
}
