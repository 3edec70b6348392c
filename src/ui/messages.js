/**
 * Faults of the program, said where they can be seen: a banner on the page and a line in the console. What a person
 * does wrong is said by the panels, not here.
 */
import { h } from './parts/dom.js';
import { icon } from './parts/icons.js';
import { TEXT } from './strings.js';

/** What the browsers say when a script, or a stylesheet it needs, cannot be fetched. */
const NOT_FETCHED = /dynamically imported module|importing a module script failed|unable to preload css/i;

/** @param {HTMLElement} host */
export function createMessages(host) {
  /** @param {string} text */
  function banner(text) {
    const close = h('button', { type: 'button', class: 'btn btn-icon', 'aria-label': TEXT.close }, icon('close'));
    const note = h('div', { class: 'notice', role: 'alert' }, icon('exclamation'), h('p', {}, text), close);
    close.addEventListener('click', () => note.remove());
    host.append(note);
  }
  /** @param {unknown} error */
  function fault(error) {
    const message = error instanceof Error ? error.message : String(error);
    console.error(error);
    banner(NOT_FETCHED.test(message) ? TEXT.notFetchedNow : TEXT.fault(message));
  }
  window.addEventListener('unhandledrejection', ({ reason }) => fault(reason));
  return {
    /** Where they stand. */
    room: host,
    warn: banner,
    fault,
    /** For a fault that is said elsewhere. @param {unknown} error */
    log: (error) => console.error(error),
  };
}

/** @typedef {ReturnType<typeof createMessages>} Messages */
