/**
 * Lines on a fine grid of whole numbers, so that on which side of one a point lies is told without rounding, and every meeting is
 * found; cut where they meet.
 *
 * @import { Traced, Vertex } from './traced.js'
 *
 * @typedef {object} Edge
 * @property {number} a  nodes
 * @property {number} b
 * @property {Traced} curve
 * @property {number} gap  m: of a line that joins an end to another curve, how long it is; else 0
 */
import { Squares } from './squares.js';

/** Steps of the grid along the side of a square of what is drawn. */
const SQUARE = 10_000;

/** Steps of the grid in one tolerance. */
const FINE = 50;

/** Cutting may make lines meet that did not, by the rounding of where they meet; so often it is looked again. */
const PASSES = 12;

/** So many lines are held against the others between two steps of work. */
const AT_ONCE = 1000;

/** @param {number} tolerance  of the curves; the grid is much finer */
export function createDrawing(tolerance) {
  const pitch = tolerance / FINE;
  /** @type {Vertex[]} on the grid */
  const nodes = [];
  /** Whole numbers: places in steps of the grid. @type {{ u: number, v: number }[]} */
  const at = [];
  /** @type {Map<string, number>} */
  const known = new Map();
  /** @type {Set<Edge>} */
  const edges = new Set();
  /** @type {Map<string, Edge>} */
  const drawn = new Map();
  /** @type {Squares<Edge>} */
  const squares = new Squares(SQUARE);
  /** What has not been held against the others. @type {Edge[]} */
  let fresh = [];

  /** @param {number} i @param {number} j @param {Float64Array} x */
  const node = (i, j, x) => {
    const key = `${i},${j}`;
    const there = known.get(key);
    if (there !== undefined) return there;
    known.set(key, nodes.length);
    nodes.push({ x, u: i * pitch, v: j * pitch });
    at.push({ u: i, v: j });
    return nodes.length - 1;
  };
  const keyOf = (/** @type {number} */ a, /** @type {number} */ b) => (a < b ? `${a},${b}` : `${b},${a}`);

  /** @param {number} a @param {number} b @param {Traced} curve @param {number} gap */
  const add = (a, b, curve, gap) => {
    if (a === b || drawn.has(keyOf(a, b))) return;
    const edge = { a, b, curve, gap };
    drawn.set(keyOf(a, b), edge);
    edges.add(edge);
    fresh.push(edge);
    squares.add(edge, at[a], at[b]);
  };
  const remove = (/** @type {Edge} */ edge) => {
    edges.delete(edge);
    drawn.delete(keyOf(edge.a, edge.b));
  };

  /** Twice the area of a triangle, positive if it turns left: exact. @param {number} a @param {number} b @param {number} c */
  const side = (a, b, c) => (at[b].u - at[a].u) * (at[c].v - at[a].v) - (at[b].v - at[a].v) * (at[c].u - at[a].u);
  /** Of a node on the line through an edge. @param {number} c @param {Edge} edge */
  const isWithin = (c, { a, b }) =>
    (at[c].u - at[a].u) * (at[c].u - at[b].u) + (at[c].v - at[a].v) * (at[c].v - at[b].v) < 0;

  /** Where two edges have to be cut. @param {Edge} e @param {Edge} o @param {(edge: Edge, at: number) => void} cutAt */
  const meet = (e, o, cutAt) => {
    const [oa, ob, ea, eb] = [side(e.a, e.b, o.a), side(e.a, e.b, o.b), side(o.a, o.b, e.a), side(o.a, o.b, e.b)];
    if (oa === 0 && isWithin(o.a, e)) cutAt(e, o.a);
    if (ob === 0 && isWithin(o.b, e)) cutAt(e, o.b);
    if (ea === 0 && isWithin(e.a, o)) cutAt(o, e.a);
    if (eb === 0 && isWithin(e.b, o)) cutAt(o, e.b);
    if (!(oa * ob < 0 && ea * eb < 0)) return;
    const t = ea / (ea - eb);
    const [from, to] = [at[e.a], at[e.b]];
    const x = nodes[t < 0.5 ? e.a : e.b].x;
    const crossing = node(Math.round(from.u + t * (to.u - from.u)), Math.round(from.v + t * (to.v - from.v)), x);
    for (const edge of [e, o]) if (crossing !== edge.a && crossing !== edge.b) cutAt(edge, crossing);
  };

  function* cut() {
    for (let pass = 0; pass < PASSES && fresh.length > 0; pass++) {
      const isDone = new Set();
      /** @type {Map<Edge, Set<number>>} */
      const cuts = new Map();
      const cutAt = (/** @type {Edge} */ edge, /** @type {number} */ where) => {
        const there = cuts.get(edge);
        if (there) there.add(where);
        else cuts.set(edge, new Set([where]));
      };
      for (const e of fresh) {
        isDone.add(e); // each pair once
        if (isDone.size % AT_ONCE === 0) yield null;
        if (!edges.has(e)) continue;
        for (const o of squares.near(at[e.a], at[e.b], 0)) {
          if (o === e || !edges.has(o)) continue;
          if (!isDone.has(o)) meet(e, o, cutAt);
        }
      }
      fresh = [];
      for (const [edge, where] of cuts) cutInto(edge, where);
    }
    fresh = [];
  }

  /** @param {Edge} edge @param {Iterable<number>} where */
  const cutInto = (edge, where) => {
    const from = at[edge.a];
    const far = (/** @type {number} */ k) => Math.hypot(at[k].u - from.u, at[k].v - from.v);
    const stops = [edge.a, ...[...where].sort((a, b) => far(a) - far(b)), edge.b];
    remove(edge);
    for (let k = 1; k < stops.length; k++) add(stops[k - 1], stops[k], edge.curve, edge.gap);
  };

  const around = () => {
    /** @type {Map<number, Edge[]>} */
    const found = new Map();
    for (const edge of edges) {
      for (const end of [edge.a, edge.b]) {
        const there = found.get(end);
        if (there) there.push(edge);
        else found.set(end, [edge]);
      }
    }
    return found;
  };

  /**
   * Ends that meet nothing are joined to what is nearest.
   * @param {number} reach      in tolerances
   * @param {boolean} isToAll   to each of several curves: those are as good as the same place, and need not meet each other
   */
  function* joinEnds(reach, isToAll) {
    const margin = reach * FINE;
    const meetings = around();
    const ends = [...meetings].filter(([, there]) => there.length === 1);
    for (const [end, [own]] of ends) {
      if (!edges.has(own)) continue;
      // the way back along the curve itself is no way on
      const behind = new Set([own]);
      let [length, here, last] = [0, end, own];
      for (;;) {
        length += Math.hypot(at[last.a].u - at[last.b].u, at[last.a].v - at[last.b].v);
        here = last.a === here ? last.b : last.a;
        const on = meetings.get(here)?.filter((edge) => edge !== last) ?? [];
        for (const edge of on) if (length < 3 * margin) behind.add(edge);
        if (length >= 3 * margin || on.length !== 1) break;
        last = on[0];
      }
      /** The nearest of each curve. @type {Map<Traced, { edge: Edge, u: number, v: number, distance: number }>} */
      const nearest = new Map();
      for (const edge of squares.near(at[end], at[end], margin)) {
        if (!edges.has(edge) || behind.has(edge)) continue;
        const [a, b] = [at[edge.a], at[edge.b]];
        const [du, dv] = [b.u - a.u, b.v - a.v];
        const t = ((at[end].u - a.u) * du + (at[end].v - a.v) * dv) / (du * du + dv * dv);
        const share = Math.min(1, Math.max(0, t));
        const [u, v] = [Math.round(a.u + share * du), Math.round(a.v + share * dv)];
        const distance = Math.hypot(u - at[end].u, v - at[end].v);
        const before = nearest.get(edge.curve);
        if (distance <= margin && (!before || distance < before.distance))
          nearest.set(edge.curve, { edge, u, v, distance });
      }
      const all = [...nearest.values()].sort((p, q) => p.distance - q.distance);
      for (const { edge, u, v, distance } of isToAll ? all : all.slice(0, 1)) {
        if (!edges.has(edge)) continue; // cut meanwhile, so joined to there
        const there = node(u, v, nodes[edge.a].x);
        if (there !== edge.a && there !== edge.b) cutInto(edge, [there]);
        add(end, there, own.curve, distance * pitch);
      }
    }
    yield null;
    yield* cut();
  }

  /** What ends in the open has the same field on both sides. */
  const cutOffEnds = () => {
    const meetings = around();
    const ends = [...meetings.keys()].filter((end) => meetings.get(end)?.length === 1);
    for (let end = ends.pop(); end !== undefined; end = ends.pop()) {
      const own = meetings.get(end)?.find((edge) => edges.has(edge));
      if (!own) continue;
      remove(own);
      const other = own.a === end ? own.b : own.a;
      if (meetings.get(other)?.filter((edge) => edges.has(edge)).length === 1) ends.push(other);
    }
  };

  return {
    nodes,
    edges,
    /** @param {Vertex} vertex */
    nodeAt: ({ u, v, x }) => node(Math.round(u / pitch), Math.round(v / pitch), x),
    add,
    cut,
    joinEnds,
    cutOffEnds,
  };
}
