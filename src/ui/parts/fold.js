/**
 * A section that folds: a line that says the most important, and below it what is fetched when it is first opened.
 *
 * @import { Child } from './dom.js'
 * @import { Clock } from '../../model/clock.js'
 */
import '../css/folds.css';
import { fill, h } from './dom.js';
import { icon } from './icons.js';

/** @param {Clock} clock @param {(error: unknown) => void} onFault */
export const foldMaker =
  (clock, onFault) =>
  /**
   * @param {string} id
   * @param {(body: HTMLElement) => Promise<void>} create  what is in it, when it is first opened
   * @param {(isOpen: boolean) => void} [onToggle]  instead of opening by itself
   */
  (id, create, onToggle) => {
    const title = h('span', { class: 'b' });
    const summary = h('span', { class: 'soft fold-summary' });
    const body = h('div', { class: 'fold-body', id: `${id}-body`, hidden: true });
    const button = h(
      'button',
      { type: 'button', class: 'fold-head', id, 'aria-expanded': 'false', 'aria-controls': body.id },
      icon('caret', 'caret'),
      title,
      summary,
    );
    const element = h('section', { class: 'fold', 'aria-labelledby': id }, h('h2', {}, button), body);
    let isOpen = false;
    /** @type {Promise<void> | null} */
    let created = null;
    const toggle = onToggle ?? ((/** @type {boolean} */ wanted) => void set(wanted));
    button.addEventListener('click', () => toggle(!isOpen));

    /** @param {boolean} wanted @param {boolean} [comesIntoSight] */
    async function set(wanted, comesIntoSight = true) {
      if (wanted === isOpen) return;
      isOpen = wanted;
      button.setAttribute('aria-expanded', String(isOpen));
      body.hidden = !isOpen;
      if (!isOpen) return;
      try {
        await (created ??= create(body));
        if (comesIntoSight) clock.onFrame(() => element.scrollIntoView({ block: 'nearest' })); // when it is drawn
      } catch (error) {
        created = null; // the next opening tries again
        toggle(false);
        onFault(error);
      }
    }

    return {
      element,
      set,
      /** @param {string} name @param {...Child} rest */
      setHead(name, ...rest) {
        title.textContent = name;
        fill(summary, rest);
      },
    };
  };
