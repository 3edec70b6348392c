/**
 * The way of one move before anything is solved: how long it is, and how fast it may be gone along. Its unit is the second:
 * what the move would take at its full speed, so that the rate of the way is at most 1, whatever moves.
 *
 * @import { Chain } from '../kinematics/chain.js'
 * @import { Pose } from '../kinematics/pose.js'
 * @import { CircularMove, JointLimits, JointMove, LinearMove, PlanLaw } from './moves.js'
 * @import { MotionRefusal } from './planReasons.js'
 * @import { ToolPath } from './toolPath.js'
 *
 * @typedef {object} MoveWay
 * @property {number} length         s
 * @property {number} acceleration   of the way at most, 1/s
 * @property {number} jerk           1/s²; perhaps Infinity
 * @property {number} share          of the joints' accelerations
 * @property {number} ceiling        what its rate is at most: less than 1 on a bend that takes more acceleration
 * @property {PlanLaw} law
 * @property {ToolPath | null} tool  its way in space; null of a joint move
 * @property {{ from: Float64Array, to: Float64Array } | null} joints   of a joint move, straight from the one to the other
 * @property {Chain} chain
 */
import { requirePositive, requirePosture } from '../kinematics/checks.js';
import { arcPath, hasArc, linePath } from './toolPath.js';

/** s; a way that would take less counts as one that takes it: powers of its time would leave the range of numbers. */
const SHORTEST = 1e-9;

/** m and rad; a way of the tool that is shorter is none: rounding. */
const STILL = 1e-12;

/** Without a limit of jerk the S-curve takes half as long again to reach its speed as the trapezoid: a / j is half of v / a. */
const ROUNDING = 2;

/**
 * @param {Chain} chain
 * @param {Float64Array} from
 * @param {JointMove} move
 * @param {JointLimits} limits
 * @returns {MoveWay}
 */
export function jointWay(chain, from, move, { rates, accelerations, jerks }) {
  const { posture, speed, acceleration: share, law = 'doubleS' } = move;
  requirePosture(chain.dof, posture);
  requireShare('speed', speed);
  requireShare('acceleration', share);
  const ways = posture.map((value, i) => Math.abs(value - from[i]));
  const least = (/** @type {(i: number) => number} */ of) =>
    ways.reduce((found, way, i) => (way > 0 ? Math.min(found, of(i)) : found), Infinity);
  const length = lengthOf(ways.reduce((most, way, i) => Math.max(most, way / (rates[i] * speed)), 0));
  const acceleration = Math.min(
    1 / SHORTEST,
    least((i) => (accelerations[i] * share) / (ways[i] / length)),
  );
  const jerk = jerks
    ? Math.min(
        1 / SHORTEST ** 2,
        least((i) => (jerks[i] * share) / (ways[i] / length)),
      )
    : roundedJerk(law, acceleration);
  return { length, acceleration, jerk, share, ceiling: 1, law, tool: null, joints: { from, to: posture }, chain };
}

/**
 * @param {Chain} chain
 * @param {Pose} T_base_from
 * @param {LinearMove | CircularMove} move
 * @returns {MoveWay | null}  null where no circle passes the three points
 */
export function toolWay(chain, T_base_from, move) {
  const { speed, turnSpeed, acceleration: most, law = 'doubleS' } = move;
  requirePositive('speed', speed);
  requirePositive('turnSpeed', turnSpeed);
  requirePositive('acceleration', most);
  const tool = pathOf(T_base_from, move);
  if (tool === null) return null;
  const isStill = tool.length < STILL && tool.turn < STILL;
  const length = isStill ? 0 : lengthOf(Math.max(tool.length / speed, tool.turn / turnSpeed));
  const acceleration = most / speed;
  // v² · bend is the acceleration across the way
  const ceiling = Math.min(1, Math.sqrt(most / tool.bend) / (tool.length / length));
  return {
    length,
    acceleration,
    jerk: roundedJerk(law, acceleration),
    share: 1,
    ceiling,
    law,
    tool,
    joints: null,
    chain,
  };
}

/** @param {Pose} T_base_from @param {LinearMove | CircularMove} move @returns {ToolPath | null} */
function pathOf(T_base_from, move) {
  if (move.kind === 'linear') return linePath(T_base_from, move.T_base_tcp);
  const via = move.via.subarray(12, 15);
  return hasArc(T_base_from, via, move.T_base_tcp) ? arcPath(T_base_from, via, move.T_base_tcp) : null;
}

/** Where a joint move passes a limit first. @param {Chain} chain @param {Float64Array} from @param {Float64Array} to @returns {Omit<MotionRefusal, 'move'> | null} */
export function firstPast({ dof, joints }, from, to) {
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

/** Where a joint move is at a share of its way. @param {MoveWay} way @param {number} share */
export function postureOn({ joints }, share) {
  if (!joints) throw new TypeError('Expected the way of a joint move.');
  const { from, to } = joints;
  return share === 1 ? to : from.map((value, i) => value + share * (to[i] - value));
}

/** Where no limit of jerk is stated. @param {PlanLaw} law @param {number} acceleration */
const roundedJerk = (law, acceleration) => (law === 'doubleS' ? ROUNDING * acceleration ** 2 : Infinity);

/**
 * What the joints' jerks are at most where one of two moves leads into the other by the joints, and one of them is an S-curve.
 * @param {MoveWay} before @param {MoveWay} after @param {JointLimits} limits
 * @returns {Float64Array | null}  null: not limited
 */
export function jerksBetween(before, after, { rates, accelerations, jerks }) {
  if (before.law !== 'doubleS' && after.law !== 'doubleS') return null;
  const share = Math.min(before.share, after.share);
  return accelerations.map((most, i) => share * (jerks ? jerks[i] : (ROUNDING * most ** 2) / rates[i]));
}

/** @param {number} quickest */
const lengthOf = (quickest) => (quickest === 0 ? 0 : Math.max(quickest, SHORTEST));

/** @param {string} name @param {number} share */
export function requireShare(name, share) {
  if (!(share > 0 && share <= 1))
    throw new RangeError(`${name}: expected a share above 0 and at most 1, got ${share}.`);
}
