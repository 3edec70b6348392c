/**
 * A tool that is pulled along: from the posture where the arm stands towards a goal that moves, as far as one frame of the
 * screen allows, and always on the same branch of solutions. Where a search for *any* posture may jump to another elbow, this
 * one walks: the way to the goal is cut into short pieces, and each is taken by a descent from the last.
 *
 * Where the way ends (a limit, the edge of the reach, an orientation that cannot be had), the arm goes as near to the goal as
 * descents find from there. At the edge of the reach the branches meet, and an arm that stands exactly on it would come back
 * with either elbow. So a follower remembers which way the arm was bent before (`bent`), and the next walk begins there.
 *
 * @import { Chain } from './chain.js'
 * @import { Search } from './descent/search.js'
 * @import { TaskName } from './descent/task.js'
 * @import { Pose } from './pose.js'
 *
 * @typedef {object} FollowOptions
 * @property {number} [mostStep]  how far a joint may go at once: radians, or characteristic lengths of a slide
 * @property {TaskName} [task]    what of the goal is to be met; else the whole pose, or what an arm with fewer joints can
 * @property {number} [positionTolerance]     m
 * @property {number} [orientationTolerance]  rad
 *
 * @typedef {object} Follower
 * @property {ArrayLike<number>} q
 * @property {ArrayLike<number> | null} [bent]  from the answer before, if there was one in this drag
 *
 * @typedef {object} Followed
 * @property {'there' | 'behind' | 'limit' | 'reach' | 'orientation' | 'singularity'} status
 *   there: the goal is met. behind: on its way, and as far as `mostStep` allows; ask again. singularity: likewise, but what
 *   takes so long is a joint that turns fast next to a singularity. The others say what the way ended at: a joint's limit;
 *   the edge of what the tool can reach; or that the tool can be there, but not so turned, on this branch.
 * @property {number} [joint]  with limit: the joint that would have to go past it
 * @property {Float64Array} q  inside the limits; no joint is farther than `mostStep` from where it was
 * @property {Float64Array | null} bent  where the next walk begins, if that is not q
 * @property {number} positionError     m, of the whole pose
 * @property {number} orientationError  rad
 * @property {TaskName} task
 */
import { requirePositive, requirePosture } from './checks.js';
import { descend } from './descent/dampedLeastSquares.js';
import { lesserTasks, uprightOf } from './descent/lesserTasks.js';
import { copy, prepareSearch } from './descent/search.js';
import { determinantAt } from './determinant.js';
import { tcpPose } from './forward.js';
import { bringInside, isSlide } from './limits.js';
import { poseFromRotationVector } from './orientations/axisAngle.js';
import { compose, poseDifference, requirePose } from './pose.js';

const MOST_STEP = 0.35;

/** Pieces of the way: so long at first (arm lengths, radians), and halved so often where joints have to go far. */
const PIECE = 0.05;
const HALVINGS = 7;

/** A joint that goes farther than this in one piece (radians, arm lengths) may have gone to another branch. */
const SAME_BRANCH = 0.1;

/** How far from the edge, in joint space, the arm counts as bent; and how much of that is remembered at most. */
const LEAST_BENT = 1e-3;
const MOST_BENT = 0.1;

/** A goal is nearly met by a posture past the limits if that leaves less than this share of the cost. */
const MUCH_BETTER = 0.25;

const MAX_ITERATIONS = 30;

/** Where a singularity is crossed is found to this many binary digits of the way. */
const BISECTIONS = 20;

const T = new Float64Array(16);
const T_piece = new Float64Array(16);
const R = new Float64Array(16);
const way = new Float64Array(6);

/**
 * @param {Chain} chain
 * @param {Follower} from
 * @param {ArrayLike<number>} T_base_goal
 * @param {FollowOptions} [options]
 * @returns {Followed}
 */
