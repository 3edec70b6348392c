/**
 * What is asked of the planner for a motion program of the document.
 *
 * @import { Question } from './planned.js'
 * @import { Chain } from '../../kinematics/chain.js'
 */
import { planQuestion } from '../../motion/planQuestion.js';
import { compilePosture } from '../compile.js';
import { motionMoves } from './motionPlan.js';

/**
 * @param {Question} question
 * @param {Chain} chain  of the document's arm
 */
export function planRequest({ doc, program, start }, chain) {
  const found = motionMoves(doc, program, start);
  return { ...found, request: planQuestion(chain, compilePosture(doc.robot, start), found.moves, found.limits) };
}
