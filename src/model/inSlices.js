/**
 * Long jobs as generators of how far they are: done at once, or in slices so short that the page stays quick.
 *
 * @import { Clock } from './clock.js'
 */

/** s */
const SLICE = 0.012;

/**
 * @template Result
 * @param {Generator<number, Result>} job
 * @returns {Result}
 */
export function atOnce(job) {
  for (;;) {
    const turn = job.next();
    if (turn.done) return turn.value;
  }
}

/**
 * A job that says nothing of how far it is, as part of one that does.
 * @template Result
 * @param {Generator<unknown, Result>} job
 * @param {number} share   that is told meanwhile
 * @returns {Generator<number, Result>}
 */
export function* within(job, share) {
  for (let turn = job.next(); ; turn = job.next()) {
    if (turn.done) return turn.value;
    yield share;
  }
}

/**
 * @template Told, Result
 * @typedef {{ onProgress?: (share: Told) => void, onDone: (result: Result) => void, onFault: (error: unknown) => void }} Listener
 */

/**
 * @template Result
 * @param {Generator<number, Result>} job   yields the share that is done
 * @param {Pick<Clock, 'now' | 'after'>} clock
 * @param {Listener<number, Result>} told
 * @returns {() => void} gives the job up: nothing more is told of it
 */
export const inSlices = (job, clock, told) => slicing(job, clock, told, false);

/**
 * The same with the first slice now: what is short is done at once.
 * @template Result
 * @param {Generator<unknown, Result>} job
 * @param {Pick<Clock, 'now' | 'after'>} clock
 * @param {Listener<unknown, Result>} told
 * @returns {() => void}
 */
export const inSlicesFromNow = (job, clock, told) => slicing(job, clock, told, true);

/**
 * @template Told, Result
 * @param {Generator<Told, Result>} job
 * @param {Pick<Clock, 'now' | 'after'>} clock
 * @param {Listener<Told, Result>} told
 * @param {boolean} beginsNow
 * @returns {() => void}
 */
function slicing(job, clock, { onProgress, onDone, onFault }, beginsNow) {
  let cancel = () => {};
  if (beginsNow) slice();
  else cancel = clock.after(0, slice);
  function slice() {
    const end = clock.now() + SLICE;
    try {
      for (;;) {
        const turn = job.next();
        if (turn.done) return onDone(turn.value);
        if (clock.now() < end) continue;
        onProgress?.(turn.value);
        cancel = clock.after(0, slice);
        return;
      }
    } catch (error) {
      onFault(error);
    }
  }
  return () => cancel();
}
