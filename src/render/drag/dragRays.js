/**
 * The geometry of a pointer in space: the line of sight through it, and where that meets an axis, a plane, an angle. Triples
 * of numbers; null where the question has no good answer.
 *
 * @typedef {readonly number[]} Vector  x y z
 * @typedef {{ from: Vector, along: Vector }} Ray  `along` is a unit vector
 */

/** @param {Vector} a @param {Vector} b */
export const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

/** @param {Vector} a @param {Vector} b */
export const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];

/** @param {Vector} a @param {Vector} b */
export const minus = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];

/** a + s b @param {Vector} a @param {number} s @param {Vector} b */
export const plus = (a, s, b) => [a[0] + s * b[0], a[1] + s * b[1], a[2] + s * b[2]];

/** A line of sight this near to an axis (sine squared), or to a plane (sine), tells nothing about where on it. */
const ALONG_AXIS = 1e-3;
const ALONG_PLANE = 0.02;

/**
 * How far along the axis it comes nearest to the line of sight.
 * @param {Ray} ray
 * @param {Vector} point  on the axis
 * @param {Vector} axis   a unit vector
 */
export function alongAxis({ from, along }, point, axis) {
  const w = minus(point, from);
  const b = dot(axis, along);
  const apart = 1 - b * b;
  if (apart < ALONG_AXIS) return null;
  const s = (b * dot(along, w) - dot(axis, w)) / apart;
  return dot(along, w) + b * s > 0 ? s : null; // not behind the eye
}

/**
 * Where the line of sight meets a plane.
 * @param {Ray} ray
 * @param {Vector} point   in the plane
 * @param {Vector} normal  a unit vector
 */
export function onPlane({ from, along }, point, normal) {
  const falls = dot(normal, along);
  if (Math.abs(falls) < ALONG_PLANE) return null;
  const t = dot(normal, minus(point, from)) / falls;
  return t > 0 ? plus(from, t, along) : null;
}

/**
 * The angle about an axis at which the line of sight meets the plane across it.
 * @param {Ray} ray
 * @param {Vector} centre
 * @param {Vector} axis  a unit vector
 * @param {Vector} zero  a unit vector across the axis: where the angle is counted from
 */
export function angleAbout(ray, centre, axis, zero) {
  const at = onPlane(ray, centre, axis);
  if (!at) return null;
  const r = minus(at, centre);
  const [x, y] = [dot(zero, r), dot(cross(axis, zero), r)];
  return x === 0 && y === 0 ? null : Math.atan2(y, x);
}

/** An angle brought near another by whole turns. @param {number} angle @param {number} near */
export const unwrap = (angle, near) => angle - 2 * Math.PI * Math.round((angle - near) / (2 * Math.PI));

/** The nearest whole step. @param {number} value @param {number} step */
export const snap = (value, step) => Math.round(value / step) * step + 0; // + 0: no minus zero

/** Any unit vector across another. @param {Vector} axis */
export function across(axis) {
  const least = [0, 1, 2].reduce((k, i) => (Math.abs(axis[i]) < Math.abs(axis[k]) ? i : k));
  const v = cross(axis, [0, 1, 2].map((i) => (i === least ? 1 : 0))); // prettier-ignore
  const length = Math.hypot(...v);
  return v.map((value) => value / length);
}
