/**
 * Where the arm is, as a controller says it to its programs: millimetres, degrees, pendant values, in the active user frame.
 *
 * @import { Doc } from '../document.js'
 * @import { Chain } from '../../kinematics/chain.js'
 */
import { tcpPose } from '../../kinematics/forward.js';
import { compilePosture } from '../compile.js';
import { pendantValues } from '../controller/controllerValues.js';
import { PENDANT_UNITS } from '../controller/pendantNumbers.js';
import { seenFromUser } from '../frames/frames.js';
import { poseInUnits } from '../numbers/poseNumbers.js';

/** @param {Doc} doc @returns {number[]} */
export const jointsForCode = ({ robot, posture }) => pendantValues(robot, posture);

/** @param {Doc} doc @param {Chain} chain  of its robot @returns {number[]} x y z w p r */
export function positionForCode(doc, chain) {
  const T = tcpPose(chain, compilePosture(doc.robot, doc.posture));
  const seen = doc.activeUser === undefined ? T : seenFromUser(doc, doc.activeUser, T);
  const { xyz, rpy = [0, 0, 0] } = poseInUnits(seen, PENDANT_UNITS);
  return [...xyz, ...rpy];
}
