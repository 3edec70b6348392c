/**
 * Keys for the whole page. While a person types, undo is the browser's own.
 * @import { Page } from './page.js'
 * @import { Files } from './files.js'
 */
import { step } from './page.js';

/**
 * @param {Page} page
 * @param {Files} files
 */
export function createShortcuts(page, files) {
  document.addEventListener('keydown', (event) => {
    if (!(event.ctrlKey || event.metaKey) || event.altKey) return;
    if (document.querySelector('.modal.show')) return; // what is behind a dialog stays as it is
    const key = event.key.toLowerCase();
    const isTyping = event.target instanceof Element && event.target.matches('[data-editing]');
    if (key === 's') {
      event.preventDefault();
      files.save();
    } else if (key === 'o') {
      event.preventDefault();
      files.choose();
    } else if (!isTyping && (key === 'z' || key === 'y')) {
      event.preventDefault();
      step(page, key === 'y' || event.shiftKey ? 'redo' : 'undo');
    }
  });
}
