/**
 * What is drawn of a section, in its plane or in space.
 *
 * @import { Cells, SectionPlane, TracedSection } from './mapped.js'
 */

/** Rows at most that are drawn of a region's inside: its edge is drawn by lines. */
const MOST_ROWS = 400;

/**
 * The inside as stripes, one for each stretch of a row that is reached. Of large sections some rows stand for those beside them.
 * @param {Cells} cells
 * @param {number} [most]  rows
 * @returns {number[]} u from, u to, v from, v to; four for each
 */
export function stripesOf({ size, columns, rows, u, v, reached }, most = MOST_ROWS) {
  const step = Math.max(1, Math.ceil(rows / most));
  /** @type {number[]} */
  const stripes = [];
  for (let row = 0; row < rows; row += step) {
    const middle = Math.min(rows - 1, row + Math.floor(step / 2));
    const [low, high] = [v + row * size, v + Math.min(rows, row + step) * size];
    let from = -1;
    for (let column = 0; column <= columns; column++) {
      const isIn = column < columns && reached[middle * columns + column] === 1;
      if (isIn && from < 0) from = column;
      if (!isIn && from >= 0) {
        stripes.push(u + from * size, u + column * size, low, high);
        from = -1;
      }
    }
  }
  return stripes;
}

/**
 * A point of the plane in space.
 * @param {SectionPlane['frame']} frame
 * @param {number} u
 * @param {number} v
 * @returns {[number, number, number]}
 */
export const lifted = ({ origin, u: along, v: up }, u, v) => [
  origin[0] + u * along[0] + v * up[0],
  origin[1] + u * along[1] + v * up[1],
  origin[2] + u * along[2] + v * up[2],
];

/** Whether a place of the plane is reached, as far as the cells say. @param {Cells} cells @param {number} u @param {number} v */
export function isCellReached({ size, columns, rows, u: left, v: low, reached }, u, v) {
  const [column, row] = [Math.floor((u - left) / size), Math.floor((v - low) / size)];
  return column >= 0 && row >= 0 && column < columns && row < rows && reached[row * columns + column] === 1;
}

/**
 * The holes, largest first.
 * @param {Pick<TracedSection, 'outlines'>} section
 */
export function holesOf({ outlines }) {
  return outlines
    .filter(({ area }) => area < 0)
    .map(({ places, area }) => ({ area: -area, ...boxOf(places) }))
    .sort((a, b) => b.area - a.area);
}

/** @param {Float64Array} places @returns {{ u: [number, number], v: [number, number] }} */
function boxOf(places) {
  /** @type {[number, number]} */
  const u = [Infinity, -Infinity];
  /** @type {[number, number]} */
  const v = [Infinity, -Infinity];
  for (let k = 0; k < places.length; k += 2) {
    u[0] = Math.min(u[0], places[k]);
    u[1] = Math.max(u[1], places[k]);
    v[0] = Math.min(v[0], places[k + 1]);
    v[1] = Math.max(v[1], places[k + 1]);
  }
  return { u, v };
}

/**
 * The box of what is drawn, m: of the outlines, or of the first picture's cells.
 * @param {SectionPlane & Partial<Pick<TracedSection, 'extent'>>} shown
 * @returns {{ u: [number, number], v: [number, number] }}
 */
export function boxOfSection({ cells, extent }) {
  if (extent) return { u: [...extent.u], v: [...extent.v] };
  const { u, v, columns, rows, size } = cells;
  return { u: [u, u + columns * size], v: [v, v + rows * size] };
}

/**
 * Points of a closed outline that differ on the screen.
 * @param {Float64Array} places
 * @param {number} apart   m: nearer ones are left out
 * @returns {number[]} u, v of each; the first and the one farthest along are kept
 */
export function thinned(places, apart) {
  /** @type {number[]} */
  const kept = [];
  let [u, v] = [Infinity, Infinity];
  for (let k = 0; k < places.length; k += 2) {
    if (Math.abs(places[k] - u) < apart && Math.abs(places[k + 1] - v) < apart) continue;
    [u, v] = [places[k], places[k + 1]];
    kept.push(u, v);
  }
  return kept;
}

/**
 * Outlines as regions: each that is no hole, with the holes in it.
 * @param {readonly { readonly points: readonly number[], readonly area: number }[]} outlines
 */
export function withHoles(outlines) {
  const regions = outlines
    .filter(({ area, points }) => area > 0 && points.length >= 6)
    .sort((a, b) => a.area - b.area)
    .map(({ points }) => ({ outer: points, holes: /** @type {(readonly number[])[]} */ ([]) }));
  for (const { area, points } of outlines) {
    if (area >= 0 || points.length < 6) continue;
    // the smallest around it, of which there is one: islands in holes are regions by themselves
    regions.find(({ outer }) => isWithin(outer, points[0], points[1]))?.holes.push(points);
  }
  return regions;
}

/**
 * Whether a point is inside a closed line: how often a ray to its right crosses it.
 * @param {ArrayLike<number>} ring  u, v of each point
 * @param {number} u
 * @param {number} v
 */
export function isWithin(ring, u, v) {
  const count = ring.length / 2;
  let isIn = false;
  for (let i = 0, j = count - 1; i < count; j = i++) {
    const [au, av, bu, bv] = [ring[2 * i], ring[2 * i + 1], ring[2 * j], ring[2 * j + 1]];
    if (av > v !== bv > v && u < au + ((v - av) / (bv - av)) * (bu - au)) isIn = !isIn;
  }
  return isIn;
}
