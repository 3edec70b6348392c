/**
 * From moves to a motion: where every joint is at every moment, as plain data that can be posted from a worker. What cannot
 * be moved is refused with its reason, and the plan holds everything up to there.
 *
 * The joints of a joint move go in proportion, so that the postures passed are the same at any speed. A move that ends in a
 * zone goes on into the next one without stopping (blend.js); one that ends fine stops.
 *
 * @import { Chain } from '../kinematics/chain.js'
 * @import { Pose } from '../kinematics/pose.js'
 * @import { PathRefusal } from './followPath.js'
 * @import { MoveWay } from './moveWay.js'
 * @import { Stretch, TimedMove } from './motionRun.js'
 * @import * as asked from './moves.js'
 * @import { PosturePath } from './posturePath.js'
 * @import { Zone } from './planZone.js'
 *
 * @typedef {asked.Move} Move   here too, as callers of planMotion need them
 * @typedef {asked.LinearMove} LinearMove
 * @typedef {asked.Ending} Ending
 * @typedef {asked.JointLimits} JointLimits
 *
 * @typedef {TimedMove & PlacedMove} MotionPart   where the arm is along `path` by `law`, from `begin` on
 *
 * @typedef {object} PlacedMove
 * @property {Move['kind']} kind
 * @property {number} begin    s
 * @property {number} end      s
 * @property {NotBlended | null} notBlended   why it stops though it was to end in a zone
 *
 * @typedef {'last' | 'wait' | 'still' | 'short' | PathRefusal['reason']} NotBlended
 *   last: no move follows, or one that is refused. wait: a wait follows. still: one of both has no way to go. short: the zone would have no length. The
 *   others: the postures of the zone, as of a path that is refused
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
import { zoneOf } from './blend.js';
import { followPath } from './followPath.js';
import { timeRun } from './motionRun.js';
import { jointWay, postureOn, toolWay } from './moveWay.js';
import { measuredBy, pathMomentAt, straightPath } from './posturePath.js';
import { zoneInSpace, zoneOfJoints } from './planZone.js';
import { timeLaw } from './timeLaw.js';

/** s; a zone that is shorter on either side is none. */
const LEAST_ZONE = 1e-6;

/**
 * @param {Chain} chain
 * @param {Float64Array} start
 * @param {readonly Move[]} moves
 * @param {JointLimits} limits
 * @param {{ onMove?: (planned: number) => void }} [options]   onMove: told after each move how many are planned
 * @returns {MotionPlan}
 */
export function planMotion(chain, start, moves, limits, { onMove } = {}) {
  requirePosture(chain.dof, start);
  for (const name of /** @type {const} */ (['rates', 'accelerations', 'jerks'])) {
    const values = limits[name];
    if (values === undefined && name === 'jerks') continue;
    requirePosture(chain.dof, /** @type {Float64Array} */ (values));
    for (const value of values ?? []) requirePositive(`each of limits.${name}`, value);
  }
  /** @type {MotionPart[]} */
  const parts = [];
  /** Of the moves since the last stop. @type {Stretch[]} */
  let run = [];
  let [posture, begin, entered] = [start, 0, 0];
  /** Of the next move, where a zone leads into it. @type {MoveWay | null} */
  let pending = null;

  /** @param {Omit<MotionPart, 'begin' | 'end' | 'kind'>} part */
  const add = (part) => {
    const end = begin + part.law.duration;
    parts.push({ ...part, kind: moves[part.move].kind, begin, end });
    begin = end;
  };

  for (const [index, move] of moves.entries()) {
    if (move.kind === 'wait') {
      const law = timeLaw(0, 0, [{ duration: secondsOf(move), coefficients: [0] }]);
      const path = straightPath([0, 1], [posture, posture]);
      add({ move: index, path, law, timing: 'trapezoid', slowed: [], notBlended: null });
      onMove?.(index + 1);
      continue;
    }
    /** @type {MoveWay | Omit<MotionRefusal, 'move'>} */
    const found = pending ?? wayOf(chain, posture, null, move, limits);
    /** @type {Planned | Omit<MotionRefusal, 'move'>} */
    const planned =
      'reason' in found ? found : planStretch(found, posture, entered, move, moves[index + 1], chain, limits);
    if ('reason' in planned) {
      // the move before was to go on into this one, and now it stops
      const upTo = pending ? planMotion(chain, start, moves.slice(0, index), limits) : null;
      const held = upTo ? upTo.parts : parts;
      return { duration: upTo ? upTo.duration : begin, start, parts: held, refused: { move: index, ...planned } };
    }
    const way = /** @type {MoveWay} */ (found);
    run.push({ move: index, way, path: planned.path, ceiling: way.ceiling });
    posture = planned.end;
    pending = null;
    entered = 0;
    if (planned.zone) {
      /** @type {NonNullable<Planned['zone']>} */
      const { halves, ceiling, next, side } = planned.zone;
      run.push({ move: index, way, path: halves[0], ceiling });
      run.push({ move: index + 1, way: next, path: halves[1], ceiling });
      posture = pathMomentAt(halves[1], Infinity).posture;
      pending = next;
      entered = side / next.length;
    } else {
      for (const part of timeRun(run, limits))
        add({ ...part, notBlended: part.move === index ? planned.notBlended : null });
      run = [];
    }
    onMove?.(index + 1);
  }
  return { duration: begin, start, parts, refused: null };
}

