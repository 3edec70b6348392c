/**
 * What a joint's slider spans, in document units: its limits where they are kept, some way beyond them where they are not,
 * and where there is none a range that grows when its end is reached.
 *
 * @import { JointDoc, RobotDoc, Units } from '../document.js'
 *
 * @typedef {{ readonly least: number, readonly most: number }} Range
 */
import { isSliding, limitsOf } from '../document.js';
import { convertLength } from '../units.js';

const TURN = { deg: 360, rad: 2 * Math.PI };

/** A slide without limits spans the arm's own size either way, and at least so much. */
const LEAST_SLIDE_METRES = 0.1;

/** How far beyond its limits a joint may be taken where they are not kept, as a share of what lies between them. */
const BEYOND = 0.25;

/** The sum of all lengths of the table, in its units. @param {RobotDoc} robot */
const sizeOf = ({ joints }) => joints.reduce((sum, { a, d }) => sum + Math.abs(a) + Math.abs(d), 0);

/** 1, 2 or 5 times a power of ten, not below the value. @param {number} value */
function roundUp(value) {
  const power = 10 ** Math.floor(Math.log10(value));
  const factor = [1, 2, 5].find((step) => step * power >= value) ?? 10;
  return Number((factor * power).toPrecision(1));
}

/**
 * How far a slider without limits goes to either side at first.
 * @param {JointDoc} joint
 * @param {RobotDoc} robot
 */
function reachOf(joint, robot) {
  const { length, angle } = robot.units;
  if (!isSliding(joint)) return TURN[angle];
  return roundUp(Math.max(convertLength(LEAST_SLIDE_METRES, 'm', length), sizeOf(robot)));
}

/**
 * @param {RobotDoc} robot
 * @param {number} index
 * @param {boolean} keepsLimits
 * @returns {Range}
 */
export function jogRange(robot, index, keepsLimits) {
  const joint = robot.joints[index];
  const { lower, upper } = limitsOf(joint);
  const reach = reachOf(joint, robot);
  const beyond = !keepsLimits && upper - lower < Infinity ? BEYOND * (upper - lower || reach) : 0;
  const outside = keepsLimits ? 0 : reach;
  return {
    least: Number.isFinite(lower) ? lower - (beyond || outside) : Math.min(-reach, upper - reach),
    most: Number.isFinite(upper) ? upper + (beyond || outside) : Math.max(reach, lower + reach),
  };
}

/**
 * A range with room for a value: as it is if the value is inside, else grown by halves of its width until it is.
 * @param {Range} range
 * @param {number} value
 * @param {boolean} [atEnd]  whether a value at the very end needs more room, too
 * @returns {Range} the same object if it has room
 */
export function grown(range, value, atEnd = false) {
  const width = range.most - range.least;
  if (!(width > 0) || !Number.isFinite(value)) return range;
  const past = Math.max(range.least - value, value - range.most);
  if (past < 0 || (past === 0 && !atEnd)) return range;
  const step = width / 2;
  const more = step * Math.max(1, Math.ceil(past / step));
  return value >= range.most
    ? { least: range.least, most: Math.max(range.most + more, value) }
    : { least: Math.min(range.least - more, value), most: range.most };
}

/** @param {JointDoc} joint @param {number} value */
export function isInside(joint, value) {
  const { lower, upper } = limitsOf(joint);
  return value >= lower && value <= upper;
}

/**
 * How far a value is from the nearer limit, and which one that is; negative: beyond it.
 * @param {JointDoc} joint @param {number} value
 * @returns {{ by: number, limit: 'lower' | 'upper' | null }}
 */
export function limitMargin(joint, value) {
  const { lower, upper } = limitsOf(joint);
  const [above, below] = [value - lower, upper - value];
  const by = Math.min(above, below);
  return { by, limit: by === Infinity ? null : above < below ? 'lower' : 'upper' };
}

/** The nearest value inside the limits. @param {JointDoc} joint @param {number} value */
export function inside(joint, value) {
  const { lower, upper } = limitsOf(joint);
  return Math.min(upper, Math.max(lower, value));
}

/**
 * All joints at zero, or as near to it as the limits let them.
 * @param {RobotDoc} robot
 * @param {boolean} keepsLimits
 * @returns {{ posture: number[], stopped: number[] }} which joints zero is out of the limits of
 */
export function zeroPosture({ joints }, keepsLimits) {
  const stopped = joints.flatMap((joint, i) => (isInside(joint, 0) ? [] : [i]));
  return { posture: joints.map((joint) => (keepsLimits ? inside(joint, 0) : 0)), stopped };
}
