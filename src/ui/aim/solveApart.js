/**
 * The worker that looks for all solutions of an arm for which there is no formula.
 *
 * @import { SolvedAll } from '../../model/aim/solutions.js'
 * @import { SolveAllQuestion } from '../../workers/solveAll.js'
 *
 * @typedef {{ id: number, all: SolvedAll }} SolveAllAnswer
 */
import { createLastQuestion } from '../parts/lastQuestion.js';

/** @param {(error: unknown) => void} onError */
export function createSolveApart(onError) {
  /** @type {ReturnType<typeof createLastQuestion<Omit<SolveAllQuestion, 'id'>, SolveAllAnswer>>} */
  const apart = createLastQuestion('solveAll', onError);
  return {
    /** @param {Omit<SolveAllQuestion, 'id'>} question @param {(all: SolvedAll) => void} onAnswer */
    ask(question, onAnswer) {
      apart.ask(question, ({ all }) => onAnswer(all));
    },
    /** The answer is not wanted any more. */
    forget: apart.cancel,
  };
}
