/**
 * The worker that plans motion programs.
 *
 * @import { PlanMotionAnswer, PlanMotionQuestion } from '../../workers/planMotion.js'
 *
 * @typedef {Extract<PlanMotionAnswer, { plan: unknown }>['plan']} MotionPlan
 */
import { createLastQuestion } from '../parts/lastQuestion.js';

/** @param {PlanMotionAnswer} answer */
const isLast = (answer) => !('planned' in answer);

/** @param {(error: unknown) => void} onError */
export function createPlanApart(onError) {
  const apart = createLastQuestion('planMotion', onError, isLast);
  return {
    /**
     * @param {Omit<PlanMotionQuestion, 'id'>} question
     * @param {(share: number) => void} onProgress
     * @param {(plan: MotionPlan) => void} onPlan
     */
    ask(question, onProgress, onPlan) {
      apart.ask(question, (answer) => {
        if ('planned' in answer) onProgress(answer.planned / question.moves.length);
        else if ('plan' in answer) onPlan(answer.plan);
        else onError(new Error(answer.fault));
      });
    },
    cancel: apart.cancel,
    end: apart.end,
  };
}
