/**
 * How far the tool can be off a way between two postures that are on it, with the same rates and accelerations of the tool
 * there: a bound, not a sample. What is off vanishes at both ends with its first two derivatives, so it is at most 1/46080 of
 * its largest sixth derivative in between (λ³(1 − λ)³/6! is at most that), and what did not quite vanish adds a little.
 *
 * A product of turns by angles whose k-th derivatives are at most xₖ has a k-th derivative of at most Bₖ(x), the complete
 * Bell polynomial, where the xₖ of all angles add up: derivatives of exp(Σ angle) would be no smaller. A place that is turned
 * by joint j last lies ρⱼ from its axis, so the sixth derivative of the place is at most Σⱼ ρⱼ (B₆ up to j − B₆ up to j − 1).
 * Derivation: docs/model.md, "Motion".
 *
 * @import { Chain } from '../kinematics/chain.js'
 * @import { ToolPath } from './toolPath.js'
 * @import { Span } from './hermite.js'
 */
import { createSpan, writeSpan } from './hermite.js';
import { TERMS } from './posturePath.js';

const SIXTH = 1 / 46080;

/** How much of first and second derivatives that did not vanish at the ends is seen in between. */
const FIRST = 5 / 16;
const SECOND = 1 / 32;

/** Derivatives that are bounded: up to the sixth. */
const ORDER = 6;

const BINOMIAL = [
  [1],
  [1, 1],
  [1, 2, 1],
  [1, 3, 3, 1],
  [1, 4, 6, 4, 1],
  [1, 5, 10, 10, 5, 1],
  [1, 6, 15, 20, 15, 6, 1],
];

/**
 * B₀ … B₆ of the sizes of the first five derivatives, of which the sixth is 0.
 * @param {Float64Array} x   [k]: of the k-th; [0] is not looked at
 * @param {Float64Array} B   7, filled
 */
export function writeBell(x, B) {
  B[0] = 1;
  for (let n = 1; n <= ORDER; n++) {
    const row = BINOMIAL[n - 1];
    let sum = 0;
    for (let k = 1; k <= n && k < TERMS; k++) sum += row[k - 1] * B[n - k] * x[k];
    B[n] = sum;
  }
}

/** @param {Chain} chain */
export function createPathBound(chain) {
  const { dof, joints } = chain;
  const slides = joints.map(({ type }) => type === 'prismatic');
  const spans = joints.map(createSpan);
  const levers = new Float64Array(dof);
  const sums = new Float64Array(TERMS);
  const B = new Float64Array(ORDER + 1);

  return {
    /** Of each joint on the piece that was bounded last. */
    spans,

    /**
     * @param {Float64Array} coefficients   of the piece
     * @param {Float64Array} J     at its beginning
     * @param {ToolPath} path
     * @param {number} from  share
     * @param {number} to
     * @param {{ position: number, turn: number }} out   filled: m, rad
     */
    write(coefficients, J, path, from, to, out) {
      for (let i = 0; i < dof; i++) writeSpan(coefficients, TERMS * i, spans[i]);
      let moved = 0; // how far the joints beyond can move the tool as seen from this one
      for (let i = dof - 1; i >= 0; i--) {
        levers[i] = slides[i] ? 1 : Math.hypot(J[6 * i], J[6 * i + 1], J[6 * i + 2]) + moved;
        moved += spans[i].derivatives[0] * levers[i];
      }
      sums.fill(0);
      writeBell(sums, B);
      let place = path.sixthOfPlace(from, to);
      for (let i = 0; i < dof; i++) {
        const { derivatives } = spans[i];
        if (slides[i]) {
          for (let k = 0; k < ORDER; k++)
            if (ORDER - k < TERMS) place += BINOMIAL[ORDER][k] * B[k] * derivatives[ORDER - k];
          continue;
        }
        const before = B[ORDER];
        for (let k = 1; k < TERMS; k++) sums[k] += derivatives[k];
        writeBell(sums, B);
        place += levers[i] * (B[ORDER] - before);
      }
      path.addTurning(from, to, sums);
      writeBell(sums, B);
      out.position = place * SIXTH;
      out.turn = B[ORDER] * SIXTH;
    },
  };
}

/** What is added where values, first and second derivatives by λ are not quite those of the way. @param {number} value @param {number} first @param {number} second */
export const unsolved = (value, first, second) => value + FIRST * first + SECOND * second;
