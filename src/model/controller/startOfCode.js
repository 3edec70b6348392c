/**
 * Where the first move of code goes, if that is to joint values: code of a program that begins with a line goes there first.
 *
 * @import { Doc } from '../document.js'
 * @import { CodeFile } from '../../karel/write/neutral.js'
 */
import { postureFromPendant } from './pendantNumbers.js';
import { runCode } from './runCode.js';

/** @param {Doc} doc @param {readonly CodeFile[]} files @returns {readonly number[] | null} */
export function startOfCode({ robot }, files) {
  const [first] = runCode(files).effects;
  if (!first?.isJoint || !Array.isArray(first.position) || first.position.length < robot.joints.length) return null;
  return postureFromPendant(robot, first.position.slice(0, robot.joints.length));
}
