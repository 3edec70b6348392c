/**
 * The section of a workspace: where the TCP can be in a plane, with its boundary as curves. A generator, so that whoever asks
 * can show what there is so far, go on with something else, or stop.
 *
 * @import { Chain } from '../kinematics/chain.js'
 * @import { Vector } from '../kinematics/lines.js'
 * @import { IsReached } from './boundary.js'
 * @import { Cells, Extent } from './cells.js'
 * @import { Enclosed, Outline } from './outline.js'
 * @import { Cut, SectionMap } from './sectionMap.js'
 * @import { Fixed, Traced, Vertex } from './traced.js'
 *
 * @typedef {object} SectionOptions
 * @property {Cut} [cut]            missing: the arm's own
 * @property {boolean} [withLimits] of turning joints (true)
 * @property {number} [tolerance]   m: how far lines may be off the curves (2e-5)
 * @property {number} [cell]        m: the size of the cells (5e-4)
 * @property {number} [seed]
 *
 * @typedef {object} SectionCurve   a critical curve, of which part may be boundary
 * @property {Traced['kind']} kind
 * @property {readonly Fixed[]} fixed
 * @property {Float64Array} places    u, v of each vertex
 * @property {Float64Array} postures  of all joints, for each vertex; joints that do not move the TCP are at zero
 *
 * @typedef {object} SectionOutline
 * @property {Float64Array} places   u, v; closed, the first is not repeated
 * @property {Uint32Array} curves    which curve the line from each vertex belongs to
 * @property {Float64Array} postures that are on the boundary there, one for each vertex
 * @property {number} area           m²; negative: a hole
 *
 * @typedef {object} Section
 * @property {SectionMap['kind']} kind
 * @property {boolean} isAnyAngle    of a half-plane: what is reached at any angle, not at one
 * @property {{ origin: Vector, u: Vector, v: Vector }} frame  seen from the chain's root
 * @property {'proven' | 'estimated'} sides  how it is known on which side of a curve the region is: by closed-form inverse
 *   kinematics, or by postures that were found
 * @property {SectionCurve[]} curves
 * @property {SectionOutline[]} outlines
 * @property {Extent | null} extent  null if the region has no area
 * @property {number} area          m²
 * @property {number} areaError
 * @property {number | null} volume  m³, of what the section makes in a full turn; null if it makes none
 * @property {number | null} volumeError
 * @property {number} gap           m: the longest stretch of boundary that was not found
 * @property {Cells} cells
 *
 * @typedef {{ stage: 'curves' | 'sides', share: number }} SectionProgress
 */
import { boundaryOf } from './boundary.js';
import { cellsOf, extentOf } from './cells.js';
import { edges, folds, ownLimits } from './criticalCurves.js';
import { createPlaceSolver } from './exactPlaces.js';
import { enclosed, onlyOnce, outlinesOf } from './outline.js';
import { createSectionMap, ownCut } from './sectionMap.js';

/** A gap longer than so many tolerances says that a piece between two lookings was overlooked: then all are looked at closely. */
const SUSPICIOUS = 60;

/** Curves are told of after so many. */
const WORD = 4;

/**
 * @param {Chain} chain
 * @param {SectionOptions} [options]
 * @returns {Generator<SectionProgress, Section | null>} null if the arm has no such section
 */
export function* mapSection(chain, options = {}) {
  const { withLimits = true, tolerance = 2e-5, cell = 5e-4 } = options;
  const cut = options.cut ?? ownCut(chain, withLimits);
  const map = cut && createSectionMap(chain, cut, withLimits);
  if (!map) return null;
  const isReached = exactlyReached(chain, map, withLimits);
  if (!isReached) return null;

  /** @type {Traced[]} */
  const curves = [];
  for (const trace of [edges, folds, ownLimits]) {
    for (const curve of trace(map, tolerance)) {
      curves.push(curve);
      if (curves.length % WORD === 0) yield { stage: 'curves', share: curves.length / (curves.length + WORD) };
    }
  }
  let outlines = yield* outlinesAlong(curves, isReached, tolerance, false);
  if (outlines.some(({ gap }) => gap > SUSPICIOUS * tolerance)) {
    outlines = yield* outlinesAlong(curves, isReached, tolerance, true);
  }
  return sectionOf(map, curves, outlines, cell);
}

/**
 * @param {readonly Traced[]} curves
 * @param {IsReached} isReached
 * @param {number} tolerance
 * @param {boolean} isThorough
 * @returns {Generator<SectionProgress, Outline[]>}
 */
function* outlinesAlong(curves, isReached, tolerance, isThorough) {
  const pieces = [];
  for (const [i, curve] of curves.entries()) {
    pieces.push(...boundaryOf(curve, isReached, tolerance, isThorough));
    yield { stage: 'sides', share: (i + 1) / curves.length };
  }
  return outlinesOf(onlyOnce(pieces, tolerance), tolerance).filter(({ vertices }) => vertices.length > 2);
}

/**
 * @param {Chain} chain
 * @param {SectionMap} map
 * @param {boolean} withLimits
 * @returns {IsReached | null} null if more joints move the TCP than have a closed form
 */
function exactlyReached(chain, map, withLimits) {
  const solve = createPlaceSolver(chain, withLimits, map.isAnyAngle ? map.left : -1);
  if (!solve) return null;
  return (u, v) => (map.kind !== 'meridian' || u >= 0) && solve(map.lift([u, v])).some(({ isInside }) => isInside);
}

/**
 * @param {SectionMap} map
 * @param {readonly Traced[]} curves
 * @param {readonly Outline[]} outlines
 * @param {number} cell
 * @returns {Section}
 */
function sectionOf(map, curves, outlines, cell) {
  const { area, areaError, turned, turnedError, gap } = enclosed(outlines);
  const makesSolid = map.kind === 'meridian' && map.placement.ranges.isClosed[map.left];
  const number = new Map(curves.map((curve, i) => [curve, i]));
  return {
    kind: map.kind,
    isAnyAngle: map.kind === 'meridian' && map.isAnyAngle,
    frame: { origin: map.origin, u: map.u, v: map.v },
    sides: 'proven',
    curves: curves.map(({ kind, fixed, vertices }) => ({ kind, fixed, ...written(map, vertices) })),
    outlines: outlines.map((outline) => ({
      ...written(map, outline.vertices),
      curves: Uint32Array.from(outline.curves, (curve) => number.get(curve) ?? 0),
      area: outline.area,
    })),
    extent: extentOf(outlines),
    area,
    areaError,
    volume: makesSolid ? turned : null,
    volumeError: makesSolid ? turnedError : null,
    gap,
    cells: cellsOf(outlines, cell),
  };
}

/** @param {SectionMap} map @param {readonly Vertex[]} vertices */
function written(map, vertices) {
  const { q } = map.placement;
  const { joints } = map.placement.ranges;
  const places = new Float64Array(2 * vertices.length);
  const postures = new Float64Array(q.length * vertices.length);
  vertices.forEach(({ x, u, v }, i) => {
    places[2 * i] = u;
    places[2 * i + 1] = v;
    map.write(x);
    if (map.left >= 0) q[joints[map.left]] = map.needed();
    postures.set(q, q.length * i);
    if (map.left >= 0) q[joints[map.left]] = 0;
  });
  return { places, postures };
}

/**
 * All of it at once.
 * @param {Chain} chain
 * @param {SectionOptions} [options]
 */
export function sectionAtOnce(chain, options) {
  const job = mapSection(chain, options);
  let turn = job.next();
  while (!turn.done) turn = job.next();
  return turn.value;
}
