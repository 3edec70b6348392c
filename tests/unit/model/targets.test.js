/** Named targets through the session: kept, renamed, edited, put elsewhere, taken away, undone, saved. */
import { expect, test } from 'vitest';
import { readRobotXml, writeRobotXml } from '../../../src/io/robotXml.js';
import { LIBRARY, newDocument } from '../../../src/model/library.js';
import { refusal } from '../../../src/model/refusals.js';
import { reduce, startState } from '../../../src/model/session.js';
import { createStore } from '../../../src/model/store.js';

/** @typedef {import('../../../src/model/session.js').AppState} AppState */
/** @typedef {import('../../../src/model/session.js').Action} Action */

const start = () =>
  /** @type {import('../../../src/model/store.js').Store<AppState, Action>} */ (
    createStore(startState(newDocument(LIBRARY.puma560)), reduce)
  );
const pose = (/** @type {number} */ x) => ({ xyz: [x, 0, 500], rpy: [180, 0, 0] });
const ids = (/** @type {ReturnType<typeof start>} */ store) => store.state.doc.targets.map(({ id }) => id);

test('the first free name is given, and names are changed, refused twice, and freed', () => {
  const store = start();
  for (const x of [100, 200, 300]) store.dispatch({ type: 'add-target', pose: pose(x) });
  expect(ids(store)).toEqual(['aim_1', 'aim_2', 'aim_3']);
  store.dispatch({ type: 'rename-target', index: 1, id: 'pick' });
  expect(() => store.dispatch({ type: 'rename-target', index: 0, id: 'pick' })).toThrow(
    'Another target is called "pick" already.',
  );
  expect(() => store.dispatch({ type: 'rename-target', index: 0, id: 'no blanks' })).toThrow('A name is a letter');
  store.dispatch({ type: 'add-target', pose: pose(400) });
  expect(ids(store)).toEqual(['aim_1', 'pick', 'aim_3', 'aim_2']);
});

test('a target goes to another place in the list, and no other is lost', () => {
  const store = start();
  for (const x of [100, 200, 300]) store.dispatch({ type: 'add-target', pose: pose(x) });
  store.dispatch({ type: 'move-target', index: 0, to: 2 });
  expect(ids(store)).toEqual(['aim_2', 'aim_3', 'aim_1']);
  store.dispatch({ type: 'move-target', index: 2, to: 1 });
  expect(ids(store)).toEqual(['aim_2', 'aim_1', 'aim_3']);
  store.dispatch({ type: 'remove-target', index: 0 });
  expect(store.state.doc.targets.map(({ xyz }) => xyz[0])).toEqual([100, 300]);
});

test('editing keeps the name, the same again is no step, and undo brings the first back', () => {
  const store = start();
  store.dispatch({ type: 'add-target', pose: pose(100), configuration: 'N U T, 0, 0, 0' });
  const first = store.state.doc;
  store.dispatch({ type: 'edit-target', index: 0, pose: pose(100), configuration: 'N U T, 0, 0, 0' });
  expect(store.state.doc).toBe(first);
  store.dispatch({ type: 'edit-target', index: 0, pose: pose(-0) });
  expect(store.state.doc.targets).toEqual([{ id: 'aim_1', ...pose(-0) }]);
  store.dispatch({ type: 'undo' });
  expect(store.state.doc).toBe(first);
});

test('what came with a pose is not kept with it', () => {
  const store = start();
  store.dispatch({ type: 'add-target', pose: { ...pose(1), ...{ id: 'x', kind: 'user' } } });
  expect(Object.keys(store.state.doc.targets[0])).toEqual(['id', 'xyz', 'rpy']);
});

test('targets are saved and opened', () => {
  const store = start();
  store.dispatch({ type: 'add-target', pose: pose(100), configuration: 'N U T, 0, 0, 0' });
  store.dispatch({ type: 'add-target', pose: { xyz: [1, 2, 3], quaternion: [0, 0, 0.6, 0.8] } });
  const text = writeRobotXml(store.state.doc);
  expect(text).toContain('<target id="aim_1" configuration="N U T, 0, 0, 0" xyz="100 0 500" rpy="180 0 0"/>');
  expect(readRobotXml(text).doc).toEqual(store.state.doc);
});

test('a full list takes no more', () => {
  const doc = newDocument(LIBRARY.puma560);
  const full = { ...doc, targets: Array.from({ length: 200 }, (_, i) => ({ id: `t${i}`, ...pose(i) })) };
  expect(refusal(full, { type: 'add-target', pose: pose(0) })?.message).toBe(
    'A model keeps at most 200 named targets.',
  );
});
