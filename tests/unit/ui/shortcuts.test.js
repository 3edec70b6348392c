import { expect, test } from 'vitest';
import { SHORTCUTS, shortcutOf } from '../../../src/ui/shortcuts.js';
import { HELP } from '../../../src/ui/words/help.js';

/** @param {string} key @param {Partial<Record<'ctrlKey' | 'metaKey' | 'altKey' | 'shiftKey', boolean>>} [held] */
const press = (key, held = {}) =>
  shortcutOf({ key, ctrlKey: false, metaKey: false, altKey: false, shiftKey: false, ...held })?.id;

test('keys do what the table says, with Ctrl or Command alike', () => {
  expect(press('z', { ctrlKey: true })).toBe('undo');
  expect(press('Z', { metaKey: true, shiftKey: true })).toBe('redo');
  expect(press('y', { ctrlKey: true })).toBe('redo');
  expect(press('s', { metaKey: true })).toBe('save');
  expect(press('o', { ctrlKey: true })).toBe('open');
  expect(press('?', { shiftKey: true })).toBe('help');
});

test('other keys, and keys of the browser and the system, are left alone', () => {
  expect(press('z')).toBe(undefined);
  expect(press('s')).toBe(undefined);
  expect(press('?', { ctrlKey: true })).toBe(undefined);
  expect(press('z', { ctrlKey: true, altKey: true })).toBe(undefined);
  expect(press('Dead')).toBe(undefined);
});

test('every shortcut has its words in the help, and nothing else has', () => {
  expect(Object.keys(HELP.shortcut).sort()).toEqual([...new Set(SHORTCUTS.map(({ id }) => id))].sort());
});
