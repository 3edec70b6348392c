/** Steps on the clipboard: what was copied comes back as it was; what is not steps, or not for this robot, is refused and changes nothing. */
import fc from 'fast-check';
import { expect, test } from 'vitest';
import { readSteps, stepsText } from '../../../src/io/stepsText.js';
import { LIBRARY, newDocument } from '../../../src/model/library.js';
import { readySteps } from '../../helpers/readySteps.js';
import { refusal } from '../../../src/model/refusals.js';
import { reduce, startState } from '../../../src/model/session.js';
import { READY_WORDS } from '../../../src/ui/words/ready.js';
import { SEED, runs } from '../../helpers/property.js';

const state = startState(newDocument(LIBRARY.puma560));
const { units } = state.doc.robot;
const steps = readySteps(state.doc, 'corners', READY_WORDS.comments) ?? [];

/** A program with them. @param {import('../../../src/model/program/motionCommands.js').NewStep[]} list */
const withThem = (list) =>
  reduce(state, { type: 'add-motion-program', name: 'One', steps: list }).doc.motionPrograms[0].steps;

test('what is copied is pasted as it was, with names of its own', () => {
  expect(steps.length).toBeGreaterThan(5);
  const first = withThem(steps);
  const read = readSteps(stepsText(first, units), units);
  if ('against' in read) throw new Error(read.against);
  expect(read.steps.every((step) => !('id' in step))).toBe(true);
  expect(withThem(read.steps)).toEqual(first);
});

test('other texts, other versions and other units are told apart', () => {
  const text = stepsText(steps, units);
  expect(readSteps(text, { length: 'm', angle: 'rad' })).toEqual({ against: 'units' });
  expect(readSteps(text.replace('"version":1', '"version":2'), units)).toEqual({ against: 'version' });
  for (const other of [
    '',
    '{',
    '[]',
    'null',
    '{"denavit":"steps"}',
    '{"denavit":"steps","version":1,"steps":[]}',
    '<a/>',
  ])
    expect(readSteps(other, units)).toEqual({ against: 'other' });
});

test('a text with anything changed in it puts in sound steps, or nothing and says why', () => {
  const text = stepsText(steps.slice(0, 3), units);
  let kept = 0;
  fc.assert(
    fc.property(
      fc.nat(text.length - 1),
      fc.nat(6),
      fc.constantFrom('', '9', '"', '-', '{}', 'null', '"__proto__":1,', '1e999'),
      (at, length, put) => {
        const read = readSteps(text.slice(0, at) + put + text.slice(at + length), units);
        if ('against' in read) return;
        const command = /** @type {const} */ ({ type: 'add-motion-program', name: '', steps: read.steps });
        if (refusal(state.doc, command) !== null) return;
        kept++;
        expect(reduce(state, command).doc.motionPrograms[0].steps.length).toBe(read.steps.length);
      },
    ),
    { seed: SEED, numRuns: runs(400) },
  );
  expect(kept).toBeGreaterThan(5);
});
