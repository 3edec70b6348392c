import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { SCHEMA, readQueryParameters } from '../../../src/io/queryParameters.js';
import { SEED, runs } from '../../helpers/property.js';

const DEFAULTS = {
  ...{ robot: 'puma560', q: null, units: null, panels: null, theme: null },
  ...{ view: 'iso', projection: 'perspective', frames: 'ends', trace: 'off' },
  ...{ hint: 'on', autosave: 'on', quality: 'high', clock: 'browser' },
};

/** @param {string} search */
const read = (search) => readQueryParameters(search, SCHEMA);

test('parameters that are given are read, the others are at their defaults', () => {
  expect(read('')).toEqual({ values: DEFAULTS, refused: [] });
  expect(read('?robot=ur5&theme=dark')).toEqual({
    values: { ...DEFAULTS, robot: 'ur5', theme: 'dark' },
    refused: [],
  });
});

test('a bad or unknown one is reported with what was expected, and the default stands', () => {
  const { values, refused } = read('?robot=<b>&cat=1&quality=');
  expect(values).toEqual(DEFAULTS);
  expect(refused.map(({ values, ...rest }) => ({ ...rest, first: values?.[0] }))).toEqual([
    { why: 'not-understood', name: 'robot', text: '<b>', kind: 'one', initial: 'puma560', first: 'planar2r' },
    { why: 'not-understood', name: 'quality', text: '', kind: 'one', initial: 'high', first: 'high' },
    { why: 'unknown', name: 'cat', text: '1', first: undefined },
  ]);
});

test('names of Object.prototype are no parameters and no values', () => {
  expect(read('?constructor=1&__proto__=2').refused.map(({ name }) => name)).toEqual(['constructor', '__proto__']);
  for (const name of ['constructor', '__proto__', 'toString']) {
    for (const parameter of Object.keys(SCHEMA)) {
      expect(read(`?${parameter}=${name}`).values).toEqual(DEFAULTS);
      expect(read(`?${parameter}=${name}`).refused).toHaveLength(1);
    }
  }
});

test('of two the first counts, and that is said', () => {
  const { values, refused } = read('?robot=ur5&robot=ur10');
  expect(values.robot).toBe('ur5');
  expect(refused).toEqual([{ why: 'twice', name: 'robot', text: 'ur5' }]);
});

describe('joint values', () => {
  test.each([
    ['0,45,-90', [0, 45, -90]],
    ['1.5, -.5,+2e-3', [1.5, -0.5, 0.002]],
    ['−10', [-10]],
    ['-0', [0]],
  ])('%s', (text, expected) => expect(read(`?q=${encodeURIComponent(text)}`).values.q).toEqual(expected));

  test.each(['', ',', '1,', '1;2', '0x10', 'NaN', '1e400', 'Infinity', '1e10', '1'.repeat(400), '1,'.repeat(99) + '1'])(
    'none: %.20s',
    (text) => {
      expect(read(`?q=${text}`).values.q).toBe(null);
      expect(read(`?q=${text}`).refused).toMatchObject([{ why: 'not-understood', name: 'q', kind: 'numbers' }]);
    },
  );
});

test('units are a length, an angle or both, in any order', () => {
  expect(read('?units=mm,deg').values.units).toEqual({ length: 'mm', angle: 'deg' });
  expect(read('?units=rad, m').values.units).toEqual({ length: 'm', angle: 'rad' });
  expect(read('?units=cm').values.units).toEqual({ length: 'cm' });
  for (const bad of ['', 'mm,cm', 'mm,deg,', 'mm,deg,rad', 'inch', 'MM']) {
    expect(read(`?units=${bad}`).values.units).toBe(null);
  }
});

test('panels are those that stand beside the view, the bar with them unless there are none', () => {
  expect(read('?panels=none').values.panels).toEqual([]);
  expect(read('?panels=view').values.panels).toEqual(['bar']);
  expect(read('?panels=view,jog,pose').values.panels).toEqual(['jog', 'pose', 'bar']);
  expect(read('?panels=code,all').values.panels).toEqual([
    'code',
    'robot',
    'program',
    'workspace',
    'jacobian',
    'jog',
    'pose',
    'aim',
    'bar',
  ]);
  for (const bad of ['', 'bar', 'none,jog', 'jog,cat', 'jog,'.repeat(50) + 'jog']) {
    expect(read(`?panels=${bad}`).values.panels, bad).toBe(null);
  }
});

/** Pieces of addresses, good ones and bad ones. */
const piece = fc.oneof(
  fc.constantFrom('%', '%zz', '%ff', '%00', '&&', '=', '?', '#', '+', '%u0041', '__proto__', '\ud800', ',,,', '1e999'),
  fc.constantFrom(...Object.keys(SCHEMA)),
  fc.constantFrom(...Object.values(SCHEMA).flatMap(({ values }) => values)),
  fc.double().map(String),
  fc.string({ unit: 'binary', maxLength: 30 }),
);
const pair = fc.tuple(fc.oneof(piece, fc.constantFrom(...Object.keys(SCHEMA))), fc.array(piece, { maxLength: 4 }));
const address = fc
  .array(
    pair.map(([name, values]) => `${name}=${values.join(',')}`),
    { maxLength: 8 },
  )
  .map((pairs) => `?${pairs.join('&')}`);

test('any text after the question mark gives values that the schema allows, and never throws', () => {
  fc.assert(
    fc.property(address, (search) => {
      const { values, refused } = read(search);
      expect(Object.keys(values)).toEqual(Object.keys(SCHEMA));
      expect(SCHEMA.robot.values).toContain(values.robot);
      expect(['on', 'off']).toContain(values.hint);
      expect(['high', 'low']).toContain(values.quality);
      expect([null, 'auto', 'light', 'dark']).toContain(values.theme);
      for (const number of values.q ?? []) expect(Math.abs(number)).toBeLessThanOrEqual(1e9);
      expect(values.q).not.toEqual([]);
      expect(new Set(values.panels).size).toBe(values.panels?.length ?? 0);
      for (const { name, why } of refused) expect(Object.hasOwn(SCHEMA, name)).toBe(why !== 'unknown');
      // Nothing is dropped in silence: what was given is used, or reported.
      for (const [name] of new URLSearchParams(search)) {
        const isRefused = refused.some((one) => one.name === name);
        if (!isRefused) expect(values[/** @type {keyof typeof values} */ (name)]).not.toBe(null);
      }
    }),
    { seed: SEED, numRuns: runs(500) },
  );
});
