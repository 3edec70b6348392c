/**
 * Where a camera has to stand to get points into the picture: an exact answer, in closed form, for a camera whose
 * direction is given.
 *
 * @import { Vector3 } from 'three'
 *
 * @typedef {object} Lens
 * @property {number} tanX  half the width that the picture may be filled to, at distance 1
 * @property {number} tanY  the same for the height
 */

/**
 * Seen from the camera's own axes (x right, y up, z back), a point (px, py, pz) is inside the picture's right edge if
 * px − x ≤ tanX (z − pz), and so on for the other edges. The camera is as near as all of these allow, and in the middle.
 * @param {readonly Vector3[]} points
 * @param {{ right: Vector3, up: Vector3, back: Vector3 }} axes  unit vectors
 * @param {Lens} lens
 * @returns {{ x: number, y: number, z: number, depth: number }} the camera along its axes, and how far behind the points'
 *   middle it is
 */
export function fitCamera(points, { right, up, back }, { tanX, tanY }) {
  let [east, west, north, south] = [-Infinity, -Infinity, -Infinity, -Infinity];
  let [near, far] = [-Infinity, Infinity];
  for (const point of points) {
    const [px, py, pz] = [point.dot(right), point.dot(up), point.dot(back)];
    east = Math.max(east, px + tanX * pz);
    west = Math.max(west, -px + tanX * pz);
    north = Math.max(north, py + tanY * pz);
    south = Math.max(south, -py + tanY * pz);
    near = Math.max(near, pz);
    far = Math.min(far, pz);
  }
  const z = Math.max((east + west) / (2 * tanX), (north + south) / (2 * tanY));
  return { x: (east - west) / 2, y: (north - south) / 2, z, depth: z - (near + far) / 2 };
}

/**
 * The same for a camera that sees in parallel, where what matters is not how far away it is but how wide it sees: at `depth`
 * the lens would see just as wide.
 * @param {readonly Vector3[]} points
 * @param {{ right: Vector3, up: Vector3, back: Vector3 }} axes
 * @param {Lens} lens
 * @returns {{ x: number, y: number, z: number, depth: number }}
 */
export function fitParallel(points, { right, up, back }, { tanX, tanY }) {
  const [x, y, z] = [right, up, back].map((axis) => {
    const along = points.map((point) => point.dot(axis));
    const [least, most] = [Math.min(...along), Math.max(...along)];
    return { middle: (least + most) / 2, half: (most - least) / 2 };
  });
  const depth = Math.max(x.half / tanX, y.half / tanY);
  return { x: x.middle, y: y.middle, z: z.middle + depth, depth };
}
