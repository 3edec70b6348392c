/**
 * Where a workspace is cut: in a half-plane or a plane, of which each arm has one of its own; and what of an arm takes care of that.
 *
 * @import { Chain } from '../kinematics/chain.js'
 * @import { Vector } from '../kinematics/lines.js'
 * @import { Placement } from './placement.js'
 *
 * @typedef {{ kind: 'meridian', angle: number | null } | { kind: 'plane', origin: Vector, u: Vector, v: Vector }} Cut
 *   angle: of the half-plane about the axis, rad, from the frame's x; null: all of them at once. origin, u, v: in the chain's
 *   root; u and v are unit vectors and square to each other
 *
 * @typedef {object} Settings  of the map of a section; what is not said here is said there
 * @property {'meridian' | 'plane' | 'flat'} kind
 * @property {number} left
 * @property {Vector} origin
 * @property {Vector} across
 * @property {Vector} u
 * @property {Vector} v
 * @property {Vector} gaugeU   what of a place counts as u
 * @property {Vector} gaugeV
 * @property {Vector} gaugeW   and as beside the plane
 * @property {Vector} sideways
 * @property {boolean} isAnyAngle
 */
import { cross, dot, minus, along, squareTo, norm } from '../kinematics/lines.js';
import { createRandom } from '../kinematics/random.js';
import { alwaysCrosses } from './crossing.js';
import { createPlacement, writePlacement } from './placement.js';

/** Directions that differ by less are the same one. */
const SAME = 1e-9;

const LOOKS = 6;

/** @type {Vector} */
const STILL = [0, 0, 0];

/**
 * Which moving joint turns every place about one axis that stands still: the first that turns, if what is before it slides
 * along its axis.
 * @param {Placement} placement
 */
export function turningJoint({ ranges: { slides, joints }, axes }) {
  const turns = joints.findIndex((_, k) => !slides[k]);
  if (turns < 0) return -1;
  const axis = axes.subarray(3 * turns, 3 * turns + 3);
  for (let k = 0; k < turns; k++) if (norm(cross(axes.subarray(3 * k, 3 * k + 3), axis)) > SAME) return -1;
  return turns;
}

/** Places for some postures, of which `look` is told. @param {Placement} placement @param {() => void} look */
function lookAround(placement, look) {
  const random = createRandom(2);
  const { lower, upper } = placement.ranges;
  for (let i = 0; i < LOOKS; i++) {
    writePlacement(
      placement,
      lower.map((low, k) => low + (upper[k] - low) * random()),
    );
    look();
  }
}

/**
 * The normal of the plane that a planar arm never leaves, or null.
 * @param {Placement} placement
 * @returns {Vector | null}
 */
export function flatNormal(placement) {
  const { J, ranges } = placement;
  /** @type {Vector[]} */
  const columns = [];
  lookAround(placement, () => {
    for (let k = 0; k < ranges.joints.length; k++) columns.push([J[3 * k], J[3 * k + 1], J[3 * k + 2]]);
  });
  const longest = columns.reduce((best, column) => (norm(column) > norm(best) ? column : best), [0, 0, 0]);
  const size = norm(longest);
  if (size === 0) return null;
  const normals = columns.map((column) => cross(longest, column));
  const normal = normals.reduce((best, each) => (norm(each) > norm(best) ? each : best), [0, 0, 0]);
  if (norm(normal) < SAME * size * size) return null;
  const unit = along([0, 0, 0], 1 / norm(normal), normal);
  if (!columns.every((column) => Math.abs(dot(unit, column)) <= SAME * size)) return null;
  // on the side that its axes look to, so that their turns are counterclockwise
  const axis = placement.axes.subarray(0, 3);
  return placement.ranges.slides[0] || dot(unit, axis) >= 0 ? unit : along([0, 0, 0], -1, unit);
}

/**
 * A slide of constant direction that crosses the plane most squarely, or −1.
 * @param {Placement} placement
 * @param {Vector} normal
 */
function crossingSlide(placement, normal) {
  const { axes, ranges } = placement;
  const first = axes.slice();
  const moves = ranges.slides.map((slides) => !slides);
  lookAround(placement, () => {
    for (let i = 0; i < first.length; i++) if (Math.abs(axes[i] - first[i]) > SAME) moves[Math.floor(i / 3)] = true;
  });
  let best = -1;
  let most = 1e-3;
  moves.forEach((isNone, k) => {
    const share = Math.abs(dot(normal, first.subarray(3 * k, 3 * k + 3)));
    if (!isNone && share > most) [best, most] = [k, share];
  });
  return best;
}

/**
 * Whether what the joints do fills space, not a surface only.
 * @param {Placement} placement
 */
function isSolid(placement) {
  const { J, chain, ranges } = placement;
  const columns = ranges.joints.map((_, k) => J.subarray(3 * k, 3 * k + 3));
  let most = 0;
  lookAround(placement, () => {
    for (const a of columns)
      for (const b of columns) for (const c of columns) most = Math.max(most, dot(cross(a, b), c));
  });
  return most > SAME * chain.characteristicLength ** 3;
}

