/**
 * What the double arrow at a singularity says, in words, above the handle's bar. What finds the direction is fetched when it
 * is first looked for.
 *
 * @import { Page } from '../page.js'
 */
import { lostWanted } from '../../model/aim/lostShown.js';
import { h } from '../parts/dom.js';
import { whenFirst } from '../parts/whenFirst.js';

/** @param {Page} page @param {HTMLElement} view */
export function createLostLine(page, view) {
  const line = h('p', { class: 'float lost-line', hidden: true });
  view.querySelector('.handle-bar')?.prepend(line);
  whenFirst(
    page,
    (state) => lostWanted(state) !== null,
    async () => (await import('./lostWords.js')).runLostLine(page, line),
  );
}