/** @param {asked.Wait} wait */
function secondsOf({ seconds }) {
  if (seconds >= 0 && seconds < Infinity) return seconds;
  throw new RangeError(`seconds: expected a number of 0 or more, got ${seconds}.`);
}

/**
 * @param {Chain} chain   without a tool of the move's own
 * @param {Float64Array} from
 * @param {Pose | null} T_base_from   where the tool is said to begin; null: where it is
 * @param {Exclude<Move, asked.Wait>} move
 * @param {JointLimits} limits
 * @returns {MoveWay | Omit<MotionRefusal, 'move'>}
 */
function wayOf(chain, from, T_base_from, move, limits) {
  if (move.kind === 'joint') return firstPast(chain, from, move.posture) ?? jointWay(chain, from, move, limits);
  const own = move.chain ?? chain;
  return toolWay(own, T_base_from ?? tcpPose(own, from), move) ?? { reason: 'arc', share: 0, posture: from };
}

/** Where a joint move passes a limit first. @param {Chain} chain @param {Float64Array} from @param {Float64Array} to @returns {Omit<MotionRefusal, 'move'> | null} */
function firstPast({ dof, joints }, from, to) {
  requirePosture(dof, to);
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
 * @typedef {object} Planned   a move up to its end, or to the zone that leads on
 * @property {PosturePath} path
 * @property {Float64Array} end
 * @property {(Extract<Zone, { halves: unknown }> & { next: MoveWay, side: number }) | null} zone
 * @property {NotBlended | null} notBlended
 */

/**
 * @param {MoveWay} way
 * @param {Float64Array} posture   where it is now
 * @param {number} entered    share of the way that is gone by then
 * @param {Exclude<Move, asked.Wait>} move
 * @param {Move | undefined} nextMove
 * @param {Chain} chain
 * @param {JointLimits} limits
 * @returns {Planned | Omit<MotionRefusal, 'move'>}
 */
function planStretch(way, posture, entered, move, nextMove, chain, limits) {
  /** @param {NotBlended | null} notBlended @returns {Planned | Omit<MotionRefusal, 'move'>} */
  const stopping = (notBlended) => {
    const whole = solve(way, posture, entered, 1);
    return 'reason' in whole ? whole : { ...whole, zone: null, notBlended };
  };
  if (move.ending.kind === 'fine') return stopping(null);
  if (!nextMove) return stopping('last');
  if (nextMove.kind === 'wait') return stopping('wait');
  if (way.length === 0) return stopping('still');

  const nextChain = (nextMove.kind !== 'joint' && nextMove.chain) || chain;
  const inSpace = way.tool !== null && nextMove.kind !== 'joint' && nextChain === way.chain;
  /** The posture at the corner, where it is needed: between two ways in space it is not, and need not be there. */
  let corner = way.joints?.to ?? posture;
  if (way.tool && !inSpace) {
    const whole = solve(way, posture, entered, 1);
    if ('reason' in whole) return whole;
    corner = whole.end;
  }
  const next = wayOf(chain, corner, inSpace && way.tool ? way.tool.poseAt(1) : null, nextMove, limits);
  if ('reason' in next || next.length === 0) return stopping('reason' in next ? 'last' : 'still');
  const side = zoneOf(way, next, move.ending);
  if (!(side > LEAST_ZONE)) return stopping('short');
  const main = solve(way, posture, entered, 1 - side / way.length);
  if ('reason' in main) return main;
  /** @type {Zone} */
  let zone;
  if (inSpace) {
    zone = zoneInSpace(way, next, side, main.end);
  } else {
    const into = solve(next, corner, 0, side / next.length);
    if ('reason' in into) return stopping('last'); // the next move will be refused with its reason
    zone = zoneOfJoints(way, pathMomentAt(main.path, Infinity), pathMomentAt(into.path, Infinity), side);
  }
  return 'refused' in zone ? stopping(zone.refused) : { ...main, zone: { ...zone, next, side }, notBlended: null };
}

/**
 * The joints from one share of a move's way to another, by its seconds.
 * @param {MoveWay} way @param {Float64Array} posture @param {number} from @param {number} to
 * @returns {{ path: PosturePath, end: Float64Array } | Omit<MotionRefusal, 'move'>}
 */
function solve(way, posture, from, to) {
  const { chain, length, tool } = way;
  if (!tool) {
    const end = postureOn(way, to);
    return { path: straightPath([from * length, to * length], [posture, end]), end };
  }
  const found = followPath(chain, tool, posture, { from, to });
  if (found.status === 'refused') {
    const { reason, share, posture: there, joint } = found;
    return { reason, share, posture: there, ...(joint !== undefined && { joint }) };
  }
  const path = measuredBy(found.path, from * length, length);
  return { path, end: pathMomentAt(path, Infinity).posture };
}
