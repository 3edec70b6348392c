/**
 * Opening a document in place of the one that is there. Files take a while to read, so several may be under way: the one
 * that was asked for last wins, and no mixture ever comes of it.
 *
 * @import { Doc } from '../model/document.js'
 * @import { Action, AppState } from '../model/session.js'
 * @import { Store } from '../model/store.js'
 */

/** @param {Store<AppState, Action>} store */
export function createOpener(store) {
  let latest = 0;
  return {
    /** Something is on its way. @returns {() => boolean} whether it is still wanted */
    begin() {
      const turn = ++latest;
      return () => turn === latest;
    },
    /** @param {Doc} doc */
    open(doc) {
      latest++;
      store.dispatch({ type: 'replace-document', doc });
    },
  };
}

/** @typedef {ReturnType<typeof createOpener>} Opener */
