/**
 * Whether the TCP can be brought to a place of a section, for arms with joints to spare: by descents from postures that are
 * near it, of which some tens of thousands are kept by where they put the TCP (`seenPostures.js`). That it can is proven by the posture that is
 * found; that it cannot is what these descents say, no more.
 *
 * @import { Descent } from './descent.js'
 * @import { SectionMap } from './sectionMap.js'
 * @import { Seen } from './seenPostures.js'
 *
 * @typedef {object} Arrival  as near as it came
 * @property {number} off     m
 * @property {Float64Array} x of the map
 * @property {number} u
 * @property {number} v
 * @property {number} beside  the way that is missing beside the plane, m
 * @property {number | null} held  where the joint stands that the plane takes care of, if that is at a limit
 *
 * @typedef {(u: number, v: number, x: Float64Array) => Arrival | null} GoTo  null: there; x: of the map, of a posture that is near
 */
import { createRandom } from '../kinematics/random.js';
import { seenIn } from './seenPostures.js';

/** Squares along one side of what postures are kept in. */
const SQUARES = 96;

/** Descents: from the nearest that are kept, from near a given posture, and from anywhere. */
const NEAREST = 6;
const NUDGED = 6;
const ANYWHERE = 6;
const NUDGE = 0.03;

/**
 * @param {SectionMap} map
 * @param {Descent} descent
 * @param {readonly Seen[]} seen
 * @param {number} within  m
 * @returns {GoTo}
 */
export function createGoing(map, descent, seen, within) {
  const random = createRandom(1);
  const { ranges } = map.placement;
  const start = new Float64Array(ranges.joints.length);
  const low = [Infinity, Infinity];
  const high = [-Infinity, -Infinity];
  for (const { u, v } of seen) {
    [low[0], low[1]] = [Math.min(low[0], u), Math.min(low[1], v)];
    [high[0], high[1]] = [Math.max(high[0], u), Math.max(high[1], v)];
  }
  const squareAt = (/** @type {number} */ value, /** @type {0 | 1} */ axis) =>
    Math.max(0, Math.min(SQUARES - 1, Math.floor(((value - low[axis]) / (high[axis] - low[axis] || 1)) * SQUARES)));
  /** @type {Seen[][]} */
  const kept = Array.from({ length: SQUARES * SQUARES }, () => []);
  for (const one of seen) kept[SQUARES * squareAt(one.u, 0) + squareAt(one.v, 1)].push(one);

  /** @param {number} u @param {number} v */
  const nearest = (u, v) => {
    const [i, j] = [squareAt(u, 0), squareAt(v, 1)];
    const found = [];
    for (let reach = 1; reach < SQUARES && found.length < NEAREST; reach *= 2) {
      found.length = 0;
      for (let a = Math.max(0, i - reach); a <= Math.min(SQUARES - 1, i + reach); a++)
        for (let b = Math.max(0, j - reach); b <= Math.min(SQUARES - 1, j + reach); b++)
          for (const one of kept[SQUARES * a + b])
            found.push({ x: one.x, far: Math.hypot(one.u - u, one.v - v, one.off) });
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

  return (u, v, x) => {
    if (map.kind === 'meridian' && u < 0) return { off: -u, x, u: 0, v, beside: 0, held: null }; // a half-plane ends at its axis
    const place = map.lift([u, v]);
    /** @type {Arrival | null} */
    let best = null;
    const arrives = () => {
      const off = descent.bring(place, start);
      if (off > within && (!best || off < best.off)) {
        const at = seenIn(map, descent.placement.place);
        const held = map.ends.find((end) => map.left < 0 || end.at === start[map.left]);
        best = {
          ...at,
          beside: -at.beside,
          off,
          x: Float64Array.from(map.free, (k) => start[k]),
          held: held?.at ?? null,
        };
      }
      return off <= within;
    };
    for (const { x: near } of nearest(u, v)) {
      map.free.forEach((k, i) => (start[k] = near[i]));
      map.write(near);
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
