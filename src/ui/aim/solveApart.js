/**
 * The worker that looks for all solutions of an arm for which there is no formula; started when it is first needed. A question
 * that was overtaken by another is given up, with the worker that is still busy on it.
 *
 * @import { SolvedAll } from '../../model/aim/solutions.js'
 * @import { SolveAllQuestion } from '../../workers/solveAll.js'
 */

/** @param {(error: unknown) => void} onError */
export function createSolveApart(onError) {
  /** @type {Worker | null} */
  let worker = null;
  let isBusy = false;
  let latest = 0;

  function start() {
    const made = new Worker(new URL('../../workers/solveAll.js', import.meta.url), { type: 'module' });
    made.onerror = (event) => {
      isBusy = false;
      onError(new Error(event.message));
    };
    return made;
  }

  return {
    /** @param {Omit<SolveAllQuestion, 'id'>} question @param {(all: SolvedAll) => void} onAnswer */
    ask(question, onAnswer) {
      if (isBusy) {
        worker?.terminate();
        worker = null;
      }
      worker ??= start();
      isBusy = true;
      const id = ++latest;
      worker.onmessage = ({ data }) => {
        if (data.id !== latest) return;
        isBusy = false;
        onAnswer(data.all);
      };
      worker.postMessage({ id, ...question });
    },
    /** The answer is not wanted any more. */
    forget() {
      latest++;
    },
  };
}
