import { expect, test } from 'vitest';
import { poseFromRows, rowsOf } from '../../../src/model/numbers/poseRows.js';

const rows = [
  [0, -1, 0, 0.1],
  [1, 0, 0, 0.2],
  [0, 0, 1, 0.3],
  [0, 0, 0, 1],
];

test('rows become columns, and columns rows again', () => {
  const T = poseFromRows(rows);
  expect(Array.from(T.subarray(12))).toEqual([0.1, 0.2, 0.3, 1]);
  expect(Array.from(T.subarray(0, 3))).toEqual([0, 1, 0]);
  expect(rowsOf(T)).toEqual(rows);
});

test.each([
  ['too few rows', rows.slice(1)],
  ['a short row', rows.with(2, [0, 0, 1])],
  ['no number', rows.with(0, [NaN, -1, 0, 0])],
  ['a scale', rows.with(0, [0, -2, 0, 0])],
  ['the transpose', rows[0].map((_, j) => rows.map((row) => row[j]))],
  ['nothing', /** @type {number[][]} */ (/** @type {unknown} */ (null))],
])('%s is no pose', (_, wrong) => expect(() => poseFromRows(wrong)).toThrow(RangeError));
