import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { LIBRARY, newDocument } from '../../../src/model/library.js';
import { reduce, startState } from '../../../src/model/session.js';
import { SEED, runs } from '../../helpers/property.js';
import { anyAction, anyDocument } from './arbitrary.js';

/** @typedef {import('../../../src/model/session.js').Action} Action */
/** @typedef {import('../../../src/model/session.js').AppState} AppState */
/** @typedef {import('../../../src/model/document.js').Doc} Doc */

/** @param {AppState} state @param {Action} action  one that is refused changes nothing */
function tryTo(state, action) {
  try {
    return reduce(state, action);
  } catch (error) {
    expect(error).toBeInstanceOf(RangeError);
    return state;
  }
}

/** @param {AppState} state @param {...Action} actions */
const after = (state, ...actions) => actions.reduce(reduce, state);
/** @param {number} first @returns {Action} */
const stand = (first) => ({ type: 'stand', posture: [first, 2, 3, 4, 5, 6] });
/** @type {Action} */
const undo = { type: 'undo' };
/** @type {Action} */
const redo = { type: 'redo' };
/** @type {Action} */
const edit = { type: 'set-joint-field', joint: 1, field: 'a', value: 100 };

/** @param {Doc} doc */
const withoutPosture = (doc) => ({ ...doc, posture: null });

describe('playing moves the arm and is nothing to undo', () => {
  const begun = after(startState(newDocument(LIBRARY.puma560)), edit);

  test('what can be undone and redone stays what it was', () => {
    const undone = after(begun, undo);
    const stood = after(undone, stand(1), stand(7));
    expect(stood.past).toBe(undone.past);
    expect(stood.future).toBe(undone.future);
    expect(stood.doc.posture).toEqual([7, 2, 3, 4, 5, 6]);
  });

  test('undo takes the last edit back, not the playing, and the arm stays; redo likewise', () => {
    const undone = after(begun, stand(7), undo);
    expect(undone.doc.robot.joints[1].a).toBe(431.8);
    expect(undone.doc.posture[0]).toBe(7);
    const redone = after(undone, stand(8), redo);
    expect(redone.doc.robot.joints[1].a).toBe(100);
    expect(redone.doc.posture[0]).toBe(8);
  });

  test('an edit after playing is undone alone', () => {
    const edited = after(begun, stand(7), { type: 'set-joint-field', joint: 1, field: 'a', value: 200 });
    const undone = after(edited, undo);
    expect(undone.doc.robot.joints[1].a).toBe(100);
    expect(undone.doc.posture[0]).toBe(7);
    expect(after(undone, undo).doc.robot.joints[1].a).toBe(431.8);
  });

  test('a hand on the arm after playing: undo leads to where playing left it, then to where it stood before', () => {
    const moved = after(begun, stand(7), { type: 'set-joint-value', joint: 0, value: 30 });
    const once = after(moved, undo);
    expect(once.doc.posture).toEqual([7, 2, 3, 4, 5, 6]);
    expect(after(once, undo).doc).toEqual(begun.doc);
    expect(after(once, redo).doc.posture[0]).toBe(30);
  });

  test('a drag after playing that is given up leaves the arm where playing left it', () => {
    const stood = after(begun, stand(7));
    const drag = (/** @type {number} */ value) =>
      /** @type {Action} */ ({ type: 'set-joint-value', joint: 0, value, gesture: 'drag' });
    expect(after(stood, drag(20), drag(40), { type: 'cancel-gesture' })).toEqual(stood);
    const dragged = after(stood, drag(20), drag(40), { type: 'end-gesture' });
    expect(dragged.past).toHaveLength(stood.past.length + 2);
    expect(after(dragged, undo).doc.posture[0]).toBe(7);
  });

  test('whatever is done around it, undo leads to the very first document, and redo to the last', () => {
    const anyStand = fc.record({
      type: fc.constant(/** @type {const} */ ('stand')),
      posture: fc.array(fc.integer({ min: -90, max: 90 }), { minLength: 2, maxLength: 6 }),
    });
    fc.assert(
      fc.property(
        anyDocument,
        fc.array(fc.oneof({ arbitrary: anyAction, weight: 2 }, anyStand), { maxLength: 40 }),
        (doc, actions) => {
          let state = startState(structuredClone(doc));
          const first = state.doc;
          for (const action of actions) {
            const before = state;
            state = tryTo(state, action);
            if (action.type !== 'stand') continue;
            expect(state.past).toBe(before.past);
            expect(state.future).toBe(before.future);
            expect(withoutPosture(state.doc)).toEqual(withoutPosture(before.doc));
          }
          state = reduce(state, { type: 'end-gesture' });
          const last = state;
          while (state.past.length > 0) state = reduce(state, undo);
          expect(withoutPosture(state.doc)).toEqual(withoutPosture(first));
          expect(state.stood ?? state.doc).toBe(first);
          while (state.future.length > last.future.length) state = reduce(state, redo);
          expect(withoutPosture(state.doc)).toEqual(withoutPosture(last.doc));
        },
      ),
      { seed: SEED, numRuns: runs(120) },
    );
  });
});
