/**
 * Light or dark: as the system says until a person chooses, then as they chose, also next time. Storage that is
 * forbidden (an embedded page) is no reason to stop.
 */
const KEY = 'denavit.theme';

/** @param {'auto' | 'light' | 'dark'} asked  what the address says */
export function createTheme(asked) {
  const root = document.documentElement;
  const dark = matchMedia('(prefers-color-scheme: dark)');
  /** @type {(() => void)[]} */
  const listeners = [];
  let chosen = asked === 'auto' ? remembered() : asked;

  function apply() {
    root.dataset.bsTheme = chosen ?? (dark.matches ? 'dark' : 'light');
    listeners.forEach((listener) => listener());
  }
  dark.addEventListener('change', apply);
  apply();
  return {
    /** @param {() => void} listener  called after each change */
    onChange: (listener) => void listeners.push(listener),
    toggle() {
      chosen = root.dataset.bsTheme === 'dark' ? 'light' : 'dark';
      remember(chosen);
      apply();
    },
  };
}

/** @typedef {ReturnType<typeof createTheme>} Theme */

/** @returns {'light' | 'dark' | null} */
function remembered() {
  try {
    const value = localStorage.getItem(KEY);
    return value === 'light' || value === 'dark' ? value : null;
  } catch {
    return null; // storage is forbidden here: the system decides
  }
}

/** @param {string} value */
function remember(value) {
  try {
    localStorage.setItem(KEY, value);
  } catch {
    // Storage is forbidden here: the choice lasts as long as the page.
  }
}
