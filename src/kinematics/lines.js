/**
 * Vectors, rotations and lines in space, for the solvers that work on the lines of the joint axes. Rotations are nine
 * numbers, column-major; plain arrays, since small typed ones are slow to make. Everything returns something new.
 *
 * @typedef {[number, number, number]} Vector
 * @typedef {readonly number[]} Rotation
 *
 * @typedef {object} Line  of a joint
 * @property {boolean} slides
 * @property {Vector} axis   unit direction
 * @property {Vector} point  on it
 *
 * @typedef {{ axis: ArrayLike<number>, point: ArrayLike<number> }} BareLine
 */

/** @param {ArrayLike<number>} a @param {ArrayLike<number>} b */
export const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

/** @param {ArrayLike<number>} a @param {ArrayLike<number>} b @returns {Vector} */
export const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];

/** @param {ArrayLike<number>} a @param {ArrayLike<number>} b @returns {Vector} */
export const minus = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];

/** a + t · b. @param {ArrayLike<number>} a @param {number} t @param {ArrayLike<number>} b @returns {Vector} */
export const along = (a, t, b) => [a[0] + t * b[0], a[1] + t * b[1], a[2] + t * b[2]];

/** @param {ArrayLike<number>} a */
export const norm = (a) => Math.sqrt(dot(a, a));

/** @param {ArrayLike<number>} a @returns {Vector} */
export const unit = (a) => along([0, 0, 0], 1 / norm(a), a);

/**
 * Two unit vectors that make a right-handed frame with a unit axis as the third.
 * @param {Vector} axis
 * @returns {[Vector, Vector]}
 */
export function squareTo(axis) {
  const smallest = axis.reduce((best, value, i) => (Math.abs(value) < Math.abs(axis[best]) ? i : best), 0);
  const u = unit(
    cross(
      axis,
      [0, 1, 2].map((i) => Number(i === smallest)),
    ),
  );
  return [u, cross(axis, u)];
}

/** The angle between two unit vectors, right to the last digits at both ends. @param {Vector} a @param {Vector} b */
export const angleBetween = (a, b) => Math.atan2(norm(cross(a, b)), dot(a, b));

/**
 * The angle of the turn about an axis that takes v towards w. From their parts across the axis, which keep their
 * digits where v and w are all but along it.
 * @param {ArrayLike<number>} axis unit
 * @param {ArrayLike<number>} v
 * @param {ArrayLike<number>} w
 */
export function angleAbout(axis, v, w) {
  const a = cross(axis, v);
  const b = cross(axis, w);
  return Math.atan2(dot(axis, cross(a, b)), dot(a, b));
}

/** A turn by Rodrigues' formula. @param {Vector} axis @param {number} angle @returns {Rotation} */
export function turn([x, y, z], angle) {
  const c = Math.cos(angle);
  const s = Math.sin(angle);
  const v = 1 - c;
  return [
    c + v * x * x,
    v * x * y + s * z,
    v * x * z - s * y,
    v * x * y - s * z,
    c + v * y * y,
    v * y * z + s * x,
    v * x * z + s * y,
    v * y * z - s * x,
    c + v * z * z,
  ];
}

/** @param {Rotation} R @param {ArrayLike<number>} v @returns {Vector} */
export const rotate = (R, v) => [
  R[0] * v[0] + R[3] * v[1] + R[6] * v[2],
  R[1] * v[0] + R[4] * v[1] + R[7] * v[2],
  R[2] * v[0] + R[5] * v[1] + R[8] * v[2],
];

/** The rotation back. @param {Rotation} R @returns {Rotation} */
export const transposed = (R) => [R[0], R[3], R[6], R[1], R[4], R[7], R[2], R[5], R[8]];

/** @param {Rotation} A @param {Rotation} B @returns {Rotation} */
export function product(A, B) {
  const out = [0, 0, 0, 0, 0, 0, 0, 0, 0];
  for (let i = 0; i < 9; i += 3) {
    for (let j = 0; j < 3; j++) out[i + j] = A[j] * B[i] + A[j + 3] * B[i + 1] + A[j + 6] * B[i + 2];
  }
  return out;
}

/** @param {Rotation} A @param {Rotation} B */
export function largestDifference(A, B) {
  let most = 0;
  for (let i = 0; i < 9; i++) most = Math.max(most, Math.abs(A[i] - B[i]));
  return most;
}

/** The point of a line nearest to another point. @param {Line} line @param {Vector} point @returns {Vector} */
export const footOn = ({ axis, point: onLine }, point) => along(onLine, dot(minus(point, onLine), axis), axis);

/**
 * The point of a line nearest to another line that is not parallel to it.
 * @param {BareLine} line
 * @param {BareLine} other
 * @returns {Vector}
 */
export function nearestTo(line, other) {
  const normal = cross(line.axis, other.axis);
  const t = dot(cross(minus(other.point, line.point), other.axis), normal) / dot(normal, normal);
  return along(line.point, t, line.axis);
}

/** Where a joint takes a point. @param {Line} line @param {number} q @param {Vector} point @returns {Vector} */
export function moved({ slides, axis, point: onLine }, q, point) {
  return slides ? along(point, q, axis) : along(onLine, 1, rotate(turn(axis, q), minus(point, onLine)));
}
