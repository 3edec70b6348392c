/**
 * A worker for one question at a time, started when it is first needed. A question that is overtaken by another, or is not wanted
 * any more, is given up with the worker that is busy on it.
 *
 * @template {{ id: number }} Answer
 * @param {() => Worker} start
 * @param {(error: unknown) => void} onError
 * @param {(answer: Answer) => boolean} [isLast]  whether the worker has said all
 */
export function createLastQuestion(start, onError, isLast = () => true) {
  /** @type {Worker | null} */
  let worker = null;
  let isBusy = false;
  let latest = 0;

  function begin() {
    const begun = start();
    begun.onerror = (event) => {
      isBusy = false;
      onError(new Error(event.message));
    };
    return begun;
  }

  function cancel() {
    latest++;
    if (!isBusy) return;
    worker?.terminate();
    worker = null;
    isBusy = false;
  }

  return {
    /** @param {object} question @param {(answer: Answer) => void} onAnswer */
    ask(question, onAnswer) {
      cancel();
      worker ??= begin();
      isBusy = true;
      const id = latest;
      worker.onmessage = ({ data }) => {
        if (data.id !== latest) return;
        isBusy = !isLast(data);
        onAnswer(data);
      };
      worker.postMessage({ id, ...question });
    },
    cancel,
  };
}
