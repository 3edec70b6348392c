/**
 * What may stand in the way, and how far a point is from it. All of them are convex, which the search along a segment
 * (segmentDistance.js) stands on; a point inside is at distance 0, however deep.
 *
 * @import { Pose } from '../../kinematics/pose.js'
 *
 * @typedef {{ kind: 'sphere', centre: ArrayLike<number>, radius: number }} Sphere
 * @typedef {{ kind: 'box', T_base_box: Pose, size: ArrayLike<number> }} Box                 whole edges; the pose is of its centre
 * @typedef {{ kind: 'cylinder', T_base_cylinder: Pose, radius: number, height: number }} Cylinder  about z; the pose is of its centre
 * @typedef {{ kind: 'plane', normal: ArrayLike<number>, offset: number }} Plane             what is behind it is in its way:
 *   normal · point < offset, the normal a unit vector
 * @typedef {Sphere | Box | Cylinder | Plane} Obstacle   metres, seen from the chain's root
 *
 * @typedef {(x: number, y: number, z: number, nearest: Float64Array) => number} PointDistance  writes the obstacle's nearest point
 */

/** @type {{ [K in Obstacle['kind']]: (obstacle: Extract<Obstacle, { kind: K }>) => PointDistance }} */
const DISTANCES = {
  sphere: sphereDistance,
  box: boxDistance,
  cylinder: cylinderDistance,
  plane: planeDistance,
};

/** @param {Obstacle} obstacle @returns {PointDistance} */
export const pointDistance = (obstacle) =>
  /** @type {(obstacle: Obstacle) => PointDistance} */ (DISTANCES[obstacle.kind])(checked(obstacle));

/**
 * A sphere around the whole of it, to pass over what is far away; a plane has none.
 * @param {Obstacle} obstacle
 * @returns {{ centre: ArrayLike<number>, radius: number }}
 */
export function surroundings(obstacle) {
  switch (obstacle.kind) {
    case 'sphere':
      return obstacle;
    case 'box':
      return {
        centre: obstacle.T_base_box.slice(12, 15),
        radius: Math.hypot(obstacle.size[0], obstacle.size[1], obstacle.size[2]) / 2,
      };
    case 'cylinder':
      return {
        centre: obstacle.T_base_cylinder.slice(12, 15),
        radius: Math.hypot(obstacle.radius, obstacle.height / 2),
      };
    case 'plane':
      return { centre: [0, 0, 0], radius: Infinity };
  }
}

/** Throws unless every number is finite and every size positive. @template {Obstacle} T @param {T} obstacle @returns {T} */
function checked(obstacle) {
  /** @type {[string, number][]} */
  const sizes =
    obstacle.kind === 'box'
      ? Array.from(obstacle.size).map((size, i) => [`edge ${i + 1} of the box`, size])
      : obstacle.kind === 'cylinder'
        ? [
            ['the radius of the cylinder', obstacle.radius],
            ['the height of the cylinder', obstacle.height],
          ]
        : obstacle.kind === 'sphere'
          ? [['the radius of the sphere', obstacle.radius]]
          : [['the length of the normal', Math.abs(Math.hypot(...Array.from(obstacle.normal)) - 1) < 1e-9 ? 1 : NaN]];
  for (const [name, size] of sizes) {
    if (!(size > 0 && size < Infinity)) throw new RangeError(`Expected ${name} to be positive, got ${size}.`);
  }
  return obstacle;
}

/** @param {Sphere} sphere @returns {PointDistance} */
function sphereDistance({ centre, radius }) {
  const [cx, cy, cz] = Array.from(centre);
  return (x, y, z, nearest) => {
    const far = Math.hypot(x - cx, y - cy, z - cz);
    const share = far > radius ? radius / far : 1;
    nearest[0] = cx + share * (x - cx);
    nearest[1] = cy + share * (y - cy);
    nearest[2] = cz + share * (z - cz);
    return Math.max(0, far - radius);
  };
}

/** @param {Plane} plane @returns {PointDistance} */
function planeDistance({ normal, offset }) {
  const [nx, ny, nz] = Array.from(normal);
  return (x, y, z, nearest) => {
    const above = Math.max(0, nx * x + ny * y + nz * z - offset);
    nearest[0] = x - above * nx;
    nearest[1] = y - above * ny;
    nearest[2] = z - above * nz;
    return above;
  };
}

/** @param {Box} box @returns {PointDistance} */
function boxDistance({ T_base_box: T, size }) {
  const [hx, hy, hz] = Array.from(size, (edge) => edge / 2);
  return inFrame(T, (u, v, w, local) => {
    local[0] = Math.min(hx, Math.max(-hx, u));
    local[1] = Math.min(hy, Math.max(-hy, v));
    local[2] = Math.min(hz, Math.max(-hz, w));
  });
}

/** @param {Cylinder} cylinder @returns {PointDistance} */
function cylinderDistance({ T_base_cylinder: T, radius, height }) {
  return inFrame(T, (u, v, w, local) => {
    const far = Math.hypot(u, v);
    const share = far > radius ? radius / far : 1;
    local[0] = share * u;
    local[1] = share * v;
    local[2] = Math.min(height / 2, Math.max(-height / 2, w));
  });
}

/**
 * The distance to what is easily clamped in a frame of its own.
 * @param {Pose} T
 * @param {(u: number, v: number, w: number, local: Float64Array) => void} clamp
 * @returns {PointDistance}
 */
function inFrame(T, clamp) {
  const local = new Float64Array(3);
  return (x, y, z, nearest) => {
    const dx = x - T[12];
    const dy = y - T[13];
    const dz = z - T[14];
    const u = T[0] * dx + T[1] * dy + T[2] * dz;
    const v = T[4] * dx + T[5] * dy + T[6] * dz;
    const w = T[8] * dx + T[9] * dy + T[10] * dz;
    clamp(u, v, w, local);
    for (let k = 0; k < 3; k++) nearest[k] = T[12 + k] + T[k] * local[0] + T[4 + k] * local[1] + T[8 + k] * local[2];
    return Math.hypot(u - local[0], v - local[1], w - local[2]);
  };
}
