import fc from 'fast-check';
import { expect, test } from 'vitest';
import {
  choice,
  collapse,
  FINITE,
  JOINT_VALUES,
  POSITIVE,
  POSITIVE_INTEGER,
  SIGN,
  string,
  VECTOR_3,
} from '../../../src/io/valueTypes.js';
import { runs, SEED } from '../../helpers/property.js';

/** @param {{ read: (text: string) => object }} type @param {string} text */
const valueOf = (type, text) => {
  const reading = type.read(text);
  return 'value' in reading ? reading.value : undefined;
};

test('a number is read by its spelling', () => {
  const spellings = {
    0: 0,
    '-0': -0,
    '+1': 1,
    '.5': 0.5,
    '5.': 5,
    '1e3': 1000,
    '1E+3': 1000,
    '-2.5e-3': -0.0025,
    '007': 7,
    '1e-400': 0,
  };
  for (const [spelling, value] of Object.entries(spellings)) expect(valueOf(FINITE, spelling)).toBe(value);
});

test.for([
  [
    '',
    ' ',
    '+',
    '-',
    '.',
    'e5',
    '1e',
    '1e+',
    '1.5.2',
    '--1',
    '1 2',
    '1,5',
    '1.000,5',
    '1_000',
    "1'000",
    '0x10',
    '0b11',
    '0o7',
  ],
  [
    'NaN',
    'INF',
    '-INF',
    'Infinity',
    'inf',
    'null',
    'undefined',
    'true',
    'abc',
    '12abc',
    '1/2',
    '${pi/2}',
    'pi',
    '1°',
    '１',
    '٣',
  ],
  ['\u00A01', '1\u2009', '\v1', '1\0', '[1]', '1f', '1n', '1d', '(1)', '1%'],
])('what only JavaScript, or nobody, takes for a number is refused: %j', (spellings) => {
  for (const spelling of spellings) {
    expect({ spelling, ...FINITE.read(spelling) }).toEqual({
      spelling,
      code: 'number',
      expected: 'a number such as 12.5',
    });
  }
});

test('a number out of range is refused', () => {
  for (const spelling of ['1e9999', '1.1e9', '-1000000000.1']) {
    expect(FINITE.read(spelling)).toEqual({ code: 'number', expected: 'a number from -1000000000 to 1000000000' });
  }
});

test('every number in range is written as text that reads back as the same number', () => {
  fc.assert(
    fc.property(fc.double({ min: -1e9, max: 1e9, noNaN: true }), (value) => {
      expect(valueOf(FINITE, FINITE.write(value))).toBe(value);
    }),
    { seed: SEED, numRuns: runs(500) },
  );
});

test('what is no number is not written', () => {
  for (const value of [NaN, Infinity, undefined, '1']) expect(() => FINITE.write(value)).toThrow(RangeError);
  for (const value of [[1, NaN, 2], undefined, 3]) expect(() => VECTOR_3.write(value)).toThrow(RangeError);
  expect(() => string().write(3)).toThrow('Expected a text to write, got 3.');
});

test('the blanks of XML are blanks, and no others', () => {
  expect(collapse(' \t\n\r a \r\n b\u00A0 ')).toBe('a b\u00A0');
  expect(valueOf(VECTOR_3, '\t1\n2\r\n 3 ')).toEqual([1, 2, 3]);
});

test('a positive number is above zero', () => {
  expect(valueOf(POSITIVE, '5e-324')).toBe(5e-324);
  for (const text of ['0', '-1', '1e-400', '1e10', '', 'x']) expect(valueOf(POSITIVE, text)).toBeUndefined();
});

test('whole numbers are whole', () => {
  expect(valueOf(POSITIVE_INTEGER, ' +012 ')).toBe(12);
  for (const text of ['0', '-1', '1.0', '1e3', '99999999999', ''])
    expect(valueOf(POSITIVE_INTEGER, text)).toBeUndefined();
  expect(['1', '+1', '-01', ' 1 '].map((text) => valueOf(SIGN, text))).toEqual([1, 1, -1, 1]);
  for (const text of ['0', '2', '1.0', '']) expect(valueOf(SIGN, text)).toBeUndefined();
});

test('a list has as many numbers as it must', () => {
  expect(valueOf(JOINT_VALUES, '1 2')).toEqual([1, 2]);
  for (const text of ['', '1', '1 2 3 4 5 6 7', '1 2 x']) expect(valueOf(JOINT_VALUES, text)).toBeUndefined();
  expect(JOINT_VALUES.read('1')).toEqual({ code: 'number', expected: '2 to 6 numbers with blanks between them' });
});

test('a word is one of those allowed, whatever blanks are around it', () => {
  const type = choice(['one', 'two', 'three']);
  expect(valueOf(type, ' two\n')).toBe('two');
  expect(type.read('Two')).toEqual({ code: 'choice', expected: 'one, two or three' });
});

test('a text keeps its blanks, and is counted in characters', () => {
  expect(valueOf(string(3), ' \n ')).toBe(' \n ');
  expect(valueOf(string(3), '😀😀😀')).toBe('😀😀😀');
  expect(string(3).read('😀😀😀😀')).toEqual({ code: 'text-length', expected: 'at most 3 characters' });
});
