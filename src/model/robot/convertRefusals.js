/**
 * What can be said against converting a document: numbers that no document can hold.
 *
 * @import { Convention, Doc, PoseDoc, Units } from '../document.js'
 * @import { Issue } from '../issues.js'
 */
import { convertConvention } from './convertConvention.js';
import { firstBeyond } from './convertUnits.js';
import { ANGLE_UNITS, LARGEST_NUMBER, LENGTH_UNITS } from '../documentRules.js';
import { badChoice, issue, shown } from '../refusalParts.js';

/**
 * @param {Doc} doc
 * @param {Units} units
 * @returns {Issue | null}
 */
export function unitsRefusal(doc, units) {
  if (units === null || typeof units !== 'object') {
    return issue('choice', 'robot.units', `Expected a unit of length and one of angle, got ${shown(units)}.`);
  }
  const bad =
    badChoice('the unit of length', 'robot.units.length', units.length, LENGTH_UNITS) ??
    badChoice('the unit of angle', 'robot.units.angle', units.angle, ANGLE_UNITS);
  if (bad) return bad;
  const beyond = firstBeyond(doc, units);
  if (!beyond) return null;
  const unit = units[beyond.quantity];
  const reason = beyond.value === 0 ? 'could not be told from zero' : 'would be beyond 10⁹';
  return issue('number', 'robot.units', `In ${unit}, a number of this robot ${reason}.`);
}

/**
 * @param {Doc} doc
 * @param {Convention} convention
 * @returns {Issue | null}
 */
export function baseAndToolRefusal(doc, convention) {
  const { robot, frames } = convertConvention(doc, convention);
  if ([robot.base, robot.tool, ...frames].every(isHeld)) return null;
  return issue('number', 'robot.convention', 'What base or tool would have to take is beyond 10⁹.');
}

/** @param {PoseDoc} pose */
const isHeld = ({ xyz, rpy = [] }) => [...xyz, ...rpy].every((value) => Math.abs(value) <= LARGEST_NUMBER);
