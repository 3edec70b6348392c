/**
 * The surface of voxels as a mesh: two triangles for each side of a reached cube whose neighbour is not. Corners are shared;
 * triangles run counterclockwise seen from outside, and together they are closed. Of some cubes a step, since there may be millions.
 *
 * @import { Voxels } from './voxels.js'
 *
 * @typedef {object} VoxelSurface
 * @property {Float32Array} corners    x, y, z each
 * @property {Uint32Array} triangles   three corners each
 * @property {Uint32Array} cubes       the cube that each pair of triangles belongs to
 */
import { AT_ONCE } from './voxels.js';

/** The four corners of a cube's side towards lower and higher values along each axis, seen from outside. */
const SIDES = [
  { step: [-1, 0, 0], corners: [[0, 0, 0], [0, 0, 1], [0, 1, 1], [0, 1, 0]] }, // prettier-ignore
  { step: [1, 0, 0], corners: [[1, 0, 0], [1, 1, 0], [1, 1, 1], [1, 0, 1]] }, // prettier-ignore
  { step: [0, -1, 0], corners: [[0, 0, 0], [1, 0, 0], [1, 0, 1], [0, 0, 1]] }, // prettier-ignore
  { step: [0, 1, 0], corners: [[0, 1, 0], [0, 1, 1], [1, 1, 1], [1, 1, 0]] }, // prettier-ignore
  { step: [0, 0, -1], corners: [[0, 0, 0], [0, 1, 0], [1, 1, 0], [1, 0, 0]] }, // prettier-ignore
  { step: [0, 0, 1], corners: [[0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]] }, // prettier-ignore
];

/** @param {Voxels} voxels @returns {Generator<null, VoxelSurface>} */
export function* surfacing({ size, corner, counts, reached }) {
  const [nx, ny, nz] = counts;
  const isReached = (/** @type {number} */ i, /** @type {number} */ j, /** @type {number} */ k) =>
    i >= 0 && j >= 0 && k >= 0 && i < nx && j < ny && k < nz && reached[(k * ny + j) * nx + i] === 1;
  /** @type {Map<number, number>} */
  const numbers = new Map();
  /** @type {number[]} */
  const corners = [];
  /** @type {number[]} */
  const triangles = [];
  /** @type {number[]} */
  const cubes = [];
  const numberOf = (/** @type {number} */ i, /** @type {number} */ j, /** @type {number} */ k) => {
    const key = (k * (ny + 1) + j) * (nx + 1) + i;
    let number = numbers.get(key);
    if (number === undefined) {
      number = numbers.size;
      numbers.set(key, number);
      corners.push(corner[0] + i * size, corner[1] + j * size, corner[2] + k * size);
    }
    return number;
  };
  for (let k = 0, looked = 0; k < nz; k++) {
    for (let j = 0; j < ny; j++) {
      looked += nx;
      if (looked > AT_ONCE) {
        looked = 0;
        yield null;
      }
      for (let i = 0; i < nx; i++) {
        if (!isReached(i, j, k)) continue;
        for (const { step, corners: four } of SIDES) {
          if (isReached(i + step[0], j + step[1], k + step[2])) continue;
          const [a, b, c, d] = four.map(([di, dj, dk]) => numberOf(i + di, j + dj, k + dk));
          triangles.push(a, b, c, a, c, d);
          cubes.push((k * ny + j) * nx + i);
        }
      }
    }
  }
  return {
    corners: Float32Array.from(corners),
    triangles: Uint32Array.from(triangles),
    cubes: Uint32Array.from(cubes),
  };
}
