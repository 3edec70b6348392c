/** The quickest way through the phase plane, on grids so coarse that both ends of each interval have their say. */
import fc from 'fast-check';
import { expect, test } from 'vitest';
import { quickestProfile } from '../../../src/motion/phasePlane.js';
import { SEED, runs } from '../../helpers/property.js';

/** @import { Plane } from '../../../src/motion/phasePlane.js' */

const number = (/** @type {number} */ min, /** @type {number} */ max) => fc.double({ min, max, noNaN: true });
const WIDTHS = number(0.02, 0.5);

/** @returns {fc.Arbitrary<Plane>} */
const anyPlane = () =>
  fc
    .record({ dof: fc.integer({ min: 1, max: 4 }), widths: fc.array(WIDTHS, { minLength: 2, maxLength: 12 }) })
    .chain(({ dof, widths }) => {
      const count = widths.length;
      const list = (/** @type {number} */ length, /** @type {fc.Arbitrary<number>} */ one) =>
        fc.array(one, { minLength: length, maxLength: length }).map((values) => Float64Array.from(values));
      // a joint may turn back, stand, or go fast between points that are next to each other
      const slope = fc.oneof(number(-2, 2), fc.constant(0));
      return fc.record({
        grid: fc.constant(
          Float64Array.from([0, ...widths.map((_, i) => widths.slice(0, i + 1).reduce((a, b) => a + b))]),
        ),
        dof: fc.constant(dof),
        first: list(dof * (count + 1), slope),
        second: list(dof * (count + 1), number(-8, 8)),
        rates: list(dof, number(0.5, 3)),
        accelerations: list(dof, number(0.5, 8)),
        shares: list(count, fc.constantFrom(0.3, 1)),
        own: list(count, fc.constantFrom(1, Infinity)),
        ceiling: list(count + 1, fc.constantFrom(0.5, 4, 100)),
      });
    });

/** What of its limits a profile uses at most, at both ends of each interval. @param {Plane} plane @param {Float64Array} x */
function useOf({ grid, dof, first, second, rates, accelerations, shares, own, ceiling }, x) {
  let most = 0;
  x.forEach((square, i) => {
    most = Math.max(most, square / ceiling[i]);
    for (let j = 0; j < dof; j++) most = Math.max(most, (first[dof * i + j] ** 2 * square) / rates[j] ** 2);
  });
  for (let i = 0; i < shares.length; i++) {
    const u = (x[i + 1] - x[i]) / (2 * (grid[i + 1] - grid[i]));
    most = Math.max(most, Math.abs(u) / own[i]);
    for (const end of [i, i + 1]) {
      for (let j = 0; j < dof; j++) {
        const acceleration = first[dof * end + j] * u + second[dof * end + j] * x[end];
        most = Math.max(most, Math.abs(acceleration) / (shares[i] * accelerations[j]));
      }
    }
  }
  return most;
}

test('rates and accelerations are within the limits at both ends of each interval, and begin and end at rest', () => {
  fc.assert(
    fc.property(anyPlane(), (plane) => {
      const x = quickestProfile(plane);
      expect([x[0], x[x.length - 1]]).toEqual([0, 0]);
      for (const square of x) expect(square).toBeGreaterThanOrEqual(0);
      expect(useOf(plane, x)).toBeLessThan(1 + 1e-6);
    }),
    { seed: SEED, numRuns: runs(500) },
  );
});

test('none is quicker: to be faster at one point passes a limit there, or has no way on within them', () => {
  fc.assert(
    fc.property(anyPlane(), (plane) => {
      const x = quickestProfile(plane);
      for (const [i, square] of x.entries()) {
        if (i === 0 || i === x.length - 1) continue;
        expect(useOf(plane, x.with(i, square * 1.001 + 1e-6))).toBeGreaterThan(1 - 1e-6);
      }
    }),
    { seed: SEED, numRuns: runs(200) },
  );
});
