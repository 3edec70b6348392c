/**
 * One question at a time to a worker that is started when it is first needed. A question that was overtaken by another, or is
 * not wanted any more, is given up with the worker that is busy on it.
 */

/**
 * @template {object} Question
 * @template {{ id: number }} Answer
 * @param {() => Worker} start
 * @param {(answer: Answer) => boolean} isLast   nothing follows
 * @param {(error: unknown) => void} onError
 */
export function createApart(start, isLast, onError) {
  /** @type {Worker | null} */
  let worker = null;
  let isBusy = false;
  let latest = 0;

  function cancel() {
    latest++;
    if (!isBusy) return;
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
      worker ??= start();
      isBusy = true;
      const id = latest;
      worker.onerror = (event) => {
        cancel();
        onError(new Error(event.message));
      };
      worker.onmessage = ({ data }) => {
        const answer = /** @type {Answer} */ (data);
        if (answer.id !== latest) return;
        if (isLast(answer)) isBusy = false;
        onAnswer(answer);
      };
      worker.postMessage({ ...question, id });
    },
    cancel,
  };
}
