/**
 * Keys for the whole page. While a person types, undo is the browser's own.
 * @import { Page } from './page.js'
 * @import { Files } from './files.js'
 */
import { TEXT } from './strings.js';

/**
 * @param {Page} page
 * @param {Files} files
 */
export function createShortcuts({ store, announce }, files) {
  document.addEventListener('keydown', (event) => {
    if (!(event.ctrlKey || event.metaKey) || event.altKey) return;
    const key = event.key.toLowerCase();
    const isTyping = event.target instanceof Element && event.target.matches('[data-editing], [data-own-undo]');
    if (key === 's') {
      event.preventDefault();
      files.save();
    } else if (key === 'o') {
      event.preventDefault();
      files.choose();
    } else if (!isTyping && (key === 'z' || key === 'y')) {
      event.preventDefault();
      const type = key === 'y' || event.shiftKey ? 'redo' : 'undo';
      store.dispatch({ type });
      announce(TEXT.done[type]);
    }
  });
}
