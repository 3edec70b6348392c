/** Numbers with their errors: never more digits than are known, never an error that is stated too small. */
import fc from 'fast-check';
import { expect, test } from 'vitest';
import { measureText, tickText, withError } from '../../../src/ui/workspace/measures.js';
import { SEED, runs } from '../../helpers/property.js';

test('a number ends where its error begins', () => {
  expect(withError(0.826905, 6.7e-5)).toEqual(['0.82691', '0.00007']);
  expect(withError(2.516, 1.44e-3)).toEqual(['2.5160', '0.0015']);
  expect(withError(2.5015, 0.2393)).toEqual(['2.5', '0.3']);
  expect(withError(0.942478, 0)).toEqual(['0.942478', '0.000001']);
  expect(withError(12345, 700)).toEqual(['12345', '700']);
  expect(measureText('area', 0.0012345, 2e-7)).toBe('12.345 ± 0.002 cm²');
  expect(measureText('volume', 2.5015, 0.2393)).toBe('2.5 ± 0.3 m³');
});

test('the error that is stated covers the error and the rounding of neither', () => {
  const error = fc.double({ min: 1e-6, max: 10, noNaN: true });
  fc.assert(
    fc.property(error, (off) => {
      const [, text] = withError(1, off);
      expect(Number(text)).toBeGreaterThanOrEqual(off * (1 - 1e-9));
      expect(Number(text)).toBeLessThanOrEqual(off * 1.51 + 1e-6);
    }),
    { seed: SEED, numRuns: runs(200) },
  );
});

test('a grid is read in the units of the document, without digits that say nothing', () => {
  const mm = /** @type {const} */ ({ length: 'mm', angle: 'deg' });
  expect(tickText(0.5, 0.1, mm)).toBe('500');
  expect(tickText(-0.0005, 0.0005, mm)).toBe('−0.5');
  expect(tickText(0.25, 0.05, { length: 'm', angle: 'rad' })).toBe('0.25');
  expect(tickText(0, 0, mm)).toBe('0.00'); // all that a planar arm reaches has one height
});
