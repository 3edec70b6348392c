/**
 * Inverse kinematics: a posture for a pose, or the truth about why there is none. An answer that is called converged has
 * been checked once more by forward kinematics; whatever the status, `q` is inside the limits and the errors are those
 * of `q`. The same question always has the same answer: chance is seeded, and budgets are counts.
 *
 * Postures are found by descents on the finite-difference Jacobian, the first from the seed. An arm that has a solver for all
 * its postures (solvers.js) uses it for what descents cannot know: which solution is nearest to the seed, that there is
 * none, and how little would be missing outside the limits.
 *
 * @import { Chain } from './chain.js'
 * @import { EveryPosture } from './everyPosture.js'
 * @import { Hunt } from './descent/hunt.js'
 * @import { InverseOptions, Settings } from './descent/inverseOptions.js'
 * @import { LesserTask } from './descent/lesserTasks.js'
 * @import { TaskName } from './descent/task.js'
 * @import { Excess, LimitVerdict } from './descent/verdict.js'
 *
 * @typedef {object} InverseResult
 * @property {'converged' | 'subspace' | 'unreachable' | 'outside-limits' | 'stalled' | 'budget'} status
 *   converged: the whole pose. subspace: the task that is named. unreachable: it is proven that no posture takes the pose,
 *   limits or not. outside-limits: there are postures, all of them outside. stalled: every descent came to rest short of the
 *   goal. budget: likewise, but some descents were cut off by `maxIterations` before they came to rest.
 * @property {'distance' | 'orientation' | 'limits' | 'joints'} [reason]   what is in the way, unless converged. distance: no
 *   posture that was found brings the tool to this place. orientation: it can be there, but not so turned. limits: it could,
 *   if some joint went past its limit. joints: the arm has too few of them for more than the task that it has met.
 * @property {Float64Array} q   the best posture found: the one that meets the task, or else the nearest to the whole pose
 *   by the weighing of dampedLeastSquares.js
 * @property {number} positionError     m, of the whole pose at q
 * @property {number} orientationError  rad, likewise: the angle of the turn that is missing
 * @property {number} iterations  of all descents
 * @property {number} restarts    how often a search started anew, in all searches: for the pose, past the limits, for tasks
 * @property {LesserTask} [task]     with subspace; and with outside-limits, if it is not the whole pose that is found there
 * @property {LimitVerdict} [limit]   with outside-limits
 * @property {number} [shortBy]       with the reason distance: how near to the place the tool was found to come, m
 * @property {number} [beyondReach]   with the reason distance, where it is proven by the arm's reach that it cannot come nearer; m
 */
import { proposePostures, solveEveryPosture } from './everyPosture.js';
import { tcpPose } from './forward.js';
import { copy } from './descent/search.js';
import { createHunt, seekFrom, seekInside, seekOutside, seekPlace, settle, tryFirst } from './descent/hunt.js';
import { checkedOptions } from './descent/inverseOptions.js';
import { lesserTasks, uprightOf } from './descent/lesserTasks.js';
import { unwindTowards } from './limits.js';
import { certainTurn } from './parallelAxes.js';
import { poseDifference, requirePose } from './pose.js';
import { recognise } from './solvers/solvers.js';
import { taskTurn } from './descent/task.js';
import { writeBestTurns } from './turns.js';
import { beyondReach, leastExcess, limitsBind } from './descent/verdict.js';
import { wayFrom } from './way.js';

/** Starts when the goal is known to be impossible: only the nearest posture is looked for. */
const NEAREST_RESTARTS = 7;

/** Starts before the arm's solver is asked whether there is anything to be found: the quick ones cost less than a start. */
const RESTARTS_BEFORE = { quick: 2, slow: 12 };

/**
 * A goal missed by less than this (radians, arm lengths), or by less than so many tolerances, may be within tolerance of a
 * posture though no posture meets it exactly: there the solver's word is not taken, and descents decide.
 */
const BORDER = { least: 1e-6, tolerances: 100 };

/** Starts when limits are ignored: there are at most 16 solutions, and the one least outside is wanted. */
const OUTSIDE_RESTARTS = 50;

/** Starts for the place alone, once the pose is given up, where they do not agree: about 1 in 400 goals has a place nearer by a thousandth yet. */
const PLACE_RESTARTS = 40;

/** Starts for a task that is the arm's to meet, and rarely fails. */
const TASK_RESTARTS = 50;

/** A solution nearer to the seed by less than this (radians, arm lengths) is the same one. */
const NEARER = 1e-6;

const T_base_tcp = new Float64Array(16);
const difference = new Float64Array(6);

