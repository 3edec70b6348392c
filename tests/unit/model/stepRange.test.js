/** Steps that are chosen together, and the commands that change them at once. */
import { expect, test } from 'vitest';
import { LIBRARY, newDocument } from '../../../src/model/library.js';
import { chosenSteps, extendedTo } from '../../../src/model/program/stepRange.js';
import { refusal } from '../../../src/model/refusals.js';
import { reduce, startState } from '../../../src/model/session.js';

/** @import { AppState } from '../../../src/model/session.js' */

/** A program of waits of 1, 2, 3, 4 and 5 s. */
const start = () =>
  reduce(startState(newDocument(LIBRARY.planar2r)), {
    type: 'add-motion-program',
    name: 'Waits',
    steps: [1, 2, 3, 4, 5].map((seconds) => ({ kind: 'wait', seconds })),
  });
const steps = (/** @type {AppState} */ state) => state.doc.motionPrograms[0].steps;
const seconds = (/** @type {AppState} */ state) => steps(state).map((step) => ('seconds' in step ? step.seconds : NaN));

/** @param {AppState} state @param {number} index */
const choose = (state, index) =>
  reduce(state, { type: 'show', change: { step: steps(state)[index].id, stepRange: null } });
/** @param {AppState} state @param {number} index */
const extend = (state, index) => reduce(state, { type: 'show', change: extendedTo(state, steps(state)[index].id) });

test('a choice goes from where it was begun to the step that is chosen, either way, and ends with another choice', () => {
  expect(chosenSteps(start())).toBeNull();
  const one = choose(start(), 2);
  expect(chosenSteps(one)).toEqual({ first: 2, count: 1 });
  expect(chosenSteps(extend(one, 4))).toEqual({ first: 2, count: 3 });
  expect(chosenSteps(extend(extend(one, 4), 0))).toEqual({ first: 0, count: 3 });
  expect(chosenSteps(extend(extend(one, 4), 2))).toEqual({ first: 2, count: 1 });
  const other = reduce(extend(one, 4), { type: 'show', change: { step: steps(one)[0].id } });
  expect(chosenSteps(other)).toEqual({ first: 0, count: 1 });
  const without = reduce(extend(one, 4), { type: 'remove-steps', program: 0, step: 2, count: 1 });
  expect(chosenSteps(without)).toEqual({ first: 3, count: 1 }); // where it was begun is gone
  expect(chosenSteps(extend(start(), 1))).toEqual({ first: 1, count: 1 }); // none was chosen before
});

test('several are moved, edited and deleted at once, and each is one step to undo', () => {
  const state = start();
  const moved = reduce(state, { type: 'move-step', program: 0, step: 1, to: 3, count: 2 });
  expect(seconds(moved)).toEqual([1, 4, 5, 2, 3]);
  expect(reduce(moved, { type: 'undo' }).doc).toBe(state.doc);
  expect(seconds(reduce(moved, { type: 'move-step', program: 0, step: 3, to: 0, count: 2 }))).toEqual([2, 3, 1, 4, 5]);
  for (const [step, to, count] of [
    [1, 4, 2],
    [4, 0, 2],
    [0, 0, 0],
    [0, 1, 1.5],
    [1, -1, 2],
  ])
    expect(refusal(state.doc, { type: 'move-step', program: 0, step, to, count })).not.toBeNull();

  const off = steps(state).map((step) => ({ ...step, disabled: /** @type {const} */ (true) }));
  const edited = reduce(state, { type: 'edit-steps', program: 0, step: 2, to: off.slice(0, 2) });
  expect(steps(edited).map(({ id, disabled = false }) => [id, disabled])).toEqual(
    steps(state).map(({ id }, i) => [id, i === 2 || i === 3]),
  );
  expect(seconds(edited)).toEqual([1, 2, 1, 2, 5]);
  expect(steps(edited)[0]).toBe(steps(state)[0]);
  expect(reduce(edited, { type: 'undo' }).doc).toBe(state.doc);
  expect(reduce(state, { type: 'edit-steps', program: 0, step: 1, to: steps(state).slice(1, 3) })).toBe(state);
  for (const [step, count] of [
    [4, 2],
    [0, 0],
    [5, 1],
  ])
    expect(refusal(state.doc, { type: 'edit-steps', program: 0, step, to: off.slice(0, count) })).not.toBeNull();
});
