import { expect, test } from 'vitest';
import { applyCommand } from '../../../src/model/commands.js';
import { LIBRARY, newDocument } from '../../../src/model/library.js';
import { planPostures } from '../../../src/model/program/posturePlan.js';
import { refusal } from '../../../src/model/refusals.js';
import { whatChanged } from '../../../src/model/whatChanged.js';

/** @import { Doc } from '../../../src/model/document.js' */
/** @import { PostureCommand } from '../../../src/model/program/postureCommand.js' */

/** @type {Doc} */
const doc = {
  ...newDocument(LIBRARY.planar2r),
  posture: [7, 8],
  postures: [
    { id: 'p1', q: [1, 2] },
    { id: 'home', q: [0, 0] },
  ],
};
const row = (/** @type {string} */ name, /** @type {number[] | null} */ q) => ({ name, q, reason: q ? null : 'why' });
const rows = [
  row('home', [5, 6]),
  row('p1', [1, 2]),
  row('', [3, 4]),
  row('pick up', [3, 4]),
  row('bad', null),
  row('current', [9, 9]),
];

test('rows are added, change what has their name, move the arm, or are refused; the plan is one command', () => {
  const { rows: planned, command, isEmpty } = planPostures(doc, rows, 'add');
  expect(planned.map(({ name, fate }) => [name, fate])).toEqual([
    ['home', 'changed'],
    ['p1', 'same'],
    ['p2', 'new'],
    ['pick up', 'refused'],
    ['bad', 'refused'],
    ['current', 'moves'],
  ]);
  expect([isEmpty, planned[4].reason]).toEqual([false, 'why']);
  expect(refusal(doc, command)).toBe(null);
  const after = applyCommand(doc, command);
  expect(after.posture).toEqual([9, 9]);
  expect(after.postures).toEqual([
    { id: 'p1', q: [1, 2] },
    { id: 'home', q: [5, 6] },
    { id: 'p2', q: [3, 4] },
  ]);
  expect(applyCommand(after, command)).toBe(after);
});

test('replacing leaves only what the table has, in its order', () => {
  const { command } = planPostures(doc, [row('b', [1, 1]), row('home', [0, 0])], 'replace');
  const after = applyCommand(doc, command);
  expect(after.postures.map(({ id }) => id)).toEqual(['b', 'home']);
  expect(after.posture).toBe(doc.posture);
  expect(whatChanged(doc, after)).toEqual({ what: 'postures' });
});

test('nothing is carried out that no document may hold', () => {
  const set = (/** @type {unknown} */ postures) =>
    refusal(doc, /** @type {PostureCommand} */ ({ type: 'set-postures', postures }))?.code ?? null;
  expect(set([{ id: 'a', q: [1, 2] }])).toBe(null);
  expect(set([{ id: 'a', q: [1] }])).toBe('posture-length');
  expect(set([{ id: 'current', q: [1, 2] }])).toBe('id');
  expect(set([{ id: 'a', q: [1, NaN] }])).toBe('number');
  expect(set([{ id: 'a', q: [1, 2] }, { id: 'a', q: [1, 2] }])).toBe('id-taken'); // prettier-ignore
  expect(set(Array.from({ length: 1000 }, (_, i) => ({ id: `a${i}`, q: [1, 2] })))).toBe('too-many-postures');
  expect(set(null)).toBe('choice');
});
