/**
 * The joints along a way of the tool: a chain of polynomials, so short each that the tool keeps to the way as exactly as
 * promised (pathBound.js), and whose rates and accelerations go on from one to the next. Always on the branch of solutions
 * on which it begins; where the way cannot be followed it says from where on, and why.
 *
 * @import { Chain } from '../kinematics/chain.js'
 * @import { Followed } from '../kinematics/follow.js'
 * @import { TaskName } from '../kinematics/descent/task.js'
 * @import { Span } from './hermite.js'
 * @import { PathKnot } from './pathSolver.js'
 * @import { PathMoment, PosturePath } from './posturePath.js'
 * @import { ToolPath } from './toolPath.js'
 *
 * @typedef {object} FollowedPath
 * @property {'done'} status
 * @property {PosturePath} path           by the share of the way
 * @property {number} positionDeviation   m, at most
 * @property {number} turnDeviation       rad, at most; of no account where the task leaves the orientation free
 * @property {TaskName} task              what of the way's poses is met: the whole, or what an arm with fewer joints can
 *
 * @typedef {object} PathRefusal
 * @property {'refused'} status
 * @property {Exclude<Followed['status'], 'there' | 'behind'> | 'start'} reason   start: the posture to begin with is not there
 * @property {number} [joint]   with limit: the joint that would have to go past it
 * @property {number} share     where it can be followed to, to a millionth of the way
 * @property {Float64Array} posture   there
 */
import { requirePositive, requirePosture } from '../kinematics/checks.js';
import { followPose } from '../kinematics/follow.js';
import { writeHermite } from './hermite.js';
import { createPathBound, unsolved } from './pathBound.js';
import { createKnot, createPathSolver } from './pathSolver.js';
import { TERMS } from './posturePath.js';

const HUNDREDTH_DEGREE = 1.745e-4; // rad, rounded down

const FIRST_PIECE = 0.125;
const LEAST_PIECE = 1e-6;

/** Of the piece that would just keep the promise, so much is tried next; and no piece is so much longer than the last. */
const CAUTION = 0.9;
const MOST_GROWTH = 3;

/** The postures are on the way to this: arm lengths, radians. */
const SOLVED = 1e-10;

/** An arm with too few joints for every pose may use up this of the promise, where it may rest beside a pose. */
const BESIDE = 1 / 2;

/** A posture to begin with may be off the beginning by this (arm lengths, radians), which typed values are. */
const NEAR = 1e-6;

/** A bound of a polynomial may be past a limit by this, and the limit still be kept: rounding. */
const ROUNDING = 1e-12;

/** Shares of the way at which it shows why it ends. */
const LOOK_AHEAD = [1e-3, 1e-2, 0.05];

/**
 * @param {Chain} chain
 * @param {ToolPath} way    seen from the chain's root
 * @param {ArrayLike<number>} begin   a posture that has the tool where the way begins
 * @param {object} [options]
 * @param {number} [options.positionDeviation]  m; 0.01 mm if nothing is said
 * @param {number} [options.turnDeviation]      rad; 0.01° if nothing is said
 * @param {number} [options.from]   only this part of the way: shares
 * @param {number} [options.to]
 * @param {boolean} [options.isRounded]   by decimals, which put poses beside those that an arm with too few joints has: it may rest there
 * @param {Pick<PathMoment, 'first' | 'second'>} [options.heading]   by the share: what the joints do at the beginning, where the
 *   way leaves them a choice; else as little as may be
 * @returns {FollowedPath | PathRefusal}
 */
