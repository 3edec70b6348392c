/**
 * A long menu in sections, each with its heading, made anew each time it opens.
 *
 * @import { Options as PopperOptions } from '@popperjs/core'
 *
 * @typedef {object} MenuItem
 * @property {string} title
 * @property {string} [detail]
 * @property {boolean} [isChosen]
 * @property {() => void} run
 *
 * @typedef {{ heading: string, items: readonly MenuItem[] }} Section
 */
import { Dropdown } from './menuPlugin.js';
import { fill, h } from './dom.js';
import { icon } from './icons.js';

let menus = 0;

/**
 * @param {HTMLButtonElement} button  alone in an element of class dropdown
 * @param {() => readonly Section[]} sections  asked when the menu opens
 */
export function addMenu(button, sections) {
  const list = h('div', { class: 'dropdown-menu menu choices dense' });
  const id = `sections-${++menus}`;
  button.after(list);
  button.dataset.bsToggle = 'dropdown';
  button.setAttribute('aria-expanded', 'false');
  button.addEventListener('show.bs.dropdown', () =>
    fill(
      list,
      sections().map(({ heading, items }, i) =>
        h(
          'div',
          { role: 'group', 'aria-labelledby': `${id}-${i}` },
          h('p', { class: 'dropdown-header', id: `${id}-${i}` }, heading),
          items.map(itemButton),
        ),
      ),
    ),
  );
  button.addEventListener('shown.bs.dropdown', () =>
    list.querySelector('[aria-current]')?.scrollIntoView({ block: 'nearest' }),
  );
  list.addEventListener('click', () => button.focus());
  new Dropdown(button, {
    popperConfig: (/** @type {PopperOptions} */ usual) => ({
      ...usual,
      strategy: 'fixed',
      // As long as it is, it stays on the screen, over its own button if it must.
      modifiers: [
        ...usual.modifiers,
        { name: 'preventOverflow', options: { altAxis: true, padding: 8, boundary: document.body } },
      ],
    }),
  });
}

/** @param {MenuItem} item */
function itemButton({ title, detail, isChosen = false, run }) {
  const button = h(
    'button',
    { type: 'button', class: 'dropdown-item', 'aria-current': isChosen ? 'true' : null },
    isChosen && icon('check'),
    h('span', {}, title),
    detail && h('small', {}, detail),
  );
  button.addEventListener('click', run);
  return button;
}
