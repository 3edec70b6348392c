import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { circleZeros, COUNT, DEGREE, evaluate } from '../../../src/kinematics/solvers/general/circleRoots.js';
import { SEED, runs } from '../../helpers/property.js';

/**
 * Π sin((θ − θ_i) / 2) over sixteen θ_i, complex ones in pairs, as coefficients: from values, by the sums of Fourier.
 * @param {number[]} real
 * @param {[number, number][]} complex  real and imaginary part of one of each pair
 */
function polynomialWith(real, complex) {
  const at = (/** @type {number} */ angle) =>
    real.reduce((product, zero) => product * Math.sin((angle - zero) / 2), 1) *
    complex.reduce((product, [x, y]) => product * (Math.cosh(y) - Math.cos(angle - x)), 1);
  const samples = Array.from({ length: 64 }, (_, k) => [(2 * Math.PI * k) / 64, at((2 * Math.PI * k) / 64)]);
  return Float64Array.from({ length: COUNT }, (_, i) => {
    const k = Math.ceil(i / 2);
    const wave = (/** @type {number} */ angle) => (i % 2 ? Math.cos(k * angle) : Math.sin(k * angle));
    return samples.reduce((sum, [angle, value]) => sum + value * (i === 0 ? 1 : 2 * wave(angle)), 0) / samples.length;
  });
}

const anyAngle = fc.double({ min: 0, max: 6.28, noNaN: true });
const complexZero = fc.tuple(anyAngle, fc.double({ min: 0.05, max: 2, noNaN: true }));
const turned = (/** @type {number} */ angle) => Math.atan2(Math.sin(angle), Math.cos(angle));
const largest = (/** @type {Float64Array} */ c) => Math.max(...c.map(Math.abs));

describe('the zeros of a trigonometric polynomial', () => {
  test('are all found, and no others', () => {
    const gap = fc.double({ min: 0.05, max: 1, noNaN: true });
    const zeros = fc.integer({ min: 0, max: DEGREE }).chain((pairs) =>
      fc.tuple(
        fc.array(gap, { minLength: 2 * (DEGREE - pairs), maxLength: 2 * (DEGREE - pairs) }).map((gaps) => {
          const whole = gaps.reduce((sum, part) => sum + part, 0);
          return gaps.map((_, i) => (gaps.slice(0, i).reduce((sum, part) => sum + part, 0.2) / whole) * 2 * Math.PI);
        }),
        fc.array(complexZero, { minLength: pairs, maxLength: pairs }),
      ),
    );
    fc.assert(
      fc.property(zeros, ([real, complex]) => {
        const c = polynomialWith(real, complex);
        const found = circleZeros(c, 1e-14 * largest(c));
        // where the polynomial is tiny on a whole arc nothing can be told, and that is said
        const doubt = found.filter(({ count }) => count > 1);
        for (const zero of real) {
          const near = found.some(({ angle, width }) => Math.abs(turned(angle - zero)) < 1e-9 + 4 * width);
          expect(near).toBe(true);
        }
        if (doubt.length === 0) expect(found.length).toBe(real.length);
        for (let i = 1; i < found.length; i++) expect(found[i].angle).toBeGreaterThan(found[i - 1].angle);
      }),
      { seed: SEED, numRuns: runs(150) },
    );
  });
  test('sixteen of them, evenly spaced, to the last digits; also where an arc begins', () => {
    for (const shift of [0, 0.3713, 1]) {
      const real = Array.from({ length: 16 }, (_, k) => shift + (k * Math.PI) / 8);
      const c = polynomialWith(real, []);
      const found = circleZeros(c, 1e-15 * largest(c));
      expect(found.length).toBe(16);
      for (const { angle, count } of found) {
        expect(count).toBe(1);
        expect(Math.min(...real.map((zero) => Math.abs(turned(zero - angle))))).toBeLessThan(1e-13);
      }
    }
  });
  test('two too near to be told apart are a cluster of two, whether they touch, cross or miss, and wherever', () => {
    for (const place of [2, 0.3713]) {
      for (const [real, complex] of /** @type {[number[], [number, number][]][]} */ ([
        [[place, place], []],
        [[place, place + 1e-8], []],
        [[], [[place, 1e-8]]],
      ])) {
        const c = polynomialWith([1, 4, ...real], [...complex, ...Array(6).fill([3, 1])]);
        const found = circleZeros(c, 1e-13 * largest(c));
        expect(found.map(({ count }) => count).toSorted()).toEqual([1, 1, 2]);
        const cluster = found.find(({ count }) => count === 2);
        expect(turned((cluster?.angle ?? 0) - place)).toBeCloseTo(0, 4);
      }
    }
  });
  test('two that stand out of the noise are two', () => {
    const c = polynomialWith([0.5, 4, 2, 2.001], Array(6).fill([3, 1]));
    expect(circleZeros(c, 1e-13 * largest(c)).map(({ count }) => count)).toEqual([1, 1, 1, 1]);
  });
  test('more than two in one place are a cluster of any number', () => {
    const c = polynomialWith([1, 4, 2, 2, 2, 2], Array(5).fill([3, 1]));
    expect(circleZeros(c, 1e-12 * largest(c)).map(({ count }) => count)).toEqual([1, Infinity, 1]);
  });
  test('of nothing but noise are one cluster all around', () => {
    const all = circleZeros(new Float64Array(COUNT), 1e-12);
    expect(all.every(({ count }) => count === Infinity)).toBe(true);
  });
});

test('the derivatives are those of the polynomial', () => {
  const c = polynomialWith([1, 2, 3, 4], Array(6).fill([2.5, 1]));
  for (const angle of [0, 1.3, 5]) {
    const [, slope, bend] = evaluate(c, angle).slice();
    const [more, less] = [angle + 1e-5, angle - 1e-5].map((at) => evaluate(c, at).slice());
    expect(slope).toBeCloseTo((more[0] - less[0]) / 2e-5, 6);
    expect(bend).toBeCloseTo((more[1] - less[1]) / 2e-5, 6);
  }
});
