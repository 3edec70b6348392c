/**
 * Faults of the program, said where they can be seen: a banner on the page and a line in the console. What a person
 * does wrong is said by the panels, not here.
 */
import { h } from './dom.js';
import { icon } from './icons.js';
import { TEXT } from './strings.js';

/** @param {HTMLElement} host */
export function createMessages(host) {
  /** @param {string} text */
  function banner(text) {
    const close = h('button', { type: 'button', class: 'btn btn-icon', 'aria-label': TEXT.close }, icon('close'));
    const note = h('div', { class: 'notice', role: 'alert' }, icon('exclamation'), h('p', {}, text), close);
    close.addEventListener('click', () => note.remove());
    host.append(note);
  }
  return {
    warn: banner,
    /** @param {unknown} error */
    fault(error) {
      console.error(error);
      banner(TEXT.fault(error instanceof Error ? error.message : String(error)));
    },
  };
}

/** @typedef {ReturnType<typeof createMessages>} Messages */
