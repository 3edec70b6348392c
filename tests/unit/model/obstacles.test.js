/** Obstacles through the session: added, changed, renamed, taken away, undone, saved. */
import { expect, test } from 'vitest';
import { readRobotXml, writeRobotXml } from '../../../src/io/robotXml.js';
import { LIBRARY, newDocument } from '../../../src/model/library.js';
import { reduce, startState } from '../../../src/model/session.js';
import { createStore } from '../../../src/model/store.js';
import { whatChanged } from '../../../src/model/whatChanged.js';

/** @typedef {import('../../../src/model/session.js').AppState} AppState */
/** @typedef {import('../../../src/model/session.js').Action} Action */
/** @typedef {import('../../../src/model/workcell/obstacles.js').NewObstacle} NewObstacle */

const start = () =>
  /** @type {import('../../../src/model/store.js').Store<AppState, Action>} */ (
    createStore(startState(newDocument(LIBRARY.puma560)), reduce)
  );
/** @type {NewObstacle} */
const BOX = { kind: 'box', xyz: [500, 0, 100], rpy: [0, 0, 0], width: 300, depth: 200, height: 100 };
/** @type {NewObstacle} */
const BALL = { kind: 'sphere', xyz: [0, 500, 0], radius: 50 };

test('each kind has names of its own; names are changed, refused twice, and freed', () => {
  const store = start();
  for (const obstacle of [BOX, BALL, BOX]) store.dispatch({ type: 'add-obstacle', obstacle });
  const ids = () => store.state.doc.obstacles.map(({ id }) => id);
  expect(ids()).toEqual(['box_1', 'sphere_1', 'box_2']);
  store.dispatch({ type: 'rename-obstacle', index: 0, id: 'table' });
  expect(() => store.dispatch({ type: 'rename-obstacle', index: 1, id: 'table' })).toThrow(
    'Another obstacle is called "table" already.',
  );
  expect(() => store.dispatch({ type: 'rename-obstacle', index: 1, id: 'no blanks' })).toThrow('A name is a letter');
  store.dispatch({ type: 'rename-obstacle', index: 1, id: 'sphere_1' });
  store.dispatch({ type: 'remove-obstacle', index: 1 });
  store.dispatch({ type: 'add-obstacle', obstacle: BOX });
  expect(ids()).toEqual(['table', 'box_2', 'box_1']);
});

test('a change keeps the name, may be of kind, and the same again is no step', () => {
  const store = start();
  store.dispatch({ type: 'add-obstacle', obstacle: { ...BOX, ...{ id: 'x', radius: 7, colour: 'red' } } });
  const first = store.state.doc;
  expect(first.obstacles).toStrictEqual([{ ...BOX, id: 'box_1' }]);
  store.dispatch({ type: 'edit-obstacle', index: 0, obstacle: { ...BOX } });
  expect(store.state.doc).toBe(first);
  store.dispatch({ type: 'edit-obstacle', index: 0, obstacle: { ...BOX, height: 101 } });
  expect(whatChanged(first, store.state.doc)).toEqual({
    ...{ what: 'list', list: 'obstacles', change: 'changed', id: 'box_1' },
  });
  store.dispatch({ type: 'edit-obstacle', index: 0, obstacle: BALL });
  expect(store.state.doc.obstacles).toStrictEqual([{ ...BALL, id: 'box_1' }]);
  store.dispatch({ type: 'undo' });
  store.dispatch({ type: 'undo' });
  expect(store.state.doc).toBe(first);
});

test.for([
  [{ ...BALL, radius: 0 }, 'The radius of a sphere is a number above 0'],
  [{ ...BALL, radius: undefined }, 'got undefined'],
  [{ ...BOX, depth: NaN }, 'The depth of a box is a number above 0, up to 10⁹; got NaN.'],
  [{ ...BOX, xyz: [0, 0] }, 'Expected 3 numbers as position, got 2.'],
  [{ ...BOX, quaternion: [0, 0, 0, 1] }, 'not both'],
  [{ ...BOX, kind: 'cone' }, 'Expected box or sphere or cylinder or plane'],
  [null, 'as the kind of an obstacle, got undefined.'],
])('what is no obstacle is refused, and nothing is lost: %s', ([obstacle, why]) => {
  const store = start();
  store.dispatch({ type: 'add-obstacle', obstacle: BOX });
  const before = store.state;
  const senseless = /** @type {NewObstacle} */ (/** @type {unknown} */ (obstacle));
  expect(() => store.dispatch({ type: 'add-obstacle', obstacle: senseless })).toThrow(String(why));
  expect(() => store.dispatch({ type: 'edit-obstacle', index: 0, obstacle: senseless })).toThrow(String(why));
  expect(() => store.dispatch({ type: 'edit-obstacle', index: 1, obstacle: BOX })).toThrow('an obstacle index');
  expect(store.state).toBe(before);
});

test('a hundred are kept, and no more', () => {
  const store = start();
  for (let i = 0; i < 100; i++) store.dispatch({ type: 'add-obstacle', obstacle: BALL });
  expect(() => store.dispatch({ type: 'add-obstacle', obstacle: BALL })).toThrow('at most 100 obstacles');
});

test('the file keeps them in their order, and a rounded quaternion is told', () => {
  const store = start();
  for (const obstacle of [BALL, BOX]) store.dispatch({ type: 'add-obstacle', obstacle });
  const text = writeRobotXml(store.state.doc);
  expect(readRobotXml(text)).toStrictEqual({ doc: store.state.doc, issues: [] });
  const { doc, issues } = readRobotXml(text.replace(/(<box [^/]*)rpy="0 0 0"/, '$1quat_xyzw="0 0 0.707 0.707"'));
  expect(issues.map(({ message }) => message)).toEqual([expect.stringContaining('obstacle "box_1" has a quaternion')]);
  expect(Math.hypot(...(doc?.obstacles[1].quaternion ?? []))).toBeCloseTo(1, 12);
});
