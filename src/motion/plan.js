/**
 * From moves to a motion: where every joint is at every moment, as plain data that can be posted from a worker. What cannot
 * be moved is refused with its reason, and the plan holds everything up to there.
 *
 * The joints of a joint move go in proportion, so that the postures passed are the same at any speed. A move that ends in a
 * zone goes on into the next one without stopping (blend.js); one that ends fine stops.
 *
 * @import { Chain } from '../kinematics/chain.js'
 * @import { Pose } from '../kinematics/pose.js'
 * @import { MoveWay } from './moveWay.js'
 * @import { Stretch, TimedMove } from './motionRun.js'
 * @import * as asked from './moves.js'
 * @import { MotionRefusal, NotBlended } from './planReasons.js'
 * @import { PathMoment, PosturePath } from './posturePath.js'
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
import { firstPast, jerksBetween, jointWay, postureOn, toolWay } from './moveWay.js';
import { headingBy, measuredBy, pathMomentAt, straightPath } from './posturePath.js';
import { zoneInSpace, zoneOfJoints } from './planZone.js';
import { timeLaw } from './timeLaw.js';
import { isVia, viaRun } from './viaRun.js';

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
  /** What the joints do at the beginning of the next move, where a zone leads into it. @type {PathMoment | undefined} */
  let heading;
  /** Of the next move, where a zone leads into it. @type {MoveWay | null} */
  let pending = null;
  /** The moves before this one are planned, with one before them. */
  let done = 0;

  /** @param {Omit<MotionPart, 'begin' | 'end' | 'kind'>} part */
  const add = (part) => {
    const end = begin + part.law.duration;
    parts.push({ ...part, kind: moves[part.move].kind, begin, end });
    begin = end;
  };

  for (const [index, move] of moves.entries()) {
    if (index < done) continue;
    if (move.kind === 'wait') {
      const law = timeLaw(0, 0, [{ duration: secondsOf(move), coefficients: [0] }]);
      const path = straightPath([0, 1], [posture, posture]);
      add({ move: index, path, law, timing: 'trapezoid', instead: null, slowed: [], notBlended: null });
      onMove?.(index + 1);
      continue;
    }
    if (isVia(move)) {
      const { parts: passed, end, refused } = viaRun(chain, posture, moves, index, limits);
      for (const part of passed) {
        add(part);
        onMove?.(part.move + 1);
      }
      if (refused) return { duration: begin, start, parts, refused };
      [posture, done] = [end, index + passed.length];
      continue;
    }
    /** @type {MoveWay | Omit<MotionRefusal, 'move'>} */
    const found = pending ?? wayOf(chain, posture, null, move, limits);
    /** @type {Planned | Omit<MotionRefusal, 'move'>} */
    const planned =
      'reason' in found
        ? found
        : planStretch(found, { posture, entered, heading }, move, moves[index + 1], chain, limits);
    if ('reason' in planned) {
      // the move before was to go on into this one, and now it stops
      const upTo = pending ? planMotion(chain, start, moves.slice(0, index), limits) : null;
      const held = upTo ? upTo.parts : parts;
      return { duration: upTo ? upTo.duration : begin, start, parts: held, refused: { move: index, ...planned } };
    }
    const way = /** @type {MoveWay} */ (found);
    run.push({ move: index, way, path: planned.path, ceiling: way.ceiling });
    posture = planned.end;
    [pending, entered, heading] = [null, 0, undefined];
    if (planned.zone) {
      /** @type {NonNullable<Planned['zone']>} */
      const { halves, ceiling, next, side } = planned.zone;
      run.push({ move: index, way, path: halves[0], ceiling });
      run.push({ move: index + 1, way: next, path: halves[1], ceiling });
      heading = pathMomentAt(halves[1], Infinity);
      posture = heading.posture;
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
 * @param {asked.WayMove} move
 * @param {JointLimits} limits
 * @returns {MoveWay | Omit<MotionRefusal, 'move'>}
 */
function wayOf(chain, from, T_base_from, move, limits) {
  const own = move.chain ?? chain;
  if (move.kind === 'joint') return firstPast(own, from, move.posture) ?? jointWay(own, from, move, limits);
  return toolWay(own, T_base_from ?? tcpPose(own, from), move) ?? { reason: 'arc', share: 0, posture: from };
}

/**
 * @typedef {object} Planned   a move up to its end, or to the zone that leads on
 * @property {PosturePath} path
 * @property {Float64Array} end
 * @property {(Extract<Zone, { halves: unknown }> & { next: MoveWay, side: number }) | null} zone
 * @property {NotBlended | null} notBlended
 *
 * @typedef {object} Entered   where a move is when a zone has led into it; at its beginning if none has
 * @property {Float64Array} posture
 * @property {number} entered   share of the way that is gone by then
 * @property {PathMoment} [heading]   by seconds
 */

/**
 * @param {MoveWay} way
 * @param {Entered} entered
 * @param {asked.WayMove} move
 * @param {Move | undefined} nextMove
 * @param {Chain} chain
 * @param {JointLimits} limits
 * @returns {Planned | Omit<MotionRefusal, 'move'>}
 */
function planStretch(way, entered, move, nextMove, chain, limits) {
  /** @param {NotBlended | null} notBlended @returns {Planned | Omit<MotionRefusal, 'move'>} */
  const stopping = (notBlended) => {
    const whole = solve(way, entered, 1);
    return 'reason' in whole ? whole : { ...whole, zone: null, notBlended };
  };
  if (move.ending.kind === 'fine') return stopping(null);
  if (!nextMove) return stopping('last');
  if (nextMove.kind === 'wait') return stopping('wait');
  if (isVia(nextMove)) return stopping('law');
  if (way.length === 0) return stopping('still');

  const nextChain = nextMove.chain ?? chain;
  const inSpace = way.tool !== null && nextMove.kind !== 'joint' && nextChain === way.chain;
  /** The posture at the corner, where it is needed: between two ways in space it is not, and need not be there. */
  let corner = way.joints?.to ?? entered.posture;
  if (way.tool && !inSpace) {
    const whole = solve(way, entered, 1);
    if ('reason' in whole) return whole;
    corner = whole.end;
  }
  const next = wayOf(chain, corner, inSpace && way.tool ? way.tool.poseAt(1) : null, nextMove, limits);
  if ('reason' in next || next.length === 0) return stopping('reason' in next ? 'last' : 'still');
  const side = zoneOf(way, next, move.ending);
  if (!(side > LEAST_ZONE)) return stopping('short');
  const main = solve(way, entered, 1 - side / way.length);
  if ('reason' in main) return main;
  /** @type {Zone} */
  let zone;
  if (inSpace) {
    zone = zoneInSpace(way, next, side, pathMomentAt(main.path, Infinity));
  } else {
    const into = solve(next, { posture: corner, entered: 0 }, side / next.length);
    if ('reason' in into) return stopping('last'); // the next move will be refused with its reason
    const [begin, end] = [main.path, into.path].map((path) => pathMomentAt(path, Infinity));
    zone = zoneOfJoints(way, begin, end, side, jerksBetween(way, next, limits));
  }
  return 'refused' in zone ? stopping(zone.refused) : { ...main, zone: { ...zone, next, side }, notBlended: null };
}

/**
 * The joints from one share of a move's way to another, by its seconds.
 * @param {MoveWay} way @param {Entered} at @param {number} to
 * @returns {{ path: PosturePath, end: Float64Array } | Omit<MotionRefusal, 'move'>}
 */
function solve(way, { posture, entered: from, heading }, to) {
  const { chain, length, tool } = way;
  if (!tool) {
    const end = postureOn(way, to);
    return { path: straightPath([from * length, to * length], [posture, end]), end };
  }
  const found = followPath(chain, tool, posture, { from, to, ...(heading && { heading: headingBy(heading, length) }) });
  if (found.status === 'refused') {
    const { reason, share, posture: there, joint } = found;
    return { reason, share, posture: there, ...(joint !== undefined && { joint }) };
  }
  const path = measuredBy(found.path, from * length, length);
  return { path, end: pathMomentAt(path, Infinity).posture };
}
