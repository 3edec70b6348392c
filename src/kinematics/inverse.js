/**
 * Inverse kinematics: a posture for a pose, or the truth about why there is none. An answer that is called converged has
 * been checked once more by forward kinematics; whatever the status, `q` is inside the limits and the errors are those
 * of `q`. The same question always has the same answer: chance is seeded, and budgets are counts.
 *
 * The first descent starts at the seed, so that where it succeeds the answer is near the seed.
 *
 * @import { Chain } from './chain.js'
 * @import { TaskName } from './task.js'
 * @import { LimitVerdict } from './verdict.js'
 *
 * @typedef {object} InverseOptions
 * @property {ArrayLike<number>} [seed]  posture to start from and stay near; else the middle of the limits, 0 where unlimited
 * @property {number} [randomSeed]
 * @property {number} [restarts]         how many more starts a search may take
 * @property {number} [positionTolerance]     m
 * @property {number} [orientationTolerance]  rad
 * @property {number} [maxIterations]    of one descent
 *
 * @typedef {object} MetTask   what an arm with fewer than 6 joints can do of a goal
 * @property {Exclude<TaskName, 'pose'>} name
 * @property {readonly TaskPart[]} met
 * @property {readonly TaskPart[]} free
 * @typedef {'position' | 'tool-axis' | 'turn-about-tool-axis' | 'orientation'} TaskPart
 *
 * @typedef {object} InverseResult
 * @property {'converged' | 'subspace' | 'unreachable' | 'outside-limits' | 'stalled' | 'budget'} status
 *   converged: the whole pose. subspace: the task that is named. unreachable: proven, the goal is beyond the chain's reach.
 *   outside-limits: found, but only by ignoring them. stalled: every descent came to rest short of the goal.
 *   budget: likewise, but some descents were cut off by `maxIterations` before they came to rest.
 * @property {Float64Array} q   the best posture found: the one that meets the task, or else the nearest to the whole pose
 *   by the weighing of dampedLeastSquares.js
 * @property {number} positionError     m, of the whole pose at q
 * @property {number} orientationError  rad, likewise: the angle of the turn that is missing
 * @property {number} iterations  of all descents
 * @property {number} restarts    how often a search started anew, in all searches: for the pose, past the limits, for tasks
 * @property {MetTask} [task]     with subspace; and with outside-limits, if it is not the whole pose that is found there
 * @property {LimitVerdict} [limit]   with outside-limits
 * @property {number} [beyondReach]   with unreachable, m
 */
import { requirePosture } from './checks.js';
import { tcpPose } from './forward.js';
import { createHunt, seekInside, seekOutside, settle } from './hunt.js';
import { bringInside, middlePosture, unwindTowards } from './limits.js';
import { certainTurn } from './parallelAxes.js';
import { poseDifference, requirePose } from './pose.js';
import { taskTurn } from './task.js';
import { beyondReach, limitsBind } from './verdict.js';

/** Starts when the goal is known to be impossible: only the nearest posture is looked for. */
const NEAREST_RESTARTS = 12;

/** A goal no farther beyond reach than this share of it may be a slide's limit's fault; one that is farther, nobody's. */
const SLIDE_SHORTAGE = 0.25;

/** Starts when limits are ignored: there are at most 16 solutions, and the one least outside is wanted. */
const OUTSIDE_RESTARTS = 50;

/** From the richest to the poorest: an arm that cannot meet one is asked for the next. @type {readonly MetTask[]} */
const LESSER_TASKS = [
  { name: 'position-and-axis', met: ['position', 'tool-axis'], free: ['turn-about-tool-axis'] },
  { name: 'position', met: ['position'], free: ['orientation'] },
];

/** With this many joints or more an arm is meant to meet whole poses, and half an answer is none. */
const FULL_POSE_JOINTS = 6;

/** @param {string} name @param {number} value */
function requirePositive(name, value) {
  if (!(value > 0 && value < Infinity)) throw new RangeError(`Expected ${name} to be positive, got ${value}.`);
}

/** @param {string} name @param {number} value @param {number} [least] */
function requireWhole(name, value, least = 0) {
  if (!(Number.isSafeInteger(value) && value >= least)) {
    throw new RangeError(`Expected ${name} to be a whole number, got ${value}.`);
  }
}

/**
 * @param {Chain} chain
 * @param {InverseOptions} options
 */
