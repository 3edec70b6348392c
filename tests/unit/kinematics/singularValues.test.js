import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { createSvd, decompose } from '../../../src/kinematics/measures/singularValues.js';
import { SEED, runs } from '../../helpers/property.js';
import { times, transpose } from './oracle.js';

/** @import { Matrix } from './oracle.js' */

/** Column-major → rows. @param {ArrayLike<number>} A @param {number} rows @param {number} columns @returns {Matrix} */
const rowsOf = (A, rows, columns) =>
  Array.from({ length: rows }, (_, i) => Array.from({ length: columns }, (_, j) => A[j * rows + i]));
/** @param {Matrix} rows */
const svdOf = (rows) => {
  const [m, n] = [rows.length, rows[0].length];
  return decompose(transpose(rows).flat(), createSvd(m, n));
};
/** @param {Matrix} A @param {Matrix} B */
const apart = (A, B) => Math.max(...A.flatMap((row, i) => row.map((value, j) => Math.abs(value - B[i][j]))));
/** @param {number} n @returns {Matrix} */
const unit = (n) => Array.from({ length: n }, (_, i) => Array.from({ length: n }, (_, j) => Number(i === j)));

/** Entries of any size, columns of very different sizes, columns that repeat: what Jacobians are like, and worse. */
const anyMatrix = fc
  .record({
    rows: fc.integer({ min: 1, max: 7 }),
    columns: fc.integer({ min: 1, max: 7 }),
    entries: fc.array(fc.double({ min: -1, max: 1, noNaN: true }), { minLength: 49, maxLength: 49 }),
    powers: fc.array(fc.integer({ min: -20, max: 3 }), { minLength: 7, maxLength: 7 }),
    copies: fc.array(fc.option(fc.integer({ min: 0, max: 6 }), { freq: 4 }), { minLength: 7, maxLength: 7 }),
    isEven: fc.boolean(),
  })
  .map(({ rows, columns, entries, powers, copies, isEven }) => {
    const from = copies.map((copy, j) => (copy === null || copy >= columns ? j : copy));
    return Array.from({ length: rows }, (_, i) =>
      Array.from({ length: columns }, (_, j) => entries[7 * i + from[j]] * (isEven ? 1 : 10 ** powers[j])),
    );
  });

describe('any matrix up to 7 × 7', () => {
  test('is put together again from U, Σ and Vᵀ, and U and V are orthogonal', () => {
    fc.assert(
      fc.property(anyMatrix, (A) => {
        const [m, n] = [A.length, A[0].length];
        const { values, U, V } = svdOf(A);
        const [UU, VV] = [rowsOf(U, m, m), rowsOf(V, n, n)];
        expect(apart(times(transpose(UU), UU), unit(m))).toBeLessThan(2e-14);
        expect(apart(times(transpose(VV), VV), unit(n))).toBeLessThan(2e-14);
        const S = Array.from({ length: m }, (_, i) => Array.from({ length: n }, (_, j) => (i === j ? values[i] : 0)));
        const largest = Math.max(...A.flat().map(Math.abs));
        expect(apart(times(times(UU, S), transpose(VV)), A)).toBeLessThanOrEqual(1e-14 * largest);
        values.forEach((value, i) => expect(value >= 0 && (i === 0 || value <= values[i - 1])).toBe(true));
      }),
      { seed: SEED, numRuns: runs(400) },
    );
  });
  test('has the singular values of its transpose', () => {
    fc.assert(
      fc.property(anyMatrix, (A) => {
        const [a, b] = [svdOf(A).values, svdOf(transpose(A)).values];
        a.forEach((value, i) => expect(Math.abs(value - b[i])).toBeLessThanOrEqual(1e-14 * a[0]));
      }),
      { seed: SEED, numRuns: runs(200) },
    );
  });
});

