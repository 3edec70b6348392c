import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { createChain } from '../../../src/kinematics/chain.js';
import {
  bringInside,
  excessOf,
  fillRandomPosture,
  middlePosture,
  unwindTowards,
} from '../../../src/kinematics/limits.js';
import { createRandom } from '../../../src/kinematics/random.js';
import { worstExcess } from '../../../src/kinematics/descent/verdict.js';
import { SEED, runs } from '../../helpers/property.js';

const TURN = 2 * Math.PI;
/** One joint with these limits. @param {'revolute' | 'prismatic'} type @param {number} [lower] @param {number} [upper] */
const only = (type, lower, upper) =>
  createChain({ convention: 'standard', joints: [{ type, a: 1, alpha: 0, d: 0, theta: 0, lower, upper }] }).packed;

const anyLimits = fc
  .tuple(fc.double({ min: -7, max: 7, noNaN: true }), fc.double({ min: 0, max: 9, noNaN: true }))
  .map(([lower, width]) => ({ lower, upper: lower + width }));
const anyValue = fc.double({ min: -30, max: 30, noNaN: true });

describe('a value past its limits', () => {
  test('comes inside by full turns if any number of them does it, else to the limit that it went past', () => {
    fc.assert(
      fc.property(anyLimits, anyValue, ({ lower, upper }, value) => {
        const inside = bringInside(only('revolute', lower, upper), 0, value);
        expect(inside >= lower && inside <= upper).toBe(true);
        if (value >= lower && value <= upper) expect(inside).toBe(value);
        const turns = [...Array(20).keys()].map((k) => value + (k - 10) * TURN);
        const possible = turns.some((turned) => turned > lower + 1e-9 && turned < upper - 1e-9);
        if (possible) expect(Math.abs(Math.sin((inside - value) / 2))).toBeLessThan(1e-14);
        const slid = bringInside(only('prismatic', lower, upper), 0, value);
        expect(slid === Math.min(upper, Math.max(lower, value))).toBe(true); // minus zero is zero
      }),
      { seed: SEED, numRuns: runs(300) },
    );
  });
  test('is past by the least way there is back, full turns aside', () => {
    fc.assert(
      fc.property(anyLimits, anyValue, ({ lower, upper }, value) => {
        const turns = [...Array(20).keys()].map((k) => value + (k - 10) * TURN);
        const least = Math.min(...turns.map((turned) => Math.max(0, lower - turned, turned - upper)));
        const { by, bound } = excessOf(only('revolute', lower, upper), 0, value);
        expect(by).toBeCloseTo(least, 12);
        const limit = bound === 'lower' ? lower - by : upper + by;
        if (by > 1e-9) expect(Math.abs(Math.sin((limit - value) / 2))).toBeLessThan(1e-12);
        expect(excessOf(only('prismatic', lower, upper), 0, value).by).toBe(Math.max(0, lower - value, value - upper));
      }),
      { seed: SEED, numRuns: runs(300) },
    );
  });
  test('is nowhere past a side that has no limit', () => {
    expect(excessOf(only('revolute', 0), 0, -1)).toMatchObject({ by: 0 });
    expect(bringInside(only('revolute', 0), 0, -1)).toBeCloseTo(TURN - 1, 14);
    expect(excessOf(only('prismatic', 0), 0, -1)).toEqual({ by: 1, bound: 'lower' });
    expect(excessOf(only('prismatic', undefined, 2), 0, 2.5)).toEqual({ by: 0.5, bound: 'upper' });
    expect(excessOf(only('prismatic'), 0, 1e9)).toMatchObject({ by: 0 });
  });
  test('is worst where it would move the arm most: metres count by the characteristic length', () => {
    const limits = { lower: -1, upper: 1 };
    const chain = createChain({
      convention: 'standard',
      joints: [
        { type: 'revolute', a: 0.1, alpha: 0, d: 0, theta: 0, ...limits },
        { type: 'prismatic', a: 0.1, alpha: 0, d: 0, theta: 0, lower: 0, upper: 0.1 },
      ],
    });
    expect(chain.characteristicLength).toBeLessThan(0.2);
    expect(worstExcess(chain, [1.2, 0.15])).toMatchObject({ joint: 1, by: expect.closeTo(0.05, 12), bound: 'upper' });
    expect(worstExcess(chain, [-1.5, 0.15])).toMatchObject({ joint: 0, by: expect.closeTo(0.5, 12), bound: 'lower' });
    expect(worstExcess(chain, [1, 0.1])).toMatchObject({ by: 0 });
  });
});

test('unwinding changes a turning joint by full turns only, as near to the target as the limits allow', () => {
  fc.assert(
    fc.property(anyLimits, fc.double({ min: 0, max: 1, noNaN: true }), anyValue, ({ lower, upper }, part, target) => {
      const start = Math.min(upper, lower + part * (upper - lower));
      const q = Float64Array.of(start);
      unwindTowards(only('revolute', lower, upper), q, [target]);
      expect(q[0] >= lower && q[0] <= upper).toBe(true);
      expect(Math.abs(Math.sin((q[0] - start) / 2))).toBeLessThan(1e-14);
      for (const other of [q[0] - TURN, q[0] + TURN]) {
        if (other >= lower && other <= upper)
          expect(Math.abs(other - target)).toBeGreaterThan(Math.abs(q[0] - target) - 1e-12);
      }
      const slide = Float64Array.of(start);
      unwindTowards(only('prismatic', lower, upper), slide, [target]);
      expect(slide[0]).toBe(start);
    }),
    { seed: SEED, numRuns: runs(300) },
  );
});

test('the middle posture is the middle of the limits; with one side open it is zero, or the limit past zero', () => {
  expect(Array.from(middlePosture(only('revolute', -1, 2)))).toEqual([0.5]);
  expect(Array.from(middlePosture(only('prismatic')))).toEqual([0]);
  expect(Array.from(middlePosture(only('prismatic', 1)))).toEqual([1]);
  expect(Array.from(middlePosture(only('revolute', undefined, -2)))).toEqual([-2]);
  expect(Array.from(middlePosture(only('revolute', undefined, 2)))).toEqual([0]);
});

test('random postures are inside the limits, spread over all of them, and the same for the same seed', () => {
  /** @type {[ReturnType<typeof only>, number, number][]} */
  const cases = [
    [only('revolute', -1, 2), -1, 2],
    [only('revolute'), -Math.PI, Math.PI],
    [only('revolute', 1), 1, 1 + TURN],
    [only('prismatic', undefined, 1), -9, 1],
    [only('prismatic'), -5, 5],
  ];
  for (const [packed, low, high] of cases) {
    const draw = () => {
      const random = createRandom(7);
      return Array.from({ length: 400 }, () => {
        const q = new Float64Array(1);
        fillRandomPosture(packed, random, 5, q);
        return q[0];
      });
    };
    const values = draw();
    expect(Math.min(...values)).toBeGreaterThanOrEqual(low);
    expect(Math.max(...values)).toBeLessThanOrEqual(high);
    const inQuarters = [0, 1, 2, 3].map(
      (k) => values.filter((v) => Math.floor((4 * (v - low)) / (high - low)) === k).length,
    );
    for (const count of inQuarters) expect(count).toBeGreaterThan(60);
    expect(draw()).toEqual(values);
  }
});
