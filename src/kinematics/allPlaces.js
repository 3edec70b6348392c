/**
 * All postures that bring the tool's point to a place, whatever they make of its orientation: what an arm of two or three
 * joints is asked for, as the two elbows of a planar arm or the four of one with a shoulder. The place by the joints is the
 * regional problem of a larger arm (regional.js), with the tool's point in the wrist's stead.
 *
 * @import { Chain } from './chain.js'
 * @import { Line, Vector } from './lines.js'
 */
import { descend } from './descent/dampedLeastSquares.js';
import { prepareSearch } from './descent/search.js';
import { screwsOf, goalFromStart } from './screws.js';
import { isDeficient, prepareRegional, solveRegional } from './solvers/regional.js';
import { writeBestTurns } from './turns.js';
import { wayBetween, wayFrom } from './way.js';

const MOST_JOINTS = 3;

/** Candidates are near enough for a few steps. */
const POLISH = { positionTolerance: 1e-10, orientationTolerance: 1, maxIterations: 20 };

/** Two postures nearer than this (radians, arm lengths) are the same one, as an elbow that is exactly straight. */
const SAME = 1e-4;

/**
 * @param {Chain} chain
 * @param {ArrayLike<number>} T_base_goal  of which the place counts
 * @param {ArrayLike<number>} seed  full turns are chosen near it, and postures are sorted by their way from it
 * @returns {{ q: Float64Array, withinLimits: boolean }[] | null}  null where the joints have more freedom than a place takes,
 *   in general or at this one; and for arms with more joints
 */
export function allPlaces(chain, T_base_goal, seed) {
  const { dof } = chain;
  if (dof > MOST_JOINTS) return null;
  const { slides, axes, points, home, length: given } = screwsOf(chain);
  const length = given > 0 ? given : 1;
  const lines = Array.from(
    { length: dof },
    (_, i) =>
      /** @type {Line} */ ({
        slides: slides[i],
        axis: [axes[3 * i], axes[3 * i + 1], axes[3 * i + 2]],
        point: [points[3 * i] / length, points[3 * i + 1] / length, points[3 * i + 2] / length],
      }),
  );
  const placeOf = (/** @type {ArrayLike<number>} */ T) =>
    /** @type {Vector} */ ([T[12] / length, T[13] / length, T[14] / length]);
  const regional = prepareRegional(lines, placeOf(home));
  if (isDeficient(regional)) return null;
  const found = solveRegional(regional, placeOf(goalFromStart(chain, T_base_goal)));
  if (found.some(({ free, coupled }) => free.length + coupled.length > 0)) return null;

  const search = prepareSearch(chain, T_base_goal, POLISH);
  search.task = 'position';
  search.isBounded = false;
  /** @type {Float64Array[]} */
  const distinct = [];
  for (const { q } of found) {
    q.forEach((value, i) => (search.q[i] = lines[i].slides ? value * length : value));
    if (descend(search) !== 'met') continue;
    if (!distinct.some((other) => wayBetween(chain, other, search.q) < SAME)) distinct.push(search.q.slice());
  }
  return distinct
    .map((q) => ({ withinLimits: writeBestTurns(chain, q, seed), q }))
    .sort((a, b) => wayFrom(chain, seed, a.q) - wayFrom(chain, seed, b.q));
}
