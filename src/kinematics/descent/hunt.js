/**
 * The searches behind inverse kinematics: many descents, the first from the seed and the others from anywhere, until one
 * does what is asked. Each leaves its answer in `hunt.search.q`.
 *
 * @import { Chain } from '../chain.js'
 * @import { Search } from './search.js'
 * @import { TaskName } from './task.js'
 * @import { Excess } from './verdict.js'
 *
 * @typedef {object} HuntOptions
 * @property {Float64Array} seed   inside the limits
 * @property {Float64Array} best   room for as many values
 * @property {number} randomSeed
 * @property {number} positionTolerance
 * @property {number} orientationTolerance
 * @property {number} maxIterations
 *
 * @typedef {object} Hunt
 * @property {Chain} chain
 * @property {Search} search
 * @property {Float64Array} seed
 * @property {ArrayLike<number>} goal
 * @property {number} randomSeed
 * @property {(() => number) | null} random   made at the first start from anywhere: most searches need none
 * @property {number} restarts   how often a search has started anew, so far
 * @property {Float64Array} best   of all postures inside the limits, the nearest to the whole pose
 * @property {number} bestCost
 * @property {boolean} wasCut  whether a descent to the whole pose ran out of iterations before it came to rest
 */
import { descend } from './dampedLeastSquares.js';
import { prepareSearch } from './search.js';
import { uprightOf } from './lesserTasks.js';
import { bringInside, fillRandomPosture } from '../limits.js';
import { createRandom } from '../random.js';
import { distanceFromShoulder, worstExcess } from './verdict.js';

/** A posture this little outside its limits (rad, or characteristic lengths) may have a neighbour inside that will do. */
const NEARLY_INSIDE = 1e-2;

/** What a task leaves free is pursued with this weight first, and then let go while the task itself is met exactly. */
const SPARE = 0.03;

/** Of two postures equally near, which symmetric arms have, the first found is kept: rounding is not to choose. */
const BETTER = 1 - 1e-6;

/** So many starts from anywhere that come to the same, as near as descents that stop at the first standstill can tell. */
const AGREEING = { starts: 8, within: 1.1 };

/** Starts near the limits of the first three joints, and how near, of the way from limit to limit. */
const CORNERS = 8;
const NEAR_LIMIT = 0.1;

/** How many times the iterations of another descent the last one may take, which goes to the very bottom. */
const SETTLING = 10;

/**
 * @param {Chain} chain
 * @param {ArrayLike<number>} T_base_goal
 * @param {HuntOptions} options
 * @returns {Hunt}
 */
export function createHunt(chain, T_base_goal, options) {
  const { seed, best, randomSeed } = options;
  const search = prepareSearch(chain, T_base_goal, options);
  copy(seed, best);
  return {
    chain,
    goal: T_base_goal,
    search,
    seed,
    randomSeed,
    random: null,
    restarts: 0,
    best,
    bestCost: Infinity,
    wasCut: false,
  };
}

/** The method of typed arrays takes longer for so few. @param {Float64Array} from @param {Float64Array} to */
function copy(from, to) {
  for (let i = 0; i < to.length; i++) to[i] = from[i];
}

/** A posture from anywhere, into search.q. @param {Hunt} hunt */
function startAnywhere(hunt) {
  const { chain, goal, search } = hunt;
  const random = (hunt.random ??= createRandom(hunt.randomSeed));
  // so far from zero an unlimited slide is looked for, m
  const travel = distanceFromShoulder(chain, goal) + 2 * chain.characteristicLength;
  fillRandomPosture(search.packed, random, travel, search.q);
}

/**
 * A posture whose first joints are near their limits, into search.q: where a place is out of reach, the valleys lie apart by which
 * limit a joint runs into.
 * @param {Hunt} hunt
 * @param {number} corner  its binary digits say which limit
 */
function startInCorner(hunt, corner) {
  startAnywhere(hunt);
  const { lower, upper } = hunt.search.packed;
  const { q } = hunt.search;
  for (let i = 0; i < Math.min(3, q.length); i++) {
    const room = upper[i] - lower[i];
    if (room < Infinity) q[i] = lower[i] + room * ((corner >> i) & 1 ? 1 - NEAR_LIMIT : NEAR_LIMIT);
  }
}

/** The first descent of all: from the seed to the whole pose, inside the limits. @param {Hunt} hunt */
export function tryFirst(hunt) {
  copy(hunt.seed, hunt.search.q);
  return tryPose(hunt);
}

/**
 * @param {Hunt} hunt
 * @param {TaskName} task
 * @param {number} from      the number of the first start: 0 is from the seed, the others from anywhere
 * @param {number} restarts  the number of the last
 * @param {() => boolean} tryFromHere  descends from search.q; true ends the search
 */
