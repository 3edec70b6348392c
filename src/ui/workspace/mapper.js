/**
 * One worker that maps, for one question at a time. A new question overtakes the last one in the same worker, which takes it at
 * its next step; if that takes too long, the worker is given up and another one is asked.
 *
 * @import { Clock } from '../../model/clock.js'
 * @import { MapWorkspaceAnswer, MapWorkspaceQuestion } from '../../workers/mapWorkspace.js'
 *
 * @typedef {Omit<Extract<MapWorkspaceQuestion, { job: unknown }>, 'id'>} Asked
 */
import { startJob } from '../parts/startJob.js';

/** So long a worker may be silent about a question before another one is asked, s. */
const PATIENCE = 0.4;

/**
 * @param {Clock} clock
 * @param {(error: Error) => void} onError
 * @param {Worker | null} [worker]  one that has been started and not been asked
 */
export function createMapper(clock, onError, worker = null) {
  let id = 0;
  let isBusy = false;
  let wasBusy = false;
  /** @type {() => void} */
  let forget = () => {};

  function giveUp() {
    forget();
    worker?.terminate();
    worker = null;
    isBusy = wasBusy = false;
  }

  /**
   * @param {Asked} question
   * @param {(answer: MapWorkspaceAnswer) => void} onAnswer
   */
  function ask(question, onAnswer) {
    forget();
    const now = ++id;
    if (!worker) {
      worker = startJob('mapWorkspace');
      wasBusy = false;
    } else if (wasBusy || isBusy) {
      // it may be in the middle of a long step
      const cancel = clock.after(PATIENCE, () => {
        giveUp();
        ask(question, onAnswer);
      });
      forget = cancel;
    }
    isBusy = true;
    worker.onerror = (event) => {
      giveUp();
      onError(new Error(event.message));
    };
    worker.onmessage = ({ data }) => {
      if (data.id !== id) return;
      forget();
      wasBusy = false;
      if (!('word' in data)) isBusy = false;
      onAnswer(data);
    };
    worker.postMessage({ id: now, ...question });
  }

  return {
    get isBusy() {
      return isBusy;
    },
    ask,
    /** The question is not wanted any more. */
    stop() {
      forget();
      if (!isBusy) return;
      isBusy = false;
      wasBusy = true;
      worker?.postMessage({ id: ++id, stop: true });
    },
    /** Nor will there be another one soon: its memory is let go. One that has not been asked yet will be. */
    rest: () => void (id > 0 && giveUp()),
  };
}
