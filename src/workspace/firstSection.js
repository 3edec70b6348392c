/**
 * A first picture of a section: cells in which a sampled posture lands, where it is brought into the plane, or passes by near
 * enough, if no joint of the arm does that. Some milliseconds, and nothing is proven: what is not seen to be reached may be, and a
 * cell at the edge is reached in part.
 *
 * @import { Cells } from './cells.js'
 * @import { SectionOptions } from './section.js'
 * @import { Cut } from './cut.js'
 * @import { SectionMap } from './sectionMap.js'
 * @import { Chain } from '../kinematics/chain.js'
 *
 * @typedef {object} FirstSection
 * @property {SectionMap['kind']} kind
 * @property {boolean} isAnyAngle
 * @property {{ origin: SectionMap['origin'], u: SectionMap['u'], v: SectionMap['v'] }} frame
 * @property {Cells} cells
 * @property {number} beside  m: how far from the plane a place may be that counts as in it
 */
import { cross } from '../kinematics/lines.js';
import { createSampler } from './sampler.js';
import { ownCut } from './cut.js';
import { createSectionMap } from './sectionMap.js';

/** Postures, and cells along the longer side: each picture is finer than the one before. */
const PICTURES = [
  { postures: 6_000, across: 48 },
  { postures: 60_000, across: 120 },
];

/** Places of which those near a plane are taken; near: a cell across. */
const SLAB = { slices: 20, slice: 50_000, across: 56 };

/** What stands in for no distance: a section that has no width is a cell wide. */
const THIN = 1e-6;

/**
 * @param {Chain} chain
 * @param {SectionOptions} [options]
 * @returns {Generator<FirstSection>} nothing if the arm has no such section
 */
export function* firstSections(chain, options = {}) {
  const { withLimits = true, seed = 1 } = options;
  const cut = options.cut ?? ownCut(chain, withLimits);
  const map = cut && createSectionMap(chain, cut, withLimits);
  if (!map || map.isThin) {
    if (cut?.kind === 'plane') yield passingBy(chain, cut, withLimits, seed);
    return;
  }
  const { kind, isAnyAngle, origin, u, v } = map;
  for (const { postures, across } of PICTURES) {
    yield {
      kind,
      isAnyAngle: kind === 'meridian' && isAnyAngle,
      frame: { origin, u, v },
      beside: 0,
      cells: cellsAround(placesIn(map, chain, withLimits, seed, postures), across),
    };
  }
}

/**
 * @param {SectionMap} map
 * @param {Chain} chain
 * @param {boolean} withLimits
 * @param {number} seed
 * @param {number} count
 * @returns {Float64Array} u, v of each posture that can be brought into the plane
 */
function placesIn(map, chain, withLimits, seed, count) {
  const sampler = createSampler(chain, { withLimits, seed });
  const { joints } = map.placement.ranges;
  const q = new Float64Array(chain.dof);
  const x = new Float64Array(map.free.length);
  const places = new Float64Array(2 * count);
  let found = 0;
  for (let index = 0; index < count; index++) {
    sampler.postureAt(index, q);
    for (let k = 0; k < x.length; k++) x[k] = q[joints[map.free[k]]];
    map.write(x);
    if (!map.isBrought()) continue;
    places.set(map.f, 2 * found++);
  }
  return places.subarray(0, 2 * found);
}

/**
 * Of many places those near a plane, as its cells.
 * @param {Chain} chain
 * @param {Extract<Cut, { kind: 'plane' }>} cut
 * @param {boolean} withLimits
 * @param {number} seed
 * @returns {FirstSection}
 */
function passingBy(chain, { origin, u, v }, withLimits, seed) {
  const sampler = createSampler(chain, { withLimits, seed });
  const normal = cross(u, v);
  const { slices, slice, across } = SLAB;
  const thick = (2 * chain.reach) / across;
  const places = new Float32Array(3 * slice);
  /** @type {number[]} */
  const near = [];
  for (let done = 0; done < slices; done++) {
    sampler.fill(done * slice, places);
    for (let k = 0; k < places.length; k += 3) {
      const x = places[k] - origin[0];
      const y = places[k + 1] - origin[1];
      const z = places[k + 2] - origin[2];
      if (Math.abs(x * normal[0] + y * normal[1] + z * normal[2]) > thick / 2) continue;
      near.push(x * u[0] + y * u[1] + z * u[2], x * v[0] + y * v[1] + z * v[2]);
    }
  }
  const frame = { origin, u, v };
  const cells = cellsAround(Float64Array.from(near), across);
  return { kind: 'plane', isAnyAngle: false, frame, beside: thick / 2, cells };
}

/** @param {Float64Array} places @param {number} across @returns {Cells} */
function cellsAround(places, across) {
  const [low, high] = [
    [Infinity, Infinity],
    [-Infinity, -Infinity],
  ];
  for (let k = 0; k < places.length; k++) {
    low[k % 2] = Math.min(low[k % 2], places[k]);
    high[k % 2] = Math.max(high[k % 2], places[k]);
  }
  const size = Math.max(THIN, high[0] - low[0], high[1] - low[1]) / across;
  if (places.length === 0) return { size: THIN, columns: 0, rows: 0, u: 0, v: 0, reached: new Uint8Array(0) };
  const [left, bottom] = low.map((value) => Math.floor(value / size));
  const columns = Math.floor(high[0] / size) - left + 1;
  const rows = Math.floor(high[1] / size) - bottom + 1;
  const reached = new Uint8Array(columns * rows);
  for (let k = 0; k < places.length; k += 2) {
    reached[(Math.floor(places[k + 1] / size) - bottom) * columns + Math.floor(places[k] / size) - left] = 1;
  }
  return { size, columns, rows, u: left * size, v: bottom * size, reached };
}
