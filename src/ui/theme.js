/**
 * Light or dark: as the system says until a person chooses, then as they chose, also next time.
 */
import { recall, remember } from './browserStorage.js';

const KEY = 'denavit.theme';

/** @param {'auto' | 'light' | 'dark' | null} asked  what the address says, if anything */
export function createTheme(asked) {
  const root = document.documentElement;
  const dark = matchMedia('(prefers-color-scheme: dark)');
  /** @type {(() => void)[]} */
  const listeners = [];
  const last = recall(KEY);
  const before = last === 'light' || last === 'dark' ? last : null;
  /** @type {'light' | 'dark' | null} null: as the system says */
  let chosen = asked === 'auto' ? null : (asked ?? before);

  function apply() {
    root.dataset.bsTheme = chosen ?? (dark.matches ? 'dark' : 'light');
    listeners.forEach((listener) => listener());
  }
  dark.addEventListener('change', apply);
  apply();
  return {
    /** @param {() => void} listener  called after each change */
    onChange: (listener) => void listeners.push(listener),
    /** @returns {'light' | 'dark'} what it is now */
    toggle() {
      chosen = root.dataset.bsTheme === 'dark' ? 'light' : 'dark';
      remember(KEY, chosen);
      apply();
      return chosen;
    },
  };
}

/** @typedef {ReturnType<typeof createTheme>} Theme */
