/**
 * Which parts of the critical curves are the boundary of the region: those with places that can be reached on one side only.
 * What holds of one place beside a curve holds as far as the next curve, so a piece is asked of at both ends and between, and halved
 * where the answers differ: that is where another curve crosses it.
 *
 * @import { Traced, Vertex } from './traced.js'
 *
 * @typedef {(u: number, v: number) => boolean} IsReached
 *
 * @typedef {object} BoundaryPiece   the region is on its left
 * @property {Vertex} from
 * @property {Vertex} to
 * @property {Traced} curve
 */
import { apart, PIECES } from './traced.js';

/** Places are looked at this far beside a curve, in tolerances of the curve's lines. */
const BESIDE = 0.05;

/** Halvings at most. */
const DEEPEST = 24;

/** Pieces of which only the middle is asked, between two steps of work. */
const MIDDLES = 8 * PIECES;

/**
 * What is reached beside a piece: on the left only (1), on the right only (−1), on both sides or none (0).
 * @typedef {1 | -1 | 0} Side
 *
 * @callback SideAt  beside a curve at a vertex between two others
 * @param {Vertex} at
 * @param {Vertex} a
 * @param {Vertex} b
 * @returns {Side}
 */

/** @param {boolean} isLeft @param {boolean} isRight @returns {Side} */
export const sideOf = (isLeft, isRight) => (isLeft === isRight ? 0 : isLeft ? 1 : -1);

/**
 * By asking whether places close beside the curve are reached.
 * @param {IsReached} isReached
 * @param {number} tolerance
 * @returns {SideAt}
 */
export const closeBeside = (isReached, tolerance) => (at, a, b) => {
  const length = apart(a, b);
  if (length === 0) return 0;
  const step = (BESIDE * tolerance) / length;
  const [nu, nv] = [-(b.v - a.v) * step, (b.u - a.u) * step];
  return sideOf(isReached(at.u + nu, at.v + nv), isReached(at.u - nu, at.v - nv));
};

/**
 * @param {Traced} curve
 * @param {SideAt} sideAt
 * @param {number} shortest     m: a piece whose ends differ is halved until it is no longer
 * @param {boolean} isThorough  every piece is asked of from end to end; else only one whose neighbours are not like it
 * @returns {Generator<null, BoundaryPiece[]>}
 */
export function* boundaryOf(curve, sideAt, shortest, isThorough) {
  /** @type {BoundaryPiece[]} */
  const pieces = [];

  /** @param {Side} side @param {Vertex} a @param {Vertex} b */
  const add = (side, a, b) => {
    if (side === 1) pieces.push({ from: a, to: b, curve });
    else if (side === -1) pieces.push({ from: b, to: a, curve });
  };

  /** @param {Vertex} a @param {Vertex} b @param {number} depth */
  const look = (a, b, depth) => {
    const length = apart(a, b);
    if (length === 0) return;
    const middle = curve.between(a, b);
    if (!middle || length <= shortest || depth === DEEPEST) {
      add(sideAt(middle ?? a, a, b), a, b);
      return;
    }
    const first = curve.between(a, middle);
    const second = curve.between(middle, b);
    // at the ends as well: another curve may cross close to one of them
    const sides = [sideAt(a, a, b), sideAt(middle, a, b), sideAt(b, a, b)];
    if (first) sides.push(sideAt(first, a, middle));
    if (second) sides.push(sideAt(second, middle, b));
    if (sides.every((side) => side === sides[0])) {
      add(sides[0], a, b);
      return;
    }
    look(a, middle, depth + 1);
    look(middle, b, depth + 1);
  };

  const { vertices } = curve;
  if (isThorough) {
    for (let i = 1; i < vertices.length; i++) {
      look(vertices[i - 1], vertices[i], 0);
      if (i % PIECES === 0) yield null;
    }
    return pieces;
  }
  /** @type {(Side | null)[]} */
  const sides = [];
  for (let i = 1; i < vertices.length; i++) {
    const middle = curve.between(vertices[i - 1], vertices[i]);
    sides.push(middle && sideAt(middle, vertices[i - 1], vertices[i]));
    if (i % MIDDLES === 0) yield null;
  }
  for (const [i, side] of sides.entries()) {
    const isLike = side !== null && side === (sides[i - 1] ?? null) && side === (sides[i + 1] ?? null);
    if (isLike) {
      add(side, vertices[i], vertices[i + 1]);
      continue;
    }
    look(vertices[i], vertices[i + 1], 0);
    yield null;
  }
  return pieces;
}
