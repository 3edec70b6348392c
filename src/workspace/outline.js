/**
 * From pieces of boundary to closed outlines, and what they enclose. Different postures may draw the same line (an elbow that
 * is left or right at its limit), so what is there twice is taken out first; then pieces are joined end to end. An outline that
 * does not close says that a piece is missing, and by how much: the error that is stated with an area counts it.
 *
 * @import { BoundaryPiece } from './boundary.js'
 * @import { Traced, Vertex } from './traced.js'
 *
 * @typedef {object} Outline   closed; the region is on its left, so a hole runs clockwise
 * @property {Vertex[]} vertices  the first is not repeated
 * @property {Traced[]} curves    of the line from each vertex to the next
 * @property {number} area        m², negative for a hole
 * @property {number} gap         m: the longest that had to be bridged
 *
 * @typedef {object} Enclosed
 * @property {number} area     m²
 * @property {number} areaError
 * @property {number} turned   m³: of the region turned once about the axis u = 0 (Pappus)
 * @property {number} turnedError
 * @property {number} perimeter m
 * @property {number} gap
 */
import { Squares } from './squares.js';
import { apart } from './traced.js';

/** Lines that run the same way within this (the cosine of the angle) may be one line twice. */
const PARALLEL = 0.9999;

/** Two chords of one curve, each no farther off it than the tolerance, are this near to each other, in tolerances. */
const SAME_CURVE = 1.1;

/** A gap longer than so many tolerances is not bridged by joining, but closed as it is, and stated. */
const BRIDGED = 4;

/**
 * The pieces without what others have drawn before.
 * @param {readonly BoundaryPiece[]} pieces
 * @param {number} tolerance
 * @param {boolean} [isEitherWay]  also what runs back along another
 * @returns {BoundaryPiece[]}
 */
export function onlyOnce(pieces, tolerance, isEitherWay = false) {
  /** @type {Squares<BoundaryPiece>} */
  const squares = new Squares(200 * tolerance);
  /** @type {BoundaryPiece[]} */
  const kept = [];
  for (const piece of pieces) {
    const { from, to } = piece;
    const length = apart(from, to);
    if (length === 0) continue;
    const [du, dv] = [(to.u - from.u) / length, (to.v - from.v) / length];
    /** Shares of the piece that are there already. @type {[number, number][]} */
    const covered = [];
    for (const other of squares.near(from, to, tolerance)) {
      const size = apart(other.from, other.to);
      const [across, ahead] = [other.to.u - other.from.u, other.to.v - other.from.v];
      const cosine = (across * du + ahead * dv) / size;
      // chords of one curve, each so far off it, may differ by this much (the sine of the angle)
      const bend = isEitherWay ? 4 * tolerance * (1 / length + 1 / size) : 0;
      if (Math.abs(cosine) < PARALLEL - bend * bend || (cosine < 0 && !isEitherWay)) continue;
      const [along0, off0] = beside(other.from, from, du, dv);
      const [along1, off1] = beside(other.to, from, du, dv);
      if (isEitherWay) {
        const within = partWithin(off0, off1, SAME_CURVE * tolerance);
        if (!within) continue;
        const ends = within.map((share) => along0 + share * (along1 - along0));
        const [start, end] = [Math.max(0, Math.min(...ends)), Math.min(length, Math.max(...ends))];
        if (end - start > 0.01 * tolerance) covered.push([start / length, end / length]);
        continue;
      }
      if (Math.abs(off0) > 2 * tolerance || Math.abs(off1) > 2 * tolerance) continue;
      const [start, end] = [Math.max(0, along0), Math.min(length, along1)];
      if (end - start > 0.01 * tolerance) covered.push([start / length, end / length]);
    }
    // what sticks out a little from lines that draw the same curve is none of its own
    const least = (isEitherWay && covered.length > 0 ? 2 : 0.01) * tolerance;
    for (const [start, end] of uncovered(covered)) {
      if ((end - start) * length <= least) continue;
      const left = { ...piece, from: between(from, to, start), to: between(from, to, end) };
      kept.push(left);
      squares.add(left, left.from, left.to);
    }
  }
  return kept;
}

/**
 * Between which shares of the way from a to b a value is no larger than `most`.
 * @param {number} a
 * @param {number} b
 * @param {number} most
 * @returns {[number, number] | null}
 */
function partWithin(a, b, most) {
  if (a === b) return Math.abs(a) <= most ? [0, 1] : null;
  const [s, t] = [(-most - a) / (b - a), (most - a) / (b - a)];
  const [low, high] = [Math.max(0, Math.min(s, t)), Math.min(1, Math.max(s, t))];
  return low < high ? [low, high] : null;
}

/** How far along a direction a point is, and how far beside it. @param {Vertex} point @param {Vertex} from @param {number} du @param {number} dv */
const beside = (point, from, du, dv) => [
  (point.u - from.u) * du + (point.v - from.v) * dv,
  (point.v - from.v) * du - (point.u - from.u) * dv,
];

