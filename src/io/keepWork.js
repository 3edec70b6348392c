/**
 * Keeps the work while it is done, so that a tab that closes, or a browser that dies, loses a second of it. Each visit writes
 * under names of its own and reads none: two tabs cannot write over each other. Another arm that is opened in place of the
 * work gets another name, so that the work before it stays kept, too.
 *
 * @import { Clock } from '../model/clock.js'
 * @import { Action, AppState } from '../model/session.js'
 * @import { Store } from '../model/store.js'
 */
import { KEPT, writeKeptWork } from './keptWork.js';

/** Seconds from a change until it is kept, and all that came after it by then. */
const PAUSE = 1;

/**
 * @param {object} given
 * @param {Store<AppState, Action>} given.store  at the document that was opened, which is not kept
 * @param {Clock} given.clock
 * @param {{ remember: (key: string, value: string) => boolean, forget: (key: string) => void }} given.storage
 * @param {string} given.visit       its own name
 * @param {() => string} given.today
 * @param {() => string} given.look
 * @param {() => void} given.onFail  what is done is not kept; called once
 * @returns {() => boolean} keep it now; whether it is kept
 */
export function createKeeper({ store, clock, storage, visit, today, look, onFail }) {
  const opened = store.state.doc;
  let kept = opened;
  let isKept = true;
  let hasFailed = false;
  let isDue = false;
  let number = 0;

  function keep() {
    const { doc } = store.state;
    if (doc === kept && isKept) return true;
    // a new name alone, or a new table alone, is still the same work
    const isOther = doc.robot.name !== kept.robot.name && doc.robot.joints !== kept.robot.joints;
    if (isOther && kept !== opened) number++;
    kept = doc;
    isKept = true;
    if (doc === opened) {
      for (let i = 0; i <= number; i++) storage.forget(`${KEPT}${visit}.${i}`); // all of it was undone
    } else {
      isKept = storage.remember(`${KEPT}${visit}.${number}`, writeKeptWork({ doc, at: today(), look: look() }));
      if (!isKept && !hasFailed) {
        hasFailed = true;
        onFail();
      }
    }
    return isKept;
  }

  store.subscribe(() => {
    if (isDue || store.state.doc === kept) return;
    isDue = true;
    clock.after(PAUSE, () => {
      isDue = false;
      keep();
    });
  });
  return keep;
}
