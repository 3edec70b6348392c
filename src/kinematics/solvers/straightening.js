/**
 * Two singularities at once, in arms with three parallel axes (threeParallel.js): next to the wrist being in line φ has few
 * digits, and a straight or folded elbow then seems to be out of reach by more than rounding, though it is not.
 *
 * @import { ThreeParallel } from './threeParallelLines.js'
 */

/** What rounding leaves of φ, times the sine by which axis 6 is out of line: the nearer to being in line, the fewer digits. */
const NOISE = 2 ** -47;

/** Here φ has its digits. */
const MUCH_OUT_OF_LINE = 1e-3;

/** Of Newton's method, which doubles the digits. */
const STEPS = 4;

/** By how much φ may be off, in radians. @param {number} tilt  the sine by which axis 6 is out of line */
export const sumSlack = (tilt) => (tilt < MUCH_OUT_OF_LINE ? NOISE / tilt : 0);

/**
 * What brings φ to where the links just reach, if they seem not to and that is within the slack; else 0. It moves the tool by
 * nothing that counts, since the wrist is nearly in line there.
 * @param {ThreeParallel} arm
 * @param {ArrayLike<number>} wrist  where c has to be, of which x and y count
 * @param {number} sum  φ
 * @param {number} slack
 */
export function straightening({ upper, fore, offset }, wrist, sum, slack) {
  let by = 0;
  for (let steps = 0; steps < STEPS && slack > 0; steps++) {
    const cos = Math.cos(sum + by);
    const sin = Math.sin(sum + by);
    const x = wrist[0] - cos * offset[0] + sin * offset[1];
    const y = wrist[1] - sin * offset[0] - cos * offset[1];
    const reach = Math.sqrt(x * x + y * y);
    const edge = Math.min(upper + fore, Math.max(Math.abs(upper - fore), reach));
    if (reach === edge) break;
    const rate = (x * (sin * offset[0] + cos * offset[1]) + y * (sin * offset[1] - cos * offset[0])) / reach;
    by += (edge - reach) / rate;
    if (!(Math.abs(by) <= slack)) return 0;
  }
  return by;
}