/**
 * What `q` is worth, by nothing but forward kinematics.
 * @param {Hunt} hunt
 * @param {Settings} settings
 * @param {Float64Array} q  turned towards the seed
 * @param {TaskName} task
 */
function judge({ chain, goal, search, restarts }, { seed, positionTolerance, orientationTolerance }, q, task) {
  unwindTowards(chain.packed, q, seed);
  poseDifference(tcpPose(chain, q, T_base_tcp), goal, difference);
  const positionError = lengthAt(difference, 0);
  const orientationError = lengthAt(difference, 3);
  const isAtPlace = positionError <= positionTolerance;
  const isPose = isAtPlace && orientationError <= orientationTolerance;
  const isMet =
    isAtPlace &&
    (task === 'pose' || taskTurn(task, uprightOf(chain), T_base_tcp, goal, difference) <= orientationTolerance);
  return { isPose, isMet, result: { q, positionError, orientationError, iterations: search.iterations, restarts } };
}

/** Of three numbers; Math.hypot takes ten times longer. @param {ArrayLike<number>} v @param {number} at */
const lengthAt = (v, at) => Math.sqrt(v[at] * v[at] + v[at + 1] * v[at + 1] + v[at + 2] * v[at + 2]);

/**
 * The first descent comes before all that can be known about a goal: it takes no longer, and nearly always it is enough.
 * @param {Chain} chain
 * @param {ArrayLike<number>} T_base_goal
 * @param {InverseOptions} [options]
 * @returns {InverseResult}
 */
export function inverseKinematics(chain, T_base_goal, options = {}) {
  const settings = checkedOptions(chain, options);
  const hunt = createHunt(chain, requirePose(T_base_goal, 'the goal'), settings);
  const isMet = tryFirst(hunt);
  if (isMet && settings.descentsOnly) {
    const q = new Float64Array(chain.dof);
    copy(hunt.search.q, q);
    const { isPose, result } = judge(hunt, settings, q, 'pose');
    if (isPose) {
      const { positionError, orientationError, iterations, restarts } = result;
      return { status: 'converged', q, positionError, orientationError, iterations, restarts };
    }
  }
  return goOn(hunt, settings, isMet);
}

/**
 * @param {Hunt} hunt
 * @param {Settings} settings
 * @param {boolean} isFirstMet  whether the search is where the first descent has met the pose
 * @returns {InverseResult}
 */
