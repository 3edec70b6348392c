/**
 * Quaternions that were rounded by hand are brought to length 1, and a person is told.
 *
 * @import { Doc, PoseDoc } from '../model/document.js'
 * @import { Issue } from '../model/issues.js'
 */
import { QUATERNION_TOLERANCE } from '../model/documentRules.js';
import { fileIssue } from './fileIssues.js';

/** Three digits typed; farther off, it is more likely a mistake than rounding. The margin lets exactly 1.001 pass. */
const ROUNDED = 1e-3 + 1e-9;

/**
 * @param {Doc} doc  not frozen yet; its quaternions are replaced
 * @returns {Issue[]}
 */
export const roundQuaternions = ({ robot, frames, targets, obstacles }) => [
  ...rounded('The base', 'robot.base', robot.base),
  ...rounded('The tool', 'robot.tool', robot.tool),
  ...frames.flatMap((frame, i) => rounded(`Frame "${frame.id}"`, `frames.${i}`, frame)),
  ...targets.flatMap((target, i) => rounded(`Target "${target.id}"`, `targets.${i}`, target)),
  ...obstacles.flatMap((one, i) => rounded(`Obstacle "${one.id}"`, `obstacles.${i}`, one)),
];

/** @param {string} owner @param {string} path @param {PoseDoc} pose @returns {Issue[]} */
function rounded(owner, path, pose) {
  if (!pose.quaternion) return [];
  const length = Math.hypot(...pose.quaternion);
  const error = Math.abs(length - 1);
  if (error <= QUATERNION_TOLERANCE || error > ROUNDED) return [];
  pose.quaternion = pose.quaternion.map((value) => value / length);
  const message = `${owner} has a quaternion of length ${length}; it was brought to length 1.`;
  return [fileIssue('quaternion-rounded', message, { path: `${path}.quaternion` })];
}
