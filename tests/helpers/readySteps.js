/** The steps of a ready program, searched for at once. */
import { readyProgram } from '../../src/model/program/readyPrograms.js';
import { answerPlanQuestion } from '../../src/motion/planQuestion.js';

/** @param {Parameters<typeof readyProgram>} asked */
export function readySteps(...asked) {
  const search = readyProgram(...asked);
  let turn = search.next();
  while (!turn.done) turn = search.next(turn.value !== null && answerPlanQuestion(turn.value).refused === null);
  return turn.value;
}
