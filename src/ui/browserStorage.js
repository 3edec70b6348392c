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

/** @param {string} key */
export function forget(key) {
  try {
    localStorage.removeItem(key);
  } catch {
    // forbidden: then it is not there
  }
}

/** @param {string} start @returns {string[]} all keys that begin so */
export function keysFrom(start) {
  try {
    return Object.keys(localStorage).filter((key) => key.startsWith(start));
  } catch {
    return []; // forbidden here
  }
}
