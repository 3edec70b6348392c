/**
 * Two links before everything else, seen only while the keyboard is on them: to the picture, and to the table.
 * @import { Page } from './page.js'
 */
import { h } from './dom.js';
import { openPanel } from './page.js';
import { TEXT } from './strings.js';

/**
 * @param {Page} page
 * @param {{ view: HTMLElement, robot: HTMLElement | null }} rooms  `robot`: null where the table is not on the page
 */
export function createSkipLinks(page, { view, robot }) {
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
  const toTable =
    robot &&
    skip(TEXT.panels.skip.robot, () => {
      openPanel(page, 'robot');
      page.clock.onFrame(() => goTo(robot, '.grid input')); // when the panel stands
    });
  return h('nav', { class: 'skips', 'aria-label': TEXT.panels.skip.label }, toView, toTable);
}
