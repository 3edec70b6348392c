/**
 * The solid that a section at any angle makes when its first joint has no full turn. A place (ρ, z) of the section is reached
 * at the angles that the joint's range allows, for each posture of the other joints its own; over all of them together an angle
 * Δφ, and the volume is ∬ ρ Δφ dρ dz. That is a mean over a grid of places, times the area, which is known: two grids, one
 * between the places of the other, tell how far it may be off.
 *
 * @import { Cells } from './cells.js'
 * @import { PlaceSolver } from './exactPlaces.js'
 * @import { SectionMap } from './sectionMap.js'
 */

const FULL_TURN = 2 * Math.PI;

/** Places at most, in both grids. */
const PLACES = 24_000;

/** Differences of two grids by chance are smaller than this share of what they may be off: three times their difference is taken. */
const SAFE = 3;

/**
 * How much of a turn some ranges of angles cover together.
 * @param {readonly (readonly [number, number])[]} ranges
 */
export function coveredAngle(ranges) {
  /** Within one turn, cut at its end. @type {[number, number][]} */
  const cut = [];
  for (const [low, high] of ranges) {
    if (high - low >= FULL_TURN) return FULL_TURN;
    const start = low - FULL_TURN * Math.floor(low / FULL_TURN);
    const end = start + high - low;
    cut.push([start, Math.min(end, FULL_TURN)]);
    if (end > FULL_TURN) cut.push([0, end - FULL_TURN]);
  }
  let [sum, at] = [0, 0];
  for (const [start, end] of cut.sort((a, b) => a[0] - b[0])) {
    sum += Math.max(0, end - Math.max(at, start));
    at = Math.max(at, end);
  }
  return sum;
}

/**
 * @param {SectionMap} map   a meridian at any angle
 * @param {PlaceSolver} solve  with the joint left out unbound
 * @param {Cells} cells
 * @param {{ area: number, areaError: number }} enclosed
 * @returns {Generator<number, { volume: number, volumeError: number }>}  how much is done
 */
export function* sweptVolume(map, solve, cells, { area, areaError }) {
  const { left, placement } = map;
  const [low, high] = [placement.ranges.lower[left], placement.ranges.upper[left]];
  const { reached, columns, rows, size } = cells;
  const step = Math.max(1, Math.floor(Math.sqrt(area / (size * size * PLACES))));
  const sums = [0, 0];
  const counts = [0, 0];
  let most = 0;
  for (let row = Math.floor(step / 2); row < rows; row += step) {
    for (let column = Math.floor(step / 2); column < columns; column += step) {
      if (!reached[row * columns + column]) continue;
      const u = cells.u + (column + 0.5) * size;
      const postures = solve(map.lift([u, cells.v + (row + 0.5) * size])).filter(({ isInside }) => isInside);
      const height = u * coveredAngle(postures.map(({ x }) => [low - x[left], high - x[left]]));
      const grid = (Math.floor(row / step) + Math.floor(column / step)) % 2;
      sums[grid] += height;
      counts[grid]++;
      most = Math.max(most, height);
    }
    yield row / rows;
  }
  if (!counts[0] || !counts[1]) return { volume: area * (most / 2), volumeError: area * (most / 2) };
  const [a, b] = [sums[0] / counts[0], sums[1] / counts[1]];
  const mean = (sums[0] + sums[1]) / (counts[0] + counts[1]);
  return { volume: area * mean, volumeError: SAFE * area * Math.abs(a - b) + areaError * most };
}
