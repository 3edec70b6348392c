/**
 * From moves to a motion: where every joint is at every moment, as plain data that can be posted from a worker. What cannot
 * be moved is refused with its reason, and the plan holds everything up to there.
 *
 * The joints of a joint move go in proportion, so that the postures passed are the same at any speed. Along the way of a move
 * its unit is the second: what the move would take at its full speed. So the rate of the way is at most 1, whatever moves.
 *
 * @import { Chain } from '../kinematics/chain.js'
 * @import { Pose } from '../kinematics/pose.js'
 * @import { PathRefusal } from './followPath.js'
 * @import { PosturePath } from './posturePath.js'
 * @import { LawName } from './restLaw.js'
 * @import { TimeLaw } from './timeLaw.js'
 * @import { ToolPath } from './toolPath.js'
 *
 * @typedef {{ kind: 'fine' } | { kind: 'share', share: number } | { kind: 'distance', distance: number }} Ending
 *   distance: m
 *
 * @typedef {object} JointMove
 * @property {'joint'} kind
 * @property {Float64Array} posture
 * @property {number} speed          share of the joints' rates, above 0 and at most 1
 * @property {number} acceleration   share of their accelerations
 * @property {LawName} [law]
 * @property {Ending} ending
 *
 * @typedef {object} ToolMoveBase
 * @property {Pose} T_base_tcp     seen from the chain's root
 * @property {number} speed        m/s
 * @property {number} turnSpeed    rad/s
 * @property {number} acceleration  m/s²; of a turn in the same proportion to its speed
 * @property {LawName} [law]
 * @property {Ending} ending
 * @property {Chain} [chain]       with another tool
 *
 * @typedef {ToolMoveBase & { kind: 'linear' }} LinearMove
 * @typedef {ToolMoveBase & { kind: 'circular', via: Pose }} CircularMove
 * @typedef {{ kind: 'wait', seconds: number }} Wait
 * @typedef {JointMove | LinearMove | CircularMove | Wait} Move
 *
 * @typedef {object} JointLimits   one a joint, above 0
 * @property {Float64Array} rates
 * @property {Float64Array} accelerations
 * @property {Float64Array} [jerks]   of joint moves by the S-curve
 *
 * @typedef {object} MotionPart
 * @property {number} move     index
 * @property {Move['kind']} kind
 * @property {number} begin    s
 * @property {number} end      s
 * @property {PosturePath} path
 * @property {TimeLaw} law     how far along the path, from `begin`
 *
 * @typedef {object} MotionRefusal
 * @property {number} move
 * @property {PathRefusal['reason'] | 'arc'} reason   arc: no circle passes the three points
 * @property {number} share     of the move's way, where it can be gone to
 * @property {Float64Array} posture   there
 * @property {number} [joint]   with limit: the joint that would have to go past it
 *
 * @typedef {object} MotionPlan
 * @property {number} duration   s
 * @property {Float64Array} start   the posture to begin with
 * @property {MotionPart[]} parts
 * @property {MotionRefusal | null} refused
 */
import { requirePositive, requirePosture } from '../kinematics/checks.js';
import { tcpPose } from '../kinematics/forward.js';
import { followPath } from './followPath.js';
import { pathMomentAt, straightPath } from './posturePath.js';
import { restLaw } from './restLaw.js';
import { timeLaw } from './timeLaw.js';
import { arcPath, hasArc, linePath } from './toolPath.js';

/** Without a limit of jerk the S-curve takes half as long again to reach its speed as the trapezoid: a / j is half of v / a. */
const ROUNDING = 2;

/** s; a way that would take less counts as one that takes it: powers of its time would leave the range of numbers. */
const SHORTEST = 1e-9;

/**
 * @param {Chain} chain
 * @param {Float64Array} start
 * @param {readonly Move[]} moves
 * @param {JointLimits} limits
 * @returns {MotionPlan}
 */
export function planMotion(chain, start, moves, limits) {
  requirePosture(chain.dof, start);
  for (const [name, values] of Object.entries(limits)) {
    requirePosture(chain.dof, values);
    for (const value of values) requirePositive(`each of limits.${name}`, value);
  }
  /** @type {MotionPart[]} */
  const parts = [];
  let [posture, begin] = [start, 0];
  for (const [move, each] of moves.entries()) {
    const planned = planMove(('chain' in each && each.chain) || chain, posture, each, limits);
    if ('reason' in planned) return { duration: begin, start, parts, refused: { move, ...planned } };
    const end = begin + planned.law.duration;
    parts.push({ move, kind: each.kind, begin, end, path: planned.path, law: planned.law });
    posture = planned.to;
    begin = end;
  }
  return { duration: begin, start, parts, refused: null };
}

/**
 * @typedef {{ path: PosturePath, law: TimeLaw, to: Float64Array }} Planned
 * @param {Chain} chain @param {Float64Array} from @param {Move} move @param {JointLimits} limits
 * @returns {Planned | Omit<MotionRefusal, 'move'>}
 */
