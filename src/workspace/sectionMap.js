/**
 * What a section shows, as a map from joint values to a plane. One joint is left out where the plane takes care of it:
 *
 * - `meridian`: the half-plane through the first axis that turns. That joint brings every place into it, so what counts is
 *   how far out (u) and how high (v) the other joints bring the TCP. For any angle of the half-plane, or for a given one,
 *   where the joint has to be able to bring it.
 * - `plane`: a plane that a slide of constant direction crosses: the slide brings every place into it, along itself.
 * - `flat`: the plane that a planar arm never leaves. No joint is left out.
 *
 * @import { Chain } from '../kinematics/chain.js'
 * @import { Vector } from '../kinematics/lines.js'
 * @import { Placement, Ranges } from './placement.js'
 *
 * @typedef {{ kind: 'meridian', angle: number | null } | { kind: 'plane', origin: Vector, u: Vector, v: Vector }} Cut
 *   angle: of the half-plane about the axis, rad, from the frame's x; null: all of them at once. origin, u, v: in the chain's
 *   root; u and v are unit vectors and square to each other
 *
 * @typedef {object} SectionMap
 * @property {'meridian' | 'plane' | 'flat'} kind
 * @property {Placement} placement   its `q` is of all moving joints
 * @property {number[]} free         which of `ranges.joints` are arguments, by their place there
 * @property {number} left           the one that is left out, or −1
 * @property {boolean} isAnyAngle    the joint left out may have any value
 * @property {Vector} origin   of u and v
 * @property {Vector} across   along the slide that is left out, as far as the plane is away; zero of others
 * @property {Vector} u        unit vectors
 * @property {Vector} v
 * @property {Float64Array} lower    of the arguments
 * @property {Float64Array} upper
 * @property {boolean[]} isClosed
 * @property {Float64Array} f        2: u and v, filled by `write`
 * @property {Float64Array} Jf       2 · k: what the arguments do to them; u's row of a meridian times u
 * @property {Float64Array} Jn       k: what they do to the value that the joint left out has to have, if that slides
 * @property {(x: ArrayLike<number>) => void} write
 * @property {(bound: number, out: Float64Array) => void} writeBeside  after `write`: how far beside the plane the place is
 *   while the joint left out stands at `bound`, and how far on the right side of its axis (for a slide 1)
 * @property {() => number} needed   after `write`: the value of the joint left out that brings the place into the plane
 * @property {() => boolean} isBrought  after `write`: whether that joint can be there
 * @property {(f: ArrayLike<number>) => Vector} lift  a point of the section in the chain's root
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
 * @param {Chain} chain
 * @param {Cut} cut
 * @param {boolean} withLimits
 * @returns {SectionMap | null} null if no joint of the arm brings its places into that plane
 */
export function createSectionMap(chain, cut, withLimits) {
  const placement = createPlacement(chain, withLimits);
  const { ranges, place, J } = placement;
  const m = ranges.joints.length;
  writePlacement(placement, new Float64Array(m));
  const settings = cut.kind === 'meridian' ? meridian(placement, cut.angle) : plane(placement, cut);
  if (!settings) return null;
  const { kind, left, origin, u, v, gaugeU, gaugeV, gaugeW, isAnyAngle, across = STILL } = settings;
  const free = ranges.joints.map((_, k) => k).filter((k) => k !== left);
  const all = new Float64Array(m);
  const f = new Float64Array(2);
  const Jf = new Float64Array(2 * free.length);
  const Jn = new Float64Array(free.length);
  const isTurned = kind === 'meridian';
  let [ahead, beside] = [0, 0];

  /** @param {ArrayLike<number>} x */
  function write(x) {
    for (let i = 0; i < free.length; i++) all[free[i]] = x[i];
    writePlacement(placement, all);
    const px = place[0] - origin[0];
    const py = place[1] - origin[1];
    const pz = place[2] - origin[2];
    const a = gaugeU[0] * px + gaugeU[1] * py + gaugeU[2] * pz;
    const b = gaugeV[0] * px + gaugeV[1] * py + gaugeV[2] * pz;
    const c = gaugeW[0] * px + gaugeW[1] * py + gaugeW[2] * pz;
    f[0] = isTurned ? Math.sqrt(a * a + c * c) : a;
    f[1] = b;
    ahead = a;
    beside = c;
    for (let i = 0; i < free.length; i++) {
      const at = 3 * free[i];
      const ja = gaugeU[0] * J[at] + gaugeU[1] * J[at + 1] + gaugeU[2] * J[at + 2];
      const jc = gaugeW[0] * J[at] + gaugeW[1] * J[at + 1] + gaugeW[2] * J[at + 2];
      Jn[i] = jc;
      Jf[2 * i] = isTurned ? a * ja + c * jc : ja;
      Jf[2 * i + 1] = gaugeV[0] * J[at] + gaugeV[1] * J[at + 1] + gaugeV[2] * J[at + 2];
    }
  }

  const needed = () => (isTurned ? -Math.atan2(beside, ahead) : beside);
  return {
    kind,
    placement,
    free,
    left,
    isAnyAngle,
    origin,
    across,
    u,
    v,
    lower: Float64Array.from(free, (k) => ranges.lower[k]),
    upper: Float64Array.from(free, (k) => ranges.upper[k]),
    isClosed: free.map((k) => ranges.isClosed[k]),
    f,
    Jf,
    Jn,
    write,
    writeBeside(bound, out) {
      const [cos, sin] = [Math.cos(bound), Math.sin(bound)];
      out[0] = isTurned ? ahead * sin + beside * cos : beside - bound;
      out[1] = isTurned ? ahead * cos - beside * sin : 1;
    },
    needed,
    isBrought: () => isAnyAngle || (needed() >= ranges.lower[left] - SAME && needed() <= ranges.upper[left] + SAME),
    lift: (point) => along(along(origin, point[0], u), point[1], v),
  };
}

/** @typedef {{ kind: SectionMap['kind'], left: number, origin: Vector, across?: Vector, u: Vector, v: Vector, gaugeU: Vector, gaugeV: Vector, gaugeW: Vector, isAnyAngle: boolean }} Settings */

/** @param {Placement} placement at zero @param {number | null} angle @returns {Settings | null} */
function meridian(placement, angle) {
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
  };
}

/** @param {Placement} placement at zero @param {{ origin: Vector, u: Vector, v: Vector }} cut @returns {Settings | null} */
function plane(placement, { origin, u, v }) {
  const normal = cross(u, v);
  const reference = placement.place.slice();
  const flat = flatNormal(placement);
  if (flat && norm(cross(flat, normal)) <= 1e-6) {
    const offset = Math.abs(dot(normal, minus(reference, origin)));
    if (offset > 1e-6 * placement.chain.characteristicLength) return null;
    return { kind: /** @type {const} */ ('flat'), ...still(origin, u, v), left: -1 };
  }
  writePlacement(placement, new Float64Array(placement.ranges.joints.length));
  const left = crossingSlide(placement, normal);
  if (left < 0) return null;
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
    isAnyAngle: alwaysCrosses(placement, left, gaugeW, origin),
  };
}

/** @param {Vector} origin @param {Vector} u @param {Vector} v */
const still = (origin, u, v) => ({
  origin,
  u,
  v,
  gaugeU: u,
  gaugeV: v,
  gaugeW: /** @type {Vector} */ ([0, 0, 0]),
  isAnyAngle: true,
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
