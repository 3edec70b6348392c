/**
 * A table that is pasted into the grid, or is to be: the dialog that reads it comes when it is needed. One number, or one
 * expression, is pasted into its cell as anywhere.
 *
 * @import { Page } from '../page.js'
 */
import { h } from '../parts/dom.js';
import { looksLikeRobotFile } from '../files/robotFileText.js';
import { TEXT } from '../strings.js';

/** More than one cell: rows, tabs, the cells of LaTeX or Markdown. */
const IS_TABLE = /\S\s*[\n\r\t|&;]\s*\S|\\begin/;

/**
 * @param {Page} page
 * @param {HTMLTableElement} table
 * @param {HTMLElement} foot  where a button for it has room
 */
export function watchTablePaste(page, table, foot) {
  /** @param {string} text */
  function open(text) {
    const { cell } = page.store.state.session;
    import('./pasteTable.js').then(({ openPasteTable }) => openPasteTable(page, text, cell), page.messages.fault);
  }
  table.addEventListener('paste', (event) => {
    const text = event.clipboardData?.getData('text/plain') ?? '';
    if (!IS_TABLE.test(text) || looksLikeRobotFile(text)) return;
    event.preventDefault();
    open(text);
  });
  const button = h('button', { type: 'button', class: 'btn' }, TEXT.table.paste);
  button.addEventListener('click', () => open(''));
  foot.firstElementChild?.after(button);
}
