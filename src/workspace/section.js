/**
 * The section of a workspace: where the TCP can be in a plane, with its boundary as curves. A generator, so that whoever asks
 * can show what there is so far, go on with something else, or stop.
 *
 * @import { Chain } from '../kinematics/chain.js'
 * @import { Vector } from '../kinematics/lines.js'
 * @import { IsReached, SideAt } from './boundary.js'
 * @import { Cells, Extent } from './cells.js'
 * @import { SectionProgress } from './fieldOutlines.js'
 * @import { PlaceSolver } from './exactPlaces.js'
 * @import { Enclosed, Outline } from './outline.js'
 * @import { Cut } from './cut.js'
 * @import { SectionMap } from './sectionMap.js'
 * @import { Fixed, Traced, Vertex } from './traced.js'
 *
 * @typedef {object} SectionOptions
 * @property {Cut} [cut]            missing: the arm's own
 * @property {boolean} [withLimits] of turning joints (true)
 * @property {number} [tolerance]   m: how far lines may be off the curves (2e-5); up to 2.5 times as far where that closes a long gap
 * @property {number} [cell]        m: the size of the cells (5e-4)
 * @property {number} [seed]
 * @property {boolean} [withVolume]  also of what the first joint makes of it through less than a full turn, which takes a while (true)
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
 * @property {number | null} volume  m³, of what the section makes as its first joint turns through its range; null if it
 *   makes none, or that is not known
 * @property {number | null} volumeError
 * @property {number} gap           m: the longest stretch of boundary that was not found
 * @property {Cells} cells
 */
import { boundaryOf, closeBeside } from './boundary.js';
import { cellsOf, extentOf } from './cells.js';
import { edges, folds, ownLimits } from './criticalCurves.js';
import { addDrawn, criticalPostures, nothingDrawn } from './criticalPostures.js';
import { createPlaceSolver } from './exactPlaces.js';
import { createDescent } from './descent.js';
import { createGoing } from './goneTo.js';
import { outlinesOfFields } from './fieldOutlines.js';
import { enclosed, onlyOnce, outlinesOf } from './outline.js';
import { createSampler } from './sampler.js';
import { ownCut } from './cut.js';
import { createSectionMap } from './sectionMap.js';
import { farthestOf, seenPostures } from './seenPostures.js';
import { atOnce, saying } from './steps.js';
import { sweptVolume } from './swept.js';

/** A gap longer than so many tolerances says that a piece between two lookings was overlooked: then all are looked at closely. */
const SUSPICIOUS = 60;

/** A piece whose ends differ is halved until it is no longer than this many tolerances. */
const SHORTEST = 0.02;

/** Curves are told of after so many. */
const WORD = 4;

/** Strips between curves narrower than so many tolerances are not asked of: estimated outlines may be off by as much. */
const STRIP = 3;

/**
 * An estimated outline whose longest gap is longer than so many tolerances is looked for again, with curves that are coarser by these
 * factors: which pieces are overlooked depends on where curves happen to have their points.
 */
const LONG_GAP = 100;
const COARSER = [1.5, 2.5];

/** The axis is looked at in so many pieces. */
const AXIS_PIECES = 400;

/** So many curves are thought to be half of all, where nobody knows how many there are. */
const FEW = 10;

/**
 * @param {Chain} chain
 * @param {SectionOptions} [options]
 * @returns {Generator<SectionProgress, Section | null>} null if the arm has no such section
 */
export function* mapSection(chain, options = {}) {
  const { tolerance = 2e-5 } = options;
  let best = yield* sectionWithin(chain, { ...options, tolerance });
  for (const factor of COARSER) {
    if (!best || best.sides === 'proven' || best.gap <= LONG_GAP * tolerance) break;
    const other = yield* sectionWithin(chain, { ...options, tolerance: factor * tolerance });
    if (other && other.areaError < best.areaError) best = other;
  }
  return best;
}

/**
 * @param {Chain} chain
 * @param {SectionOptions & { tolerance: number }} options
 * @returns {Generator<SectionProgress, Section | null>}
 */
