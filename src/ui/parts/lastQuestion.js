/**
 * A worker for one question at a time, started when it is first needed. A question that is overtaken by another, or is not wanted
 * any more, is given up with the worker that is busy on it.
 *
 * @import { JobName } from '../../workers/worker.js'
 */
import { startJob } from './startJob.js';

/**
 * @template {object} Question
 * @template {{ id: number }} Answer
 * @param {JobName} job
 * @param {(error: unknown) => void} onError
 * @param {(answer: Answer) => boolean} [isLast]  whether the worker has said all
 */
export function createLastQuestion(job, onError, isLast = () => true) {
  /** @type {Worker | null} */
  let worker = null;
  let isBusy = false;
  let latest = 0;

  function cancel() {
    if (isBusy) end();
    else latest++;
  }

  function end() {
    latest++;
    worker?.terminate();
    worker = null;
    isBusy = false;
  }

  return {
    get isBusy() {
      return isBusy;
    },
    /** @param {Question} question @param {(answer: Answer) => void} onAnswer  perhaps several times */
    ask(question, onAnswer) {
      cancel();
      worker ??= startJob(job);
      isBusy = true;
      const id = latest;
      worker.onerror = (event) => {
        cancel();
        onError(new Error(event.message));
      };
      worker.onmessage = ({ data }) => {
        if (data.id !== latest) return;
        if (isLast(data)) isBusy = false;
        onAnswer(data);
      };
      worker.postMessage({ id, ...question });
    },
    cancel,
    /** For now: no worker is kept for a next question. */
    end,
  };
}
