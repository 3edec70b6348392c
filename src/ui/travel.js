/**
 * The arm goes to another posture while a person watches: in less than half a second, at once where no motion is wanted, and
 * in one undo step. Whatever else moves the arm meanwhile, or Escape, ends it.
 *
 * @import { Page } from './page.js'
 */
import { newGesture } from './page.js';

const SECONDS = 0.35;

const wantsNoMotion = () => matchMedia('(prefers-reduced-motion: reduce)').matches;

/**
 * @param {Page} page
 * @param {readonly number[]} to  in document units
 * @param {() => void} [onArrival]
 */
export function travelTo({ store, clock }, to, onArrival = () => {}) {
  const from = store.state.doc.posture;
  const isThere = to.every((value, i) => value === from[i]);
  if (isThere || wantsNoMotion()) {
    store.dispatch({ type: 'set-posture', posture: to });
    onArrival();
    return;
  }
  const gesture = newGesture();
  const begun = clock.now();
  let last = from;
  const go = () => {
    if (store.state.doc.posture !== last || to.length !== last.length) return; // something else has moved it
    const share = Math.min(1, (clock.now() - begun) / SECONDS);
    const smooth = share * share * (3 - 2 * share);
    const posture = share === 1 ? to : to.map((value, i) => from[i] + smooth * (value - from[i]));
    store.dispatch({ type: 'set-posture', posture, gesture });
    last = store.state.doc.posture;
    if (share < 1) {
      clock.onFrame(go);
      return;
    }
    store.dispatch({ type: 'end-gesture' });
    onArrival();
  };
  clock.onFrame(go);
}
