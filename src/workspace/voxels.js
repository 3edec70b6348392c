/**
 * A solid as cubes (voxels) side by side.
 *
 * @typedef {object} Voxels
 * @property {number} size     m
 * @property {[number, number, number]} corner  of the first, seen from the chain's root
 * @property {[number, number, number]} counts  along x, y and z; x runs fastest
 * @property {Uint8Array} reached               1 or 0
 * @property {Float32Array} manipulability
 * @property {Float32Array} margin
 * @property {Float32Array} directions
 * @property {Uint8Array | null} postures       null where there are infinitely many
 * @property {number} joints       how many move the TCP
 * @property {number} freedoms     in how many directions they move it in general: 3 makes a volume, 2 a surface, 1 a curve
 * @property {boolean} isMiddle    a cube is reached if its middle is; else if a posture landed in it
 * @property {number} volume       m³; where postures landed, cubes at the edge count half
 * @property {number} volumeError  m³: half of the cubes at the edge
 */

/** So many are looked at between two steps of work. */
export const AT_ONCE = 2e5;

/** Cubes at most; if there were more of the size that is asked for, they are made larger. */
const MOST_CUBES = 4e6;

/** A box thinner than this share of a cube is flat: what there is of it is rounding. */
const FLAT = 1e-4;

/**
 * What a box of places needs.
 * @param {Float32Array} places
 */
export function extentOf(places) {
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  for (let k = 0; k < places.length; k++) {
    low[k % 3] = Math.min(low[k % 3], places[k]);
    high[k % 3] = Math.max(high[k % 3], places[k]);
  }
  return { low, high };
}

/** @param {{ low: number[], high: number[] }} extent @param {number} wanted @param {Pick<Voxels, 'joints' | 'freedoms'>} arm @returns {Voxels} */
export function emptyVoxels({ low, high }, wanted, { joints, freedoms }) {
  // places seen so far leave some room: a few in a hundred all around
  const widths = low.map((value, i) => 1.06 * (high[i] - value));
  const most = (/** @type {number} */ side) => widths.reduce((product, width) => product * (width / side + 2), 1);
  let size = wanted;
  while (most(size) > MOST_CUBES) size *= 1.1;
  // what lies in a plane lies in the middle of its cubes
  const first = low.map((value, i) =>
    widths[i] < FLAT * size
      ? (value + high[i]) / 2 / size - 0.5
      : Math.floor((value - 0.03 * (high[i] - value)) / size),
  );
  const counts = /** @type {[number, number, number]} */ (
    high.map((value, i) => Math.floor((value + 0.03 * (value - low[i])) / size - first[i]) + 1)
  );
  const cubes = counts[0] * counts[1] * counts[2];
  return {
    size,
    corner: /** @type {[number, number, number]} */ (first.map((k) => k * size)),
    counts,
    reached: new Uint8Array(cubes),
    manipulability: new Float32Array(cubes),
    margin: new Float32Array(cubes),
    directions: new Float32Array(cubes),
    postures: null,
    joints,
    freedoms,
    isMiddle: false,
    volume: 0,
    volumeError: 0,
  };
}

/** The cube of a place, −1 outside. @param {Voxels} voxels @param {number} x @param {number} y @param {number} z */
export function cubeAt({ size, corner, counts }, x, y, z) {
  const i = Math.floor((x - corner[0]) / size);
  const j = Math.floor((y - corner[1]) / size);
  const k = Math.floor((z - corner[2]) / size);
  if (i < 0 || j < 0 || k < 0 || i >= counts[0] || j >= counts[1] || k >= counts[2]) return -1;
  return (k * counts[1] + j) * counts[0] + i;
}

/** @param {Voxels} voxels @param {number} cube @returns {[number, number, number]} */
export function middleOf({ size, corner, counts }, cube) {
  const i = cube % counts[0];
  const j = Math.floor(cube / counts[0]) % counts[1];
  const k = Math.floor(cube / (counts[0] * counts[1]));
  return [corner[0] + (i + 0.5) * size, corner[1] + (j + 0.5) * size, corner[2] + (k + 0.5) * size];
}

/**
 * From a cube to the next along each axis. Where there is one layer only, the next is none: a line of cubes is all edge.
 * @param {Voxels['counts']} counts
 */
export const stepsOf = ([x, y, z]) => [1, x, x * y].map((step, axis) => ([x, y, z][axis] === 1 ? x * y * z : step));

/** @param {Voxels} voxels @returns {Generator<null, Voxels>} the same, its volume counted */
export function* measuring(voxels) {
  const { reached, counts, size } = voxels;
  let all = 0;
  let edge = 0;
  const steps = stepsOf(counts);
  for (let k = 0; k < reached.length; k++) {
    if (k % AT_ONCE === AT_ONCE - 1) yield null;
    if (!reached[k]) continue;
    all++;
    if (steps.some((step) => !reached[k + step] || !reached[k - step])) edge++;
  }
  voxels.volume = (voxels.isMiddle ? all : all - edge / 2) * size ** 3;
  voxels.volumeError = (edge / 2) * size ** 3;
  return voxels;
}

/** What can be given away while the original is worked on. @param {Voxels} voxels @returns {Voxels} */
export const copyOf = (voxels) => ({
  ...voxels,
  reached: voxels.reached.slice(),
  manipulability: voxels.manipulability.slice(),
  margin: voxels.margin.slice(),
  directions: voxels.directions.slice(),
});
