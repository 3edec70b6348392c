/**
 * The parts of the handle on the tool, by shape alone: arrows along the axes, quarter arcs about them, small planes across
 * them, and the point itself. Lengths are shares of an arrow's. What a pointer means is decided here, in pixels.
 *
 * @import { Sight } from '../sight.js'
 * @import { Vector } from './dragRays.js'
 *
 * @typedef {{ kind: 'move' | 'turn' | 'plane' | 'free', axis: number }} HandlePart  of `free`, the point, the axis is 0
 *
 * @typedef {object} Placed  the handle, where it is
 * @property {Vector} centre
 * @property {readonly Vector[]} axes  unit vectors
 * @property {number} length  of an arrow, m
 */
import { dot, minus, plus } from './dragRays.js';

export const SHAFT = { from: 0.13, to: 0.82 };
export const HEAD = { length: 0.2, radius: 0.062 };
export const ARC = { radius: 0.7, margin: 0.18 }; // radians from the axes at its ends
export const PLANE = { from: 0.16, to: 0.32 };

/** An arrow that points at the eye, or a plane that is seen from its edge, cannot be dragged: cosine, sine. */
const END_ON = 0.98;
const EDGE_ON = 0.17;

const ARC_PIECES = 24;

/** @type {readonly HandlePart[]} */
export const PARTS = [
  { kind: 'free', axis: 0 },
  ...[0, 1, 2].flatMap((axis) => [
    { kind: /** @type {const} */ ('move'), axis },
    { kind: /** @type {const} */ ('plane'), axis },
    { kind: /** @type {const} */ ('turn'), axis },
  ]),
];

/** @param {HandlePart | null} a @param {HandlePart | null} b */
export const isSame = (a, b) => a?.kind === b?.kind && a?.axis === b?.axis;

/** In the plane across axis k. @param {number} k @param {number} u @param {number} w @returns {number[]} */
export function acrossAxis(k, u, w) {
  const point = [0, 0, 0];
  point[(k + 1) % 3] = u;
  point[(k + 2) % 3] = w;
  return point;
}

/** @param {number} k @param {number} length @returns {number[]} */
export const alongUnit = (k, length) => [0, 1, 2].map((i) => (i === k ? length : 0));

/** The line or outline of a part, in the frame of the handle. @param {HandlePart} part @returns {number[][]} */
export function outlineOf({ kind, axis }) {
  if (kind === 'free') return [[0, 0, 0]];
  if (kind === 'move') return [alongUnit(axis, SHAFT.from), alongUnit(axis, 1)];
  if (kind === 'plane') {
    const { from, to } = PLANE;
    return [[from, from], [to, from], [to, to], [from, to], [from, from]].map(([u, w]) => acrossAxis(axis, u, w)); // prettier-ignore
  }
  const sweep = Math.PI / 2 - 2 * ARC.margin;
  return Array.from({ length: ARC_PIECES + 1 }, (_, i) => {
    const angle = ARC.margin + (sweep * i) / ARC_PIECES;
    return acrossAxis(axis, ARC.radius * Math.cos(angle), ARC.radius * Math.sin(angle));
  });
}

/** @param {Placed} placed @param {Vector} local */
export const atHandle = ({ centre, axes, length }, local) =>
  axes.reduce((/** @type {Vector} */ sum, axis, i) => plus(sum, local[i] * length, axis), centre);

/**
 * Whether a part can be dragged as it is seen; what cannot is not drawn.
 * @param {HandlePart} part
 * @param {Vector} towards  a unit vector to the eye
 * @param {readonly Vector[]} axes
 */
export function isUsable({ kind, axis }, towards, axes) {
  const facing = Math.abs(dot(towards, axes[axis]));
  if (kind === 'move') return facing < END_ON;
  return kind !== 'plane' || facing > EDGE_ON;
}

/** How near a pointer has to come: pixels. */
const NEAR = { fine: { point: 9, part: 8 }, coarse: { point: 20, part: 24 } };

/**
 * What the pointer means: the point before all else, then what is nearest.
 * @param {Placed} placed
 * @param {Sight} sight
 * @param {number} x
 * @param {number} y
 * @param {boolean} isCoarse  a finger
 * @returns {{ part: HandlePart, point: Vector } | null}  `point`: the place on the part that is nearest to the pointer
 */
export function partAt(placed, sight, x, y, isCoarse) {
  const near = isCoarse ? NEAR.coarse : NEAR.fine;
  const towards = sight.towards(placed.centre);
  let least = near.part;
  /** @type {{ part: HandlePart, point: Vector } | null} */
  let found = null;
  for (const part of PARTS) {
    if (!isUsable(part, towards, placed.axes)) continue;
    const outline = outlineOf(part).map((local) => atHandle(placed, local));
    const pixels = outline.map((point) => sight.project(point));
    if (part.kind === 'free') {
      if (Math.hypot(x - pixels[0][0], y - pixels[0][1]) <= near.point) return { part, point: outline[0] };
      continue;
    }
    const { distance, at, share } = nearestOn(pixels, x, y);
    const away = part.kind === 'plane' && isInside(pixels, x, y) ? 0 : distance;
    if (away >= least) continue;
    least = away;
    found = { part, point: plus(outline[at], share, minus(outline[at + 1], outline[at])) };
  }
  return found;
}

/**
 * Of a line through pixels, where it comes nearest.
 * @param {readonly (readonly [number, number])[]} line
 * @param {number} x
 * @param {number} y
 */
export function nearestOn(line, x, y) {
  let best = { distance: Infinity, at: 0, share: 0 };
  for (let i = 0; i + 1 < line.length; i++) {
    const [[ax, ay], [bx, by]] = [line[i], line[i + 1]];
    const [dx, dy] = [bx - ax, by - ay];
    const square = dx * dx + dy * dy;
    const share = square === 0 ? 0 : Math.max(0, Math.min(1, ((x - ax) * dx + (y - ay) * dy) / square));
    const distance = Math.hypot(x - ax - share * dx, y - ay - share * dy);
    if (distance < best.distance) best = { distance, at: i, share };
  }
  return best;
}

/** @param {readonly (readonly [number, number])[]} outline  closed @param {number} x @param {number} y */
function isInside(outline, x, y) {
  let isIn = false;
  for (let i = 0; i + 1 < outline.length; i++) {
    const [[ax, ay], [bx, by]] = [outline[i], outline[i + 1]];
    if (ay > y !== by > y && x < ax + ((y - ay) / (by - ay)) * (bx - ax)) isIn = !isIn;
  }
  return isIn;
}
