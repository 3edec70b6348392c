/**
 * The button below the table that copies all of it, as text or as code.
 *
 * @import { Page } from '../page.js'
 */
import { refill, withChoices } from '../parts/choices.js';
import { h } from '../parts/dom.js';
import { icon } from '../parts/icons.js';
import { TEXT } from '../strings.js';

/** @param {Page} page @param {(text: string) => void} say @returns {HTMLElement} */
export function createCopyTableMenu(page, say) {
  const button = h('button', { type: 'button', class: 'btn' }, TEXT.table.copy, icon('caret', 'caret'));
  /** @type {typeof import('./copyTable.js').copyTableChoices | null} */
  let choices = null;

  async function fetchChoices() {
    if (choices) return;
    choices = (await import('./copyTable.js')).copyTableChoices;
    refill(button);
  }
  const warm = () => void fetchChoices().catch(() => {}); // who opens the menu is told
  button.addEventListener('pointerenter', warm, { once: true });
  button.addEventListener('focus', warm, { once: true });

  return withChoices(button, () => {
    if (choices) return { groups: choices(page, say) };
    fetchChoices().catch(page.messages.fault);
    return { groups: [[{ title: TEXT.fetching, against: '' }]] };
  });
}
