/**
 * How near a segment comes to another one, and to a convex obstacle.
 * @import { PointDistance } from './obstacles.js'
 */

const nearest = new Float64Array(3);

/** Halvings of the segment: what is left of it then is a millionth. */
const HALVINGS = 20;

/**
 * The distance of two segments: the closest points of both lines, brought back to the segments, end by end.
 * @param {Float64Array} ends  x y z of both ends, of one segment after the other
 * @param {number} p  where the first begins
 * @param {number} r  where the second begins
 * @param {Float64Array} [at]  receives the shares of both, from 0 to 1
 */
export function segmentsApart(ends, p, r, at) {
  const ux = ends[p + 3] - ends[p];
  const uy = ends[p + 4] - ends[p + 1];
  const uz = ends[p + 5] - ends[p + 2];
  const vx = ends[r + 3] - ends[r];
  const vy = ends[r + 4] - ends[r + 1];
  const vz = ends[r + 5] - ends[r + 2];
  const wx = ends[p] - ends[r];
  const wy = ends[p + 1] - ends[r + 1];
  const wz = ends[p + 2] - ends[r + 2];
  const uu = ux * ux + uy * uy + uz * uz;
  const vv = vx * vx + vy * vy + vz * vz;
  const uv = ux * vx + uy * vy + uz * vz;
  const uw = ux * wx + uy * wy + uz * wz;
  const vw = vx * wx + vy * wy + vz * wz;
  // (w + s u − t v)² is convex in s and t: its least value over the square is where it has no slope, or on an edge
  const steep = uu * vv - uv * uv;
  let s = steep > 1e-12 * uu * vv ? share(uv * vw - vv * uw, steep) : 0;
  let t = share(uv * s + vw, vv);
  s = share(uv * t - uw, uu);
  t = share(uv * s + vw, vv);
  if (at) {
    at[0] = s;
    at[1] = t;
  }
  return Math.hypot(wx + s * ux - t * vx, wy + s * uy - t * vy, wz + s * uz - t * vz);
}

/** A quotient between 0 and 1; 0 where there is none. @param {number} over @param {number} under */
const share = (over, under) => (under > 0 ? Math.min(1, Math.max(0, over / under)) : 0);

/**
 * The distance of a segment from a convex obstacle, to a millionth of the segment's length. It is a convex function of the place
 * on the segment, and at each place the nearest point says on which side it falls.
 * @param {Float64Array} ends
 * @param {number} p  where the segment begins
 * @param {PointDistance} distance
 * @param {Float64Array} [at]  receives the share, and the nearest point of the obstacle
 */
export function segmentFrom(ends, p, distance, at) {
  const x = ends[p];
  const y = ends[p + 1];
  const z = ends[p + 2];
  const ux = ends[p + 3] - x;
  const uy = ends[p + 4] - y;
  const uz = ends[p + 5] - z;
  let low = 0;
  let high = 1;
  let least = Infinity;
  for (let i = 0; i < HALVINGS + 2; i++) {
    // both ends first: often the nearest place is one of them
    const t = i === 0 ? 0 : i === 1 ? 1 : (low + high) / 2;
    const far = distance(x + t * ux, y + t * uy, z + t * uz, nearest);
    if (far < least) {
      least = far;
      if (at) {
        at[0] = t;
        at.set(nearest, 1);
      }
    }
    if (far === 0) break;
    const slope = (x + t * ux - nearest[0]) * ux + (y + t * uy - nearest[1]) * uy + (z + t * uz - nearest[2]) * uz;
    if (slope > 0) high = t;
    else low = t;
    if (low >= high) break;
  }
  return least;
}
