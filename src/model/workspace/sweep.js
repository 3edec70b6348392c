/**
 * The trace that the tool point leaves while one joint moves and the others stand; and where a section shows a place.
 *
 * @import { Chain } from '../../kinematics/chain.js'
 * @import { SectionPlane } from './mapped.js'
 */
import { tcpPose } from '../../kinematics/forward.js';
import { cross, dot, minus } from '../../kinematics/lines.js';

/** A turning joint is looked at every so many radians; a slide in as many places as a full turn. */
const STEP = 0.035;
const PLACES = 180;

/** A place nearer to an axis than this, m, is on it. */
const ON_AXIS = 1e-9;

/**
 * @param {Chain} chain
 * @param {readonly number[]} q
 * @param {number} joint
 * @param {number} from  rad or m
 * @param {number} to
 * @returns {Float64Array} x, y and z each, m, seen from the world; both ends are in it
 */
export function sweptPlaces(chain, q, joint, from, to) {
  const isSlide = chain.joints[joint].type === 'prismatic';
  const steps = Math.max(1, Math.min(PLACES * 8, Math.ceil(isSlide ? PLACES : Math.abs(to - from) / STEP)));
  const places = new Float64Array(3 * (steps + 1));
  for (let k = 0; k <= steps; k++) {
    const T = tcpPose(chain, q.with(joint, k === steps ? to : from + (k / steps) * (to - from)));
    places.set([T[12], T[13], T[14]], 3 * k);
  }
  return places;
}

/** @param {Chain} chain @param {ArrayLike<number>} q */
export function toolPlace(chain, q) {
  const T = tcpPose(chain, q);
  return [T[12], T[13], T[14]];
}

/**
 * Where a section shows a place: of a half-plane at any angle how far out and how high, of a plane what stands straight above it.
 * @param {Pick<SectionPlane, 'kind' | 'isAnyAngle' | 'frame'>} plane
 * @param {ArrayLike<number>} place
 * @param {number} [at]  of the first of its numbers
 * @returns {[number, number]}
 */
export function seenInSection({ kind, isAnyAngle, frame: { origin, u, v } }, place, at = 0) {
  const r = [0, 1, 2].map((i) => place[at + i] - origin[i]);
  const [out, up] = [u, v].map((way) => r[0] * way[0] + r[1] * way[1] + r[2] * way[2]);
  if (kind !== 'meridian' || !isAnyAngle) return [out, up];
  return [Math.sqrt(Math.max(0, r[0] * r[0] + r[1] * r[1] + r[2] * r[2] - up * up)), up];
}

/**
 * How far a place is turned about the axis of a half-plane, from that, rad; on the axis not at all.
 * @param {Pick<SectionPlane, 'frame'>} plane
 * @param {ArrayLike<number>} place
 */
export function angleInSection({ frame: { origin, u, v } }, place) {
  const r = minus(place, origin);
  const [ahead, aside] = [dot(r, u), dot(r, cross(v, u))];
  return Math.hypot(ahead, aside) < ON_AXIS ? 0 : Math.atan2(aside, ahead);
}

/** The place that a section shows there. @param {Pick<SectionPlane, 'frame'>} plane @param {number} across @param {number} up */
export const placeInSection = ({ frame: { origin, u, v } }, across, up) =>
  [0, 1, 2].map((i) => origin[i] + across * u[i] + up * v[i]);