describe('singular values computed elsewhere: mpmath 1.3.0 with 60 digits, and numpy 2.4.6 as far as it goes', () => {
  const B = [
    [-0.352, -0.698, 0.302, -0.855, 0.072, -0.269],
    [-0.884, 0.015, -0.925, -0.133, -0.86, -0.819],
    [-0.151, 0.654, -0.752, -0.554, 0.255, 0.895],
    [0.154, -0.207, 0.953, -0.907, 0.717, -0.421],
    [-0.711, -0.764, -0.383, 0.632, -0.639, 0.163],
    [0.278, -0.255, 0.095, -0.874, -0.881, -0.588],
  ];
  const sizes = [1, 1e-3, 1e-6, 1e-10, 1e-14, 1e-18];
  const graded = B.map((row) => row.map((value, j) => value * sizes[j]));
  const wide = [
    [0.361, -0.145, -0.372, 0.171, -0.094, -0.4, 0.589],
    [0.398, -0.512, 0.149, 0.05, 0.75, 0.459, -0.424],
    [0.96, -0.764, -0.164, 0.514, -0.696, -0.022, -0.922],
    [0.336, 0.529, 0.146, 0.751, -0.373, 0.391, 0.189],
    [0.16, -0.088, 0.68, 0.889, -0.052, 0.328, -0.879],
    [0.403, 0.294, 0.986, 0.644, -0.431, -0.228, 0.337],
  ];
  const tall = [
    [-0.955, -0.077, -0.664, -0.766],
    [-0.882, 0.536, -0.741, -0.505],
    [-0.218, 0.743, -0.839, -0.102],
    [0.099, 0.767, 0.639, 0.728],
    [-0.443, -0.169, -0.282, 0.768],
    [0.915, -0.698, -0.648, -0.536],
  ];
  /** @type {[string, Matrix, number[]][]} */
  const cases = [
    [
      'columns from 1 down to 1e-18, each to its last digits',
      graded,
      [
        1.2388229150190697, 0.001179805326638166, 7.889074617413848e-7, 1.627019523126531e-10, 7.352008131544998e-15,
        3.446375712543127e-19,
      ],
    ],
    [
      '6 × 7',
      wide,
      [
        2.213420214903226, 1.6824937352500877, 1.3312925961887658, 0.8237506330902531, 0.7287889822997692,
        0.33782143241187923,
      ],
    ],
    ['6 × 4', tall, [2.162829078545482, 1.793577616364925, 0.9781362512494796, 0.8599483618592624]],
  ];
  test.each(cases)('%s', (_, A, wanted) => {
    svdOf(A).values.forEach((value, i) => expect(Math.abs(value / wanted[i] - 1)).toBeLessThan(4e-15));
  });
  test("Hilbert's matrix, whose columns are nearly parallel: to the rounding of the largest", () => {
    const A = B.map((_, i) => B.map((_, j) => 1 / (i + j + 1)));
    const wanted = [
      1.618899858924339, 0.24236087057520955, 0.016321521319875826, 0.0006157483541826453, 1.2570757122637029e-5,
      1.082799484481101e-7,
    ];
    svdOf(A).values.forEach((value, i) => expect(Math.abs(value - wanted[i])).toBeLessThan(1e-15));
  });
});

describe('edges', () => {
  test('nothing but zeros: no singular value, and U and V are still orthogonal', () => {
    const { values, U, V } = decompose(new Float64Array(18), createSvd(6, 3));
    expect(Array.from(values)).toEqual([0, 0, 0]);
    expect(rowsOf(U, 6, 6)).toEqual(unit(6));
    expect(rowsOf(V, 3, 3)).toEqual(unit(3));
  });
  test('very large and very small entries neither overflow nor vanish', () => {
    for (const size of [1e-280, 1e280]) {
      const { values } = svdOf([
        [3 * size, 0],
        [4 * size, 0],
        [0, size],
      ]);
      expect(values[0] / size).toBeCloseTo(5, 12);
      expect(values[1] / size).toBeCloseTo(1, 12);
    }
  });
  test('what was in the room does not matter', () => {
    const svd = createSvd(2, 2);
    const first = Array.from(decompose([1, 2, 3, 4], svd).U);
    decompose([0, 0, 0, 0], svd);
    expect(Array.from(decompose([1, 2, 3, 4], svd).U)).toEqual(first);
  });
});
