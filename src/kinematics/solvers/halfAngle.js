/** Where rounding alone may have parted two solutions that are one. */
const ROUNDING = 1.2e-14;

/** By how much a factor may be negative and still mean zero: what is nearly within reach is left to the caller's check. */
const NEARLY = 2e-9;

/**
 * The angle between 0 and π of which half has the squared tangent (a·b) / (c·d). For a triangle with sides a, b, c these
 * are the factors of Heron's formula: an angle near 0 or π keeps all its digits, which an arccosine would halve. An angle
 * that rounding cannot tell from 0 or π is exactly that.
 * @example
 * halfAngle(1, 1, 1, 1, 1) // → Math.PI / 2
 * halfAngle(-1e-17, 1, 1, 1, 1) // → 0
 * halfAngle(-1, 1, 1, 1, 1) // → NaN
 * @param {number} a  factors of the numerator
 * @param {number} b
 * @param {number} c  and of the denominator
 * @param {number} d
 * @param {number} scale  of the numbers that the factors are differences of
 * @returns {number} NaN if there is no such angle
 */
export function halfAngle(a, b, c, d, scale) {
  const above = clamped(a * b, scale * (Math.abs(a) + Math.abs(b)));
  const below = clamped(c * d, scale * (Math.abs(c) + Math.abs(d)));
  if (above < 0 || below < 0) return NaN;
  return 2 * Math.atan2(Math.sqrt(above), Math.sqrt(below));
}

/** @param {number} product @param {number} doubt  by how much it may be off, for factors off by 1 */
const clamped = (product, doubt) => (product < ROUNDING * doubt && product > -NEARLY * doubt ? 0 : product);
