/**
 * Plans of long programs, off the page's thread: a question comes as plain data, how many moves are planned goes back now and
 * then, and the plan with the question's own id. Whoever asked may terminate the worker at any time.
 *
 * @import { PlanQuestion, answerPlanQuestion } from '../motion/planQuestion.js'
 *
 * @typedef {PlanQuestion & { id: number }} PlanMotionQuestion
 * @typedef {{ id: number, planned: number } | { id: number, plan: ReturnType<typeof answerPlanQuestion> } | { id: number, fault: string }} PlanMotionAnswer
 *   fault: the question makes no sense, as planMotion's errors say
 */
import { answerPlanQuestion as answer } from '../motion/planQuestion.js';

/** So many moves between two words of progress: some milliseconds. */
const WORD = 10;

/** @param {PlanMotionAnswer} said */
const say = (said) => self.postMessage(said);

self.onmessage = ({ data }) => {
  const { id, ...question } = /** @type {PlanMotionQuestion} */ (data);
  try {
    const plan = answer(question, (planned) => {
      if (planned % WORD === 0) say({ id, planned });
    });
    say({ id, plan });
  } catch (error) {
    say({ id, fault: error instanceof Error ? error.message : String(error) });
  }
};
