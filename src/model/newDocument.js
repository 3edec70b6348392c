/**
 * Documents that nobody has typed yet.
 * @import { Doc, RobotDoc } from './document.js'
 */
import { homePosture } from './document.js';

/**
 * A new document around a robot: at home, nothing recorded.
 * @param {RobotDoc} robot
 * @returns {Doc}
 */
export const newDocument = (robot) => ({
  robot,
  posture: homePosture(robot),
  postures: [],
  frames: [],
  targets: [],
  obstacles: [],
  motionPrograms: [],
  programs: [],
  extensions: [],
});
