/** Contours of functions whose zeros are known: each piece keeps to its branch. */
import { describe, expect, test } from 'vitest';
import { contourPieces } from '../../../src/workspace/contour.js';

/** One square: both branches of a hyperbola go through it. */
const ONE = { low: [-1, -1], high: [1, 1], grid: 1 };

describe('two branches in one square', () => {
  test.each([0.3, -0.3, 0.1, -0.1])('of p q = %f are not taken for each other', (value) => {
    const of = (/** @type {number} */ p, /** @type {number} */ q) => p * q - value;
    const { pieces, between } = contourPieces(of, ONE);
    expect(pieces).toHaveLength(2);
    for (const [a, b] of pieces) {
      // the branches lie in opposite quadrants: all of one has the same signs
      expect(a.map(Math.sign)).toEqual(b.map(Math.sign));
      const middle = between(a, b);
      expect(middle?.map(Math.sign)).toEqual(a.map(Math.sign));
      expect(Math.abs(of(middle?.[0] ?? 9, middle?.[1] ?? 9))).toBeLessThan(1e-9);
    }
  });
});

test('a circle is one piece, all of it on the circle', () => {
  const of = (/** @type {number} */ p, /** @type {number} */ q) => p * p + q * q - 0.5;
  const { pieces } = contourPieces(of, { low: [-1, -1], high: [1, 1], grid: 15 });
  expect(pieces).toHaveLength(1);
  expect(pieces[0].at(0)).toBe(pieces[0].at(-1));
  for (const [p, q] of pieces[0]) expect(Math.abs(of(p, q))).toBeLessThan(1e-12);
});
