/**
 * What a person should know about a robot and its postures before they become code for a controller.
 *
 * @import { JointDoc, RobotDoc } from '../document.js'
 * @import { Issue } from '../issues.js'
 */
import { LARGEST_VALUE } from '../../karel/write/neutral.js';
import { hasControllerData } from './controllerData.js';
import { isSliding, limitsOf, quantityOf } from '../document.js';

/** Degrees: one full turn. */
const FULL_TURN = 360;

/** FANUC couples J3 to J2 in arms of at least so many axes. */
const COUPLED = 4;

/** How far past a limit is still at the limit: what bringing a value back from radians may cost, as a share of it. */
const ROUNDING = 1e-12;

/** Significant digits of a number in a sentence. */
const SHOWN_DIGITS = 9;

/** @param {RobotDoc} robot @param {'fanuc' | 'kuka'} brand @returns {Issue[]} */
export function robotIssues(robot, brand) {
  if (hasControllerData(robot)) return [];
  const couldBeCoupled = robot.joints.length >= COUPLED && !robot.joints.slice(1, 3).some(isSliding);
  const message = `${robot.name} has no controller data: the joint values in the code are the model's own${
    brand === 'fanuc' && couldBeCoupled ? ", and the coupling of FANUC's J3 to J2 is not set" : ''
  }.`;
  return [{ severity: 'warning', code: 'no-controller-data', path: 'robot.joints', message }];
}

/**
 * @param {RobotDoc} robot
 * @param {{ id: string, q: readonly number[], pendant: readonly number[], index: number }} posture  what it is called in a sentence; the document's and the pendant's values
 * @returns {Issue[]}
 */
export function postureIssues({ joints, units }, { id, q, pendant, index }) {
  return joints.flatMap((joint, i) => {
    const unit = units[quantityOf(joint, 'home')];
    const problem =
      tooLarge(pendant[i]) ?? pastLimit(joint, q[i], unit) ?? (isSliding(joint) ? null : manyTurns(joint, pendant[i]));
    if (!problem) return [];
    const message = `${id[0].toUpperCase()}${id.slice(1)} has ${nameOf(joint, i)} at ${problem.text}.`;
    return [{ severity: problem.severity, code: problem.code, path: `steps.${index}.q.${i}`, message }];
  });
}

/** @typedef {{ severity: 'error' | 'warning', code: string, text: string }} Problem */

/** @param {number} pendant @returns {Problem | null} */
function tooLarge(pendant) {
  if (Math.abs(pendant) <= LARGEST_VALUE) return null;
  const text = `${shown(pendant)} on the pendant; a controller takes values up to ±${LARGEST_VALUE}`;
  return { severity: 'error', code: 'value-too-large', text };
}

/** @param {JointDoc} joint @param {number} value @param {string} unit @returns {Problem | null} */
function pastLimit(joint, value, unit) {
  const { lower, upper } = limitsOf(joint);
  const [limit, side] = value < lower ? [lower, 'below its lower'] : [upper, 'above its upper'];
  const isPast = value < lower || value > upper;
  if (!isPast || Math.abs(value - limit) <= ROUNDING * Math.abs(limit)) return null;
  return {
    severity: 'warning',
    code: 'outside-limits',
    text: `${shown(value)} ${unit}, ${side} limit of ${shown(limit)} ${unit}`,
  };
}

/** @param {JointDoc} joint @param {number} pendant @returns {Problem | null} */
function manyTurns(joint, pendant) {
  const { lower, upper } = limitsOf(joint);
  const isLimited = Number.isFinite(pendant < 0 ? lower : upper);
  if (isLimited || Math.abs(pendant) <= FULL_TURN) return null;
  const text = `${shown(pendant)} deg, more than a full turn from zero; the model has no limit there, but a controller's axis has`;
  return { severity: 'warning', code: 'many-turns', text };
}

/** Without the noise of the last digits. @param {number} value */
const shown = (value) => String(Number(value.toPrecision(SHOWN_DIGITS)));

/** @param {JointDoc} joint @param {number} index */
const nameOf = ({ label }, index) => (label ? `J${index + 1} (${label})` : `J${index + 1}`);
