/**
 * A solid of cubes in few numbers, so that whoever shows it need not look at millions: how far it extends, and for each thing that
 * is told of a cube its scale and how much of the region is in each part of it.
 *
 * @import { Voxels } from './voxels.js'
 *
 * @typedef {object} Scale
 * @property {number} least   where the scale begins
 * @property {number} most
 * @property {boolean} isCount  whole numbers, each a part by itself
 * @property {number[]} shares  of all cubes, in each part; one part where all are the same
 *
 * @typedef {object} Summary
 * @property {number} count   of cubes that are reached
 * @property {number[]} low   m, the box of all of them
 * @property {number[]} high
 * @property {{ across: number, area: number, areaError: number } | null} layer  if they are one layer: the axis square to it, and
 *   the area, m², with half of the cubes at its edge as its error
 * @property {Record<'height' | 'manipulability' | 'margin' | 'directions', Scale> & { postures: Scale | null }} scales
 */

import { AT_ONCE, stepsOf } from './voxels.js';

/** Parts of a scale that is no count. */
const PARTS = 4;

/** @param {Voxels} voxels @returns {Generator<null, Summary | null>} null if nothing is reached */
export function* summarising(voxels) {
  const { reached, counts, corner, size, postures } = voxels;
  const layerSize = counts[0] * counts[1];
  let count = 0;
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  for (let cube = 0; cube < reached.length; cube++) {
    if (cube % AT_ONCE === AT_ONCE - 1) yield null;
    if (!reached[cube]) continue;
    count++;
    const [i, j, k] = [cube % counts[0], Math.floor(cube / counts[0]) % counts[1], Math.floor(cube / layerSize)];
    low[0] = Math.min(low[0], i);
    low[1] = Math.min(low[1], j);
    low[2] = Math.min(low[2], k);
    high[0] = Math.max(high[0], i);
    high[1] = Math.max(high[1], j);
    high[2] = Math.max(high[2], k);
  }
  if (count === 0) return null;
  const across = low.findIndex((at, axis) => high[axis] === at);
  const heightOf = (/** @type {number} */ cube) => corner[2] + (Math.floor(cube / layerSize) + 0.5) * size;
  const valuesOf = (/** @type {ArrayLike<number>} */ values) => (/** @type {number} */ cube) => values[cube];
  const scale = (/** @type {(cube: number) => number} */ of, /** @type {Partial<Scale>} */ fixed = {}) =>
    scaleOf(reached, count, of, fixed);
  return {
    count,
    low: low.map((at, axis) => corner[axis] + at * size),
    high: high.map((at, axis) => corner[axis] + (at + 1) * size),
    layer: across < 0 ? null : { across, ...(yield* layerArea(voxels, across)) },
    scales: {
      height: yield* scale(heightOf),
      manipulability: yield* scale(valuesOf(voxels.manipulability), { least: 0 }),
      margin: yield* scale(valuesOf(voxels.margin), { least: 0, most: 1 }),
      directions: yield* scale(valuesOf(voxels.directions), { least: 0, most: 1 }),
      postures: postures ? yield* scale(valuesOf(postures), { isCount: true }) : null,
    },
  };
}

/**
 * @param {Uint8Array} reached
 * @param {number} count
 * @param {(cube: number) => number} of
 * @param {Partial<Scale>} fixed  what is known of the scale
 * @returns {Generator<null, Scale>}
 */
function* scaleOf(reached, count, of, { isCount = false, ...fixed }) {
  let [least, most] = [Infinity, -Infinity];
  for (let cube = 0; cube < reached.length; cube++) {
    if (cube % AT_ONCE === AT_ONCE - 1) yield null;
    if (!reached[cube]) continue;
    const value = of(cube);
    if (value < least) least = value;
    if (value > most) most = value;
  }
  least = fixed.least ?? least;
  most = fixed.most ?? most;
  const parts = isCount ? most - least + 1 : most > least ? PARTS : 1;
  const width = isCount ? parts : most - least || 1;
  const counts = new Array(parts).fill(0);
  for (let cube = 0; cube < reached.length; cube++) {
    if (cube % AT_ONCE === AT_ONCE - 1) yield null;
    if (!reached[cube]) continue;
    const at = Math.floor(((of(cube) - least) / width) * parts);
    counts[Math.min(parts - 1, Math.max(0, at))]++;
  }
  return { least, most, isCount, shares: counts.map((each) => each / count) };
}

/** @param {Voxels} voxels @param {number} across */
function* layerArea({ reached, counts, size, isMiddle }, across) {
  const steps = stepsOf(counts).filter((_, axis) => axis !== across);
  let [all, edge] = [0, 0];
  for (let cube = 0; cube < reached.length; cube++) {
    if (cube % AT_ONCE === AT_ONCE - 1) yield null;
    if (!reached[cube]) continue;
    all++;
    if (steps.some((step) => !reached[cube + step] || !reached[cube - step])) edge++;
  }
  return { area: (isMiddle ? all : all - edge / 2) * size ** 2, areaError: (edge / 2) * size ** 2 };
}
