/**
 * What the browser remembers for this page. Storage may be forbidden (an embedded page) or full: then nothing is
 * remembered, and nothing breaks.
 */

/** @param {string} key @returns {string | null} */
export function recall(key) {
  try {
    return localStorage.getItem(key);
  } catch {
    return null; // forbidden here
  }
}

/** @param {string} key @param {string} value @returns {boolean} whether it is kept */
export function remember(key, value) {
  try {
    localStorage.setItem(key, value);
    return true;
  } catch {
    return false; // forbidden or full
  }
}
