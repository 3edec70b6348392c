/**
 * Bootstrap's dropdown for a button and the list beside it. The plugin is fetched when the pointer or the keyboard first
 * comes to such a button, so that it is there, as a rule, when the button is pressed.
 *
 * @import { Dropdown } from 'bootstrap'
 */

/** @type {typeof Dropdown | null} once it is here */
let plugin = null;

const fetchPlugin = async () => (plugin ??= (await import('./menuPlugin.js')).Dropdown);

/** An open menu has other items now: it finds its place anew. @param {HTMLButtonElement} button */
export const placeMenu = (button) => plugin?.getInstance(button)?.update();

/**
 * @param {HTMLButtonElement} button  in the same element as its `.dropdown-menu`
 * @param {[number, number]} [offset]  of the menu from the button, px
 */
export function giveMenu(button, offset = [0, 2]) {
  // As attributes: once the plugin is here, Bootstrap hears of a click before the button does, and makes the menu itself.
  Object.assign(button.dataset, {
    bsToggle: 'dropdown',
    bsPopperConfig: JSON.stringify({
      strategy: 'fixed', // over the edges of what scrolls
      modifiers: [
        { name: 'offset', options: { offset } },
        // A long one stays on the screen, over its own button if it must.
        { name: 'preventOverflow', options: { altAxis: true, padding: 8 } },
      ],
    }),
  });
  button.setAttribute('aria-expanded', 'false');

  const warm = () => void fetchPlugin().catch(() => {}); // whoever presses the button is told
  button.addEventListener('pointerenter', warm, { once: true });
  button.addEventListener('focus', warm, { once: true });

  /** @param {typeof Dropdown} Plugin */
  const menuBy = (Plugin) => Plugin.getInstance(button) ?? new Plugin(button);

  let isAwaited = false;
  /** @param {Event} event @param {string} [selector] what to go to in the menu */
  async function open(event, selector) {
    if (plugin) return void menuBy(plugin); // which hears of the event itself, at the document
    event.preventDefault();
    if (isAwaited) return;
    isAwaited = true;
    try {
      menuBy(await fetchPlugin()).show();
      const item = selector && button.parentElement?.querySelector(selector);
      if (item instanceof HTMLElement) item.focus();
    } finally {
      isAwaited = false;
    }
  }
  button.addEventListener('click', (event) => open(event));
  button.addEventListener('keydown', (event) => {
    if (event.key === 'ArrowDown' || event.key === 'ArrowUp') open(event, '.dropdown-item:not(:disabled)');
  });
}
