/**
 * KAREL's numbers as text. A real always has a point, so that it is never taken for an integer; digits are as many as
 * bring the number back.
 */
import { MAX_INTEGER } from './tree.js';

/** The range of REAL, 32-bit floating point; what is smaller than the second cannot be told from zero with full digits. */
const LARGEST_REAL = 3.4028235e38;
const SMALLEST_REAL = 1.1754944e-38;

/** Within these a number is written without an exponent. */
const PLAIN_FROM = 1e-4;
const PLAIN_BELOW = 1e9;

const MAX_DECIMALS = 20;

/** @param {number} value  a literal's: 0 or more */
export function integerText(value) {
  if (Number.isInteger(value) && value >= 0 && !Object.is(value, -0) && value <= MAX_INTEGER) return String(value);
  throw new RangeError(
    `Expected a whole number from 0 to ${MAX_INTEGER} (a sign is an operator), got ${shown(value)}.`,
  );
}

/**
 * @example
 * realText(90) // → '90.0'
 * realText(90, 3) // → '90.000'
 * realText(1e-7) // → '1.0E-7'
 * @param {number} value     a literal's: 0 or more
 * @param {number} decimals  at least so many digits after the point, where there is no exponent
 */
export function realText(value, decimals = 1) {
  if (!(value === 0 || (value >= SMALLEST_REAL && value <= LARGEST_REAL)) || Object.is(value, -0)) {
    throw new RangeError(
      `Expected 0 or a real from ${SMALLEST_REAL} to ${LARGEST_REAL} (a sign is an operator), got ${shown(value)}.`,
    );
  }
  if (!Number.isInteger(decimals) || decimals < 1 || decimals > MAX_DECIMALS) {
    throw new RangeError(`Expected 1 to ${MAX_DECIMALS} decimals, got ${decimals}.`);
  }
  if (value !== 0 && (value < PLAIN_FROM || value >= PLAIN_BELOW)) {
    const [mantissa, exponent] = value.toExponential().split('e');
    return `${withDecimals(mantissa, 1)}E${exponent.replace('+', '')}`;
  }
  return withDecimals(String(value), decimals);
}

/** @param {string} text @param {number} decimals */
function withDecimals(text, decimals) {
  const [whole, fraction = ''] = text.split('.');
  return `${whole}.${fraction.padEnd(decimals, '0')}`;
}

const shown = (/** @type {number} */ value) => (Object.is(value, -0) ? '-0' : String(value));
