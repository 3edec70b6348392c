/**
 * What is asked of the planner for a motion program of the document.
 *
 * @import { Question } from './planned.js'
 * @import { KernelMoves } from './motionPlan.js'
 * @import { Chain } from '../../kinematics/chain.js'
 * @import { PlanQuestion } from '../../motion/planQuestion.js'
 */
import { planQuestion } from '../../motion/planQuestion.js';
import { compilePosture } from '../compile.js';
import { movesInSlices } from './motionPlan.js';

/**
 * A posture for each joint move to a pose has to be looked for, so that it takes its time.
 * @param {Question} question
 * @param {Chain} chain  of the document's arm
 * @returns {Generator<number, KernelMoves & { request: PlanQuestion }>}
 */
export function* planRequest({ doc, program, start }, chain) {
  const found = yield* movesInSlices(doc, program, start);
  return { ...found, request: planQuestion(chain, compilePosture(doc.robot, start), found.moves, found.limits) };
}
