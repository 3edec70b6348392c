/**
 * Keys for the whole page, in one table: what they do here, and what the list in the help says of them (words/help.js, by
 * `id`). While a person types, undo and the question mark are the field's own.
 *
 * @import { Page } from './page.js'
 * @import { Files } from './files/files.js'
 *
 * @typedef {object} Shortcut
 * @property {'save' | 'open' | 'undo' | 'redo' | 'help'} id
 * @property {string} key       as in KeyboardEvent.key, in lower case
 * @property {boolean} [hasControl]  with Ctrl, or Command
 * @property {boolean} [hasShift]    true: with Shift; false: without; else either
 * @property {boolean} [isTyped]     it means something else while a person types
 */
import { step } from './page.js';

/** @type {readonly Shortcut[]} */
export const SHORTCUTS = [
  { id: 'undo', key: 'z', hasControl: true, hasShift: false, isTyped: true },
  { id: 'redo', key: 'z', hasControl: true, hasShift: true, isTyped: true },
  { id: 'redo', key: 'y', hasControl: true, isTyped: true },
  { id: 'save', key: 's', hasControl: true },
  { id: 'open', key: 'o', hasControl: true },
  { id: 'help', key: '?', isTyped: true },
];

export const TEXT_FIELDS =
  '[data-editing], [contenteditable], textarea, select, input:not([type=range], [type=checkbox])';

/**
 * @param {Pick<KeyboardEvent, 'key' | 'ctrlKey' | 'metaKey' | 'altKey' | 'shiftKey'>} event
 * @returns {Shortcut | undefined}
 */
export const shortcutOf = ({ key, ctrlKey, metaKey, altKey, shiftKey }) =>
  altKey
    ? undefined
    : SHORTCUTS.find(
        (shortcut) =>
          shortcut.key === key.toLowerCase() &&
          (shortcut.hasControl ?? false) === (ctrlKey || metaKey) &&
          (shortcut.hasShift === undefined || shortcut.hasShift === shiftKey),
      );

/**
 * @param {Page} page
 * @param {{ files: Files, openHelp: () => unknown }} tools
 */
export function createShortcuts(page, { files, openHelp }) {
  /** @type {Record<Shortcut['id'], () => unknown>} */
  const actions = {
    save: files.save,
    open: files.choose,
    undo: () => step(page, 'undo'),
    redo: () => step(page, 'redo'),
    help: openHelp,
  };
  document.addEventListener('keydown', (event) => {
    const shortcut = shortcutOf(event);
    if (!shortcut || event.defaultPrevented) return;
    if (document.querySelector('.modal.show')) return; // what is behind a dialog stays as it is
    const field = shortcut.hasControl ? '[data-editing]' : TEXT_FIELDS;
    if (shortcut.isTyped && event.target instanceof Element && event.target.matches(field)) return;
    event.preventDefault();
    actions[shortcut.id]();
  });
}
