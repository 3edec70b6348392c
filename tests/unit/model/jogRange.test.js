/** How far sliders go. */
import fc from 'fast-check';
import { expect, test } from 'vitest';
import { grown, inside, isInside, jogRange, limitMargin, zeroPosture } from '../../../src/model/jog/jogRange.js';
import { LIBRARY } from '../../../src/model/library.js';
import { SEED, runs } from '../../helpers/property.js';

const { puma560, scara_cobra600: scara } = LIBRARY;
/** @param {Partial<import('../../../src/model/document.js').JointDoc>} change */
const withFirst = (change) => ({ ...puma560, joints: puma560.joints.with(0, { ...puma560.joints[0], ...change }) });

test('kept limits are the ends of the slider; given free, it goes on a quarter beyond them', () => {
  expect(jogRange(puma560, 1, true)).toEqual({ least: -45, most: 225 });
  expect(jogRange(puma560, 1, false)).toEqual({ least: -45 - 67.5, most: 225 + 67.5 });
});

test('without limits a turn either way, or the size of the arm', () => {
  expect(jogRange(withFirst({ lower: undefined, upper: undefined }), 0, true)).toEqual({ least: -360, most: 360 });
  expect(jogRange(withFirst({ type: 'continuous' }), 0, false)).toEqual({ least: -360, most: 360 });
  const slide = scara.joints.findIndex(({ type }) => type === 'prismatic');
  const free = {
    ...scara,
    joints: scara.joints.with(slide, { ...scara.joints[slide], lower: undefined, upper: undefined }),
  };
  const { least, most } = jogRange(free, slide, true);
  expect([-least, most]).toEqual([1000, 1000]); // the lengths of the table, 987 mm, rounded up
});

test('one limit is one end, and there is room on the other side of it', () => {
  expect(jogRange(withFirst({ lower: undefined, upper: -500 }), 0, true)).toEqual({ least: -860, most: -500 });
  expect(jogRange(withFirst({ lower: 500, upper: undefined }), 0, true)).toEqual({ least: 500, most: 860 });
});

test('limits that are one point still make a slider once they are given free', () => {
  const { least, most } = jogRange(withFirst({ lower: 10, upper: 10 }), 0, false);
  expect(most - least).toBeGreaterThan(0);
});

test('a range grows to hold a value, on that side only, and stays itself where it need not', () => {
  const any = fc.double({ min: -1e6, max: 1e6, noNaN: true });
  fc.assert(
    fc.property(any, fc.double({ min: 1e-3, max: 1e4, noNaN: true }), any, (least, width, value) => {
      const range = { least, most: least + width };
      const next = grown(range, value);
      expect(next.least).toBeLessThanOrEqual(Math.min(least, value));
      expect(next.most).toBeGreaterThanOrEqual(Math.max(range.most, value));
      if (value >= least && value <= range.most) expect(next).toBe(range);
      else expect(next.least === least || next.most === range.most).toBe(true);
    }),
    { seed: SEED, numRuns: runs(200) },
  );
  const range = { least: -360, most: 360 };
  expect(grown(range, 360)).toBe(range);
  expect(grown(range, 360, true)).toEqual({ least: -360, most: 720 });
  expect(grown(range, -360, true)).toEqual({ least: -720, most: 360 });
});

test('zero, or the limit that is nearest to it, and which joints that was', () => {
  const shifted = withFirst({ lower: 20, upper: 90 });
  expect(zeroPosture(shifted, true)).toEqual({ posture: [20, 0, 0, 0, 0, 0], stopped: [0] });
  expect(zeroPosture(shifted, false)).toEqual({ posture: [0, 0, 0, 0, 0, 0], stopped: [0] });
  expect(zeroPosture(puma560, true).stopped).toEqual([]);
  expect(inside(shifted.joints[0], 100)).toBe(90);
  expect(isInside(shifted.joints[0], 90)).toBe(true);
});

test('what is left to the nearer limit, less than nothing beyond it', () => {
  const second = puma560.joints[1]; // −45° to 225°
  expect(limitMargin(second, 0)).toEqual({ by: 45, limit: 'lower' });
  expect(limitMargin(second, 200)).toEqual({ by: 25, limit: 'upper' });
  expect(limitMargin(second, 225)).toEqual({ by: 0, limit: 'upper' });
  expect(limitMargin(second, -50)).toEqual({ by: -5, limit: 'lower' });
  const free = { ...second, lower: undefined, upper: undefined };
  expect(limitMargin(free, 7)).toEqual({ by: Infinity, limit: null });
  expect(limitMargin({ ...free, upper: 10 }, 7)).toEqual({ by: 3, limit: 'upper' });
});
