/**
 * What a FANUC pair is written from: the caller's options, checked, with the numbers as they will stand in the text. A
 * caller's mistake is a RangeError.
 *
 * @import { TpDate, TpTermination } from './tpTree.js'
 *
 * @typedef {object} PairPoint
 * @property {string} name                     for people; never part of a statement
 * @property {readonly number[]} jointValues   as the teach pendant shows them: degrees, or mm where the joint slides
 * @property {readonly boolean[]} slides       for each joint; the same at all points
 *
 * @typedef {object} PairOptions
 * @property {string} programName
 * @property {string} robotName
 * @property {string} version                  of the software that writes
 * @property {string} generatedAt              ISO 8601, as '2026-07-01T12:00:00Z'; shown as it stands, in its own zone
 * @property {readonly PairPoint[]} points     1 or more, in the order they are visited
 * @property {readonly string[]} [convention]  lines for the header: how pendant values come from the model's
 * @property {number} [firstRegister]          default 1; the points take this position register and the following
 * @property {number} [speedPercent]           of joint motion, 1 to 100, default 20
 * @property {TpTermination} [termination]     at all points but the last, where the arm stops; default 'FINE'
 * @property {number} [userFrame]              UFRAME_NUM, set before moving; joint motion does not depend on it
 * @property {number} [toolFrame]              UTOOL_NUM, likewise
 *
 * @typedef {object} PairMove
 * @property {string} name
 * @property {number} register
 * @property {readonly number[]} jointValues   rounded
 * @property {TpTermination} termination
 *
 * @typedef {object} PairPlan
 * @property {{ karel: string, tp: string }} names
 * @property {string} robotName
 * @property {string} version
 * @property {TpDate} time
 * @property {readonly string[]} convention
 * @property {readonly boolean[]} slides
 * @property {readonly PairMove[]} moves
 * @property {number} speedPercent
 * @property {number} [userFrame]
 * @property {number} [toolFrame]
 */
import { fanucNames } from './fanucNames.js';

/**
 * As the pendant shows joint values, so that a person can compare them. A controller keeps them as 32-bit reals, which
 * have thousandths up to 8191.
 */
export const DECIMALS = 3;

/** A pendant's field for a joint value is 10 characters wide: a sign, 5 digits, the point, 3 decimals. */
export const LARGEST_JOINT_VALUE = 99999.999;

/** Position registers that a controller can be set up for (HandlingTool operator's manual, section 19). */
const MAX_REGISTERS = 2000;

/** A motion group has at most nine axes. */
const MAX_AXES = 9;

/** What the KAREL program calls its own things; it cannot be called so itself. */
export const FILLER_NAMES = { joints: 'joints', target: 'target', status: 'status', register: 'reg_no', fill: 'fill' };

/** @param {PairOptions} options @returns {PairPlan} */
export function planPair(options) {
  const { points, firstRegister = 1, speedPercent = 20, termination = 'FINE' } = options;
  const slides = commonSlides(points);
  if (!Number.isInteger(firstRegister) || firstRegister < 1 || firstRegister + points.length - 1 > MAX_REGISTERS) {
    throw new RangeError(
      `Expected ${points.length} position registers within 1 to ${MAX_REGISTERS}, got a first one of ${firstRegister}.`,
    );
  }
  return {
    names: fanucNames(options.programName, Object.values(FILLER_NAMES)),
    robotName: options.robotName,
    version: options.version,
    time: timeOf(options.generatedAt),
    convention: options.convention ?? [],
    slides,
    moves: points.map(({ name, jointValues }, i) => ({
      name,
      register: firstRegister + i,
      jointValues: jointValues.map(rounded),
      termination: i < points.length - 1 ? termination : 'FINE',
    })),
    speedPercent,
    userFrame: options.userFrame,
    toolFrame: options.toolFrame,
  };
}

/** @param {readonly PairPoint[]} points */
function commonSlides(points) {
  if (points.length === 0) throw new RangeError('Expected at least one point, got none.');
  const { slides } = points[0];
  if (slides.length < 1 || slides.length > MAX_AXES) {
    throw new RangeError(`Expected 1 to ${MAX_AXES} axes, got ${slides.length}.`);
  }
  for (const point of points) {
    const same = point.slides.length === slides.length && slides.every((slide, i) => slide === point.slides[i]);
    if (same && point.jointValues.length === slides.length) continue;
    throw new RangeError(
      `Expected ${slides.length} joint values at each point, of the same axes; got others at "${point.name}".`,
    );
  }
  return slides;
}

/** @param {number} value */
function rounded(value) {
  if (Math.abs(value) <= LARGEST_JOINT_VALUE) return Number(value.toFixed(DECIMALS));
  throw new RangeError(`Expected joint values within ±${LARGEST_JOINT_VALUE}, got ${value}.`);
}

/** @param {string} text @returns {TpDate} */
function timeOf(text) {
  const match = /^(\d{4})-(\d\d)-(\d\d)T(\d\d):(\d\d):(\d\d)(\.\d+)?(Z|[+-]\d\d:\d\d)?$/.exec(text);
  if (!match) throw new RangeError(`Expected a time such as 2026-07-01T12:00:00Z, got ${JSON.stringify(text)}.`);
  const [year, month, day, hour, minute, second] = match.slice(1, 7).map(Number);
  return { year, month, day, hour, minute, second };
}
