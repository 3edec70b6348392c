/**
 * All postures that put the TCP at a place, for arms of which at most three joints move it: in closed form, so that there
 * being none is proven too (up to rounding).
 *
 * @import { Chain } from '../kinematics/chain.js'
 * @import { Line, Vector } from '../kinematics/lines.js'
 * @import { Ranges } from './placement.js'
 *
 * @typedef {object} PlacePosture
 * @property {Float64Array} x   of the joints that move the TCP, turned by full turns into their ranges where that is possible
 * @property {boolean} isInside whether all of them are inside
 * @property {readonly number[]} loose  which of them may have any value, the TCP being on their axis; no limit counts there
 *
 * @typedef {(place: ArrayLike<number>) => PlacePosture[]} PlaceSolver
 */
import { screwsOf } from '../kinematics/screws.js';
import { isDeficient, prepareRegional, solveRegional } from '../kinematics/solvers/regional.js';
import { createPlacement, writePlacement } from './placement.js';

const FULL_TURN = 2 * Math.PI;

/** A proposal that misses the place by more (arm lengths) is none. */
const THERE = 1e-8;

/** Past a limit by no more than this (radians, metres) is at it. */
const AT_LIMIT = 1e-9;

/**
 * @param {Chain} chain
 * @param {boolean} withLimits
 * @param {number} [unbound]  a joint that has no limits, by its place in the ranges; −1: none
 * @returns {PlaceSolver | null} null if more than three joints move the TCP, or three in a surface only
 */
export function createPlaceSolver(chain, withLimits, unbound = -1) {
  const placement = createPlacement(chain, withLimits);
  const { ranges, place: here } = placement;
  if (ranges.joints.length > 3) return null;
  const { slides, axes, points, home } = screwsOf(chain);
  const { start } = chain.packed;
  const length = chain.characteristicLength;
  const lines = ranges.joints.map(
    (i) =>
      /** @type {Line} */ ({
        slides: slides[i],
        axis: [axes[3 * i], axes[3 * i + 1], axes[3 * i + 2]],
        point: [points[3 * i] / length, points[3 * i + 1] / length, points[3 * i + 2] / length],
      }),
  );
  const regional = prepareRegional(lines, [home[12] / length, home[13] / length, home[14] / length]);
  // one joint too many for a surface: infinitely many postures, of which it would find some
  if (lines.length === 3 && isDeficient(regional)) return null;

  return (place) => {
    const [dx, dy, dz] = [place[0] - start[12], place[1] - start[13], place[2] - start[14]];
    const P = /** @type {Vector} */ (
      [0, 4, 8].map((k) => (start[k] * dx + start[k + 1] * dy + start[k + 2] * dz) / length)
    );
    /** @type {PlacePosture[]} */
    const found = [];
    for (const { q, free } of solveRegional(regional, P)) {
      const x = Float64Array.from(q, (value, k) => (lines[k].slides ? value * length : value));
      const isInside = turnInside(ranges, x, free, unbound);
      writePlacement(placement, x);
      const off = Math.hypot(here[0] - place[0], here[1] - place[1], here[2] - place[2]);
      if (off <= THERE * length) found.push({ x, isInside, loose: free });
    }
    return found;
  };
}

/**
 * Whether a value is inside, once full turns that bring it there are taken; they are.
 * @param {Ranges} ranges
 * @param {Float64Array} x
 * @param {readonly number[]} [loose]  are taken inside in any case
 * @param {number} [unbound]
 */
export function turnInside({ lower, upper, slides, isClosed }, x, loose = [], unbound = -1) {
  let isInside = true;
  for (let k = 0; k < x.length; k++) {
    if (loose.includes(k)) x[k] = Math.min(upper[k], Math.max(lower[k], 0));
    else if (!slides[k]) {
      const middle = (lower[k] + upper[k]) / 2;
      x[k] -= FULL_TURN * Math.round((x[k] - middle) / FULL_TURN);
      if (isClosed[k] || k === unbound) continue;
    }
    if (x[k] < lower[k] - AT_LIMIT || x[k] > upper[k] + AT_LIMIT) isInside = false;
    else x[k] = Math.min(upper[k], Math.max(lower[k], x[k]));
  }
  return isInside;
}
