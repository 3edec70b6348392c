/**
 * Sampled postures with where a section has them: to see it roughly, to start from, and to come from to a place of it.
 *
 * @import { Farthest } from './criticalPostures.js'
 * @import { Descent } from './descent.js'
 * @import { Sampler } from './sampler.js'
 * @import { SectionMap } from './sectionMap.js'
 *
 * @typedef {object} Seen
 * @property {Float64Array} x  of the map
 * @property {number} u
 * @property {number} v
 * @property {number} off      m: beside the plane, or how much farther the joint would have to go that brings it there; 0: in the section
 */
import { along, cross, dot } from '../kinematics/lines.js';

/** Postures kept. */
const KEPT = 40_000;

/** Where no joint takes care of the plane: of so many those that pass by it, so near (arm's reaches), are brought into it. */
const SLAB = { slices: 40, slice: 50_000, near: 1 / 40, kept: 10_000 };

/** Brought as near as this (m) is in the plane. */
const IN_PLANE = 1e-9;

/** Postures that are brought, between two steps of work. */
const AT_ONCE = 200;

/** In so many directions the farthest is looked for. */
const DIRECTIONS = 48;

/**
 * Where a section has a place of the TCP: u and v, and how far beside the plane, which of a half-plane at any angle is nothing.
 * @param {SectionMap} map
 * @param {ArrayLike<number>} place
 */
export function seenIn({ kind, origin, across, u, v, isAnyAngle, sideways }, place) {
  let [x, y, z] = [place[0] - origin[0], place[1] - origin[1], place[2] - origin[2]];
  if (kind === 'plane' && isAnyAngle) {
    const away = dot(cross(u, v), [x, y, z]);
    [x, y, z] = along([x, y, z], -away, across);
  }
  const [out, height] = [dot(u, [x, y, z]), dot(v, [x, y, z])];
  if (kind !== 'meridian' || !isAnyAngle) return { u: out, v: height, beside: dot(sideways, [x, y, z]) };
  return { u: Math.sqrt(Math.max(0, x * x + y * y + z * z - height * height)), v: height, beside: 0 };
}

/**
 * @param {SectionMap} map
 * @param {Sampler} sampler
 * @param {Descent} descent
 * @returns {Generator<null, Seen[]>}
 */
export function* seenPostures(map, sampler, descent) {
  if (map.isThin) return yield* broughtPostures(map, sampler, descent);
  const { joints, lower, upper } = map.placement.ranges;
  const q = new Float64Array(map.placement.q.length);
  /** @type {Seen[]} */
  const seen = [];
  for (let index = 0; index < KEPT; index++) {
    sampler.postureAt(index, q);
    const x = Float64Array.from(map.free, (k) => q[joints[k]]);
    map.write(x);
    const needed = map.needed();
    const off = map.isAnyAngle ? 0 : Math.max(0, lower[map.left] - needed, needed - upper[map.left]);
    seen.push({ x, u: map.f[0], v: map.f[1], off: map.kind === 'meridian' ? off * map.f[0] : off });
  }
  return seen;
}

/**
 * @param {SectionMap} map
 * @param {Sampler} sampler
 * @param {Descent} descent
 * @returns {Generator<null, Seen[]>}
 */
function* broughtPostures(map, sampler, descent) {
  const { ranges, chain } = map.placement;
  const { slices, slice, near, kept } = SLAB;
  const [nx, ny, nz] = map.sideways;
  const height = dot(map.sideways, map.origin);
  const places = new Float32Array(3 * slice);
  const q = new Float64Array(chain.dof);
  /** @type {Seen[]} */
  const seen = [];
  for (let done = 0; done < slices && seen.length < kept; done++) {
    yield null;
    sampler.fill(done * slice, places);
    for (let k = 0; k < slice && seen.length < kept; k++) {
      const beside = nx * places[3 * k] + ny * places[3 * k + 1] + nz * places[3 * k + 2] - height;
      if (Math.abs(beside) > near * chain.reach) continue;
      const passing = seenIn(map, places.subarray(3 * k, 3 * k + 3));
      sampler.postureAt(done * slice + k, q);
      const x = Float64Array.from(ranges.joints, (joint) => q[joint]);
      const off = descent.bring(map.lift([passing.u, passing.v]), x);
      const { u, v } = seenIn(map, descent.placement.place);
      seen.push({ x, u, v, off: off > IN_PLANE ? off : 0 });
      if (seen.length % AT_ONCE === 0) yield null;
    }
  }
  return seen;
}

/**
 * Of sampled postures those that put the TCP the farthest in some direction of the section: close to its outer boundary.
 * @param {readonly Seen[]} seen
 * @returns {Farthest[]}
 */
export function farthestOf(seen) {
  const best = Array.from({ length: DIRECTIONS }, (_, k) => {
    const theta = (2 * Math.PI * k) / DIRECTIONS;
    const x = /** @type {Float64Array | null} */ (null);
    return { theta, c: Math.cos(theta), s: Math.sin(theta), far: -Infinity, x };
  });
  for (const { x, u, v, off } of seen) {
    for (const each of off > 0 ? [] : best) {
      const far = u * each.c + v * each.s;
      if (far > each.far) [each.far, each.x] = [far, x];
    }
  }
  return best.flatMap(({ theta, x }) => (x ? [{ theta, x }] : []));
}
