import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import {
  compose,
  identity,
  invert,
  isPose,
  poseDifference,
  position,
  requirePose,
  translation,
} from '../../../src/kinematics/pose.js';
import { SEED, runs } from '../../helpers/property.js';
import { anyPose, columnMajor, largestDifference, rigid, rodrigues, rowsOf, times } from './oracle.js';

const anyAxis = fc
  .array(fc.double({ min: -1, max: 1, noNaN: true }), { minLength: 3, maxLength: 3 })
  .filter((axis) => Math.hypot(...axis) > 0.1);
/** Angles of every size: down to 1e-12 from none and from half a turn. */
const anyTurn = fc
  .tuple(fc.double({ min: -12, max: 0, noNaN: true }), fc.boolean())
  .map(([exponent, fromHalf]) => (fromHalf ? Math.PI - 10 ** exponent : 10 ** exponent));
const unit = (/** @type {number[]} */ axis) => axis.map((value) => value / Math.hypot(...axis));

describe('composition', () => {
  test('is the matrix product', () => {
    fc.assert(
      fc.property(anyPose, anyPose, (A, B) => {
        expect(largestDifference(rowsOf(compose(A, B)), times(rowsOf(A), rowsOf(B)))).toBeLessThan(2e-15);
      }),
      { seed: SEED, numRuns: runs(100) },
    );
  });
  test('may write over either of its inputs', () => {
    fc.assert(
      fc.property(anyPose, anyPose, (A, B) => {
        const product = compose(A, B);
        expect(compose(A.slice(), B, undefined)).toEqual(product);
        const left = A.slice();
        expect(compose(left, B, left)).toEqual(product);
        const right = B.slice();
        expect(compose(A, right, right)).toEqual(product);
      }),
      { seed: SEED, numRuns: runs(50) },
    );
  });
  test('with the inverse, on either side and in place, is the identity', () => {
    fc.assert(
      fc.property(anyPose, (T) => {
        for (const product of [compose(T, invert(T)), compose(invert(T), T), compose(T, invert(T.slice()))]) {
          expect(largestDifference(rowsOf(product), rowsOf(identity()))).toBeLessThan(4e-15);
        }
        const own = T.slice();
        expect(invert(own, own)).toEqual(invert(T));
      }),
      { seed: SEED, numRuns: runs(100) },
    );
  });
});

describe('the difference of two poses', () => {
  test('is the axis times the angle that Rodrigues turned by, for every size of angle', () => {
    fc.assert(
      fc.property(anyPose, anyAxis, anyTurn, (T_a_from, axis, angle) => {
        const turn = rodrigues(axis, angle);
        const T_a_to = columnMajor(times(rigid(turn, [0, 0, 0]), rowsOf(T_a_from)));
        const found = poseDifference(T_a_from, T_a_to).subarray(3);
        const wanted = unit(axis).map((value) => value * angle);
        // 1e-15 of rounding in the matrices, whatever the angle: no digits of a small one are lost, nor of a half turn
        expect(Math.hypot(...wanted.map((value, k) => value - found[k]))).toBeLessThan(4e-15);
      }),
      { seed: SEED, numRuns: runs(500) },
    );
  });
  test('at exactly a half turn about x, y, z and between them is π about that axis, either way', () => {
    for (const axis of [
      [1, 0, 0],
      [0, 1, 0],
      [0, 0, 1],
      [1, 1, 0],
      [0, -1, 1],
      [1, 2, -3],
    ]) {
      const [x, y, z] = unit(axis);
      const half = [[x, y, z].map((v) => 2 * v * x), [x, y, z].map((v) => 2 * v * y), [x, y, z].map((v) => 2 * v * z)];
      half.forEach((row, i) => (row[i] -= 1)); // 2uuᵀ − 1: not a sine of π in it
      const found = Array.from(poseDifference(identity(), columnMajor(rigid(half, [0, 0, 0]))).subarray(3));
      expect(Math.hypot(...found)).toBeCloseTo(Math.PI, 14);
      expect(Math.abs(found.reduce((sum, value, k) => sum + value * [x, y, z][k], 0))).toBeCloseTo(Math.PI, 14);
    }
  });
  test('is never more than a half turn, and takes the one pose to the other', () => {
    fc.assert(
      fc.property(anyPose, anyPose, (A, B) => {
        const [x, y, z, ...turn] = poseDifference(A, B);
        const angle = Math.hypot(...turn);
        expect(angle).toBeLessThanOrEqual(Math.PI + 1e-15);
        const R = angle === 0 ? rodrigues([1, 0, 0], 0) : rodrigues(turn, angle);
        const turned = times(rigid(R, [0, 0, 0]), rowsOf(A));
        const arrived = turned.map((row, i) =>
          row.map((value, j) => (j === 3 && i < 3 ? A[12 + i] + [x, y, z][i] : value)),
        );
        expect(largestDifference(arrived, rowsOf(B))).toBeLessThan(1e-14);
      }),
      { seed: SEED, numRuns: runs(300) },
    );
  });
  test('between a pose and itself is nothing', () => {
    expect(Array.from(poseDifference(identity(), identity()), Math.abs)).toEqual([0, 0, 0, 0, 0, 0]);
  });
});

describe('what is not a pose', () => {
  const broken = (/** @type {(T: Float64Array) => void} */ change) => {
    const T = translation([1, 2, 3]);
    change(T);
    return T;
  };
  test.each([
    ['12 numbers', new Float64Array(12), 'got 12 numbers'],
    ['a NaN', broken((T) => (T[13] = NaN)), 'got NaN at index 13'],
    ['infinity', broken((T) => (T[12] = Infinity)), 'got Infinity at index 12'],
    [
      'a row-major matrix',
      Float64Array.of(1, 0, 0, 5, 0, 1, 0, 6, 0, 0, 1, 7, 0, 0, 0, 1),
      'got a bottom row of 5 6 7 1 (is the matrix row-major?)',
    ],
    ['a stretched axis', broken((T) => (T[0] = 1 + 2e-6)), 'from orthonormal'],
    ['a skewed axis', broken((T) => (T[1] = 3e-6)), 'from orthonormal'],
    ['a mirror', broken((T) => (T[10] = -1)), 'got left-handed axes'],
  ])('%s is refused with what came', (_, T, words) => {
    expect(isPose(T)).toBe(false);
    expect(() => requirePose(T, 'the goal')).toThrow(RangeError);
    expect(() => requirePose(T, 'the goal')).toThrow('Expected the goal to be a pose');
    expect(() => requirePose(T, 'the goal')).toThrow(words);
  });
  test.each([[undefined], [null], [7], ['pose']])('%s is refused as of the wrong type', (value) => {
    const T = /** @type {ArrayLike<number>} */ (/** @type {unknown} */ (value));
    expect(() => requirePose(T, 'the tool')).toThrow(TypeError);
  });
  test('six decimals are good enough for a pose', () => {
    fc.assert(
      fc.property(anyPose, (T) => {
        const typed = T.map((value) => Number(value.toFixed(6)));
        expect(requirePose(typed, 'the base')).toBe(typed);
      }),
      { seed: SEED, numRuns: runs(200) },
    );
  });
});

test('position reads what translation wrote', () => {
  expect(position(translation([1, 2, 3]))).toEqual([1, 2, 3]);
});
