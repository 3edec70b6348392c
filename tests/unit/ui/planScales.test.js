/** What plots of a program are made of: scales that hold their curves, round ticks, and the rows of the table beside them. */
import fc from 'fast-check';
import { expect, test } from 'vitest';
import { extentOf, linesOf, rowHeights } from '../../../src/ui/program/planDrawing.js';
import { rangeOf, ticksOf } from '../../../src/ui/program/planScale.js';
import { rowTimes } from '../../../src/ui/program/planTable.js';
import { SEED, runs } from '../../helpers/property.js';

/** @import { Column } from '../../../src/model/program/planColumns.js' */

/** @param {readonly number[]} values @param {Partial<Column>} [more] */
const column = (values, more = {}) =>
  /** @type {Column} */ ({
    ...{ name: 'J1', values: Float64Array.from(values), unit: 'deg', least: -Infinity, most: Infinity },
    ...more,
  });
const number = fc.double({ min: -1e4, max: 1e4, noNaN: true });

test('a scale holds all its curves with room at both sides, and is never narrower than what is shown at least', () => {
  fc.assert(
    fc.property(fc.array(fc.array(number, { minLength: 1 }), { minLength: 1, maxLength: 3 }), (all) => {
      const [least, most] = rangeOf(all.map((values) => column(values)), false, 2); // prettier-ignore
      const values = all.flat();
      expect(least).toBeLessThan(Math.min(...values));
      expect(most).toBeGreaterThan(Math.max(...values));
      expect(most - least).toBeGreaterThanOrEqual(2 - 1e-9);
    }),
    { seed: SEED, numRuns: runs(100) },
  );
  expect(rangeOf([column([])], true, 2)).toEqual([-1, 1]);
});

test('a limit is shown where a curve comes near it, or where limits are asked for, and else does not flatten the curve', () => {
  const near = rangeOf([column([0, 10], { least: -2, most: 500 })], false, 1);
  expect(near[0]).toBeLessThan(-2);
  expect(near[1]).toBeLessThan(20);
  expect(rangeOf([column([0, 10], { most: 500 })], true, 1)[1]).toBeGreaterThan(500);
});

test('ticks are round, evenly apart, inside the range, and no more than there is room for', () => {
  fc.assert(
    fc.property(number, fc.double({ min: 1e-3, max: 1e4, noNaN: true }), fc.integer({ min: 1, max: 12 }), (from, wide, most) => {
      const ticks = ticksOf([from, from + wide], most);
      expect(ticks.length).toBeLessThanOrEqual(most + 1);
      const slack = 1e-8 * (wide + Math.abs(from));
      for (const [i, tick] of ticks.entries()) {
        expect(tick).toBeGreaterThanOrEqual(from - slack);
        expect(tick).toBeLessThanOrEqual(from + wide + slack);
        if (i < 2) continue;
        expect(tick - ticks[i - 1]).toBeCloseTo(ticks[1] - ticks[0], 6);
      }
      if (ticks.length > 1) expect(String((ticks[1] - ticks[0]).toExponential(3))).toMatch(/^[125]\.000e/);
    }),
    { seed: SEED, numRuns: runs(100) },
  ); // prettier-ignore
  expect(ticksOf([0, 3.01], 6)).toEqual([0, 1, 2, 3]);
  expect(ticksOf([-0.3, 0.3], 6)).toEqual([-0.3, -0.2, -0.1, 0, 0.1, 0.2, 0.3]);
});

test('rows of the table are at every mark, evenly between, in order, none twice, and not too many', () => {
  fc.assert(
    fc.property(
      fc.double({ min: 0.1, max: 2e4, noNaN: true }),
      fc.array(fc.double({ min: 0, max: 1, noNaN: true }), { maxLength: 8 }),
      (duration, shares) => {
        const marks = [...new Set([0, ...shares.map((share) => share * duration), duration])].sort((a, b) => a - b);
        const times = rowTimes(duration, marks);
        for (const mark of marks) expect(times).toContain(mark);
        expect(times).toEqual([...times].sort((a, b) => a - b));
        expect(new Set(times).size).toBe(times.length);
        expect(times.length).toBeLessThanOrEqual(61 + marks.length);
        expect(times.at(-1)).toBe(duration);
      },
    ),
    { seed: SEED, numRuns: runs(100) },
  );
  expect(rowTimes(0.2, [0, 0.11, 0.2])).toEqual([0, 0.05, 0.1, 0.11, 0.15000000000000002, 0.2]);
});

test('a strip says how far its curve goes with the digits that tell its ends apart; strips are rows of their own', () => {
  expect(extentOf(Float64Array.of(-32.4, 57.6))).toBe('−32…58');
  expect(extentOf(Float64Array.of(0.01, 0.052))).toBe('0.010…0.052');
  expect(linesOf(extentOf(Float64Array.of(-32.4, 57.6)))).toEqual(['−32…58']);
  expect(linesOf(extentOf(Float64Array.of(-35266, 35260)))).toEqual(['35260', '−35266']); // side by side they would be cut off
  expect(linesOf(extentOf(Float64Array.of(-192, -167)))).toEqual(['−167', '−192']);
  expect(extentOf(Float64Array.of(5, 5))).toBe('5.0');
  const columns = [column([1]), column([2])];
  expect(rowHeights({ columns, isStrips: true }).rows).toHaveLength(2);
  expect(rowHeights({ columns, isStrips: false }).rows).toHaveLength(1);
});
