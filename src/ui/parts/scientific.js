/** Numbers of any size, short: 0.0213, 1.2e−7, ∞. */
import { plain } from './format.js';

/** @param {number} value @param {number} [digits] significant ones */
export function significant(value, digits = 4) {
  if (!Number.isFinite(value)) return value < 0 ? '−∞' : '∞';
  return plain(Number(value.toPrecision(digits)));
}

/** From here on a number is written without its power of ten. */
const ORDINARY = 0.1;

/** Two digits and a power of ten, as they stand below each other in a column: −2.2e−5, 12, 0. @param {number} value */
export function tiny(value) {
  if (value === 0) return '0';
  if (Math.abs(value) >= ORDINARY) return plain(Number(value.toPrecision(2)));
  return value.toExponential(1).replaceAll('-', '−');
}

/** From here down a step is written as a power of ten. */
const SMALL_STEP = 1e-3;

/** All its digits: 0.01, 1e−5, 2.5e−7. @param {number} value */
export const stepText = (value) => (value >= SMALL_STEP ? plain(value) : value.toExponential().replaceAll('-', '−'));

const RAISED = '⁰¹²³⁴⁵⁶⁷⁸⁹';

/** 10⁻⁷. @param {number} exponent whole */
export const powerOfTen = (exponent) =>
  `10${exponent < 0 ? '⁻' : ''}${[...String(Math.abs(exponent))].map((digit) => RAISED[Number(digit)]).join('')}`;
