/**
 * Curves in a section, traced: the images of curves of postures. Each is a run of vertices that lie on it to the last digits,
 * so close together that the straight lines between them leave it by no more than a tolerance.
 *
 * @import { SectionMap } from './sectionMap.js'
 *
 * @typedef {object} Vertex
 * @property {Float64Array} x  the arguments of the section map
 * @property {number} u        m
 * @property {number} v
 *
 * @typedef {object} Fixed   a joint that stands at a limit all along
 * @property {number} joint  from 0, of the chain
 * @property {'lower' | 'upper'} bound
 *
 * @typedef {object} Traced
 * @property {'limit' | 'singular'} kind   why it may be a boundary: limits alone, or the joints that are free cannot push
 *   the TCP across it
 * @property {readonly Fixed[]} fixed
 * @property {Vertex[]} vertices
 * @property {(a: Vertex, b: Vertex) => Vertex | null} between  a vertex about half-way on the curve; null if there is none
 * @property {number} roughness   m: how far the lines may be off it
 */
import { atOnce } from './steps.js';

/** Halvings of one piece, at most. */
const DEEPEST = 14;

/** A piece is halved at least until its ends are no farther apart than this many tolerances, so that no bend is overlooked. */
const LONGEST = 400;

/** @param {SectionMap} map @param {Float64Array} x @returns {Vertex} */
export function vertexAt(map, x) {
  map.write(x);
  return { x, u: map.f[0], v: map.f[1] };
}

/** @param {{ u: number, v: number }} a @param {{ u: number, v: number }} b */
export const apart = (a, b) => Math.hypot(a.u - b.u, a.v - b.v);

/** How far a point is from the line through a and b; from a, if that is none. @param {Vertex} point @param {Vertex} a @param {Vertex} b */
function besideChord(point, a, b) {
  const length = apart(a, b);
  const [du, dv] = [point.u - a.u, point.v - a.v];
  if (length === 0) return Math.hypot(du, dv);
  const t = Math.min(1, Math.max(0, (du * (b.u - a.u) + dv * (b.v - a.v)) / (length * length)));
  return Math.hypot(du - t * (b.u - a.u), dv - t * (b.v - a.v));
}

/** Pieces of a curve between two steps of work. */
export const PIECES = 32;

/**
 * A curve through some vertices, with as many more between them as the tolerance asks for; its roughness is written. Where
 * nothing is found between two of them it is interrupted.
 * @param {Omit<Traced, 'vertices' | 'roughness'>} curve
 * @param {readonly Vertex[]} vertices
 * @param {number} tolerance  m
 * @returns {Generator<null, { runs: Traced[], gaps: [Vertex, Vertex][] }>}
 */
export function* refining(curve, vertices, tolerance) {
  /** @type {[Vertex, Vertex][]} */
  const gaps = [];
  /** @type {Traced} */
  let run = { ...curve, vertices: [vertices[0]], roughness: 0 };
  const runs = [run];
  /** @param {Vertex} from @param {Vertex} to @param {number} depth */
  const walk = (from, to, depth) => {
    const middle = curve.between(from, to);
    if (!middle && apart(from, to) > tolerance) {
      gaps.push([from, to]);
      run = { ...curve, vertices: [to], roughness: 0 };
      runs.push(run);
      return;
    }
    const off = middle ? besideChord(middle, from, to) : apart(from, to);
    const isFar = middle && apart(from, middle) + apart(middle, to) > LONGEST * tolerance;
    if (!middle || depth === DEEPEST || (off <= tolerance && !isFar)) {
      run.roughness = Math.max(run.roughness, off);
      run.vertices.push(to);
      return;
    }
    walk(from, middle, depth + 1);
    walk(middle, to, depth + 1);
  };
  for (let i = 1; i < vertices.length; i++) {
    walk(vertices[i - 1], vertices[i], 0);
    if (i % PIECES === 0) yield null;
  }
  return { runs: runs.filter((each) => each.vertices.length > 1), gaps };
}

/** Likewise, at once. @param {Parameters<typeof refining>} given */
export const refined = (...given) => atOnce(refining(...given));
