/**
 * What curves make of a plane: they are cut where they meet, and run around fields.
 *
 * What several postures draw is taken once before; an end that stops short of another curve is joined to it, and how far that
 * was is kept.
 *
 * @import { BoundaryPiece } from './boundary.js'
 * @import { Edge } from './drawing.js'
 * @import { Traced, Vertex } from './traced.js'
 *
 * @typedef {object} Arrangement
 * @property {Vertex[]} nodes
 * @property {Edge[]} edges  half-edge 2 k runs from a to b, 2 k + 1 back
 * @property {Int32Array} next   of each half-edge: the next one around the field on its left
 * @property {Squares<number>} near  the edges, by where they are
 */
import { createDrawing } from './drawing.js';
import { Squares } from './squares.js';
import { apart } from './traced.js';

/** Tolerances along the side of a square of what is drawn. */
const SQUARE = 200;

/** An end this near to a curve, in tolerances, is on it; and is joined to the nearest if that is no farther. */
const TOUCHING = 8;
const JOINED = 60;

/**
 * @param {readonly BoundaryPiece[]} pieces  each once
 * @param {readonly [Vertex, Vertex][]} bridges  lines that join what the pieces leave open
 * @param {number} tolerance
 * @returns {Generator<null, Arrangement>}
 */
export function* arranged(pieces, bridges, tolerance) {
  const drawing = createDrawing(tolerance);
  for (const [from, to] of bridges)
    drawing.add(drawing.nodeAt(from), drawing.nodeAt(to), bridgeOf(from, to), apart(from, to));
  for (const { from, to, curve } of pieces) drawing.add(drawing.nodeAt(from), drawing.nodeAt(to), curve, 0);
  yield* drawing.cut();
  yield* drawing.joinEnds(TOUCHING, true);
  yield* drawing.joinEnds(JOINED, false);
  drawing.cutOffEnds();
  yield null;
  const edges = [...drawing.edges];
  /** @type {Squares<number>} */
  const near = new Squares(SQUARE * tolerance);
  edges.forEach(({ a, b }, k) => near.add(k, drawing.nodes[a], drawing.nodes[b]));
  return { nodes: drawing.nodes, edges, next: turnsAround(edges, drawing.nodes), near };
}

/** @param {Vertex} from @param {Vertex} to @returns {Traced} */
const bridgeOf = (from, to) => ({
  kind: 'singular',
  fixed: [],
  vertices: [from, to],
  roughness: 0,
  between: () => null,
});

/**
 * At every node the half-edges by their direction: whoever arrives goes on by the one that is next clockwise to where it came
 * from, and so keeps the same field on its left.
 * @param {readonly Edge[]} edges
 * @param {readonly Vertex[]} nodes
 */
function turnsAround(edges, nodes) {
  /** @type {number[][]} */
  const leaving = nodes.map(() => []);
  edges.forEach(({ a, b }, k) => {
    leaving[a].push(2 * k);
    leaving[b].push(2 * k + 1);
  });
  const next = new Int32Array(2 * edges.length);
  const direction = new Float64Array(next.length);
  edges.forEach(({ a, b }, k) => {
    const [du, dv] = [nodes[b].u - nodes[a].u, nodes[b].v - nodes[a].v];
    direction[2 * k] = Math.atan2(dv, du);
    direction[2 * k + 1] = Math.atan2(-dv, -du);
  });
  for (const halves of leaving) {
    halves.sort((g, h) => direction[g] - direction[h]);
    halves.forEach((half, k) => (next[half ^ 1] = halves[(k + halves.length - 1) % halves.length]));
  }
  return next;
}

/** The fields' borders: rings of half-edges, each with the same field on its left. @param {Arrangement} arrangement */
export function ringsOf({ next }) {
  const ringOf = new Int32Array(next.length).fill(-1);
  /** @type {number[][]} */
  const rings = [];
  for (let first = 0; first < next.length; first++) {
    if (ringOf[first] >= 0) continue;
    const ring = [];
    for (let half = first; ringOf[half] < 0; half = next[half]) {
      ringOf[half] = rings.length;
      ring.push(half);
    }
    rings.push(ring);
  }
  return { rings, ringOf };
}

/** From where to where a half-edge runs. @param {Arrangement} arrangement @param {number} half @returns {[Vertex, Vertex]} */
export function endsOf({ nodes, edges }, half) {
  const { a, b } = edges[half >> 1];
  return half & 1 ? [nodes[b], nodes[a]] : [nodes[a], nodes[b]];
}

/** Whether nothing is drawn between two places. @param {Arrangement} arrangement @param {{ u: number, v: number }} p @param {{ u: number, v: number }} q @param {number} but  an edge that does not count */
export function isClear({ nodes, edges, near }, p, q, but) {
  const side = (
    /** @type {{ u: number, v: number }} */ a,
    /** @type {{ u: number, v: number }} */ b,
    /** @type {{ u: number, v: number }} */ c,
  ) => (b.u - a.u) * (c.v - a.v) - (b.v - a.v) * (c.u - a.u);
  return !near.some(p, q, (k) => {
    if (k === but) return false;
    const [a, b] = [nodes[edges[k].a], nodes[edges[k].b]];
    return side(p, q, a) * side(p, q, b) <= 0 && side(a, b, p) * side(a, b, q) <= 0;
  });
}
