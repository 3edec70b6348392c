/** What is said against a number. */

export const NUMBER = {
  empty: 'A number is needed here, such as 431.8.',
  comma: (/** @type {string} */ mended) => `Decimals are written with a point: ${mended}.`,
  tooSmall: 'This is smaller than any number that can be kept; type 0 if that is meant.',
  notANumber: (/** @type {string} */ text) => `“${text}” is not a number; expected one such as 431.8.`,
  tooLarge: 'The number is too large; at most 1e9.',
  notLoaded: 'Only plain numbers go now: what works out expressions did not load.',
};