export function followPose(chain, { q: begin, bent = null }, T_base_goal, options = {}) {
  const { dof } = chain;
  const { mostStep = MOST_STEP, positionTolerance = 1e-9, orientationTolerance = 1e-9 } = options;
  const task = options.task ?? lesserTasks(chain)[0]?.name ?? 'pose';
  requirePosture(dof, begin);
  if (bent) requirePosture(dof, bent);
  requirePositive('mostStep', mostStep);
  requirePositive('positionTolerance', positionTolerance);
  requirePositive('orientationTolerance', orientationTolerance);
  requirePose(T_base_goal, 'the goal');
  const settings = { positionTolerance, orientationTolerance, maxIterations: MAX_ITERATIONS };

  /** Where the walk has come to; every posture on it but the first meets its piece of the way. */
  const here = insideOf(chain, bent ?? begin);
  const q = insideOf(chain, begin);

  /** @param {Followed['status']} status @param {Float64Array} at @param {Partial<Followed>} [more] @returns {Followed} */
  function answer(status, at, more) {
    poseDifference(tcpPose(chain, at, T), T_base_goal, way);
    const positionError = Math.hypot(way[0], way[1], way[2]);
    const orientationError = Math.hypot(way[3], way[4], way[5]);
    return { status, q: at, bent: null, positionError, orientationError, task, ...more };
  }

  const walk = walkTowards(chain, here, q, T_base_goal, { task, mostStep, settings });
  if (walk === 'there' || walk === 'behind') return answer(walk, here);
  if (walk === 'jump') {
    // The pieces are as short as they get, and a joint still has to go far: it is let go there, as fast as it may.
    const search = searchFrom(chain, here, T_base_goal, task, settings);
    descend(search);
    return answer('singularity', stepTowards(chain, q, search.q, mostStep));
  }

  const search = searchFrom(chain, here, T_base_goal, task, settings);
  search.isSettling = true;
  descend(search);
  search.isSettling = false;
  const rest = search.q.slice();
  const nearest = onBranchOf(chain, here, rest);
  const next = stepTowards(chain, q, nearest, mostStep);
  const isNearest = wayTo(chain, next, nearest) === 0;
  const more = { bent: isNearest ? bentAt(chain, nearest, here) : null };
  if (!isNearest) return answer('behind', next, more);
  const joint = limitInTheWay(chain, { here, rest, nearest }, T_base_goal, task, settings);
  if (joint !== null) return answer('limit', next, { ...more, joint });
  const place = searchFrom(chain, nearest, T_base_goal, 'position', settings);
  return answer(task !== 'position' && descend(place) === 'met' ? 'orientation' : 'reach', next, more);
}

/**
 * Piece by piece towards the goal.
 * @param {Chain} chain
 * @param {Float64Array} here   changed in place
 * @param {Float64Array} start  no joint goes farther from it than `mostStep`
 * @param {ArrayLike<number>} T_base_goal
 * @param {{ task: TaskName, mostStep: number, settings: Parameters<typeof prepareSearch>[2] }} options
 * @returns {'there' | 'behind' | 'jump' | 'end'}
 */
function walkTowards(chain, here, start, T_base_goal, { task, mostStep, settings }) {
  const T_base_start = tcpPose(chain, here);
  const toGo = poseDifference(T_base_start, T_base_goal).slice();
  const size = Math.max(
    Math.hypot(toGo[0], toGo[1], toGo[2]) / chain.characteristicLength,
    Math.hypot(toGo[3], toGo[4], toGo[5]),
  );
  const whole = size > PIECE ? PIECE / size : 1;
  let [done, piece, halvings] = [0, whole, 0];
  while (done < 1) {
    const next = done + piece < 1 - 1e-9 ? done + piece : 1;
    const goal = next === 1 ? T_base_goal : writePiece(T_base_start, toGo, next);
    const search = searchFrom(chain, here, goal, task, settings);
    const isMet = descend(search) === 'met';
    if (halvings < HALVINGS && isAcross(chain, here, search.q)) {
      halvings++; // through a singularity, or past it to another branch: the shortest pieces tell
      piece /= 2;
      continue;
    }
    if (!isMet || wayTo(chain, here, search.q) > SAME_BRANCH) {
      if (++halvings > HALVINGS) return isMet ? 'jump' : 'end';
      piece /= 2;
      continue;
    }
    if (wayTo(chain, start, search.q) > mostStep) {
      if (done > 0 || ++halvings > HALVINGS) return done > 0 ? 'behind' : 'jump';
      piece /= 2;
      continue;
    }
    copy(search.q, here);
    done = next;
    if (halvings > 0) {
      halvings--;
      piece *= 2;
    }
  }
  return 'there';
}

/** Whether two postures are on two sides of a singularity; with fewer joints than six no sign tells. @param {Chain} chain @param {Float64Array} a @param {Float64Array} b */
const isAcross = (chain, a, b) => chain.dof === 6 && determinantAt(chain, a) * determinantAt(chain, b) < 0;

/**
 * Where the tool is after a share of the way: straight, and turning about one axis at the same rate.
 * @param {Pose} T_base_start
 * @param {Float64Array} toGo
 * @param {number} share
 */
function writePiece(T_base_start, toGo, share) {
  poseFromRotationVector([0, 0, 0], [toGo[3] * share, toGo[4] * share, toGo[5] * share], R);
  compose(R, T_base_start, T_piece);
  for (let k = 0; k < 3; k++) T_piece[12 + k] = T_base_start[12 + k] + toGo[k] * share;
  return T_piece;
}

