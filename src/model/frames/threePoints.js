/**
 * A user frame from three points that the TCP was brought to, as on a controller: its origin, a point on its positive X axis,
 * and one on the side of its XY plane where Y is positive.
 *
 * @typedef {readonly (readonly [number, number, number] | null)[]} Taught  those three while they are taken; metres, in the world
 */

/** None of them yet. @type {Taught} */
export const NOT_TAUGHT = [null, null, null];

/** Nearer together than this, metres, two points are one. */
const APART = 1e-4;

/** A third point nearer to the line than this share of its distance, the sine of about half a degree, is on it. */
const ASIDE = 0.01;

/**
 * @param {readonly [origin: ArrayLike<number>, onX: ArrayLike<number>, onPlane: ArrayLike<number>]} points  metres, in the world
 * @returns {{ T_world_frame: Float64Array } | { fault: 'together' | 'inLine' }}
 */
export function frameFromPoints([origin, onX, onPlane]) {
  const along = [0, 1, 2].map((k) => onX[k] - origin[k]);
  const aside = [0, 1, 2].map((k) => onPlane[k] - origin[k]);
  const [length, reach] = [Math.hypot(...along), Math.hypot(...aside)];
  if (!(length > APART) || !(reach > APART)) return { fault: 'together' };
  const x = along.map((value) => value / length);
  const normal = cross(x, aside);
  const off = Math.hypot(...normal);
  if (!(off > ASIDE * reach) || !(off > APART)) return { fault: 'inLine' };
  const z = normal.map((value) => value / off);
  const y = cross(z, x);
  return { T_world_frame: Float64Array.from([...x, 0, ...y, 0, ...z, 0, origin[0], origin[1], origin[2], 1]) };
}

/** @param {readonly number[]} a @param {readonly number[]} b */
const cross = (a, b) => [0, 1, 2].map((k) => a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3]);
