/**
 * Whether the TCP can be brought to a place of a section, for arms with joints to spare: by descents from postures that are
 * near it, of which some tens of thousands are kept by where they put the TCP. That it can is proven by the posture that is
 * found; that it cannot is what these descents say, no more.
 *
 * @import { Farthest } from './criticalPostures.js'
 * @import { Descent } from './descent.js'
 * @import { Sampler } from './sampler.js'
 * @import { SectionMap } from './sectionMap.js'
 *
 * @typedef {object} Arrival  as near as it came
 * @property {number} off     m
 * @property {Float64Array} x of the map
 * @property {number} u
 * @property {number} v
 *
 * @typedef {(u: number, v: number, x: Float64Array) => Arrival | null} GoTo  null: there; x: of the map, of a posture that is near
 */
import { along, cross, dot } from '../kinematics/lines.js';
import { createRandom } from '../kinematics/random.js';

/** Postures kept, and squares along one side of what they are kept in. */
const KEPT = 40_000;
const SQUARES = 96;

/** In so many directions the farthest is looked for. */
const DIRECTIONS = 48;

/** Descents: from the nearest that are kept, from near a given posture, and from anywhere. */
const NEAREST = 6;
const NUDGED = 6;
const ANYWHERE = 6;
const NUDGE = 0.03;

/**
 * Where a section has a place of the TCP: u and v, and how far beside the plane, which of a half-plane at any angle is nothing.
 * @param {SectionMap} map
 * @param {ArrayLike<number>} place
 */
function seenIn({ kind, origin, across, u, v, isAnyAngle }, place) {
  let [x, y, z] = [place[0] - origin[0], place[1] - origin[1], place[2] - origin[2]];
  if (kind === 'plane' && isAnyAngle) {
    const away = dot(cross(u, v), [x, y, z]);
    [x, y, z] = along([x, y, z], -away, across);
  }
  const height = x * v[0] + y * v[1] + z * v[2];
  const out = x * u[0] + y * u[1] + z * u[2];
  const off = Math.sqrt(Math.max(0, x * x + y * y + z * z - height * height - out * out));
  return kind === 'meridian' && isAnyAngle ? [Math.hypot(out, off), height, 0] : [out, height, off];
}

/**
 * Where a section has sampled postures: u and v, and how much farther the slide would have to go that brings them there.
 * @param {SectionMap} map
 * @param {Sampler} sampler
 * @returns {number[][]}
 */
export function seenPostures(map, sampler) {
  const { joints, lower, upper } = map.placement.ranges;
  const q = new Float64Array(map.placement.q.length);
  const x = new Float64Array(map.free.length);
  return Array.from({ length: KEPT }, (_, index) => {
    sampler.postureAt(index, q);
    for (let k = 0; k < x.length; k++) x[k] = q[joints[map.free[k]]];
    map.write(x);
    const needed = map.needed();
    const off = map.isAnyAngle ? 0 : Math.max(0, lower[map.left] - needed, needed - upper[map.left]);
    return [map.f[0], map.f[1], off];
  });
}

/**
 * Of sampled postures those that put the TCP the farthest in some direction of the section: close to its outer boundary.
 * @param {SectionMap} map
 * @param {Sampler} sampler
 * @param {number[][]} seen
 * @returns {Farthest[]}
 */
export function farthestOf(map, sampler, seen) {
  const best = Array.from({ length: DIRECTIONS }, (_, k) => ({
    theta: (2 * Math.PI * k) / DIRECTIONS,
    far: -Infinity,
    at: 0,
  }));
  for (let k = 0; k < KEPT; k++) {
    const [u, v, off] = seen[k];
    for (const each of off > 0 ? [] : best) {
      const far = u * Math.cos(each.theta) + v * Math.sin(each.theta);
      if (far > each.far) [each.far, each.at] = [far, k];
    }
  }
  const { joints } = map.placement.ranges;
  return best.map(({ theta, at }) => {
    const q = sampler.postureAt(at);
    return { x: Float64Array.from(map.free, (i) => q[joints[i]]), theta };
  });
}