function planMove(chain, from, move, limits) {
  switch (move.kind) {
    case 'joint':
      return planJoint(chain, from, move, limits);
    case 'linear':
    case 'circular':
      return planToolMove(chain, from, move);
    case 'wait':
      if (!(move.seconds >= 0 && move.seconds < Infinity)) {
        throw new RangeError(`seconds: expected a number of 0 or more, got ${move.seconds}.`);
      }
      return {
        path: straightPath([0, 1], [from, from]),
        law: timeLaw(0, 0, [{ duration: move.seconds, coefficients: [0] }]),
        to: from,
      };
    default: {
      /** @type {never} */
      const unknown = move;
      throw new TypeError(`Unknown move: ${JSON.stringify(unknown)}`);
    }
  }
}

/**
 * @param {Chain} chain @param {Float64Array} from @param {JointMove} move @param {JointLimits} limits
 * @returns {Planned | Omit<MotionRefusal, 'move'>}
 */
function planJoint(chain, from, move, { rates, accelerations, jerks }) {
  const { posture: to, speed, acceleration: share, law: name = 'doubleS' } = move;
  requirePosture(chain.dof, to);
  requireShare('speed', speed);
  requireShare('acceleration', share);
  const past = firstPast(chain, from, to);
  if (past) return past;
  const ways = to.map((value, i) => Math.abs(value - from[i]));
  const least = (/** @type {(i: number) => number} */ of) =>
    ways.reduce((found, way, i) => (way > 0 ? Math.min(found, of(i)) : found), Infinity);
  const quickest = ways.reduce((most, way, i) => Math.max(most, way / (rates[i] * speed)), 0);
  const length = quickest === 0 ? 0 : Math.max(quickest, SHORTEST);
  const acceleration = Math.min(
    1 / SHORTEST,
    least((i) => (accelerations[i] * share) / (ways[i] / length)),
  );
  const jerk = jerks
    ? Math.min(
        1 / SHORTEST ** 2,
        least((i) => (jerks[i] * share) / (ways[i] / length)),
      )
    : roundedJerk(name, acceleration);
  const law = restLaw(name, length, { rate: 1, acceleration, jerk });
  return { path: straightPath([0, length], [from, to]), law, to };
}

/** Where a joint move passes a limit first. @param {Chain} chain @param {Float64Array} from @param {Float64Array} to @returns {Omit<MotionRefusal, 'move'> | null} */
function firstPast({ joints }, from, to) {
  let [joint, share] = [-1, Infinity];
  for (const [i, { lower, upper }] of joints.entries()) {
    if (to[i] >= lower && to[i] <= upper) continue;
    const limit = to[i] < lower ? lower : upper;
    const there = Math.min(1, Math.max(0, (limit - from[i]) / (to[i] - from[i])));
    if (there < share) [joint, share] = [i, there];
  }
  if (joint < 0) return null;
  return { reason: 'limit', joint, share, posture: from.map((value, i) => value + share * (to[i] - value)) };
}

/**
 * @param {Chain} chain @param {Float64Array} from @param {LinearMove | CircularMove} move
 * @returns {Planned | Omit<MotionRefusal, 'move'>}
 */
function planToolMove(chain, from, move) {
  const { speed, turnSpeed, acceleration: most, law: name = 'doubleS' } = move;
  requirePositive('speed', speed);
  requirePositive('turnSpeed', turnSpeed);
  requirePositive('acceleration', most);
  const way = wayOf(tcpPose(chain, from), move);
  if (way === null) return { reason: 'arc', share: 0, posture: from };
  const found = followPath(chain, way, from);
  if (found.status === 'refused') {
    const { reason, share, posture, joint } = found;
    return { reason, share, posture, ...(joint !== undefined && { joint }) };
  }
  const quickest = Math.max(way.length / speed, way.turn / turnSpeed);
  const length = quickest === 0 ? 0 : Math.max(quickest, SHORTEST);
  const acceleration = most / speed;
  const jerk = roundedJerk(name, acceleration);
  const path = { ...found.path, knots: found.path.knots.map((share) => share * length) };
  return { path, law: restLaw(name, length, { rate: 1, acceleration, jerk }), to: pathMomentAt(path, length).posture };
}

/**
 * @param {Pose} T_base_from @param {LinearMove | CircularMove} move
 * @returns {ToolPath | null}  null where no circle passes the three points
 */
function wayOf(T_base_from, move) {
  if (move.kind === 'linear') return linePath(T_base_from, move.T_base_tcp);
  const via = move.via.subarray(12, 15);
  return hasArc(T_base_from, via, move.T_base_tcp) ? arcPath(T_base_from, via, move.T_base_tcp) : null;
}

/** Where no limit of jerk is stated. @param {LawName} name @param {number} acceleration  of a rate of 1 */
const roundedJerk = (name, acceleration) => (name === 'doubleS' ? ROUNDING * acceleration ** 2 : Infinity);

/** @param {string} name @param {number} share */
function requireShare(name, share) {
  if (!(share > 0 && share <= 1))
    throw new RangeError(`${name}: expected a share above 0 and at most 1, got ${share}.`);
}
