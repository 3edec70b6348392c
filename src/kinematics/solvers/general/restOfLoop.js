/**
 * The three joints d, e and f that an elimination sets against a and b (elimination.js), with the hidden joint and the goal
 * where they stand next to these. All of it is of the pose under way.
 *
 * @typedef {'between' | 'before' | 'after'} Order   where h is: between a and b, or before or after d, e and f
 *
 * @typedef {object} Cut   how the loop is cut into two parts
 * @property {Order} order
 * @property {Int8Array} joints   a, h, b, d, e, f, from 0
 * @property {number} hidden      h
 * @property {boolean} isCut      the goal is between a and b
 */
import { COEFFICIENTS } from './dixon.js';
import { conjugate, DQ, multiply, turn } from './dualQuaternion.js';

/** The eight products of 1 or line of d, e and f. */
export const products = new Float64Array(COEFFICIENTS * DQ);

const inverseGoal = new Float64Array(DQ);
const held = new Float64Array(DQ);
const factor = new Float64Array(DQ);

/** @param {Float64Array} goal */
export const setGoal = (goal) => conjugate(goal, 0, inverseGoal, 0);

/**
 * @param {Cut} cut
 * @param {Float64Array} lines
 */
export function writeProducts({ joints, order }, lines) {
  products.fill(0, 0, DQ);
  products[0] = 1;
  let count = 1;
  for (let k = 3; k < 6; k++) {
    if (joints[k] === 0) passGoal(count);
    for (let m = 0; m < count; m++) multiply(products, DQ * m, lines, DQ * joints[k], products, DQ * (count + m));
    count *= 2;
  }
  if (joints[5] === 5 && order !== 'after') passGoal(count);
}

/** The loop is cut between joint 6 and joint 1. @param {number} count  products made so far */
function passGoal(count) {
  for (let m = 0; m < count; m++) {
    for (let k = 0; k < DQ; k++) held[k] = products[DQ * m + k];
    multiply(held, 0, inverseGoal, 0, products, DQ * m);
  }
}

/**
 * The hidden joint's own motion, and the goal if it is next to that, into `factor`.
 * @param {Cut} cut
 * @param {Float64Array} lines
 * @param {number} angle
 */
export function writeFactor({ order, hidden }, lines, angle) {
  turn(lines, DQ * hidden, Math.cos(angle / 2), Math.sin(angle / 2), factor, 0);
  held.set(factor);
  if (hidden === 0) multiply(inverseGoal, 0, held, 0, factor, 0);
  else if (hidden === 5 && order === 'after') multiply(held, 0, inverseGoal, 0, factor, 0);
}

/**
 * out[k …] = what d, e and f do, of which `products` number m is a part, with the hidden joint's motion.
 * @param {Order} order
 * @param {Float64Array} motion
 * @param {number} m
 * @param {Float64Array} out
 */
export function withFactor(order, motion, m, out) {
  if (order === 'before') multiply(factor, 0, motion, m, out, 0);
  else if (order === 'after') multiply(motion, m, factor, 0, out, 0);
  else for (let k = 0; k < DQ; k++) out[k] = motion[m + k];
}

/**
 * What d, e and f have to do together with h: the inverse of a C b. Of the pose under way, as are the next two.
 * @param {Cut} cut
 * @param {Float64Array} lines
 * @param {number} angle  of h
 * @param {(m: number) => number} shareOf  of each of the eight products
 * @param {Float64Array} out
 */
export function writeRest(cut, lines, angle, shareOf, out) {
  sum.fill(0);
  for (let m = 0; m < COEFFICIENTS; m++) {
    const share = shareOf(m);
    for (let k = 0; k < DQ; k++) sum[k] += share * products[DQ * m + k];
  }
  if (cut.order !== 'between') writeFactor(cut, lines, angle);
  withFactor(cut.order, sum, 0, out);
}
const sum = new Float64Array(DQ);

/**
 * What is between a and b.
 * @param {Cut} cut
 * @param {Float64Array} lines
 * @param {number} angle
 * @param {Float64Array} out
 */
export function writeBetween({ order, hidden, isCut }, lines, angle, out) {
  if (order === 'between') turn(lines, DQ * hidden, Math.cos(angle / 2), Math.sin(angle / 2), out, 0);
  else if (isCut) out.set(inverseGoal);
  else out.set(UNIT);
}
const UNIT = Float64Array.of(1, 0, 0, 0, 0, 0, 0, 0);
