/**
 * Which fields between critical curves are reached. Within one either every place is, or none: so one posture that lands in it
 * tells all of it, and what separates a field that is reached from one that is not closes by itself.
 *
 * Fields are asked of well inside, where there is room; slivers between curves that run closer together than they are known
 * are like what they have the longest border with.
 *
 * @import { Arrangement } from './arrangement.js'
 * @import { Arrival, GoTo } from './goneTo.js'
 * @import { Outline } from './outline.js'
 * @import { Vertex } from './traced.js'
 *
 * @typedef {object} ReachedFields
 * @property {number[][]} rings
 * @property {Int32Array} ringOf
 * @property {(1 | 0 | null)[]} isReached  of each ring; null: a sliver
 * @property {number[][]} mixed  rings along which places were come to and others not
 */
import { endsOf, isClear, ringsOf } from './arrangement.js';
import { apart } from './traced.js';

/** How far inside of a field it is asked, in tolerances: the farthest that is clear. */
const DEEP = [400, 100, 25, 8, 4, 2, 1];

/** Nearer than so deep, lines may be as far off their curve: only a strip in which no place is deeper is asked there. */
export const SAFE = 4;

/** Places to ask at, of each ring. */
const ASKED = 14;

/** So many of them between two steps of work. */
const AT_ONCE = 4;

/** A ring around less than its length by so many tolerances is a sliver. */
const SLIVER = 1;

/** @typedef {{ u: number, v: number, x: Float64Array }} Probe */

/**
 * A place in the field on the left of a half-edge, as far from it as is clear.
 * @param {Arrangement} arrangement
 * @param {number} half
 * @param {number} share  along it
 * @param {number} tolerance
 * @returns {(Probe & { depth: number }) | null}
 */
export function probeBeside(arrangement, half, share, tolerance) {
  const [a, b] = endsOf(arrangement, half);
  const from = { u: a.u + share * (b.u - a.u), v: a.v + share * (b.v - a.v) };
  const step = tolerance / apart(a, b);
  const [nu, nv] = [-(b.v - a.v) * step, (b.u - a.u) * step];
  for (const depth of DEEP) {
    // twice as far has to be clear: what is asked is not close to the next curve
    const beyond = { u: from.u + 2 * depth * nu, v: from.v + 2 * depth * nv };
    if (isClear(arrangement, from, beyond, half >> 1))
      return { u: from.u + depth * nu, v: from.v + depth * nv, x: (share < 0.5 ? a : b).x, depth };
  }
  return null;
}

/**
 * @param {Arrangement} arrangement
 * @param {readonly number[]} ring
 * @param {number} tolerance
 * @returns {Probe[]}
 */
function probesOf(arrangement, ring, tolerance) {
  const lengths = ring.map((half) => apart(...endsOf(arrangement, half)));
  const total = lengths.reduce((sum, length) => sum + length, 0);
  const found = [];
  let [along, wanted] = [0, 0.5];
  const places = 3 * ASKED;
  for (const [k, half] of ring.entries()) {
    for (; wanted / places <= (along + lengths[k]) / total && wanted < places; wanted++) {
      const probe = probeBeside(arrangement, half, ((wanted / places) * total - along) / lengths[k], tolerance);
      if (probe) found.push(probe);
    }
    along += lengths[k];
  }
  const safe = found.filter(({ depth }) => depth >= SAFE);
  return (safe.length > 0 ? safe : found).sort((p, q) => q.depth - p.depth).slice(0, ASKED);
}

/** Twice what a ring runs around. @param {Arrangement} arrangement @param {readonly number[]} ring */
function areaTwice(arrangement, ring) {
  return ring.reduce((sum, half) => {
    const [a, b] = endsOf(arrangement, half);
    return sum + a.u * b.v - b.u * a.v;
  }, 0);
}

