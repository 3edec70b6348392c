/**
 * Whether a controller counts an arm's joints in a way of its own.
 *
 * @import { JointDoc, RobotDoc } from '../document.js'
 */
import { isSliding } from '../document.js';

/** @param {JointDoc['controller']} controller */
export const isCoupled = ({ coupledTo, coupling }) => coupledTo !== undefined && coupling !== 0;

/** Whether any joint value on the pendant differs from the model's. @param {RobotDoc} robot */
export const hasControllerData = ({ joints }) =>
  joints.some(({ controller }) => controller.sign !== 1 || controller.offset !== 0 || isCoupled(controller));

/** Whether a controller would have numbers of its own, or a configuration, for this arm. @param {RobotDoc} robot */
export const hasPendant = (robot) =>
  hasControllerData(robot) || (robot.joints.length === 6 && !robot.joints.some(isSliding));
