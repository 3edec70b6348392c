/**
 * All postures for a pose by searching, for arms that no solver knows: descents from everywhere until nothing new has come
 * up for a long while. It proves nothing, and says so.
 *
 * @import { Chain } from './chain.js'
 * @import { EveryPosture } from './everyPosture.js'
 * @import { Tolerances } from './poseErrors.js'
 */
import { descend } from './descent/dampedLeastSquares.js';
import { prepareSearch } from './descent/search.js';
import { isThere } from './everyPosture.js';
import { isSlide } from './limits.js';
import { createRandom } from './random.js';
import { areSame, better, isWayWithin, onlyOnce } from './sameSolution.js';
import { distanceFromShoulder } from './descent/verdict.js';
import { jointWay, wayBetween } from './way.js';

/** So many starts in a row without anything new end the search, and so many more for each posture that is known. */
const PATIENCE = 150;
const PATIENCE_EACH = 25;
const MOST_STARTS = 2000;
const ITERATIONS = 60;

/** A posture that is pushed this far (radians, arm lengths), in so many tries, and always comes back to a tenth of it is isolated. */
const KICK = 1e-2;
const TRIES = 8;

/** One that does not is in a valley at least. It is isolated still if it comes back from so far: valleys next to singularities are short. */
const FAR = 0.2;

/**
 * @param {Chain} chain
 * @param {ArrayLike<number>} T_base_goal
 * @param {Tolerances & { randomSeed: number }} options
 * @returns {EveryPosture}
 */
export function searchEveryPosture(chain, T_base_goal, options) {
  const random = createRandom(options.randomSeed);
  const search = prepareSearch(chain, T_base_goal, { ...options, maxIterations: ITERATIONS });
  search.isBounded = false;
  const travel = distanceFromShoulder(chain, T_base_goal) + 2 * chain.characteristicLength;
  /** @type {EveryPosture} */
  const found = { postures: [], families: [], isComplete: false, method: 'search' };

  /** Downhill from search.q; the posture that it comes to, if it is one. @returns {Float64Array | null} */
  function posture() {
    if (descend(search) !== 'met') return null;
    const q = search.q.map((value, i) => jointWay(chain, i, 0, value)); // many full turns would take digits
    return isThere(chain, T_base_goal, q, options) ? q : null;
  }

  /**
   * Where a posture comes to when it is pushed, unless it comes back or to another solution.
   * @param {Float64Array} q
   * @param {number} by
   * @returns {Float64Array | null}
   */
  function pushed(q, by) {
    for (let k = 0; k < TRIES; k++) {
      for (let i = 0; i < chain.dof; i++) {
        const unit = isSlide(chain.packed, i) ? chain.characteristicLength : 1;
        search.q[i] = q[i] + by * unit * (random() < 0.5 ? -1 : 1);
      }
      const other = posture();
      if (!other || wayBetween(chain, q, other) < by / 10) continue;
      if (isWayWithin(chain, T_base_goal, q, other, options)) return other;
    }
    return null;
  }

  /** The joints that have moved when the posture is pushed and does not come back. @param {Float64Array} q @returns {number[]} */
  function looseJoints(q) {
    const other = pushed(q, KICK);
    if (!other || (found.families.length === 0 && !pushed(q, FAR))) return [];
    return [...q.keys()].filter((i) => Math.abs(jointWay(chain, i, q[i], other[i])) > KICK / 100);
  }

  for (let start = 0, idle = 0; start < MOST_STARTS; start++) {
    if (++idle > PATIENCE + PATIENCE_EACH * found.postures.length) break;
    for (let i = 0; i < chain.dof; i++) {
      search.q[i] = (2 * random() - 1) * (isSlide(chain.packed, i) ? travel : Math.PI);
    }
    const q = posture();
    if (!q) continue;
    const known = found.postures.findIndex((other) => areSame(chain, T_base_goal, q, other, options, false));
    if (known >= 0) {
      found.postures[known] = better(chain, T_base_goal, found.postures[known], q);
      continue;
    }
    const joints = looseJoints(q);
    if (joints.length === 0) {
      found.postures.push(q);
      idle = 0;
    } else if (found.families.length === 0) {
      found.families.push({ kind: 'other', q, joints });
      found.postures = found.postures.filter((other) => looseJoints(other).length === 0);
    }
  }
  found.postures = onlyOnce(chain, T_base_goal, found.postures, options, false);
  return found;
}