/** @param {Vertex} a @param {Vertex} b @param {number} share @returns {Vertex} */
const between = (a, b, share) =>
  share === 0
    ? a
    : share === 1
      ? b
      : {
          x: share < 0.5 ? a.x : b.x,
          u: a.u + share * (b.u - a.u),
          v: a.v + share * (b.v - a.v),
        };

/** What is left of 0 … 1. @param {[number, number][]} covered @returns {[number, number][]} */
function uncovered(covered) {
  /** @type {[number, number][]} */
  const left = [];
  let at = 0;
  for (const [start, end] of covered.sort((a, b) => a[0] - b[0])) {
    if (start > at) left.push([at, start]);
    at = Math.max(at, end);
  }
  if (at < 1) left.push([at, 1]);
  return left;
}

/**
 * @param {readonly BoundaryPiece[]} pieces  each once
 * @param {number} tolerance
 * @returns {Outline[]}
 */
export function outlinesOf(pieces, tolerance) {
  const reach = BRIDGED * tolerance;
  /** @type {Squares<BoundaryPiece>} */
  const starts = new Squares(4 * reach);
  /** @type {Squares<BoundaryPiece>} */
  const ends = new Squares(4 * reach);
  for (const piece of pieces) {
    starts.add(piece, piece.from, piece.from);
    ends.add(piece, piece.to, piece.to);
  }
  const left = new Set(pieces);
  /** The nearest piece that is left whose end is here. @param {Squares<BoundaryPiece>} squares @param {Vertex} here @param {'from' | 'to'} end */
  const nearest = (squares, here, end) => {
    let best = null;
    let least = reach;
    for (const piece of squares.near(here, here, reach)) {
      const distance = apart(piece[end], here);
      if (left.has(piece) && distance <= least) [best, least] = [piece, distance];
    }
    if (best) left.delete(best);
    return best;
  };
  /** @type {BoundaryPiece[][]} */
  const runs = [];
  for (const first of pieces) {
    if (!left.delete(first)) continue;
    const after = [first];
    for (let next = nearest(starts, first.to, 'from'); next; next = nearest(starts, next.to, 'from')) after.push(next);
    /** @type {BoundaryPiece[]} */
    const before = [];
    for (let next = nearest(ends, first.from, 'to'); next; next = nearest(ends, next.from, 'to')) before.push(next);
    runs.push([...before.reverse(), ...after]);
  }
  return bridged(runs, reach).map(closed);
}

/** How far it is from the end of a run to the start of another. @param {BoundaryPiece[]} a @param {BoundaryPiece[]} b */
const gapBetween = (a, b) => apart(a[a.length - 1].to, b[0].from);

/**
 * Runs that do not close, joined where their ends are nearest: where the region ends in a tip, both of its sides stop a little
 * short of it.
 * @param {BoundaryPiece[][]} runs
 * @param {number} reach
 */
function bridged(runs, reach) {
  const done = runs.filter((run) => gapBetween(run, run) <= reach);
  const open = runs.filter((run) => gapBetween(run, run) > reach);
  while (open.length > 0) {
    const run = /** @type {BoundaryPiece[]} */ (open.shift());
    const next = open.reduce((best, other) => (gapBetween(run, other) < gapBetween(run, best) ? other : best), run);
    if (next === run) done.push(run);
    else open.splice(open.indexOf(next), 1, [...run, ...next]);
  }
  return done;
}

/** @param {BoundaryPiece[]} run @returns {Outline} */
function closed(run) {
  let gap = 0;
  let area = 0;
  run.forEach((piece, i) => {
    const next = run[(i + 1) % run.length];
    gap = Math.max(gap, apart(piece.to, next.from));
    area += (piece.from.u * next.from.v - next.from.u * piece.from.v) / 2;
  });
  return { vertices: run.map(({ from }) => from), curves: run.map(({ curve }) => curve), area, gap };
}

/**
 * By integrals along the outlines: the area is ∮ u dv, and what the region makes when it turns about u = 0 is π ∮ u² dv. The
 * error is that of the lines (nowhere farther from the curve than its roughness) and of the gaps.
 * @param {readonly Outline[]} outlines
 * @param {number} [unsure]  m: how far they may be off besides, of outlines that close but for single lines over a gap
 * @returns {Enclosed}
 */
export function enclosed(outlines, unsure = 0) {
  const sum = { area: 0, areaError: 0, turned: 0, turnedError: 0, perimeter: 0, gap: 0 };
  for (const { vertices, curves, area, gap } of outlines) {
    sum.area += area;
    sum.gap = Math.max(sum.gap, gap);
    vertices.forEach((a, i) => {
      const b = vertices[(i + 1) % vertices.length];
      const length = apart(a, b);
      const off = unsure + curves[i].roughness + gap * Number(unsure === 0 && gap > length);
      sum.turned += (Math.PI / 3) * (a.u * a.u + a.u * b.u + b.u * b.u) * (b.v - a.v);
      sum.perimeter += length;
      sum.areaError += length * off;
      sum.turnedError += Math.PI * (Math.abs(a.u) + Math.abs(b.u)) * length * off;
    });
    sum.areaError += gap * gap;
  }
  return sum;
}
