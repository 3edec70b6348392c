/**
 * The worker that plans motion programs; started when it is first needed. A question that was overtaken by another, or is not
 * wanted any more, is given up with the worker that is busy on it.
 *
 * @import { PlanMotionAnswer, PlanMotionQuestion } from '../../workers/planMotion.js'
 *
 * @typedef {Extract<PlanMotionAnswer, { plan: unknown }>['plan']} MotionPlan
 */

/** @param {(error: unknown) => void} onError */
export function createPlanApart(onError) {
  /** @type {Worker | null} */
  let worker = null;
  let isBusy = false;
  let latest = 0;

  function start() {
    const made = new Worker(new URL('../../workers/planMotion.js', import.meta.url), { type: 'module' });
    made.onerror = (event) => {
      isBusy = false;
      onError(new Error(event.message));
    };
    return made;
  }

  function cancel() {
    latest++;
    if (!isBusy) return;
    worker?.terminate();
    worker = null;
    isBusy = false;
  }

  return {
    /**
     * @param {Omit<PlanMotionQuestion, 'id'>} question
     * @param {(share: number) => void} onProgress
     * @param {(plan: MotionPlan) => void} onPlan
     */
    ask(question, onProgress, onPlan) {
      cancel();
      worker ??= start();
      isBusy = true;
      const id = latest;
      worker.onmessage = ({ data }) => {
        const answer = /** @type {PlanMotionAnswer} */ (data);
        if (answer.id !== latest) return;
        if ('planned' in answer) return onProgress(answer.planned / question.moves.length);
        isBusy = false;
        if ('plan' in answer) onPlan(answer.plan);
        else onError(new Error(answer.fault));
      };
      worker.postMessage({ id, ...question });
    },
    cancel,
  };
}