function goOn(hunt, settings, isFirstMet) {
  const { chain, search, goal: T_base_goal } = hunt;
  const { seed, restarts, positionTolerance, orientationTolerance, descentsOnly } = settings;
  const solver = descentsOnly ? null : recognise(chain).solver;

  /** The best posture inside the limits, with the reason why it is no better. @param {Partial<InverseResult>} reason @returns {InverseResult} */
  function nearest(reason) {
    settle(hunt);
    const { isPose, result } = judge(hunt, settings, hunt.best.slice(), 'pose');
    if (isPose) return { status: 'converged', ...result };
    const { shortBy } = reason; // the posture for the whole pose may happen to come nearer to the place than any other found
    const nearer = shortBy !== undefined && { shortBy: Math.min(shortBy, result.positionError) };
    return { status: hunt.wasCut ? 'budget' : 'stalled', ...result, ...reason, ...nearer };
  }

  /** Whether no posture can have the orientation, limits or not. @param {TaskName} task */
  const isHopeless = (task) => certainTurn(chain, T_base_goal, task) > orientationTolerance;

  /** What the search has just met, if that is so. @param {LesserTask} [task] @returns {InverseResult | null} */
  function found(task) {
    const { isPose, isMet, result } = judge(hunt, settings, search.q.slice(), task?.name ?? 'pose');
    if (isPose) return { status: 'converged', ...result };
    return task && isMet ? { status: 'subspace', reason: 'joints', ...result, task } : null;
  }

  /**
   * Of some postures those inside the limits, turned towards the seed, and nearer to it than `most`; the nearest first.
   * @param {Float64Array[]} postures
   * @param {number} most
   */
  function insideByWay(postures, most) {
    const nearer = [];
    for (const q of postures) {
      if (!writeBestTurns(chain, q, seed)) continue;
      const way = wayFrom(chain, seed, q);
      if (way < most) nearer.push({ q, way });
    }
    return nearer.sort((a, b) => a.way - b.way);
  }

  /** The pose that the search has just met; or if the arm's solver knows a posture nearer to the seed, there. @returns {InverseResult | null} */
  function foundNearest() {
    const first = found();
    const proposed = first && solver && proposePostures(chain, T_base_goal);
    if (!first || !proposed) return first;
    const way = wayFrom(chain, seed, first.q) - NEARER;
    for (const near of insideByWay(proposed.postures, way)) {
      const second = seekFrom(hunt, near.q) ? found() : null;
      if (second && wayFrom(chain, seed, second.q) < way) return second;
    }
    return first;
  }

  /** The limits are all that is in the way? @param {TaskName} name @param {LesserTask} [task] @returns {InverseResult | null} */
  function seekPast(name, task) {
    if (!limitsBind(chain)) return null;
    const { isInside, least } = seekOutside(hunt, name, Math.min(restarts, OUTSIDE_RESTARTS));
    if (isInside) return found(task);
    return least && onlyOutside(least, task);
  }

  /** @param {Excess} excess @param {LesserTask} [task] */
  function onlyOutside({ joint, by, bound }, task) {
    return nearest({ status: 'outside-limits', reason: 'limits', limit: { joint, by, bound }, ...(task && { task }) });
  }

  /**
   * No posture, limits or not, as far as is known: is it the place, or the orientation there?
   * @param {boolean} isProven
   * @returns {InverseResult}
   */
  function neither(isProven) {
    if (hunt.restarts < NEAREST_RESTARTS) seekInside(hunt, 'pose', Math.min(restarts, NEAREST_RESTARTS), 1);
    const shortBy = seekPlace(hunt, Math.min(restarts, PLACE_RESTARTS));
    const proof = isProven && /** @type {const} */ ({ status: 'unreachable' });
    return nearest({ ...proof, ...(shortBy > 0 ? { reason: 'distance', shortBy } : { reason: 'orientation' }) });
  }

  /** @param {number} beyond  how far the goal is beyond the arm's reach @returns {InverseResult} */
  function tooFar(beyond) {
    seekInside(hunt, 'pose', Math.min(restarts, NEAREST_RESTARTS), 1);
    const outside = chain.joints.some(({ type }) => type === 'prismatic') ? longerSlide() : null;
    if (outside) return outside;
    const shortBy = Math.max(beyond, seekPlace(hunt, Math.min(restarts, PLACE_RESTARTS)));
    return nearest({ status: 'unreachable', reason: 'distance', shortBy, beyondReach: beyond });
  }

  /** No turn takes the tool farther than the arm's reach, but a slide that goes past its limit may. @returns {InverseResult | null} */
  function longerSlide() {
    const every = solver && solveEveryPosture(chain, T_base_goal, settings);
    const excess = every && leastExcess(chain, every.postures);
    if (excess) return onlyOutside(excess);
    return every?.isComplete ? null : seekPast('pose');
  }

  /** What is known of the pose after a few descents in vain. @param {EveryPosture} every */
  function isCertain({ isComplete, families, postures }) {
    const border = Math.max(
      BORDER.least,
      BORDER.tolerances * Math.max(positionTolerance / chain.characteristicLength, orientationTolerance),
    );
    const isMissed = Math.sqrt(2 * hunt.bestCost) > border;
    const excess = leastExcess(chain, postures);
    return isComplete && families.length === 0 && isMissed && !(excess && excess.weight < border);
  }

  /** The whole pose. @returns {InverseResult | 'impossible' | 'not found'} */
  function wholePose() {
    if (isHopeless('pose')) return 'impossible';
    const before = solver
      ? Math.min(restarts, solver.isQuick ? RESTARTS_BEFORE.quick : RESTARTS_BEFORE.slow)
      : restarts;
    if (isFirstMet || seekInside(hunt, 'pose', before, 1)) return foundNearest() ?? 'not found';
    const every = solver && solveEveryPosture(chain, T_base_goal, settings);
    if (every) {
      for (const { q } of insideByWay(every.postures, Infinity)) {
        const answer = seekFrom(hunt, q) ? found() : null;
        if (answer) return answer;
      }
      if (isCertain(every)) {
        const excess = leastExcess(chain, every.postures);
        return excess ? onlyOutside(excess) : 'impossible';
      }
      if (seekInside(hunt, 'pose', restarts, before + 1)) return foundNearest() ?? 'not found';
    }
    return seekPast('pose') ?? 'not found';
  }

  const beyond = beyondReach(chain, T_base_goal, positionTolerance);
  if (beyond > 0) return tooFar(beyond);
  const whole = wholePose();
  if (typeof whole !== 'string') return whole;
  const lesser = lesserTasks(chain).filter(({ name }) => !isHopeless(name));
  for (const task of lesser) {
    const answer = seekInside(hunt, task.name, Math.min(restarts, TASK_RESTARTS)) && found(task);
    if (answer) return answer;
  }
  for (const task of lesser) {
    const answer = seekPast(task.name, task);
    if (answer) return answer;
  }
  return neither(whole === 'impossible');
}
