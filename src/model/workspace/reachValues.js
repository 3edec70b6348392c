/**
 * What the cubes of a volume are coloured by, as numbers: metres, postures, shares, or as the kernel says of manipulability
 * (docs/workspace.md).
 *
 * @import { CubeSummary, Cubes } from './mapped.js'
 * @import { ReachColour } from './workspaceView.js'
 *
 * @typedef {{ of: (cube: number) => number, least: number, most: number }} ReachValues
 */

/**
 * @param {Cubes} cubes
 * @param {CubeSummary} summary
 * @param {ReachColour} colour
 * @returns {ReachValues | null} null where there are infinitely many postures
 */
export function reachValues(cubes, { scales }, colour) {
  const scale = scales[colour];
  const values = colour === 'height' ? null : cubes[colour];
  if (!scale || (colour !== 'height' && !values)) return null;
  const { least, most } = scale;
  const { counts, corner, size } = cubes;
  const layer = counts[0] * counts[1];
  const of = values
    ? (/** @type {number} */ cube) => values[cube]
    : (/** @type {number} */ cube) => corner[2] + (Math.floor(cube / layer) + 0.5) * size;
  return { of, least, most };
}

/** The cube of a place; −1 outside. @param {Cubes} cubes @param {number} x @param {number} y @param {number} z */
export function cubeOf({ size, corner, counts }, x, y, z) {
  const i = Math.floor((x - corner[0]) / size);
  const j = Math.floor((y - corner[1]) / size);
  const k = Math.floor((z - corner[2]) / size);
  if (!(i >= 0 && j >= 0 && k >= 0) || i >= counts[0] || j >= counts[1] || k >= counts[2]) return -1;
  return (k * counts[1] + j) * counts[0] + i;
}