export function followPath(chain, way, begin, options = {}) {
  const { positionDeviation = 1e-5, turnDeviation = HUNDREDTH_DEGREE, from = 0, to = 1, isRounded, heading } = options;
  requirePosture(chain.dof, begin);
  requirePositive('positionDeviation', positionDeviation);
  requirePositive('turnDeviation', turnDeviation);
  const { dof } = chain;
  const beside = isRounded ? { place: BESIDE * positionDeviation, turn: BESIDE * turnDeviation } : undefined;
  const solver = createPathSolver(chain, way, SOLVED, beside);
  const bound = createPathBound(chain);
  let [here, there] = [createKnot(dof), createKnot(dof)];
  const start = Float64Array.from(begin);
  if (heading) {
    here.first.set(heading.first);
    here.second.set(heading.second);
  }
  if (!solver.solve(from, start, here) || farthest(chain, start, here.q) > NEAR) {
    return { status: 'refused', reason: 'start', share: from, posture: start };
  }
  const knots = [from];
  /** @type {number[]} */
  const coefficients = [];
  const own = new Float64Array(TERMS * dof);
  const near = new Float64Array(dof);
  const off = { position: 0, turn: 0 };
  const worst = { position: 0, turn: 0 };
  const keepsTurn = solver.task === 'pose';
  /** blocked: a share that was not got to, though the pieces before it may be. */
  let [share, piece, blocked] = [from, FIRST_PIECE, Infinity];
  /** Of the determinant since the beginning: the branch. A singular posture itself has none, and more than one beyond it. */
  let sign = Math.sign(here.determinant);

  while (share < to) {
    const next = share + piece > to - LEAST_PIECE ? to : share + piece;
    const width = next - share;
    for (let i = 0; i < dof; i++) {
      near[i] = here.q[i] + width * (here.first[i] + (width / 2) * here.second[i]);
      there.first[i] = here.first[i] + width * here.second[i];
      there.second[i] = here.second[i];
    }
    /** Of the promise, what the piece may take up; more than 1 where it breaks it. */
    let over = Infinity;
    let [past, isSolved] = [-1, solver.solve(next, near, there)];
    if (isSolved && sign * there.determinant < 0) isSolved = false; // through a singularity
    if (isSolved) {
      writeHermite(here, there, width, own);
      bound.write(own, here.J, way, share, next, off);
      addUnsolved(here, there, width, off);
      over = Math.max(off.position / positionDeviation, keepsTurn ? off.turn / turnDeviation : 0);
      past = firstPast(chain, bound.spans);
    }
    if (over <= 1 && past < 0) {
      coefficients.push(...own);
      knots.push(next);
      worst.position = Math.max(worst.position, off.position);
      worst.turn = Math.max(worst.turn, off.turn);
      [here, there] = [there, here];
      sign ||= Math.sign(here.determinant);
      share = next;
      if (share >= blocked) blocked = Infinity;
      piece = Math.min(
        Math.max(LEAST_PIECE, blocked - share),
        width * Math.min(MOST_GROWTH, CAUTION / over ** (1 / TERMS)),
      );
    } else if (piece > LEAST_PIECE) {
      if (!isSolved || past >= 0) blocked = next;
      const shorter = over > 1 && over < Infinity ? CAUTION / over ** (1 / TERMS) : 1 / 2;
      piece = Math.max(LEAST_PIECE, Math.min(piece, width) * Math.max(1 / 16, shorter));
    } else {
      const why =
        past >= 0 ? { reason: /** @type {const} */ ('limit'), joint: past } : whyNot(chain, way, here.q, share);
      return { status: 'refused', ...why, share, posture: here.q.slice() };
    }
  }
  const path = { dof, knots: Float64Array.from(knots), coefficients: Float64Array.from(coefficients) };
  const { task } = solver;
  return { status: 'done', path, positionDeviation: worst.position, turnDeviation: worst.turn, task };
}

/**
 * The posture that is on the way itself, near one of some that are nearly so, as those between knots are: as near to the way as it can
 * be, on an arm with too few joints. The first of them, where it is found from none.
 * @param {Chain} chain
 * @param {ToolPath} way
 * @param {number} share
 * @param {readonly Float64Array[]} near
 * @returns {Float64Array}
 */
export function postureOn(chain, way, share, near) {
  const knot = createKnot(chain.dof);
  const solver = createPathSolver(chain, way, SOLVED, { place: Infinity, turn: Infinity });
  return near.some((q) => solver.solve(share, q, knot)) ? knot.q : near[0];
}

/** What the ends of a piece are off adds to its bound. @param {PathKnot} a @param {PathKnot} b @param {number} width @param {{ position: number, turn: number }} off */
function addUnsolved(a, b, width, off) {
  for (const part of /** @type {const} */ (['position', 'turn'])) {
    const [value, first, second] = [0, 1, 2].map((k) => Math.max(a.off[part][k], b.off[part][k]));
    off[part] += unsolved(value, first * width, second * width * width);
  }
}

/** The first joint that may be past a limit on the piece. @param {Chain} chain @param {readonly Span[]} spans */
const firstPast = ({ packed: { lower, upper } }, spans) =>
  spans.findIndex(({ low, high }, i) => low < lower[i] - ROUNDING || high > upper[i] + ROUNDING);

/**
 * What the way ends at. Just beyond the end the tool misses it by next to nothing, whatever the reason; farther on it shows.
 * @param {Chain} chain
 * @param {ToolPath} way
 * @param {Float64Array} q
 * @param {number} share
 * @returns {Pick<PathRefusal, 'reason' | 'joint'>}
 */
function whyNot(chain, way, q, share) {
  const positionTolerance = SOLVED * chain.characteristicLength;
  const options = { positionTolerance, orientationTolerance: SOLVED, mostStep: Math.PI };
  for (const ahead of LOOK_AHEAD) {
    const { status, joint } = followPose(chain, { q }, way.poseAt(Math.min(1, share + ahead)), options);
    if (status === 'there' || status === 'behind' || status === 'singularity') continue;
    return joint === undefined ? { reason: status } : { reason: status, joint };
  }
  return { reason: 'singularity' };
}

/** How far apart two postures are: radians, arm lengths. @param {Chain} chain @param {Float64Array} a @param {Float64Array} b */
const farthest = ({ joints, characteristicLength }, a, b) =>
  a.reduce(
    (most, value, i) =>
      Math.max(most, Math.abs(b[i] - value) / (joints[i].type === 'prismatic' ? characteristicLength : 1)),
    0,
  );
