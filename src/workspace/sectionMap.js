/**
 * What a section shows, as a map from joint values to a plane. One joint is left out where the plane takes care of it:
 *
 * - `meridian`: the half-plane through the first axis that turns. That joint brings every place into it, so what counts is
 *   how far out (u) and how high (v) the other joints bring the TCP. For any angle of the half-plane, or for a given one,
 *   where the joint has to be able to bring it.
 * - `plane`: any plane. If a slide of constant direction crosses it, that slide brings every place into it, along itself. Else no
 *   joint is left out, and places count that lie in the plane: as if a slide square to it had no travel.
 * - `flat`: the plane that a planar arm never leaves. No joint is left out.
 *
 * @import { Chain } from '../kinematics/chain.js'
 * @import { Vector } from '../kinematics/lines.js'
 * @import { Cut } from './cut.js'
 * @import { Placement } from './placement.js'
 *
 * @typedef {object} SectionMap
 * @property {'meridian' | 'plane' | 'flat'} kind
 * @property {Placement} placement   its `q` is of all moving joints
 * @property {number[]} free         which of `ranges.joints` are arguments, by their place there
 * @property {number} left           the one that is left out, or −1
 * @property {boolean} isAnyAngle    the joint left out may have any value
 * @property {End[]} ends            where the joint left out is at a limit, if that counts
 * @property {boolean} isThin        there is nothing between its ends: of a plane that no joint is left out for
 * @property {Vector} origin   of u and v
 * @property {Vector} across   along the slide that is left out, as far as the plane is away; zero of others
 * @property {Vector} u        unit vectors
 * @property {Vector} v
 * @property {Float64Array} lower    of the arguments
 * @property {Float64Array} upper
 * @property {boolean[]} isClosed
 * @property {Float64Array} f        2: u and v, filled by `write`
 * @property {Float64Array} Jf       2 · k: what the arguments do to them; u's row of a meridian times u
 * @property {Float64Array} Jn       k: what they do to how far beside the plane the place is, filled by `writeBeside`
 * @property {Vector} sideways       which way that is counted, in the chain's root
 * @property {(x: ArrayLike<number>) => void} write
 * @property {(bound: number, out: Float64Array) => void} writeBeside  after `write`: how far beside the plane the place is
 *   while the joint left out stands at `bound`, and how far on the right side of its axis (for a slide 1)
 * @property {() => number} needed   after `write`: the value of the joint left out that brings the place into the plane
 * @property {() => boolean} isBrought  after `write`: whether that joint can be there
 * @property {(f: ArrayLike<number>) => Vector} lift  a point of the section in the chain's root
 *
 * @typedef {{ at: number, fixed: { joint: number, bound: 'lower' | 'upper' }[] }} End
 */
import { along } from '../kinematics/lines.js';
import { meridian, plane } from './cut.js';
import { createPlacement, writePlacement } from './placement.js';

/** Past a limit by no more than this (rad, m) is at it; beside the plane by no more than that (m) is in it. */
const SAME = 1e-9;
const IN_PLANE = 1e-7;

const FULL_TURN = 2 * Math.PI;

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
  const { kind, left, origin, u, v, gaugeU, gaugeV, gaugeW, isAnyAngle, across, sideways } = settings;
  const free = ranges.joints.map((_, k) => k).filter((k) => k !== left);
  const all = new Float64Array(m);
  const f = new Float64Array(2);
  const Jf = new Float64Array(2 * free.length);
  const Jn = new Float64Array(free.length);
  /** What the arguments do ahead and beside, each in turn. */
  const Jp = new Float64Array(2 * free.length);
  const isTurned = kind === 'meridian';
  const isThin = !isAnyAngle && left < 0;
  const [low, high] = left < 0 ? [0, 0] : [ranges.lower[left], ranges.upper[left]];
  const slack = isThin ? IN_PLANE : SAME;
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
      Jp[2 * i] = ja;
      Jp[2 * i + 1] = jc;
      Jf[2 * i] = isTurned ? a * ja + c * jc : ja;
      Jf[2 * i + 1] = gaugeV[0] * J[at] + gaugeV[1] * J[at + 1] + gaugeV[2] * J[at + 2];
    }
  }

  /** Of all full turns the one that is nearest to the middle of the range. */
  const needed = () => {
    if (!isTurned) return beside;
    const turn = -Math.atan2(beside, ahead);
    return turn - FULL_TURN * Math.round((turn - (low + high) / 2) / FULL_TURN);
  };
  /** @type {End[]} */
  let ends = [];
  if (isThin) ends = [{ at: 0, fixed: [] }];
  else if (!isAnyAngle) {
    const joint = ranges.joints[left];
    ends = [
      { at: low, fixed: [{ joint, bound: 'lower' }] },
      { at: high, fixed: [{ joint, bound: 'upper' }] },
    ];
  }
  return {
    kind,
    placement,
    free,
    left,
    isAnyAngle,
    ends,
    isThin,
    origin,
    across,
    sideways,
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
      for (let i = 0; i < free.length; i++) Jn[i] = isTurned ? Jp[2 * i] * sin + Jp[2 * i + 1] * cos : Jp[2 * i + 1];
    },
    needed,
    isBrought: () => isAnyAngle || (needed() >= low - slack && needed() <= high + slack),
    lift: (point) => along(along(origin, point[0], u), point[1], v),
  };
}
