/**
 * How values are written. The default widths of WRITE are not on public record: here whole numbers and reals are written as
 * short as they are, and everybody asks this file.
 */

/** From here on with an exponent. */
const LARGE = 1e9;

/** @param {unknown} value @param {boolean} isReal @param {readonly number[]} [formats] width, and decimals or base @returns {string} */
export function writtenText(value, isReal, formats = []) {
  const [width = 0, second] = formats;
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

/** As CNV_REAL_STR gives it: a leading blank, and no zero before the point (seen in programs that take both away). @param {number} value @param {number} length @param {number} decimals */
export function convertedReal(value, length, decimals) {
  const digits = value.toFixed(Math.min(Math.max(decimals, 0), 20)).replace(/^(-?)0\./, '$1.');
  return ` ${digits}`.padStart(length);
}

/** As CNV_INT_STR gives it: a leading blank. @param {number} value @param {number} length @param {number} base */
export const convertedWhole = (value, length, base) => ` ${wholeDigits(value, base || 10)}`.padStart(length);
