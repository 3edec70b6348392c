import fc from 'fast-check';
import { expect, test } from 'vitest';
import { solveAgain, solveCholesky } from '../../../src/kinematics/cholesky.js';
import { SEED, runs } from '../../helpers/property.js';

const anySystem = fc.integer({ min: 1, max: 8 }).chain((n) =>
  fc.record({
    n: fc.constant(n),
    entries: fc.array(fc.double({ min: -1, max: 1, noNaN: true }), { minLength: n * n, maxLength: n * n }),
    x: fc.array(fc.double({ min: -1, max: 1, noNaN: true }), { minLength: n, maxLength: n }),
  }),
);
/** AᵀA + 1. @param {number} n @param {number[]} A */
const definite = (n, A) =>
  Float64Array.from({ length: n * n }, (_, at) => {
    const [i, j] = [Math.floor(at / n), at % n];
    return [...Array(n).keys()].reduce((sum, k) => sum + A[k * n + i] * A[k * n + j], i === j ? 1 : 0);
  });

test('the solution of a definite system of any size is the one that it was made from, the lower triangle read alone', () => {
  fc.assert(
    fc.property(anySystem, ({ n, entries, x }) => {
      const H = definite(n, entries);
      const g = Float64Array.from({ length: n }, (_, i) => x.reduce((sum, value, j) => sum + H[i * n + j] * value, 0));
      for (let i = 0; i < n; i++) for (let j = i + 1; j < n; j++) H[i * n + j] = NaN;
      const found = new Float64Array(n);
      expect(solveCholesky(H, g, found)).toBe(true);
      found.forEach((value, i) => expect(Math.abs(value - x[i])).toBeLessThan(1e-12));
    }),
    { seed: SEED, numRuns: runs(200) },
  );
});

test('damping is added to the diagonal, and the system stays as it was, for the next try', () => {
  fc.assert(
    fc.property(anySystem, fc.double({ min: 0, max: 10, noNaN: true }), ({ n, entries, x }, damping) => {
      const H = definite(n, entries);
      const kept = H.slice();
      const g = Float64Array.from({ length: n }, (_, i) =>
        x.reduce((sum, value, j) => sum + (H[i * n + j] + (i === j ? damping : 0)) * value, 0),
      );
      const found = new Float64Array(n);
      expect(solveCholesky(H, g, found, damping)).toBe(true);
      found.forEach((value, i) => expect(Math.abs(value - x[i])).toBeLessThan(1e-12));
      expect(H).toEqual(kept);
    }),
    { seed: SEED, numRuns: runs(100) },
  );
});

test('another right side is solved by what is left of the last system of its size, in place too', () => {
  fc.assert(
    fc.property(anySystem, ({ n, entries, x }) => {
      const H = definite(n, entries);
      solveCholesky(H, new Float64Array(n), new Float64Array(n));
      const m = n === 6 ? 5 : 6;
      solveCholesky(definite(m, Array(m * m).fill(0)), new Float64Array(m), new Float64Array(m)); // of no matter
      const g = Float64Array.from({ length: n }, (_, i) => x.reduce((sum, value, j) => sum + H[i * n + j] * value, 0));
      const found = new Float64Array(n);
      solveAgain(g, found);
      solveAgain(g, g);
      found.forEach((value, i) => expect(Math.abs(value - x[i])).toBeLessThan(1e-12));
      expect(g).toEqual(found);
    }),
    { seed: SEED, numRuns: runs(100) },
  );
});

test('a system that is not definite, or not of numbers, is refused', () => {
  for (let n = 1; n <= 7; n++) {
    for (let bad = 0; bad < n; bad++) {
      for (const value of [0, -1, NaN]) {
        const H = definite(n, Array(n * n).fill(0));
        H[bad * n + bad] = value;
        expect(solveCholesky(H, new Float64Array(n), new Float64Array(n))).toBe(false);
      }
    }
  }
});
