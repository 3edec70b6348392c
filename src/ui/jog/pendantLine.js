/**
 * What the pendant shows for a joint, as a formula: J3 = q3 − J2.
 *
 * @import { RobotDoc } from '../../model/document.js'
 */
import { conventionLine } from '../../model/controller/controllerConvention.js';

/** @param {RobotDoc} robot @param {number} index */
export const pendantLine = (robot, index) =>
  conventionLine(robot, index).replaceAll('-', '−').replaceAll(' deg', '°').replaceAll('e+', 'e');
