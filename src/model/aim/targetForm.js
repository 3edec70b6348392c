/**
 * The target in the form that a person likes. The session keeps X Y Z W P R; forms that call the same angles by other names
 * show and take those very numbers, for the others they are computed.
 *
 * @import { RobotDoc } from '../document.js'
 * @import { LengthFault, OrientationForm } from '../numbers/orientationNumbers.js'
 */
import { poseFromXyzwpr, xyzwprOf } from './aim.js';
import { WPR } from '../numbers/angleForm.js';

/** KUKA's A B C are R P W: the same three turns, read backwards. */
const BACKWARDS = 'ZYX';

/**
 * @param {OrientationForm} form
 * @param {RobotDoc} robot
 * @param {readonly number[]} target  X Y Z W P R in document units
 * @returns {readonly number[]} X Y Z and the numbers of the form, in document units
 */
export function targetNumbers(form, robot, target) {
  if (form.sequence === WPR.sequence) return target;
  const place = target.slice(0, 3);
  if (form.sequence === BACKWARDS) return [...place, ...target.slice(3).toReversed()];
  return [...place, ...form.read(poseFromXyzwpr(robot, target), robot.units).values];
}

/**
 * @param {OrientationForm} form
 * @param {RobotDoc} robot
 * @param {readonly number[]} numbers  X Y Z and those of the form
 * @returns {{ target: readonly number[], fault: null } | { target: null, fault: LengthFault }}
 */
export function targetFrom(form, robot, numbers) {
  const place = numbers.slice(0, 3);
  const turn = numbers.slice(3);
  if (form.sequence === WPR.sequence) return { target: numbers, fault: null };
  if (form.sequence === BACKWARDS) return { target: [...place, ...turn.toReversed()], fault: null };
  const { T, fault } = form.write(turn, robot.units);
  return fault ? { target: null, fault } : { target: [...place, ...xyzwprOf(robot, T).slice(3)], fault: null };
}
