/**
 * A menu of choices, made anew each time it opens: which one holds now, and why one cannot be taken.
 *
 * @typedef {object} Choice
 * @property {string} title
 * @property {string | null} [detail]
 * @property {boolean} [isChosen]  it holds already
 * @property {string | null} [against]  why it cannot be taken, in place of the detail
 * @property {() => void} [run]
 * @property {HTMLElement | null} [preview]  what it would do, below it
 *
 * @typedef {readonly Choice[]} Group
 */
import { fill, h } from './dom.js';
import { icon } from './icons.js';
import { giveMenu, placeMenu } from './menus.js';

/**
 * @param {HTMLButtonElement} button
 * @param {() => { head?: string, groups: readonly Group[] }} choices  asked when the menu opens
 * @param {object} [look]
 * @param {string} [look.className]
 * @param {number} [look.inset]  how far the menu begins to the right of the button, px
 * @returns {HTMLElement} the button with its menu
 */
export function withChoices(button, choices, { className = '', inset = 0 } = {}) {
  const list = h('ul', { class: 'dropdown-menu menu choices' });
  const dropdown = h('div', { class: `dropdown ${className}`.trim() }, button, list); // Bootstrap looks for the list beside the button
  button.addEventListener('show.bs.dropdown', () => {
    const { head, groups } = choices();
    fill(
      list,
      head && h('li', {}, h('p', { class: 'dropdown-header' }, head)),
      groups.flatMap((group, i) => [
        i > 0 && h('li', { 'aria-hidden': 'true' }, h('hr', { class: 'dropdown-divider' })),
        ...group.map(item),
      ]),
    );
  });
  // It goes back to where the menu was opened, before the choice is carried out, which may take it.
  list.addEventListener('click', () => button.focus(), true);
  giveMenu(button, [inset, 2]);
  return dropdown;
}

/** What the choices of an open menu wait for has come: show them anew. @param {HTMLButtonElement} button */
export function refill(button) {
  if (button.getAttribute('aria-expanded') !== 'true') return;
  button.dispatchEvent(new CustomEvent('show.bs.dropdown'));
  placeMenu(button);
}

/** @param {Choice} choice */
function item({ title, detail, isChosen = false, against = null, run, preview = null }) {
  const small = against ?? detail;
  const button = h(
    'button',
    {
      type: 'button',
      class: 'dropdown-item',
      'aria-current': isChosen ? 'true' : null,
      disabled: against !== null,
    },
    isChosen && icon('check'),
    h('span', {}, title),
    small && h('small', {}, small),
  );
  if (run && !isChosen) button.addEventListener('click', run);
  return h('li', {}, button, preview);
}
