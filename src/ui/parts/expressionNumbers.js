/** The numbers of expressions: what floating point would blur a little is kept sharp. */
import { toRadians } from '../../model/units.js';

/** A result that is as good as a short decimal is that decimal: 0.1 + 0.2 is 0.3. */
const SHORT_DIGITS = 12;
const NOISE = 4 * 2 ** -52;

/** @param {number} value */
export function tidy(value) {
  const short = Number(value.toPrecision(SHORT_DIGITS));
  return Math.abs(short - value) <= NOISE * Math.abs(value) ? short : value;
}

const QUARTER = 90;
/** sin of 0, 30, 60, … degrees, where it is a whole number or a half. */
const SINES = [0, 0.5, NaN, 1, NaN, 0.5, 0, -0.5, NaN, -1, NaN, -0.5];
const SINE_STEP = 30;
/** tan of 0, 45, 90, … degrees. */
const TANGENTS = [0, 1, NaN, -1];
const TANGENT_STEP = 45;

/**
 * @param {'sin' | 'cos' | 'tan'} name
 * @param {number} degrees
 * @returns {number} NaN where the tangent has no value
 */
export function turnFunction(name, degrees) {
  if (name === 'tan') {
    const steps = degrees / TANGENT_STEP;
    return Number.isInteger(steps) ? TANGENTS[modulo(steps, 4)] : Math.tan(toRadians(degrees % 360));
  }
  const steps = (degrees + (name === 'cos' ? QUARTER : 0)) / SINE_STEP;
  const known = Number.isInteger(steps) ? SINES[modulo(steps, 12)] : NaN;
  return Number.isNaN(known) ? Math[name](toRadians(degrees % 360)) : known;
}

/** @param {number} x @param {number} y */
const modulo = (x, y) => ((x % y) + y) % y;