function checkedOptions({ packed, dof }, options) {
  const { seed = middlePosture(packed), randomSeed = 1, restarts = 200, maxIterations = 100 } = options;
  const { positionTolerance = 1e-9, orientationTolerance = 1e-9 } = options;
  requirePosture(dof, seed);
  requirePositive('positionTolerance', positionTolerance);
  requirePositive('orientationTolerance', orientationTolerance);
  requireWhole('restarts', restarts);
  requireWhole('maxIterations', maxIterations);
  requireWhole('randomSeed', randomSeed, -Infinity);
  const inside = new Float64Array(dof);
  for (let i = 0; i < dof; i++) inside[i] = bringInside(packed, i, seed[i]);
  return { seed: inside, randomSeed, restarts, maxIterations, positionTolerance, orientationTolerance };
}

/**
 * @param {Chain} chain
 * @param {ArrayLike<number>} T_base_goal
 * @param {InverseOptions} [options]
 * @returns {InverseResult}
 */
export function inverseKinematics(chain, T_base_goal, options = {}) {
  const settings = checkedOptions(chain, options);
  const { seed, restarts, positionTolerance, orientationTolerance } = settings;
  const hunt = createHunt(chain, requirePose(T_base_goal, 'the goal'), settings);
  const { search } = hunt;

  /**
   * What `q` is worth, by nothing but forward kinematics.
   * @param {Float64Array} q
   * @param {TaskName} task
   */
  function judge(q, task) {
    unwindTowards(chain.packed, q, seed);
    const T_base_tcp = tcpPose(chain, q);
    const difference = poseDifference(T_base_tcp, T_base_goal);
    const [x, y, z, rx, ry, rz] = difference;
    const [positionError, orientationError] = [Math.hypot(x, y, z), Math.hypot(rx, ry, rz)];
    const isThere = positionError <= positionTolerance;
    const isPose = isThere && orientationError <= orientationTolerance;
    const isMet = isThere && taskTurn(task, T_base_tcp, T_base_goal, difference) <= orientationTolerance;
    const result = { q, positionError, orientationError, iterations: search.iterations, restarts: hunt.restarts };
    return { isPose, isMet, result };
  }

  /** The best posture inside the limits, with the reason why it is no better. @param {Partial<InverseResult>} reason @returns {InverseResult} */
  function nearest(reason) {
    settle(hunt);
    const { isPose, result } = judge(hunt.best, 'pose');
    return isPose
      ? { status: 'converged', ...result }
      : { status: hunt.wasCut ? 'budget' : 'stalled', ...result, ...reason };
  }

  /** Whether no posture can have the orientation, limits or not. @param {TaskName} task */
  const isHopeless = (task) => certainTurn(chain, T_base_goal, task) > orientationTolerance;

  /** What the search has just met, if that is so. @param {MetTask} [task] @returns {InverseResult | null} */
  function found(task) {
    const { isPose, isMet, result } = judge(search.q.slice(), task?.name ?? 'pose');
    if (isPose) return { status: 'converged', ...result };
    return task && isMet ? { status: 'subspace', ...result, task } : null;
  }

  /** The limits are all that is in the way? @param {TaskName} name @param {MetTask} [task] @returns {InverseResult | null} */
  function seekPast(name, task) {
    if (!limitsBind(chain)) return null;
    const { isInside, least } = seekOutside(hunt, name, Math.min(restarts, OUTSIDE_RESTARTS));
    if (isInside) return found(task);
    if (!least) return null;
    const { joint, by, bound } = least;
    return nearest({ status: 'outside-limits', limit: { joint, by, bound }, ...(task && { task }) });
  }

  const beyond = beyondReach(chain, T_base_goal, positionTolerance);
  if (beyond > 0) {
    seekInside(hunt, 'pose', Math.min(restarts, NEAREST_RESTARTS));
    // No turn brings the goal nearer, but a slide that is a little too short is a matter of its limit.
    const isLimit = beyond < SLIDE_SHORTAGE * chain.reach && chain.joints.some(({ type }) => type === 'prismatic');
    const outside = isLimit ? seekPast('pose') : null;
    if (outside) return outside;
    return nearest({ status: 'unreachable', beyondReach: beyond });
  }
  if (isHopeless('pose')) {
    seekInside(hunt, 'pose', Math.min(restarts, NEAREST_RESTARTS));
  } else {
    if (seekInside(hunt, 'pose', restarts)) return found() ?? nearest({});
    const outside = seekPast('pose');
    if (outside) return outside;
  }
  const lesser = chain.dof < FULL_POSE_JOINTS ? LESSER_TASKS.filter(({ name }) => !isHopeless(name)) : [];
  for (const task of lesser) {
    const answer = seekInside(hunt, task.name, restarts) && found(task);
    if (answer) return answer;
  }
  for (const task of lesser) {
    const answer = seekPast(task.name, task);
    if (answer) return answer;
  }
  return nearest({});
}
