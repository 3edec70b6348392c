import fc from 'fast-check';
import { expect, test } from 'vitest';
import { readWidths, widthAfterKey, withinEdge } from '../../../src/ui/leftWidth.js';
import { SEED, runs } from '../../helpers/property.js';

test.each([
  [1920, 308, 720],
  [1366, 292, 555],
  [1100, 292, 390],
  [700, 292, 340],
])('on a page of %i px, %i of them taken at the right, the panel may have %i', (page, right, most) => {
  expect(withinEdge(page, right)).toEqual({ least: 340, most });
});

test('keys move the edge, Enter gives the panel its own width, and other keys are not for it', () => {
  const limits = { least: 340, most: 555 };
  /** @param {string} key @param {boolean} [shiftKey] */
  const after = (key, shiftKey = false) => widthAfterKey({ key, shiftKey }, 404, limits);
  expect([after('ArrowLeft'), after('ArrowRight'), after('ArrowRight', true)]).toEqual([388, 420, 468]);
  expect([after('Home'), after('End'), after('Enter'), after('Tab'), after('a')]).toEqual([
    340,
    555,
    null,
    undefined,
    undefined,
  ]);
});

test('what is remembered is taken where it is a width of a tab, whatever stands there', () => {
  expect(readWidths(JSON.stringify({ robot: 500, code: 640 }))).toEqual({ robot: 500, code: 640 });
  expect(readWidths(JSON.stringify({ robot: 339, code: 721, program: '500', jog: 400 }))).toEqual({});
  fc.assert(
    fc.property(fc.oneof(fc.string(), fc.json(), fc.constant(null)), (text) => {
      for (const width of Object.values(readWidths(text))) {
        expect(width).toBeGreaterThanOrEqual(340);
        expect(width).toBeLessThanOrEqual(720);
      }
    }),
    { seed: SEED, numRuns: runs(200) },
  );
});
