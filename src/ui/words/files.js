/** Robot files, opened and saved: what the first minute may need of it; the rest is in arrival.js. */

export const FILES = {
  saved: (/** @type {string} */ name) => `Saved as ${name}.`,
};
