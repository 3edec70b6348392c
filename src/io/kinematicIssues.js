/**
 * The last look at what was read: does the arm have a pose that can be computed, wherever the file puts it?
 *
 * @import { Doc } from '../model/document.js'
 * @import { Issue } from '../model/issues.js'
 */
import { tcpPose } from '../kinematics/forward.js';
import { compilePosture, compileRobot } from '../model/compile.js';
import { homePosture } from '../model/document.js';
import { shownText } from '../model/shownText.js';
import { fileIssue } from './fileIssues.js';

/**
 * @param {Doc} doc  sound
 * @returns {Issue[]}
 */
export function kinematicIssues({ robot, posture, postures }) {
  const refused = (/** @type {string} */ reason) => [
    fileIssue('not-finite', `The arm has no pose that can be computed: ${reason}; expected smaller numbers.`, {
      path: 'robot.joints',
    }),
  ];
  const { joints } = robot;
  const ends = [joints.map(({ lower = 0 }) => lower), joints.map(({ upper = 0 }) => upper), homePosture(robot)];
  try {
    const chain = compileRobot(robot);
    for (const q of [posture, ...postures.map((recorded) => recorded.q), ...ends]) {
      if (!tcpPose(chain, compilePosture(robot, q)).every(Number.isFinite)) return refused('it is not finite');
    }
    return [];
  } catch (error) {
    if (error instanceof RangeError) return refused(shownText(error.message)); // the kernel's own limits
    throw error;
  }
}