function seek(hunt, task, from, restarts, tryFromHere) {
  const { search, seed } = hunt;
  search.task = task;
  if (task !== 'pose') search.up = uprightOf(hunt.chain);
  for (let k = from; k <= restarts; k++) {
    if (k === 0) {
      search.q.set(seed);
    } else {
      hunt.restarts++;
      startAnywhere(hunt);
    }
    if (tryFromHere()) return true;
  }
  return false;
}

/** Downhill inside the limits to the whole pose, keeping the best. @param {Hunt} hunt */
function tryPose(hunt) {
  const { search } = hunt;
  const end = descend(search);
  if (end === 'cut') hunt.wasCut = true;
  if (search.cost < hunt.bestCost * BETTER) {
    hunt.bestCost = search.cost;
    copy(search.q, hunt.best);
  }
  return end === 'met';
}

/** Downhill inside the limits to a lesser task, the free part first as near as may be. @param {Hunt} hunt */
function tryTask({ search }) {
  search.spare = SPARE;
  descend(search);
  search.spare = 0;
  return descend(search) === 'met';
}

/**
 * The task, inside the limits.
 * @param {Hunt} hunt
 * @param {TaskName} task
 * @param {number} restarts
 * @param {number} [from]  more than 0 to go on after as many starts
 */
export const seekInside = (hunt, task, restarts, from = 0) =>
  seek(hunt, task, from, restarts, () => (task === 'pose' ? tryPose(hunt) : tryTask(hunt)));

/**
 * The whole pose, inside the limits, from a posture that somebody proposes.
 * @param {Hunt} hunt
 * @param {ArrayLike<number>} q  brought inside the limits first
 */
export function seekFrom(hunt, q) {
  const { search, chain } = hunt;
  search.task = 'pose';
  hunt.restarts++;
  for (let i = 0; i < chain.dof; i++) search.q[i] = bringInside(chain.packed, i, q[i]);
  return tryPose(hunt);
}

/**
 * The task, ignoring the limits: of all solutions, how far the one that goes least past them does so. A solution that
 * goes past by very little is brought inside and tried there, since that is where one at the limit is.
 * @param {Hunt} hunt
 * @param {TaskName} task
 * @param {number} restarts
 * @returns {{ isInside: boolean, least: Excess | null }}  least is null if no solution was found at all
 */
export function seekOutside(hunt, task, restarts) {
  const { search, chain } = hunt;
  /** @type {Excess[]} */
  const found = [];
  const isInside = seek(hunt, task, 0, restarts, () => {
    search.isBounded = false;
    const isMet = descend(search) === 'met';
    search.isBounded = true;
    if (!isMet) return false;
    const excess = worstExcess(chain, search.q);
    found.push(excess);
    if (excess.weight > NEARLY_INSIDE) return false;
    for (let i = 0; i < chain.dof; i++) search.q[i] = bringInside(chain.packed, i, search.q[i]);
    return task === 'pose' ? tryPose(hunt) : descend(search) === 'met';
  });
  found.sort((x, y) => x.weight - y.weight);
  return { isInside, least: found[0] ?? null };
}

/**
 * The place alone, inside the limits: how near to it the tool comes. The search stays at the posture for it. Where the first
 * descents all come to the same there is hardly another valley, and the other starts are spared.
 * @param {Hunt} hunt
 * @param {number} restarts
 * @returns {number} metres; 0 if it is there, within tolerance
 */
export function seekPlace(hunt, restarts) {
  const { search, chain } = hunt;
  const nearest = hunt.best.slice();
  let least = Infinity;
  let most = 0;
  search.task = 'position';
  for (let k = 0; k <= restarts; k++) {
    if (k === 0) search.q.set(hunt.best);
    else if (k <= CORNERS) startInCorner(hunt, k - 1);
    else startAnywhere(hunt);
    if (descend(search) === 'met') return 0;
    if (search.cost > most) most = search.cost;
    if (search.cost < least) {
      least = search.cost;
      nearest.set(search.q);
    }
    if (k === AGREEING.starts && most < least * AGREEING.within) break;
  }
  search.isSettling = true;
  search.q.set(nearest);
  const end = descend(search);
  search.isSettling = false;
  return end === 'met' ? 0 : Math.sqrt(2 * search.cost) * chain.characteristicLength;
}

/**
 * Take the best posture to the very bottom of where it lies, never uphill.
 * @param {Hunt} hunt
 */
export function settle(hunt) {
  const { search } = hunt;
  search.task = 'pose';
  search.isSettling = true;
  search.maxIterations *= SETTLING;
  search.q.set(hunt.best);
  tryPose(hunt);
  search.isSettling = false;
  search.maxIterations /= SETTLING;
}