/**
 * @param {SectionMap} map
 * @param {Descent} descent
 * @param {Sampler} sampler
 * @param {number[][]} seen
 * @param {number} within  m
 * @returns {GoTo}
 */
export function createGoing(map, descent, sampler, seen, within) {
  const random = createRandom(1);
  const { ranges } = map.placement;
  const start = new Float64Array(ranges.joints.length);
  const q = new Float64Array(map.placement.q.length);
  const low = [0, 1].map((axis) => seen.reduce((least, at) => Math.min(least, at[axis]), Infinity));
  const high = [0, 1].map((axis) => seen.reduce((most, at) => Math.max(most, at[axis]), -Infinity));
  const squareAt = (/** @type {number} */ value, /** @type {0 | 1} */ axis) =>
    Math.max(0, Math.min(SQUARES - 1, Math.floor(((value - low[axis]) / (high[axis] - low[axis] || 1)) * SQUARES)));
  /** @type {number[][]} */
  const kept = Array.from({ length: SQUARES * SQUARES }, () => []);
  seen.forEach(([u, v], k) => kept[SQUARES * squareAt(u, 0) + squareAt(v, 1)].push(k));

  /** @param {number} u @param {number} v */
  const nearest = (u, v) => {
    const [i, j] = [squareAt(u, 0), squareAt(v, 1)];
    const found = [];
    for (let reach = 1; reach < SQUARES && found.length < NEAREST; reach *= 2) {
      found.length = 0;
      for (let a = Math.max(0, i - reach); a <= Math.min(SQUARES - 1, i + reach); a++)
        for (let b = Math.max(0, j - reach); b <= Math.min(SQUARES - 1, j + reach); b++)
          for (const k of kept[SQUARES * a + b])
            found.push({ k, far: Math.hypot(seen[k][0] - u, seen[k][1] - v, seen[k][2]) });
    }
    return found.sort((a, b) => a.far - b.far).slice(0, NEAREST);
  };

  /** The joint left out goes as far towards the plane as it can. */
  const bring = () => {
    const { left, isAnyAngle, placement } = map;
    if (left < 0) return;
    const needed = map.needed();
    const { lower, upper } = placement.ranges;
    start[left] = isAnyAngle ? needed : Math.min(upper[left], Math.max(lower[left], needed));
  };

  /** Where the last descent has come to, seen in the section. */
  const came = () => seenIn(map, descent.placement.place);

  return (u, v, x) => {
    if (map.kind === 'meridian' && u < 0) return { off: -u, x, u: 0, v }; // a half-plane ends at its axis
    const place = map.lift([u, v]);
    /** @type {Arrival | null} */
    let best = null;
    const arrives = () => {
      const off = descent.bring(place, start);
      if (off > within && (!best || off < best.off)) {
        const [atU, atV] = came();
        best = { off, x: Float64Array.from(map.free, (k) => start[k]), u: atU, v: atV };
      }
      return off <= within;
    };
    for (const { k } of nearest(u, v)) {
      sampler.postureAt(k, q);
      ranges.joints.forEach((joint, i) => (start[i] = q[joint]));
      map.write(Float64Array.from(map.free, (i) => start[i]));
      bring();
      if (arrives()) return null;
    }
    for (let count = 1; count <= NUDGED + ANYWHERE; count++) {
      map.write(x);
      const spread = count <= NUDGED ? NUDGE * count : Math.PI;
      map.free.forEach((k, i) => {
        const value = x[i] + (2 * random() - 1) * spread;
        start[k] = ranges.isClosed[k] ? value : Math.min(ranges.upper[k], Math.max(ranges.lower[k], value));
      });
      map.write(Float64Array.from(map.free, (i) => start[i]));
      bring();
      if (arrives()) return null;
    }
    return best;
  };
}
