/**
 * The worker that looks for the nearest singular posture; started when it is first needed. It is never interrupted: it takes
 * some tens of milliseconds, and of what is asked meanwhile the last is asked when it is done. So the gauge follows a moving
 * arm as fast as answers come, and no faster.
 *
 * @import { FoundSingularity, SingularityQuestion } from '../../model/numbers/singularityNumbers.js'
 *
 * @typedef {{ question: SingularityQuestion, onAnswer: (found: FoundSingularity) => void }} Asked
 */
import { startJob } from '../parts/startJob.js';

/** @param {(error: unknown) => void} onError */
export function createSingularityApart(onError) {
  /** @type {Worker | null} */
  let worker = null;
  /** @type {Asked | null} */
  let running = null;
  /** @type {Asked | null} */
  let next = null;
  let id = 0;

  function start() {
    const made = startJob('findSingularity');
    made.onerror = (event) => {
      running = null;
      onError(new Error(event.message));
    };
    made.onmessage = ({ data }) => {
      const done = running;
      running = null;
      if (data.id === id) done?.onAnswer(data.found);
      const waiting = next;
      next = null;
      if (waiting) run(waiting);
    };
    return made;
  }

  /** @param {Asked} asked */
  function run(asked) {
    worker ??= start();
    running = asked;
    worker.postMessage({ id: ++id, ...asked.question });
  }

  return {
    /** @param {SingularityQuestion} question @param {(found: FoundSingularity) => void} onAnswer */
    ask(question, onAnswer) {
      const asked = { question, onAnswer };
      if (running) next = asked;
      else run(asked);
    },
  };
}
