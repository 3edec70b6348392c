/**
 * Which side of a curve is reached, for arms without a closed form: the critical curves part the plane into fields, and in
 * each either every place is reached or none, since the region has no boundary there. So one posture that lands in a field is
 * enough to know it. Fields are found on a grid, whose cells on the curves are walls; postures come from the sampler.
 *
 * A field in which no posture lands is taken as not reached: that is estimated, not proven.
 *
 * @import { SideAt } from './boundary.js'
 * @import { Cells } from './cells.js'
 * @import { Sampler } from './sampler.js'
 * @import { SectionMap } from './sectionMap.js'
 * @import { Descent } from './descent.js'
 * @import { Traced, Vertex } from './traced.js'
 *
 * @typedef {{ stage: 'curves' | 'postures' | 'sides' | 'volume', share: number }} SectionProgress
 *
 * @typedef {object} Fields
 * @property {SideAt} sideAt
 * @property {Cells} cells
 */
import { createRandom } from '../kinematics/random.js';
import { sideOf } from './boundary.js';
import { apart } from './traced.js';

/** Cells at most: if there were more of the size that is asked for, they are made larger. */
const MOST_CELLS = 8e6;

/** Cells around it. */
const MARGIN = 3;

/** Postures: for each cell, at least, and between two words of progress. */
const POSTURES_EACH = 3;
const LEAST_POSTURES = 4e6;
const SLICE = 1e5;

/** A cell in which no posture lands is reached if one does this near in the same field, in cells. */
const NEAR = 12;

/** Where to look beside a curve, in cells: farther only if there is a wall. */
const BESIDE = [1.5, 2.5, 4];

/** Where to try to go to, in cells. */
const CLOSE = 0.05;

/** Descents for one place, half of them from near the curve's posture, rad. */
const TRIES = 16;
const NUDGE = 0.02;

const WALL = 1;

/** Walls are no thicker than so many cells, but where they run along each other. */
const THICK = 4;

/**
 * @param {SectionMap} map
 * @param {readonly Traced[]} curves
 * @param {number} size   m: of the cells, if there are not too many
 * @param {Sampler} sampler
 * @param {(at: Vertex, u: number, v: number) => boolean} isGoneTo
 * @returns {Generator<SectionProgress, Fields>}
 */
export function* fieldsBetween(map, curves, size, sampler, isGoneTo) {
  const grid = gridAround(curves, size);
  drawWalls(grid, curves);
  const { cells } = grid;
  const hits = new Uint8Array(cells.length);
  const places = new Float32Array(3 * SLICE);
  const postures = Math.max(LEAST_POSTURES, POSTURES_EACH * cells.length);
  for (let done = 0; done < postures; done += SLICE) {
    sampler.fill(done, places);
    markHits(map, grid, places, hits);
    yield { stage: 'postures', share: Math.min(1, (done + SLICE) / postures) };
  }

  const reached = spread(grid, hits);
  const sideAt = sidesBy(grid, (cell) => reached[cell] === 1, isGoneTo);
  fillWalls(grid, hits, reached);
  const { u, v, columns, rows } = grid;
  return { sideAt, cells: { size: grid.size, u, v, columns, rows, reached } };
}

/**
 * The cells of fields that are reached: where postures land, and around there as far as no wall is between.
 * @param {Grid} grid
 * @param {Uint8Array} hits
 * @returns {Uint8Array} 1 or 0; walls are not
 */
function spread({ cells, columns }, hits) {
  const reached = new Uint8Array(cells.length);
  /** @type {number[]} */
  let front = [];
  for (let k = columns; k < cells.length - columns; k++) {
    if (hits[k] === 0 || cells[k] === WALL) continue;
    // a cell on whose edge a wall runs may have been hit from behind it
    const isClear =
      cells[k - 1] !== WALL && cells[k + 1] !== WALL && cells[k - columns] !== WALL && cells[k + columns] !== WALL;
    if (isClear) reached[k] = 1;
    if (isClear) front.push(k);
  }
  for (let distance = 0; distance < NEAR; distance++) {
    /** @type {number[]} */
    const next = [];
    for (const k of front) {
      for (const near of [k - 1, k + 1, k - columns, k + columns]) {
        if (cells[near] === WALL || reached[near]) continue;
        reached[near] = 1;
        next.push(near);
      }
    }
    front = next;
  }
  return reached;
}

/**
 * Cells on walls: reached if a posture lands there. One in which none does lies between two fields that are, or is not.
 * @param {Grid} grid
 * @param {Uint8Array} hits
 * @param {Uint8Array} reached  changed in place
 */
function fillWalls({ cells, columns }, hits, reached) {
  /** Whether the first cell off the wall is reached. @param {number} from @param {number} step */
  const isReachedAcross = (from, step) => {
    for (let k = from + step, count = 0; count < THICK; k += step, count++)
      if (cells[k] !== WALL) return reached[k] === 1;
    return false;
  };
  const isBetween = (/** @type {number} */ k) =>
    (isReachedAcross(k, 1) && isReachedAcross(k, -1)) || (isReachedAcross(k, columns) && isReachedAcross(k, -columns));
  const walls = [];
  for (let k = columns; k < cells.length - columns; k++) {
    if (cells[k] !== WALL) continue;
    if (hits[k] || isBetween(k)) walls.push(k);
  }
  for (const k of walls) reached[k] = 1;
}

/**
 * @typedef {object} Grid
 * @property {number} size
 * @property {number} u  of its corner
 * @property {number} v
 * @property {number} columns
 * @property {number} rows
 * @property {Uint8Array} cells
 */

