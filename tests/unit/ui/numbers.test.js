import { describe, expect, test } from 'vitest';
import { compact, editable, fixed, jointNumber, plain, poseNumber, withUnit } from '../../../src/ui/parts/format.js';
import { fractionOfPi, readNumber } from '../../../src/ui/parts/numberText.js';

describe('a number on the screen', () => {
  test('has a true minus and is never minus zero', () => {
    expect(fixed(-12.345, 2)).toBe('−12.35');
    expect(fixed(-0.001, 2)).toBe('0.00');
    expect(fixed(-0, 1)).toBe('0.0');
    expect(plain(-0)).toBe('0');
    expect(plain(-90)).toBe('−90');
  });

  test('of a table stands as it was typed', () => {
    for (const value of [671.83, 20.3, -0.1, 1e-7, 123456789.123]) expect(readNumber(plain(value)).value).toBe(value);
    expect(plain(671.83)).toBe('671.83');
  });

  test('has the decimals that its unit needs', () => {
    expect(poseNumber(431.8, 'mm')).toBe('431.80');
    expect(poseNumber(0.4318, 'm')).toBe('0.43180');
    expect(jointNumber(-32, 'deg')).toBe('−32.0');
    expect(withUnit('12.0', 'deg')).toBe('12.0°');
    expect(withUnit('80.0', 'mm')).toBe('80.0 mm');
  });

  test('in a cell is rounded to what fits, and says so', () => {
    expect(compact(671.83, 7)).toEqual({ text: '671.83', isRounded: false });
    expect(compact(89.95437383553924, 6)).toEqual({ text: '89.954', isRounded: true });
    expect(compact(0.34500000000000003, 7)).toEqual({ text: '0.345', isRounded: true });
    expect(compact(-Math.PI, 6)).toEqual({ text: '−3.142', isRounded: true });
    expect(compact(1e9, 7)).toEqual({ text: '1e9', isRounded: false });
    expect(compact(-0.00001, 6)).toEqual({ text: '−1e−5', isRounded: false });
    for (const value of [123456.789, -123456.789, 1.23456789e-7, -9.87654321e8]) {
      const { text } = compact(value, 7);
      expect(text.length).toBeLessThanOrEqual(7);
      expect(Math.abs((readNumber(text).value ?? 0) / value - 1)).toBeLessThan(0.05);
    }
  });

  test('of radians is a fraction of π only where it is one to the last bit', () => {
    expect([Math.PI / 2, -Math.PI, (-3 * Math.PI) / 4, Math.PI / 24].map(fractionOfPi)).toEqual([
      'π/2',
      '−π',
      '−3π/4',
      'π/24',
    ]);
    expect([0, 1.5707963, Math.PI / 2 + 2 ** -52, 1].map(fractionOfPi)).toEqual([null, null, null, null]);
  });

  test('to be edited has no rounding noise', () => {
    expect(editable(-31.999999999999996)).toBe('−32');
    expect(editable(0.1 + 0.2)).toBe('0.3');
  });
});

describe('a typed number', () => {
  const good = [
    ['431.8', 431.8],
    [' 12 ', 12],
    ['−90', -90],
    ['+.5', 0.5],
    ['1e3', 1000],
    ['2.', 2],
    ['-0', -0],
  ];
  test.each(good)('%s is %d', (text, value) => expect(readNumber(String(text))).toEqual({ value, reason: null }));

  const bad = [
    '',
    '  ',
    '12,5',
    '1,000',
    '0x10',
    '12abc',
    '1 2',
    'NaN',
    'Infinity',
    '1e400',
    '1e-400',
    '-0.5e-330',
    '2e9',
    '--1',
    '1e',
    'pi',
    '٣',
    '1_000',
  ];
  test('0 is 0, however it is written', () => {
    for (const text of ['0', '-0.0', '0e-400']) expect(Math.abs(readNumber(text).value ?? 1)).toBe(0);
  });

  test.each(bad)('“%s” is refused with a reason', (text) => {
    const { value, reason } = readNumber(text);
    expect(value).toBeNull();
    expect(reason).toMatch(/\.$/);
  });

  test('with a decimal comma is mended in the reason', () => {
    expect(readNumber('12,5').reason).toBe('Decimals are written with a point: 12.5.');
  });
});
