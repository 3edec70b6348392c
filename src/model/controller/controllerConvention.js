/**
 * A robot's controller convention in words, for the header of the code and for the person who compares numbers.
 *
 * @import { RobotDoc } from '../document.js'
 */
import { hasControllerData, isCoupled } from './controllerData.js';
import { quantityOf } from '../document.js';

/**
 * One line for each joint, as "J3 = -q3 + 90 deg - J2", or one for all.
 * @param {RobotDoc} robot
 * @returns {string[]}
 */
export function conventionLines(robot) {
  if (hasControllerData(robot)) return robot.joints.map((_, index) => conventionLine(robot, index));
  return ["the model's own joint values; it has no controller data: no signs, offsets or couplings of joints are set"];
}

/** Of one joint, whatever the others have. @param {RobotDoc} robot @param {number} index */
export function conventionLine({ joints, units }, index) {
  const joint = joints[index];
  const { sign, offset, coupling, coupledTo } = joint.controller;
  const other = joints.findIndex(({ id }) => id === coupledTo) + 1;
  const factor = Math.abs(coupling) === 1 ? '' : `${Math.abs(coupling)} `;
  return [
    `J${index + 1} = ${sign < 0 ? '-' : ''}q${index + 1}`,
    ...(offset === 0 ? [] : [`${signOf(offset)} ${Math.abs(offset)} ${units[quantityOf(joint, 'home')]}`]),
    ...(isCoupled(joint.controller) ? [`${signOf(coupling)} ${factor}J${other}`] : []),
  ].join(' ');
}

const signOf = (/** @type {number} */ value) => (value < 0 ? '-' : '+');
