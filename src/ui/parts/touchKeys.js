/**
 * Where fingers type, the keys above the keyboard are fetched when the first field that takes expressions has the focus.
 *
 * @import { Page } from '../page.js'
 */

/** @param {Page} page @param {HTMLElement} app */
export function createTouchKeys(page, app) {
  const coarse = matchMedia('(pointer: coarse)');
  let isWanted = false;
  document.addEventListener('focusin', async ({ target }) => {
    if (isWanted || !coarse.matches || !(target instanceof HTMLElement) || !target.dataset.takes) return;
    isWanted = true;
    try {
      const { createKeyRow } = await import('./keyRow.js');
      createKeyRow(page, app);
    } catch (error) {
      isWanted = false; // the keyboard has all the keys, somewhere; the next field tries again
      page.messages.log(error);
    }
  });
}