function* sectionWithin(chain, options) {
  const { withLimits = true, tolerance, cell = 5e-4, seed = 1, withVolume = true } = options;
  const cut = options.cut ?? ownCut(chain, withLimits);
  const map = cut && createSectionMap(chain, cut, withLimits);
  if (!map) return null;
  const solve = map.free.length <= 2 ? createPlaceSolver(chain, withLimits, map.isAnyAngle ? map.left : -1) : null;
  const isReached = solve && reachedBy(solve, map);

  /** @type {Traced[]} */
  const curves = [];
  for (const trace of [edges, folds, ownLimits]) {
    for (const curve of trace(map, tolerance)) {
      if (curve) curves.push(curve);
      if (!curve || curves.length % WORD === 0)
        yield { stage: 'curves', share: curves.length / (curves.length + WORD) };
    }
  }
  if (isReached) {
    const sideAt = closeBeside(isReached, tolerance);
    const shortest = SHORTEST * tolerance;
    let outlines = yield* outlinesAlong(curves, sideAt, shortest, tolerance, false);
    if (outlines.some(({ gap }) => gap > SUSPICIOUS * tolerance)) {
      outlines = yield* outlinesAlong(curves, sideAt, shortest, tolerance, true);
    }
    const section = sectionOf(map, curves, outlines, { cell, tolerance }, 'proven');
    if (!withVolume || map.kind !== 'meridian' || section.volume !== null || !map.isAnyAngle) return section;
    const work = sweptVolume(map, solve, section.cells, section);
    let step = work.next();
    for (; !step.done; step = work.next()) yield { stage: 'volume', share: step.value };
    return { ...section, ...step.value };
  }
  const sampler = createSampler(chain, { withLimits, seed });
  const descent = createDescent(chain, withLimits, map.isAnyAngle ? map.left : -1);
  const seen = yield* saying(
    /** @type {SectionProgress} */ ({ stage: 'curves', share: 0 }),
    seenPostures(map, sampler, descent),
  );
  const drawn = nothingDrawn(tolerance);
  for (const curve of curves) addDrawn(drawn, curve);
  for (const curve of criticalPostures(map, tolerance, seed, drawn, farthestOf(seen))) {
    if (curve) curves.push(curve);
    yield { stage: 'curves', share: curves.length / (curves.length + FEW) };
  }
  if (map.kind === 'meridian') {
    const axis = axisOf(map, curves);
    curves.unshift(axis); // what runs along it is drawn as the axis
    addDrawn(drawn, axis);
  }
  const goTo = createGoing(map, descent, seen, tolerance / 100);
  yield { stage: 'sides', share: 0 };
  const outlines = yield* outlinesOfFields(map, curves, goTo, drawn, tolerance);
  return sectionOf(map, curves, outlines, { cell, tolerance }, 'estimated');
}

/**
 * The axis itself, as far as the curves go: a half-plane ends there.
 * @param {SectionMap} map
 * @param {readonly Traced[]} curves
 * @returns {Traced}
 */
function axisOf(map, curves) {
  let [low, high] = [Infinity, -Infinity];
  for (const { vertices } of curves) for (const { v } of vertices) [low, high] = [Math.min(low, v), Math.max(high, v)];
  const x = map.lower.slice();
  const at = (/** @type {number} */ v) => ({ x, u: 0, v });
  const vertices = Array.from({ length: AXIS_PIECES + 1 }, (_, k) => at(low + (k / AXIS_PIECES) * (high - low)));
  return { kind: 'singular', fixed: [], vertices, roughness: 0, between: (a, b) => at((a.v + b.v) / 2) };
}

/**
 * @param {readonly Traced[]} curves
 * @param {SideAt} sideAt
 * @param {number} shortest
 * @param {number} tolerance
 * @param {boolean} isThorough
 * @returns {Generator<SectionProgress, Outline[]>}
 */
function* outlinesAlong(curves, sideAt, shortest, tolerance, isThorough) {
  const pieces = [];
  for (const [i, curve] of curves.entries()) {
    const work = boundaryOf(curve, sideAt, shortest, isThorough);
    let step = work.next();
    for (; !step.done; step = work.next()) yield { stage: 'sides', share: i / curves.length };
    for (const piece of step.value) pieces.push(piece);
    yield { stage: 'sides', share: (i + 1) / curves.length };
  }
  return outlinesOf(onlyOnce(pieces, tolerance), tolerance).filter(({ vertices }) => vertices.length > 2);
}

/** @param {PlaceSolver} solve @param {SectionMap} map @returns {IsReached} */
const reachedBy = (solve, map) => (u, v) =>
  (map.kind !== 'meridian' || u >= 0) && solve(map.lift([u, v])).some(({ isInside }) => isInside);

/**
 * @param {SectionMap} map
 * @param {readonly Traced[]} curves
 * @param {readonly Outline[]} outlines
 * @param {{ cell: number, tolerance: number }} options
 * @param {Section['sides']} sides
 * @returns {Section}
 */
function sectionOf(map, curves, outlines, { cell, tolerance }, sides) {
  const { area, areaError, turned, turnedError, gap } = enclosed(
    outlines,
    sides === 'estimated' ? STRIP * tolerance : 0,
  );
  const makesSolid = map.kind === 'meridian' && map.placement.ranges.isClosed[map.left];
  const number = new Map(curves.map((curve, i) => [curve, i]));
  return {
    kind: map.kind,
    isAnyAngle: map.kind === 'meridian' && map.isAnyAngle,
    frame: { origin: map.origin, u: map.u, v: map.v },
    sides,
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

/** All of it at once. @param {Parameters<typeof mapSection>} given */
export const sectionAtOnce = (...given) => atOnce(mapSection(...given));
