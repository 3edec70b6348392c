/**
 * How values are written. The default widths of WRITE are not on public record: here whole numbers and reals are written as
 * short as they are, and everybody asks this file.
 */

import { MAX_STRING_LENGTH } from '../words.js';

/** From here on with an exponent. */
const LARGE = 1e9;

/** @param {unknown} value @param {boolean} isReal @param {readonly number[]} [formats] width, and decimals or base @returns {string} */
export function writtenText(value, isReal, formats = []) {
  const [asked = 0, second] = formats;
  const width = Math.min(asked, MAX_STRING_LENGTH);
  if (value === undefined) return '***';
  if (Array.isArray(value))
    return value
      .slice(0, 6)
      .map((one) => writtenText(one, true))
      .join(' ');
  if (typeof value === 'string') return width > 0 ? value.slice(0, width).padEnd(width) : value;
  if (typeof value === 'boolean') return (value ? 'TRUE' : 'FALSE').padEnd(width);
  if (typeof value !== 'number') return '';
  const digits = isReal ? realDigits(value, second) : wholeDigits(value, second);
  return digits.padStart(width);
}

/** @param {number} value @param {number} [base] */
const wholeDigits = (value, base) =>
  base && base >= 2 && base <= 16 ? value.toString(base).toUpperCase() : String(value);

/** @param {number} value @param {number} [decimals] */
function realDigits(value, decimals) {
  if (decimals !== undefined && decimals >= 0) return value.toFixed(Math.min(decimals, 20));
  const rounded = Number(value.toPrecision(7));
  const short = Math.abs(rounded) >= LARGE ? rounded.toExponential() : String(rounded);
  if (short.includes('e')) return short.toUpperCase().replace('E+', 'E');
  return short.includes('.') ? short : `${short}.0`;
}

/**
 * As CNV_REAL_STR gives it: a leading blank, no zero before the point (seen in programs that take both away). What happens to
 * the digits behind is told by no document; public suites that were run on controllers have 3.142 of pi and -6.70 of -6.6982,
 * but .437 of .43755 and -.098 of -.09874: rounded from 1 on, cut below.
 * @param {number} value @param {number} length @param {number} decimals
 */
export function convertedReal(value, length, decimals) {
  const places = Math.min(Math.max(decimals, 0), 14);
  const digits = (Math.abs(value) < 1 ? cutDecimals(value, places) : value.toFixed(places)).replace(/^(-?)0\./, '$1.');
  return ` ${digits}`.padStart(Math.min(length, MAX_STRING_LENGTH));
}

/** A REAL is good for seven digits; those behind the wanted ones are left out. @param {number} value @param {number} places */
function cutDecimals(value, places) {
  const exact = Number(value.toPrecision(7)).toFixed(14);
  return exact.slice(0, exact.indexOf('.') + (places > 0 ? places + 1 : 0));
}

/** As CNV_INT_STR gives it: a leading blank. @param {number} value @param {number} length @param {number} base */
export const convertedWhole = (value, length, base) =>
  ` ${wholeDigits(value, base || 10)}`.padStart(Math.min(length, MAX_STRING_LENGTH));
