/**
 * Steps that people count in: 1, 2 or 5 times a power of ten.
 */

/**
 * The round step that is nearest by ratio.
 * @example
 * roundStep(0.0088) // → { digit: 1, exponent: -2, step: 0.01 }
 * @param {number} wanted  more than zero
 * @returns {{ digit: 1 | 2 | 5, exponent: number, step: number }} the step is the digit times ten to the exponent
 */
export function roundStep(wanted) {
  const decade = Math.floor(Math.log10(wanted));
  const rest = wanted / 10 ** decade;
  const isNext = rest >= Math.sqrt(50);
  const digit = isNext || rest < Math.SQRT2 ? 1 : rest < Math.sqrt(10) ? 2 : 5;
  const exponent = isNext ? decade + 1 : decade;
  // by way of text, since 10 ** -3 times 2 is not the number that 0.002 means
  return { digit, exponent, step: Number(`${digit}e${exponent}`) };
}
