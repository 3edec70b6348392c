/**
 * Another tool: either the flange stays and the TCP goes to the end of the new tool, or the TCP stays and the arm moves so
 * that the new one is where the old one was.
 *
 * @import { Doc } from '../document.js'
 * @import { AimAnswer } from '../aim/aim.js'
 * @import { FrameCommand } from './frameCommands.js'
 *
 * @typedef {'flange' | 'tcp'} ToolKeeps
 * @typedef {Extract<FrameCommand, { type: 'choose-tool' }>} ChooseTool
 */
import { tcpPose } from '../../kinematics/forward.js';
import { aim, gapBetween } from '../aim/aim.js';
import { compilePosture, compileRobot } from '../compile.js';
import { applyFrameCommand } from './frameCommands.js';

/**
 * @param {Doc} doc
 * @param {number | null} index  of the new tool; null: none, the flange itself
 * @param {ToolKeeps} keeps
 * @returns {{ command: ChooseTool, answer: null } | { command: null, answer: AimAnswer }}  `answer`: what inverse kinematics
 *   said where the arm cannot keep the TCP with that tool
 */
export function toolChange(doc, index, keeps) {
  const command = /** @type {const} */ ({ type: 'choose-tool', index });
  const next = applyFrameCommand(doc, command);
  if (keeps === 'flange' || next.robot === doc.robot) return { command, answer: null };
  const T_world_tcp = tcpPose(compileRobot(doc.robot), compilePosture(doc.robot, doc.posture));
  const chain = compileRobot(next.robot);
  const answer = aim(next, chain, T_world_tcp);
  const T_world_new = tcpPose(chain, compilePosture(next.robot, answer.posture));
  return answer.isMet && gapBetween(T_world_tcp, T_world_new).isClosed
    ? { command: { ...command, posture: answer.posture }, answer: null }
    : { command: null, answer };
}
