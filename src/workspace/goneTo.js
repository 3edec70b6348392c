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
 * @param {number} [from]
 */
export function seenIn({ kind, origin, across, u, v, isAnyAngle }, place, from = 0) {
  let [x, y, z] = [place[from] - origin[0], place[from + 1] - origin[1], place[from + 2] - origin[2]];
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
 * Of sampled postures those that put the TCP the farthest in some direction of the section: close to its outer boundary.
 * @param {SectionMap} map
 * @param {Sampler} sampler
 * @returns {Farthest[]}
 */
export function farthestOf(map, sampler) {
  const places = new Float32Array(3 * KEPT);
  sampler.fill(0, places);
  const best = Array.from({ length: DIRECTIONS }, (_, k) => ({
    theta: (2 * Math.PI * k) / DIRECTIONS,
    far: -Infinity,
    at: 0,
  }));
  for (let k = 0; k < KEPT; k++) {
    const [u, v] = seenIn(map, places, 3 * k);
    for (const each of best) {
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
 * @param {number} within  m
 * @returns {GoTo}
 */
export function createGoing(map, descent, sampler, within) {
  const random = createRandom(1);
  const { ranges } = map.placement;
  const start = new Float64Array(ranges.joints.length);
  const q = new Float64Array(map.placement.q.length);
  const places = new Float32Array(3 * KEPT);
  sampler.fill(0, places);
  const seen = Array.from({ length: KEPT }, (_, k) => seenIn(map, places, 3 * k));
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
      if (map.left >= 0 && map.isAnyAngle) {
        map.write(Float64Array.from(map.free, (i) => start[i]));
        start[map.left] = map.needed();
      }
      if (arrives()) return null;
    }
    for (let count = 1; count <= NUDGED + ANYWHERE; count++) {
      map.write(x);
      const spread = count <= NUDGED ? NUDGE * count : Math.PI;
      map.free.forEach((k, i) => {
        const value = x[i] + (2 * random() - 1) * spread;
        start[k] = ranges.isClosed[k] ? value : Math.min(ranges.upper[k], Math.max(ranges.lower[k], value));
      });
      if (map.left >= 0) start[map.left] = map.needed();
      if (arrives()) return null;
    }
    return best;
  };
}
