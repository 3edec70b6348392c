/**
 * How much room a move of code leaves: to the joints' limits, to singular postures, to the joints' rates; and what its decimals
 * cost.
 *
 * @import { Chain } from '../../kinematics/chain.js'
 * @import { Doc } from '../document.js'
 * @import { CodeMove } from './codeMoves.js'
 *
 * @typedef {{ millimetres: number, degrees: number }} Deviation   of the tool: of its place, of its turn
 *
 * @typedef {object} MoveMargins
 * @property {{ joint: number, room: number } | null} limit   the joint that comes nearest to a limit, and how near: rad or m;
 *   below 0 past it; null where no joint has limits
 * @property {number} singularity    the least of one over the condition number: 0 at a singular posture, 1 at best
 * @property {{ joint: number, share: number } | null} rate   the joint that has to go at the largest share of its rate for the
 *   commanded speed of the tool; null where none is commanded, or the joints share the way
 */
import { ROUNDING } from '../../karel/write/neutral.js';
import { dexterity } from '../../kinematics/dexterity.js';
import { tcpPose } from '../../kinematics/forward.js';
import { geometricJacobian } from '../../kinematics/jacobian.js';
import { pathMomentAt } from '../../motion/posturePath.js';
import { arcPath } from '../../motion/toolPath.js';
import { limitsOf } from '../program/motionLimits.js';
import { fromKernel, toKernel } from '../units.js';

const UNITS = /** @type {const} */ ({ length: 'mm', angle: 'deg' });
const SAMPLES = 8;
/** Joints of an arm that meets whole poses. */
const FULL = 6;

/** REAL and the controller's own numbers have 24 bits: of a metre in mm, so much at most. */
const SINGLE = 2 ** -24;

/** A number of code is off by so much at most: mm, degrees. */
export const DECIMALS_COST = ROUNDING + SINGLE * 10 ** 4;

/** @param {Doc} doc @param {CodeMove} move @returns {MoveMargins} */
export function moveMargins({ robot }, { followed, speed, motion }) {
  const { chain, path, way } = followed;
  const { limits } = limitsOf(robot.joints, robot.units);
  /** @type {MoveMargins['limit']} */
  let limit = null;
  /** @type {MoveMargins['rate']} */
  let rate = null;
  let singularity = 1;
  const duration = durationOf(way, speed);
  for (let k = 0; k <= SAMPLES; k++) {
    const { posture, first } = pathMomentAt(path, k / SAMPLES);
    for (const [joint, { lower, upper }] of chain.joints.entries()) {
      const room = Math.min(posture[joint] - lower, upper - posture[joint]);
      if (Number.isFinite(room) && (limit === null || room < limit.room)) limit = { joint, room };
      if (motion === 'joint' || duration === null) continue;
      const share = Math.abs(first[joint]) / duration / limits.rates[joint];
      if (rate === null || share > rate.share) rate = { joint, share };
    }
    singularity = Math.min(singularity, 1 / dexterity(chain, posture).conditionNumber);
  }
  return { limit, singularity, rate };
}

/** How long a way takes at the commanded speed, without speeding up. @param {CodeMove['followed']['way']} way @param {CodeMove['speed']} speed */
function durationOf(way, { value, unit }) {
  if (!way || value === null || !(value > 0)) return null;
  if (unit === 'mm/sec') return way.length > 0 ? way.length / toKernel('length', value, UNITS) : null;
  if (unit === 'deg/sec') return way.turn > 0 ? way.turn / toKernel('angle', value, UNITS) : null;
  return unit === 'sec' ? value : null;
}

/** @param {Doc} doc @param {CodeMove} move @returns {Deviation} */
export function roundingOf({ robot }, { followed: { chain, end, path }, isJoint }) {
  if (!isJoint) {
    const turned = 3 * DECIMALS_COST;
    return {
      millimetres: Math.sqrt(3) * DECIMALS_COST,
      degrees: chain.dof < FULL ? leaning(chain, end, turned) : turned,
    };
  }
  // A joint that is off by so much takes the tool with it: the sum of all, at either end of the way.
  const both = [pathMomentAt(path, 0).posture, end].map((q) => takenAlong(chain, q, jointsOff(robot, chain, q)));
  return {
    millimetres: Math.max(...both.map(({ millimetres }) => millimetres)),
    degrees: Math.max(...both.map(({ degrees }) => degrees)),
  };
}

