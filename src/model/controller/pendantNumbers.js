/**
 * The joints as a controller's teach pendant has them: an arm whose joint values, limits and home are the pendant's numbers, in
 * degrees and millimetres, and the way back from a number that was changed there. A pendant changes one number and keeps the
 * others: where J3 is coupled to J2, a new J2 turns the third joint as well, so that the number of J3 stays.
 *
 * @import { JointDoc, RobotDoc, Units } from '../document.js'
 */
import { pendantValues } from './controllerValues.js';
import { homePosture, isSliding, limitsOf, quantityOf } from '../document.js';
import { memo } from '../memo.js';
import { convertAngle, convertLength } from '../units.js';

/** @type {Units} */
export const PENDANT_UNITS = { length: 'mm', angle: 'deg' };

/** What the trips between the units cost, as a share of the value: nearer than this to a limit is at the limit. */
const ROUNDING = 1e-13;

/** @param {JointDoc} joint @param {number} value @param {Units} from @param {Units} to */
const between = (joint, value, from, to) =>
  isSliding(joint) ? convertLength(value, from.length, to.length) : convertAngle(value, from.angle, to.angle);

/** The pendant's number without what it is coupled to. @param {RobotDoc} robot @param {number} index @param {number} q */
function ownPart({ joints, units }, index, q) {
  const { sign, offset } = joints[index].controller;
  return between(joints[index], sign * q + offset, units, PENDANT_UNITS);
}

/** Which joint another one is coupled to, and how; −1: none. @param {RobotDoc} robot @param {number} index */
function couplingOf({ joints }, index) {
  const { coupledTo, coupling } = joints[index].controller;
  return { to: coupling === 0 ? -1 : joints.findIndex(({ id }) => id === coupledTo), coupling };
}

/**
 * The joint value behind a pendant's number, the other numbers being what they are.
 * @param {RobotDoc} robot
 * @param {readonly number[]} pendant
 * @param {number} index
 * @returns {number} in the document's units
 */
function jointValue(robot, pendant, index) {
  const joint = robot.joints[index];
  const { to, coupling } = couplingOf(robot, index);
  const own = pendant[index] - (to < 0 ? 0 : coupling * pendant[to]);
  const { sign, offset } = joint.controller;
  const value = sign * (between(joint, own, PENDANT_UNITS, robot.units) - offset) + 0;
  const { lower, upper } = limitsOf(joint);
  const isAt = (/** @type {number} */ limit) =>
    Number.isFinite(limit) && Math.abs(value - limit) <= ROUNDING * Math.abs(limit);
  return [lower, upper].find(isAt) ?? value;
}

/**
 * @param {RobotDoc} robot
 * @param {readonly number[]} pendant  degrees, or millimetres of a slide
 * @returns {number[]} in the document's units
 */
export const postureFromPendant = (robot, pendant) => robot.joints.map((_, i) => jointValue(robot, pendant, i));

/** The joints whose number depends on that of another. @param {RobotDoc} robot @param {number} index */
export const coupledTo = (robot, index) =>
  robot.joints.flatMap((_, k) => (couplingOf(robot, k).to === index ? [k] : []));

/**
 * One number of the pendant is another, and all the others are as they were. Joints that this does not move keep their digits.
 * @param {RobotDoc} robot
 * @param {readonly number[]} posture
 * @param {number} index
 * @param {number} value
 * @returns {number[]} the posture, in the document's units
 */
export function withPendantValue(robot, posture, index, value) {
  const pendant = pendantValues(robot, posture).with(index, value);
  const moved = [index, ...coupledTo(robot, index)];
  return posture.map((q, i) => (moved.includes(i) ? jointValue(robot, pendant, i) : q));
}

/**
 * What a number of the pendant may be while the others stay: its own joint's limits, which move with what it is coupled to;
 * and no farther than the limits of joints that are coupled to it let it, unless those are past their limits already.
 * @param {RobotDoc} robot
 * @param {readonly number[]} posture
 * @param {readonly number[]} pendant
 * @param {number} index
 * @returns {{ lower: number, upper: number, stoppedBy: readonly number[] }} stoppedBy: coupled joints that stop it before its own limits
 */
function pendantLimits(robot, posture, pendant, index) {
  const own = couplingOf(robot, index);
  const shift = own.to < 0 ? 0 : own.coupling * pendant[own.to];
  const ends = (/** @type {number} */ k) =>
    Object.values(limitsOf(robot.joints[k])).map((limit) =>
      Number.isFinite(limit) ? ownPart(robot, k, limit) : limit * robot.joints[k].controller.sign,
    );
  let [lower, upper] = ends(index)
    .map((end) => end + shift)
    .sort((a, b) => a - b);
  /** @type {number[]} */
  const stoppedBy = [];
  for (const k of coupledTo(robot, index)) {
    const { coupling } = couplingOf(robot, k);
    const [least, most] = ends(k)
      .map((end) => (pendant[k] - end) / coupling)
      .sort((a, b) => a - b);
    const { lower: low, upper: high } = limitsOf(robot.joints[k]);
    if (posture[k] < low || posture[k] > high || (least <= lower && most >= upper)) continue;
    stoppedBy.push(k);
    lower = Math.max(lower, Math.min(least, pendant[index]));
    upper = Math.min(upper, Math.max(most, pendant[index]));
  }
  return { lower, upper, stoppedBy };
}

/**
 * The arm with the pendant's numbers where it stands, for what shows and checks joint values. It is never compiled.
 */
export const onPendant = memo(
  /** @param {RobotDoc} robot @param {readonly number[]} posture */
  (robot, posture) => {
    const values = pendantValues(robot, posture);
    const home = pendantValues(robot, homePosture(robot));
    const limits = robot.joints.map((_, i) => pendantLimits(robot, posture, values, i));
    const finite = (/** @type {number} */ limit) => (Number.isFinite(limit) ? limit : undefined);
    /** @type {RobotDoc} */
    const shown = {
      ...robot,
      units: PENDANT_UNITS,
      joints: robot.joints.map((joint, i) => {
        const { lower, upper } = limits[i];
        const isHeld = Number.isFinite(lower) || Number.isFinite(upper);
        return {
          ...joint,
          type: joint.type === 'continuous' && isHeld ? 'revolute' : joint.type,
          a: convertLength(joint.a, robot.units.length, 'mm'),
          d: convertLength(joint.d, robot.units.length, 'mm'),
          ...{ lower: finite(lower), upper: finite(upper), home: home[i] },
        };
      }),
    };
    return { robot: shown, values, limits };
  },
);

/**
 * All numbers of the pendant at zero, or as near as the joints' limits let them.
 * @param {RobotDoc} robot
 * @param {boolean} keepsLimits
 * @returns {{ posture: number[], stopped: number[] }}
 */
export function zeroOnPendant(robot, keepsLimits) {
  const zero = postureFromPendant(
    robot,
    robot.joints.map(() => 0),
  );
  const posture = zero.map((value, i) => {
    const { lower, upper } = limitsOf(robot.joints[i]);
    return keepsLimits ? Math.min(upper, Math.max(lower, value)) : value;
  });
  return { posture, stopped: zero.flatMap((value, i) => (value === posture[i] ? [] : [i])) };
}

/** Of a joint's number. @param {RobotDoc} robot @param {number} index */
export const pendantUnit = (robot, index) => PENDANT_UNITS[quantityOf(robot.joints[index], 'home')];

/** Which joint another is coupled to, −1 if none. @param {RobotDoc} robot @param {number} index */
export const coupledWith = (robot, index) => couplingOf(robot, index).to;
