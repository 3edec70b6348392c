/**
 * Look at the document as it was looked at when it was sent or kept. Panels that this page has not are left alone.
 *
 * @import { Page } from '../page.js'
 * @import { Look } from '../../io/readLook.js'
 */

/** @param {Page} page @param {Look} look */
export function applyLook({ store, clock, camera }, { change, camera: numbers }) {
  const { tab, panel, ...rest } = change;
  const isHere = (/** @type {string | undefined} */ name) => name && document.querySelector(`[data-opens=${name}]`);
  store.dispatch({
    type: 'show',
    change: { ...rest, ...(isHere(tab) && { tab }), ...(isHere(panel) && { panel }) },
  });
  if (numbers) clock.onFrame(() => camera.goTo(numbers)); // when another arm is in the picture
}