/**
 * What each joint of a posture that is given by joint values may be off by: rad, m.
 * @param {Doc['robot']} robot
 * @param {Chain} chain
 * @param {Float64Array} q
 */
export const jointsOff = (robot, { joints }, q) =>
  joints.map(({ type, lower, upper }, i) => {
    const quantity = type === 'prismatic' ? 'length' : 'angle';
    // at a limit it is rounded to the inside (insideLimits.js)
    const isAtLimit = Math.min(q[i] - lower, upper - q[i]) <= toKernel(quantity, 4 * ROUNDING, UNITS);
    const off = isAtLimit ? DECIMALS_COST + ROUNDING : DECIMALS_COST;
    return toKernel(quantity, off, UNITS) * (1 + coupledShare(robot, i));
  });

/** How far the tool goes where the joints are off by so much. @param {Chain} chain @param {Float64Array} q @param {readonly number[]} off @returns {Deviation} */
export function takenAlong(chain, q, off) {
  const J = geometricJacobian(chain, q);
  let [metres, radians] = [0, 0];
  for (const [i, share] of off.entries()) {
    metres += share * Math.hypot(J[6 * i], J[6 * i + 1], J[6 * i + 2]);
    radians += share * Math.hypot(J[6 * i + 3], J[6 * i + 4], J[6 * i + 5]);
  }
  return { millimetres: fromKernel('length', metres, UNITS), degrees: fromKernel('angle', radians, UNITS) };
}

/**
 * How far the tool of an arm with fewer joints is turned by what its pose is off: it follows from the place and from what of the
 * turn is met. Next to a singular posture joints go with the root of what the pose is off, no farther (e = δ²/2).
 * @param {Chain} chain
 * @param {Float64Array} q
 * @param {number} degrees  off
 */
function leaning(chain, q, degrees) {
  const off = toKernel('angle', degrees, UNITS);
  return fromKernel('angle', Math.min(off * dexterity(chain, q).conditionNumber, Math.sqrt(2 * off)), UNITS);
}

/** Of a point on an arc, m: so little that the arc changes in proportion. */
const NUDGE = 1e-7;
const ARC_SHARES = [0.25, 0.5, 0.75];

/**
 * What an arc is off by at most, where its three points are off by what their decimals cost: the nearer two of them are to each
 * other, the more of it between the others.
 * @param {CodeMove} done
 * @param {Deviation} before   of where it begins
 * @param {Deviation} own      of its other two points
 * @returns {Deviation}
 */
export function roundingOfArc({ kernel, followed: { chain, path } }, before, own) {
  if (kernel.kind !== 'circular') return own;
  const T_from = tcpPose(chain, pathMomentAt(path, 0).posture);
  const points = [T_from, kernel.via, kernel.T_base_tcp];
  const placesOn = (/** @type {readonly Float64Array[]} */ [from, via, to]) => {
    const arc = arcPath(from, via.subarray(12, 15), to);
    return ARC_SHARES.map((share) => arc.poseAt(share).slice(12, 15));
  };
  const places = placesOn(points);
  const off = places.map(() => 0);
  for (const [i, { millimetres }] of [before, own, own].entries()) {
    const squares = places.map(() => 0);
    for (let axis = 12; axis < 15; axis++) {
      const nudged = points.map((T, k) => (k === i ? T.with(axis, T[axis] + NUDGE) : T));
      for (const [k, place] of placesOn(nudged).entries())
        squares[k] += place.reduce((sum, value, j) => sum + ((value - places[k][j]) / NUDGE) ** 2, 0);
    }
    squares.forEach((square, k) => (off[k] += Math.sqrt(square) * millimetres));
  }
  return { ...own, millimetres: Math.max(own.millimetres, ...off) };
}

/** A joint that is counted with another one is off with that, too. @param {Doc['robot']} robot @param {number} index */
const coupledShare = ({ joints }, index) => Math.abs(joints[index].controller.coupling);
