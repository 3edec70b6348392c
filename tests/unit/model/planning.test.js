/** A plan is of the question it answers, and of no other: what is stale is never played. */
import { describe, expect, test } from 'vitest';
import { LIBRARY, newDocument } from '../../../src/model/library.js';
import { isSameQuestion } from '../../../src/model/program/planning.js';

/** @import { MotionProgramDoc } from '../../../src/model/document.js' */

/** @type {MotionProgramDoc} */
const program = { id: 'p1', name: 'One', steps: [{ id: 's1', kind: 'call', program: 'p2' }] };
/** @type {MotionProgramDoc} */
const called = { id: 'p2', name: 'Two', steps: [{ id: 's1', kind: 'wait', seconds: 1 }] };
const doc = { ...newDocument(LIBRARY.puma560), motionPrograms: [program, called] };
const start = [0, 0, 0, 0, 0, 0];
const question = { doc, program, start };

describe('a question is another', () => {
  test.each([
    ['when a called program was edited', { ...doc, motionPrograms: [program, { ...called, steps: [] }] }],
    ['when the robot was edited', { ...doc, robot: { ...doc.robot } }],
    ['when a target was', { ...doc, targets: [...doc.targets] }],
  ])('%s', (_, other) => {
    expect(isSameQuestion(question, { ...question, doc: other })).toBe(false);
  });
  test('when the program was, or where it begins', () => {
    expect(isSameQuestion(question, { ...question, program: { ...program } })).toBe(false);
    expect(isSameQuestion(question, { ...question, start: [0, 0, 0, 0, 0, 1] })).toBe(false);
    expect(isSameQuestion(question, null)).toBe(false);
  });
});

test('it is the same when the arm stands elsewhere, and by the same numbers', () => {
  expect(isSameQuestion(question, { ...question, doc: { ...doc, posture: [1, 2, 3, 4, 5, 6] } })).toBe(true);
  expect(isSameQuestion(question, { ...question, start: [...start] })).toBe(true);
});
