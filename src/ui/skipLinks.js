/**
 * Links before everything else, seen only while the keyboard is on them: to the picture, the table, the joints, the target.
 * @import { Page } from './page.js'
 */
import { h } from './parts/dom.js';
import { openPanel } from './page.js';
import { TEXT } from './strings.js';

/**
 * @param {Page} page
 * @param {{ view: HTMLElement, robot: HTMLElement | null, jog: HTMLElement | null, aim: HTMLElement | null }} rooms  null: not
 *   on the page
 */
export function createSkipLinks(page, { view, ...rooms }) {
  /** @param {HTMLElement} room @param {string} selector */
  const goTo = (room, selector) => {
    const goal = room.querySelector(selector);
    if (goal instanceof HTMLElement) goal.focus();
  };
  /** @param {string} words @param {() => void} go */
  const skip = (words, go) => {
    const link = h('a', { class: 'skip', href: '#' }, words);
    link.addEventListener('click', (event) => {
      event.preventDefault(); // the address stays as it is
      go();
    });
    return link;
  };
  const toView = skip(TEXT.panels.skip.view, () => goTo(view, 'canvas, button'));
  /** @param {'robot' | 'jog' | 'aim'} panel @param {string} selector */
  const toPanel = (panel, selector) => {
    const room = rooms[panel];
    return (
      room &&
      skip(TEXT.panels.skip[panel], () => {
        openPanel(page, panel);
        page.clock.onFrame(() => goTo(room, selector)); // when the panel stands
      })
    );
  };
  return h(
    'nav',
    { class: 'skips', 'aria-label': TEXT.panels.skip.label },
    ...[toView, toPanel('robot', '.grid input'), toPanel('jog', 'input'), toPanel('aim', '.aim-fields input')],
  );
}
