import { expect, test } from 'vitest';
import { SCHEMA, readQueryParameters } from '../../../src/io/queryParameters.js';

test('parameters that are given are read, the others are at their defaults', () => {
  expect(readQueryParameters('?robot=ur5&theme=dark', SCHEMA)).toEqual({
    values: { robot: 'ur5', theme: 'dark', quality: 'high', clock: 'browser' },
    refused: [],
  });
});

test('a bad or unknown one is reported, and the default stands', () => {
  expect(readQueryParameters('?robot=<b>&cat=1&quality=', SCHEMA)).toEqual({
    values: { robot: 'puma560', theme: null, quality: 'high', clock: 'browser' },
    refused: [
      { name: 'robot', text: '<b>', initial: 'puma560' },
      { name: 'quality', text: '', initial: 'high' },
      { name: 'cat', text: '1', initial: null },
    ],
  });
});

test('names of Object.prototype are no parameters', () => {
  expect(readQueryParameters('?constructor=1&__proto__=2', SCHEMA).refused.map(({ name }) => name)).toEqual([
    'constructor',
    '__proto__',
  ]);
  expect(readQueryParameters('?robot=constructor', SCHEMA).values.robot).toBe('puma560');
});
