/**
 * Keys on a tool that is taken: which part of the handle they light, and which goal they ask for.
 * @import { DragRun } from '../../../src/render/drag/dragRun.js'
 * @import { State } from '../../../src/render/robotView.js'
 */
import { expect, test } from 'vitest';
import { createDerived } from '../../../src/model/derived.js';
import { reduce, startState } from '../../../src/model/session.js';
import { firstRobot } from '../../../src/model/shelf.js';
import { startDocument } from '../../../src/model/startDocument.js';
import { createStore } from '../../../src/model/store.js';
import { createToolKeys } from '../../../src/render/drag/dragByKeys.js';

function taken() {
  const { doc } = startDocument(firstRobot, { units: null, q: null, isOther: false });
  const store = createStore(startState(doc), reduce);
  const derived = createDerived();
  /** @type {Record<string, (event: object) => void>} */
  const heard = {};
  const element = {
    addEventListener: (/** @type {string} */ name, /** @type {(event: object) => void} */ hear) =>
      void (heard[name] = hear),
  };
  const canvas = /** @type {HTMLElement} */ (/** @type {unknown} */ ({ ...element, parentElement: element }));
  /** @type {Float64Array[]} */
  const goals = [];
  const run = /** @type {DragRun} */ (
    /** @type {unknown} */ ({
      isGoing: false,
      lastMet: derived.tcp(doc),
      begin() {},
      aimAt: (/** @type {Float64Array} */ goal) => void goals.push(goal),
      letGo() {},
    })
  );
  let changes = 0;
  const keys = createToolKeys(/** @type {State} */ (/** @type {unknown} */ ({ store, derived })), {
    ...{ canvas, room: canvas, run, isWide: () => true, isHeld: () => false, userFrame: () => null },
    onChange: () => void changes++,
  });
  const hold = (/** @type {string} */ key) =>
    heard.keydown({ key, target: canvas, preventDefault() {}, stopPropagation() {} });
  const release = (/** @type {string} */ key) => heard.keyup({ key });
  const press = (/** @type {string} */ key) => (hold(key), release(key));
  /** Metres from where the tool was taken to what was asked for last. */
  const way = () => [12, 13, 14].map((k) => Number(((goals.at(-1)?.[k] ?? NaN) - from[k]).toFixed(9)));
  const from = derived.tcp(doc);
  return { keys, press, hold, release, goals, way, from, changes: () => changes };
}

test.each(
  /** @type {const} */ ([
    ['ArrowRight', 0],
    ['ArrowDown', 1],
    ['PageUp', 2],
  ]),
)('%s lights the arrow and, when turning, the arc of its axis', (key, axis) => {
  const { keys, press, goals, from, changes } = taken();
  press(key);
  expect([keys.lit, goals]).toEqual([null, []]); // not taken yet
  press('t');
  expect(keys.lit).toBeNull();
  press(key);
  expect(keys.lit).toEqual({ kind: 'move', axis });
  const moved = goals[0].map((value, i) => Math.abs(value - from[i]));
  expect(moved[12 + axis]).toBeCloseTo(0.01, 12);
  expect(moved.filter((value) => value > 1e-12)).toHaveLength(1);
  const before = changes();
  press('r');
  expect(keys.lit).toBeNull(); // another motion, and none of its parts yet
  press(key);
  expect(keys.lit).toEqual({ kind: 'turn', axis });
  expect(changes()).toBeGreaterThan(before);
  press('Escape');
  expect(keys.lit).toBeNull();
});

test('two arrows that are held move the tool in their plane, as a drag of the small plane does', () => {
  const { keys, press, hold, release, way } = taken();
  press('t');
  hold('ArrowRight');
  hold('ArrowUp');
  expect([way(), keys.lit]).toEqual([[0.01, 0.01, 0], { kind: 'plane', axis: 2 }]);
  release('ArrowRight');
  hold('ArrowUp');
  expect([way(), keys.lit]).toEqual([[0, 0.01, 0], { kind: 'move', axis: 1 }]);
  hold('PageDown');
  expect([way(), keys.lit]).toEqual([[0, 0.01, -0.01], { kind: 'plane', axis: 0 }]);
  hold('ArrowDown'); // the later of two that are against each other
  expect(way()).toEqual([0, -0.01, -0.01]);
});

test('P takes the next plane: its two axes have the arrows, and the one across it the page keys', () => {
  const { keys, press, way } = taken();
  press('t');
  const seen = ['XY', 'YZ', 'XZ', 'XY'].map((plane, i) => {
    if (i > 0) {
      press('p');
      expect(keys.lit).toEqual({ kind: 'plane', axis: [0, 1, 2].find((axis) => !plane.includes('XYZ'[axis])) });
    }
    return ['ArrowRight', 'ArrowUp', 'PageUp'].map((key) => (press(key), 'XYZ'[way().indexOf(0.01)])).join('');
  });
  expect(seen).toEqual(['XYZ', 'YZX', 'XZY', 'XYZ']);
  press('p');
  press('r'); // turns stay about X, Y and Z
  press('ArrowRight');
  expect(keys.lit).toEqual({ kind: 'turn', axis: 0 });
});