/**
 * @param {Chain} chain
 * @param {Float64Array} q
 * @param {ArrayLike<number>} goal
 * @param {TaskName} task
 * @param {Parameters<typeof prepareSearch>[2]} settings
 * @returns {Search}  good until the next one
 */
function searchFrom(chain, q, goal, task, settings) {
  const search = prepareSearch(chain, goal, settings);
  search.task = task;
  search.turnsBack = false; // the same posture a full turn away is not where the arm can be in a frame
  if (task !== 'pose') search.up = uprightOf(chain);
  copy(q, search.q);
  return search;
}

/** @param {Chain} chain @param {ArrayLike<number>} q */
const insideOf = ({ packed, dof }, q) => Float64Array.from({ length: dof }, (_, i) => bringInside(packed, i, q[i]));

/** The largest joint's way, full turns and all: radians, arm lengths. @param {Chain} chain @param {ArrayLike<number>} a @param {ArrayLike<number>} b */
function wayTo({ packed, dof, characteristicLength }, a, b) {
  let most = 0;
  for (let i = 0; i < dof; i++) {
    most = Math.max(most, Math.abs(b[i] - a[i]) / (isSlide(packed, i) ? characteristicLength : 1));
  }
  return most;
}

/** From one posture to another, or as far as no joint goes farther than `most`. @param {Chain} chain @param {Float64Array} from @param {Float64Array} to @param {number} most */
function stepTowards(chain, from, to, most) {
  const length = wayTo(chain, from, to);
  return length <= most ? to.slice() : from.map((value, i) => value + ((to[i] - value) * most) / length);
}

/**
 * As far from `here` to `there` as the branch goes: where they are on two sides of a singularity, to its edge.
 * @param {Chain} chain
 * @param {Float64Array} here
 * @param {Float64Array} there
 */
function onBranchOf(chain, here, there) {
  const at = (/** @type {number} */ share) => here.map((value, i) => value + share * (there[i] - value));
  if (!isAcross(chain, here, there)) return there.slice();
  let [on, off] = [0, 1];
  for (let k = 0; k < BISECTIONS; k++) {
    const middle = (on + off) / 2;
    if (isAcross(chain, here, at(middle))) off = middle;
    else on = middle;
  }
  return at(on);
}

/**
 * A posture beside the nearest one, to the side that the arm came from; null if it came from nowhere else.
 * @param {Chain} chain
 * @param {Float64Array} nearest
 * @param {Float64Array} here  the last on the way that met what it had to
 */
function bentAt(chain, nearest, here) {
  const length = wayTo(chain, nearest, here);
  return length < LEAST_BENT ? null : stepTowards(chain, nearest, here, MOST_BENT);
}

/**
 * The joint without whose limit the arm would come much nearer. If the descent came to rest beside no limit, it may have left
 * the one that the way ended at for the edge of the branch: then the joint without whose limit the way would have gone on.
 * @param {Chain} chain
 * @param {{ here: Float64Array, rest: Float64Array, nearest: Float64Array }} postures  nearest: rest, or the edge before it
 * @param {ArrayLike<number>} T_base_goal
 * @param {TaskName} task
 * @param {Parameters<typeof prepareSearch>[2]} settings
 */
function limitInTheWay(chain, { here, rest, nearest }, T_base_goal, task, settings) {
  const { lower, upper } = chain.packed;
  const isBeside = rest.some((value, i) => value <= lower[i] || value >= upper[i]);
  const search = searchFrom(chain, isBeside ? nearest : here, T_base_goal, task, settings);
  search.maxIterations = 0;
  descend(search);
  const { cost } = search;
  search.maxIterations = settings.maxIterations;
  search.isBounded = false;
  const isMet = descend(search) === 'met';
  search.isBounded = true;
  const isNearer = isMet || (isBeside && search.cost < MUCH_BETTER * cost);
  const joint = isNearer && (isBeside || !isAcross(chain, here, search.q)) ? farthestPast(chain, search.q) : -1;
  return joint < 0 ? null : joint;
}

/**
 * The joint farthest past its limit. Full turns count: where its limits are a turn and more apart it could be inside again
 * from the other end, but that is no way to go on.
 * @param {Chain} chain
 * @param {ArrayLike<number>} q
 * @returns {number} -1 if all are inside
 */
function farthestPast({ packed, dof, characteristicLength }, q) {
  let [farthest, most] = [-1, 0];
  for (let i = 0; i < dof; i++) {
    const past =
      Math.max(packed.lower[i] - q[i], q[i] - packed.upper[i]) / (isSlide(packed, i) ? characteristicLength : 1);
    if (past > most) [farthest, most] = [i, past];
  }
  return farthest;
}