/** @param {readonly Traced[]} curves @param {number} wanted  the size of its cells @returns {Grid} */
function gridAround(curves, wanted) {
  const [low, high] = [
    [Infinity, Infinity],
    [-Infinity, -Infinity],
  ];
  for (const { vertices } of curves) {
    for (const { u, v } of vertices) {
      [low[0], low[1]] = [Math.min(low[0], u), Math.min(low[1], v)];
      [high[0], high[1]] = [Math.max(high[0], u), Math.max(high[1], v)];
    }
  }
  const size = Math.max(wanted, Math.sqrt(((high[0] - low[0]) * (high[1] - low[1])) / MOST_CELLS));
  const [columns, rows] = [0, 1].map((axis) => Math.ceil((high[axis] - low[axis]) / size) + 2 * MARGIN + 2);
  const corner = (/** @type {number} */ axis) => (Math.floor(low[axis] / size) - MARGIN) * size;
  return {
    size,
    u: corner(0),
    v: corner(1),
    columns,
    rows,
    cells: new Uint8Array(columns * rows),
  };
}

/** The cell at a place; −1 outside. @param {Grid} grid @param {number} u @param {number} v */
function cellAt(grid, u, v) {
  const column = Math.floor((u - grid.u) / grid.size);
  const row = Math.floor((v - grid.v) / grid.size);
  return column < 0 || row < 0 || column >= grid.columns || row >= grid.rows ? -1 : row * grid.columns + column;
}

/** @param {Grid} grid @param {readonly Traced[]} curves */
function drawWalls(grid, curves) {
  const { columns, rows, cells, size } = grid;
  for (const { vertices } of curves) {
    for (let i = 1; i < vertices.length; i++) {
      const [a, b] = [vertices[i - 1], vertices[i]];
      const steps = Math.ceil((4 * apart(a, b)) / size) + 1;
      for (let k = 0; k <= steps; k++) {
        const share = k / steps;
        cells[cellAt(grid, a.u + share * (b.u - a.u), a.v + share * (b.v - a.v))] = WALL;
      }
    }
  }
  for (let k = 0; k < columns; k++) cells[k] = cells[columns * (rows - 1) + k] = WALL;
  for (let k = 0; k < rows; k++) cells[columns * k] = cells[columns * k + columns - 1] = WALL;
}

/** @param {SectionMap} map @param {Grid} grid @param {Float32Array} places @param {Uint8Array} hits */
function markHits({ kind, origin, u, v }, grid, places, hits) {
  const isTurned = kind === 'meridian';
  for (let k = 0; k < places.length; k += 3) {
    const x = places[k] - origin[0];
    const y = places[k + 1] - origin[1];
    const z = places[k + 2] - origin[2];
    const height = x * v[0] + y * v[1] + z * v[2];
    const out = isTurned
      ? Math.sqrt(Math.max(0, x * x + y * y + z * z - height * height))
      : x * u[0] + y * u[1] + z * u[2];
    const cell = cellAt(grid, out, height);
    if (cell >= 0) hits[cell] = 1;
  }
}

/**
 * Where walls are all around, as between two curves close together, the places beside the curve are tried to be gone to, from
 * the curve's own posture and some others.
 * @param {Grid} grid
 * @param {(cell: number) => boolean} isReached
 * @param {(at: Vertex, u: number, v: number) => boolean} isGoneTo
 * @returns {SideAt}
 */
function sidesBy(grid, isReached, isGoneTo) {
  return (at, a, b) => {
    const length = apart(a, b);
    if (length === 0) return 0;
    const [nu, nv] = [-(b.v - a.v) / length, (b.u - a.u) / length];
    const look = (/** @type {1 | -1} */ sense) => {
      for (const distance of BESIDE) {
        const step = sense * distance * grid.size;
        const cell = cellAt(grid, at.u + step * nu, at.v + step * nv);
        if (cell < 0) return false;
        if (grid.cells[cell] !== WALL) {
          // a wall may have been stepped over, so only the first cell off the curve's own tells for sure
          return distance === BESIDE[0] ? isReached(cell) : isTried(sense);
        }
      }
      return isTried(sense);
    };
    const isTried = (/** @type {1 | -1} */ sense) => {
      const step = sense * CLOSE * grid.size;
      return isGoneTo(at, at.u + step * nu, at.v + step * nv);
    };
    return sideOf(look(1), look(-1));
  };
}

/**
 * Whether a descent brings the TCP to a place beside a critical curve.
 * @param {SectionMap} map
 * @param {Descent} descent
 * @param {number} within  m
 * @returns {(at: Vertex, u: number, v: number) => boolean}
 */
export function triedFrom(map, descent, within) {
  const random = createRandom(1);
  const { ranges } = map.placement;
  const x = new Float64Array(ranges.joints.length);
  return (at, u, v) => {
    if (map.kind === 'meridian' && u < 0) return false;
    const place = map.lift([u, v]);
    for (let start = 0; start < TRIES; start++) {
      map.write(at.x);
      const spread = start < TRIES / 2 ? NUDGE * (start + 1) : Math.PI;
      map.free.forEach((k, i) => {
        const value = at.x[i] + (2 * random() - 1) * spread;
        x[k] = ranges.isClosed[k] ? value : Math.min(ranges.upper[k], Math.max(ranges.lower[k], value));
      });
      if (map.left >= 0) x[map.left] = map.needed();
      if (descent.bring(place, x) <= within) return true;
    }
    return false;
  };
}