/**
 * @param {Arrangement} arrangement
 * @param {GoTo} goTo
 * @param {number} tolerance
 * @param {(u: number, v: number, arrival: Arrival) => void} fellShort  is told of places that were not come to, in fields reached or not
 * @returns {Generator<number, ReachedFields>}  how much is done
 */
export function* reachedFields(arrangement, goTo, tolerance, fellShort) {
  const { rings, ringOf } = ringsOf(arrangement);
  /** @type {(1 | 0 | null)[]} */
  const isReached = [];
  /** @type {number[][]} */
  const mixed = [];
  for (const ring of rings) {
    const length = ring.reduce((sum, half) => sum + apart(...endsOf(arrangement, half)), 0);
    const isSliver = Math.abs(areaTwice(arrangement, ring)) < SLIVER * tolerance * length;
    const probes = isSliver ? [] : probesOf(arrangement, ring, tolerance);
    let [reached, asked] = [0, 0];
    for (const { u, v, x } of probes) {
      const arrival = goTo(u, v, x);
      if (arrival) fellShort(u, v, arrival);
      else reached++;
      if (++asked % AT_ONCE === 0) yield isReached.length / rings.length;
    }
    isReached.push(probes.length === 0 ? null : reached > 0 ? 1 : 0);
    if (reached > 0 && reached < probes.length) mixed.push(ring);
    yield isReached.length / rings.length;
  }
  return { rings, ringOf, isReached, mixed };
}

/**
 * The border between what is reached and what is not, as closed outlines.
 * @param {Arrangement} arrangement
 * @param {ReachedFields} fields
 * @returns {Outline[]}
 */
export function outlinesBetween(arrangement, { rings, ringOf, isReached }) {
  const { edges, next } = arrangement;
  const status = isReached.slice();
  for (let left = rings.length; left > 0; left--) {
    let isChanged = false;
    rings.forEach((ring, k) => {
      if (status[k] !== null) return;
      const lengths = [0, 0];
      for (const half of ring) {
        const other = status[ringOf[half ^ 1]];
        if (other !== null) lengths[other] += apart(...endsOf(arrangement, half));
      }
      if (lengths[0] + lengths[1] === 0) return;
      status[k] = lengths[1] > lengths[0] ? 1 : 0;
      isChanged = true;
    });
    if (!isChanged) break;
  }
  const isBorder = (/** @type {number} */ half) => status[ringOf[half]] === 1 && status[ringOf[half ^ 1]] !== 1;
  const isTaken = new Uint8Array(next.length);
  /** @type {Outline[]} */
  const outlines = [];
  for (let first = 0; first < next.length; first++) {
    if (isTaken[first] || !isBorder(first)) continue;
    /** @type {Outline} */
    const outline = { vertices: [], curves: [], area: 0, gap: 0 };
    for (let half = first; !isTaken[half];) {
      isTaken[half] = 1;
      const [a, b] = endsOf(arrangement, half);
      outline.vertices.push(a);
      outline.curves.push(edges[half >> 1].curve);
      outline.gap = Math.max(outline.gap, edges[half >> 1].gap);
      outline.area += (a.u * b.v - b.u * a.v) / 2;
      half = next[half];
      while (!isBorder(half)) half = next[half ^ 1];
    }
    outlines.push(outline);
  }
  return outlines;
}

/**
 * The ring that is nearest to the left of a place: of the field that it lies in.
 * @param {Arrangement} arrangement
 * @param {Int32Array} ringOf
 * @param {{ u: number, v: number }} place
 */
export function ringAround({ nodes, edges }, ringOf, { u, v }) {
  let [nearest, ring] = [-Infinity, -1];
  edges.forEach(({ a, b }, k) => {
    const [from, to] = [nodes[a], nodes[b]];
    if (from.v > v === to.v > v) return;
    const at = from.u + ((v - from.v) / (to.v - from.v)) * (to.u - from.u);
    if (at > u || at <= nearest) return;
    // the field is on its right, which is the left of what runs down
    [nearest, ring] = [at, ringOf[2 * k + Number(to.v > from.v)]];
  });
  return ring;
}
