/**
 * Says the outcome of a command to a screen reader. One polite region; the same words twice are said twice.
 */
import { h } from './parts/dom.js';

export function createAnnouncer() {
  const region = h('div', { class: 'visually-hidden', role: 'status', 'aria-live': 'polite' });
  document.body.append(region);
  let odd = false;
  return (/** @type {string} */ text) => {
    odd = !odd;
    region.textContent = odd ? text : `${text}\u00a0`;
  };
}

/** @typedef {ReturnType<typeof createAnnouncer>} Announce */
