import { expect, test } from 'vitest';
import { createRandom } from '../../../src/kinematics/random.js';
import { doubleTurnRoots, polynomialRoots, quadraticRoots, turnRoots } from '../../../src/kinematics/solvers/roots.js';
import { SEED, runs } from '../../helpers/property.js';

const random = createRandom(SEED);
const wide = () => (random() < 0.5 ? -1 : 1) * 10 ** (4 * random() - 2);

/** Ascending coefficients of the product of (x − root). @param {readonly number[]} roots */
const polynomialOf = (roots) =>
  roots.reduce((p, root) => [...p, 0].map((_, i) => (p[i - 1] ?? 0) - root * (p[i] ?? 0)), [1]);

const sorted = (/** @type {readonly number[]} */ values) => values.toSorted((a, b) => a - b);

test('polynomials give back the roots that they are made of', () => {
  for (let i = 0; i < runs(200); i++) {
    const roots = sorted([wide(), wide(), wide(), wide()]);
    if (roots.some((root, k) => Math.abs(root - roots[k - 1]) < 0.05 * Math.abs(root))) continue;
    const found = sorted(polynomialRoots(polynomialOf(roots)));
    expect(found).toHaveLength(4);
    found.forEach((x, k) => expect(Math.abs(x / roots[k] - 1)).toBeLessThan(1e-6));
  }
});

test('polynomials without real roots have none; of lower degree fewer', () => {
  expect(polynomialRoots([2, 0, 3, 0, 1])).toEqual([]);
  expect(polynomialRoots([6, -5, 1, 0, 0])).toEqual([expect.closeTo(2, 12), expect.closeTo(3, 12)].toReversed());
  expect(polynomialRoots([1])).toEqual([]);
});

test('a double root is found once, even if rounding lifts it off', () => {
  for (const lift of [0, 1e-15, -1e-17, 1e-11]) {
    const p = polynomialOf([0.3, 0.3, -0.7, 2]);
    p[0] -= lift;
    const near = polynomialRoots(p).filter((x) => Math.abs(x - 0.3) < 1e-4);
    expect(near.length).toBeGreaterThan(0);
    if (Math.abs(lift) < 1e-14) expect(near).toHaveLength(1);
  }
});

test('sums of sines and cosines are zero where they should be', () => {
  for (let i = 0; i < runs(200); i++) {
    const [x, c1, s1, c2, s2] = [2 * Math.PI * random(), wide(), wide(), wide(), wide()];
    const at = (/** @type {number} */ y) =>
      c1 * Math.cos(y) + s1 * Math.sin(y) + c2 * Math.cos(2 * y) + s2 * Math.sin(2 * y);
    const found = doubleTurnRoots(-at(x), c1, s1, c2, s2);
    expect(found.length === 2 || found.length === 4).toBe(true);
    expect(Math.min(...found.map((y) => Math.abs(Math.sin((y - x) / 2))))).toBeLessThan(1e-5);
    const size = Math.abs(c1) + Math.abs(s1) + Math.abs(c2) + Math.abs(s2);
    for (const y of found) expect(Math.abs(at(y) - at(x)) / size).toBeLessThan(1e-13);
  }
  // Roots on the seams of the two half circles
  expect(sorted(doubleTurnRoots(0, 1, 0, 0, 0).map((x) => Math.cos(x)))).toEqual([
    expect.closeTo(0),
    expect.closeTo(0),
  ]);
  expect(doubleTurnRoots(1, 0, 0, 1, 0)).toHaveLength(2); // cos 2x = −1, twice, at ±90°
});

test('one turn: two angles, one at the edge, none beyond it', () => {
  expect(turnRoots(0, 2, 1).map(Math.sin)).toEqual([expect.closeTo(0.5), expect.closeTo(0.5)]);
  expect(turnRoots(3, 4, 5)).toEqual([Math.atan2(4, 3)]);
  expect(turnRoots(3, 4, 5 + 1e-12)).toHaveLength(1);
  expect(turnRoots(3, 4, -5)).toHaveLength(1);
  expect(turnRoots(3, 4, 5.001)).toEqual([]);
  // c is the difference of numbers that are far larger than it
  expect(turnRoots(1e-9, 0, 1e-9 + 1e-16)).toEqual([]);
  expect(turnRoots(1e-9, 0, 1e-9 + 1e-16, 1)).toHaveLength(1);
});

test('quadratic equations, also those that are linear', () => {
  expect(sorted(quadraticRoots(1, -3, 2))).toEqual([1, 2]);
  expect(quadraticRoots(0, 2, -1)).toEqual([0.5]);
  expect(quadraticRoots(0, 0, 1)).toEqual([]);
  expect(quadraticRoots(1, -2, 1)).toEqual([1]);
  expect(quadraticRoots(1, -2, 1 + 1e-12)).toHaveLength(1);
  expect(quadraticRoots(1, 0, 1)).toEqual([]);
  // Both to the last digits, though one is far smaller
  expect(sorted(quadraticRoots(1, -1e8, 1))[0]).toBe(1e-8);
});
