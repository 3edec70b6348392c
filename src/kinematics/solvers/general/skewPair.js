/**
 * The two joints a and b that an elimination begins with (elimination.js): what vanishes on all that they can do, and
 * how far their lines are from one plane.
 */
import { writeAnnihilator } from './annihilator.js';
import { conjugate, DQ, multiply } from './dualQuaternion.js';

/** Four vectors of which the volume, over the product of their lengths, is less than this are taken for dependent. */
const FLAT = 1e-5;

/**
 * The four forms that vanish on C, B C, C A and B C A.
 * @param {Float64Array} lines
 * @param {Int8Array} joints
 * @param {Float64Array} C
 * @param {Float64Array} forms  4 · 8, filled
 * @returns {boolean} false if the four are nearly dependent, as when the lines are nearly the same
 */
export function writeForms(lines, [a, , b], C, forms) {
  span.set(C);
  multiply(lines, DQ * b, C, 0, span, DQ);
  multiply(C, 0, lines, DQ * a, span, 2 * DQ);
  multiply(span, DQ, lines, DQ * a, span, 3 * DQ);
  return writeAnnihilator(span, forms) > FLAT;
}
const span = new Float64Array(4 * DQ);

/**
 * The moment of line a about line b once it is moved.
 * @param {Float64Array} lines
 * @param {Int8Array} joints
 * @param {Float64Array} C   inverse of the motion
 */
export function mutualMoment(lines, [a, , b], C) {
  conjugate(C, 0, moved, 0);
  multiply(moved, 0, lines, DQ * b, moved, DQ);
  multiply(moved, DQ, C, 0, moved, 2 * DQ);
  let sum = 0;
  for (let k = 1; k < 4; k++) {
    sum += lines[DQ * a + k] * moved[2 * DQ + 4 + k] + lines[DQ * a + 4 + k] * moved[2 * DQ + k];
  }
  return sum;
}
const moved = new Float64Array(3 * DQ);
