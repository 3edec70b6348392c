/**
 * What is fetched when it is first wanted; if that fails it is said, and tried again when it is next wanted.
 *
 * @import { Page } from '../page.js'
 * @import { AppState } from '../../model/session.js'
 */

/**
 * @param {Pick<Page, 'addView' | 'messages'>} page
 * @param {(state: AppState) => boolean} isWanted
 * @param {() => Promise<void>} start
 */
export function whenFirst({ addView, messages }, isWanted, start) {
  let isStarted = false;
  addView(isWanted, async (isWantedNow) => {
    if (!isWantedNow || isStarted) return;
    isStarted = true;
    try {
      await start();
    } catch (error) {
      isStarted = false;
      messages.fault(error);
    }
  });
}

/**
 * What several wait for is fetched once; what could not be fetched is tried again by the next who asks.
 * @template Value
 * @param {() => Promise<Value>} load
 * @returns {() => Promise<Value>}
 */
export function onceLoaded(load) {
  /** @type {Promise<Value> | null} */
  let loading = null;
  return () => {
    loading ??= load().catch((error) => {
      loading = null;
      throw error;
    });
    return loading;
  };
}

/**
 * What is behind an element is fetched when a hand, or the focus, comes to it: it is there when it is pressed. If that fails, whoever
 * presses is told.
 * @param {HTMLElement} host
 * @param {string} selector
 * @param {() => Promise<unknown>} load
 */
export function whenNear(host, selector, load) {
  const events = ['pointerover', 'pointerdown', 'focusin'];
  /** @param {Event} event */
  const near = ({ target }) => {
    if (!(target instanceof Element && target.closest(selector))) return;
    for (const name of events) host.removeEventListener(name, near);
    load().catch(() => {});
  };
  for (const name of events) host.addEventListener(name, near);
}