/** @param {Placement} placement at zero @param {number | null} angle @returns {Settings | null} */
export function meridian(placement, angle) {
  const left = turningJoint(placement);
  if (left < 0) return null;
  const { axes, frames, ranges } = placement;
  const at = 16 * ranges.joints[left];
  const v = /** @type {Vector} */ (Array.from(axes.subarray(3 * left, 3 * left + 3)));
  const origin = /** @type {Vector} */ (Array.from(frames.subarray(at + 12, at + 15)));
  const gaugeU = /** @type {Vector} */ (Array.from(frames.subarray(at, at + 3)));
  const gaugeW = cross(v, gaugeU);
  const turned = along(along([0, 0, 0], Math.cos(angle ?? 0), gaugeU), Math.sin(angle ?? 0), gaugeW);
  // the lag of the half-plane is told from its own direction, so that zero is the joint's own zero there
  const side = cross(v, turned);
  const isAnyAngle = angle === null || ranges.isClosed[left];
  return {
    kind: /** @type {const} */ ('meridian'),
    left,
    origin,
    u: turned,
    v,
    gaugeU: turned,
    gaugeV: v,
    gaugeW: side,
    isAnyAngle,
    across: STILL,
    sideways: side,
  };
}

/** @param {Placement} placement at zero @param {{ origin: Vector, u: Vector, v: Vector }} cut @returns {Settings | null} */
export function plane(placement, { origin, u, v }) {
  const normal = cross(u, v);
  const reference = placement.place.slice();
  const flat = flatNormal(placement);
  if (flat && norm(cross(flat, normal)) <= 1e-6) {
    const offset = Math.abs(dot(normal, minus(reference, origin)));
    if (offset > 1e-6 * placement.chain.characteristicLength) return null;
    return { kind: /** @type {const} */ ('flat'), ...still(origin, u, v), gaugeW: STILL, isAnyAngle: true };
  }
  writePlacement(placement, new Float64Array(placement.ranges.joints.length));
  const left = crossingSlide(placement, normal);
  if (left < 0 && !isSolid(placement)) return null;
  if (left < 0)
    return { kind: /** @type {const} */ ('plane'), ...still(origin, u, v), gaugeW: normal, isAnyAngle: false };
  writePlacement(placement, new Float64Array(placement.ranges.joints.length));
  const along3 = /** @type {Vector} */ (Array.from(placement.axes.subarray(3 * left, 3 * left + 3)));
  const share = dot(normal, along3);
  const gaugeW = along(STILL, -1 / share, normal);
  return {
    kind: /** @type {const} */ ('plane'),
    left,
    origin,
    across: along(STILL, 1 / share, along3),
    u,
    v,
    gaugeU: along(u, -dot(u, along3) / share, normal),
    gaugeV: along(v, -dot(v, along3) / share, normal),
    gaugeW,
    sideways: along(STILL, -1, along3),
    isAnyAngle: alwaysCrosses(placement, left, gaugeW, origin),
  };
}

/** As the plane itself is gauged: no joint is left out. @param {Vector} origin @param {Vector} u @param {Vector} v */
const still = (origin, u, v) => ({
  left: -1,
  origin,
  across: STILL,
  u,
  v,
  gaugeU: u,
  gaugeV: v,
  sideways: cross(u, v),
});

/**
 * The section that an arm has by itself: of a planar arm its plane, of one that turns first the half-plane, of others the
 * plane through the middle of what they reach, square to a slide.
 * @param {Chain} chain
 * @param {boolean} withLimits
 * @returns {Cut | null}
 */
export function ownCut(chain, withLimits) {
  const placement = createPlacement(chain, withLimits);
  const middle = placement.ranges.lower.map((low, k) => (low + placement.ranges.upper[k]) / 2);
  const flat = flatNormal(placement);
  writePlacement(placement, middle);
  const turns = turningJoint(placement);
  if (flat) {
    const { start } = chain.packed;
    /** @type {Vector} */
    const x = [start[0], start[1], start[2]];
    const isAcross = Math.abs(dot(x, flat)) < SAME;
    const [u, v] = isAcross ? [x, cross(flat, x)] : squareTo(flat);
    const root = /** @type {Vector} */ ([start[12], start[13], start[14]]);
    return { kind: 'plane', origin: along(root, dot(flat, minus(placement.place, root)), flat), u, v };
  }
  if (turns >= 0) return { kind: 'meridian', angle: null };
  const slide = placement.ranges.slides.indexOf(true);
  if (slide < 0) return null;
  const normal = /** @type {Vector} */ (Array.from(placement.axes.subarray(3 * slide, 3 * slide + 3)));
  const [u, v] = squareTo(normal);
  return { kind: 'plane', origin: /** @type {Vector} */ (Array.from(placement.place)), u, v };
}
