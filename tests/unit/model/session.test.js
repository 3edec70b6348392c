import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { refusal } from '../../../src/model/refusals.js';
import { LIBRARY, newDocument } from '../../../src/model/library.js';
import { reduce, startState } from '../../../src/model/session.js';
import { createStore } from '../../../src/model/store.js';
import { deepFreeze } from '../../../src/model/freeze.js';
import { SEED, runs } from '../../helpers/property.js';
import { anyAction, anyDocument } from './arbitrary.js';

/** @typedef {import('../../../src/model/session.js').Action} Action */
/** @typedef {import('../../../src/model/session.js').AppState} AppState */
/** @typedef {import('../../../src/model/store.js').Store<AppState, Action>} Page */

const puma = () => newDocument(LIBRARY.puma560);
/** @param {import('../../../src/model/document.js').Doc} [doc] @returns {Page} */
const start = (doc = puma()) => createStore(startState(doc), reduce);
const moveFirst = (/** @type {number} */ value, /** @type {string} */ gesture) =>
  /** @type {Action} */ ({ type: 'set-joint-value', joint: 0, value, gesture });

/** Senseless actions are refused with an error and change nothing. @param {Page} store @param {Action} action */
function tryTo(store, action) {
  const before = store.state;
  try {
    store.dispatch(action);
  } catch (error) {
    expect(error).toBeInstanceOf(RangeError);
    expect(store.state).toBe(before);
  }
}

/** Written anew, from what a document promises. @param {import('../../../src/model/document.js').Doc} doc */
function expectSound({
  robot,
  posture,
  postures,
  targets,
  frames,
  obstacles,
  activeTool,
  activeUser,
  motionPrograms,
  codeOptions = 'x',
}) {
  expect(codeOptions.length > 0 && codeOptions.length <= 10_000).toBe(true);
  expectSoundPrograms(motionPrograms, { joints: robot.joints.length, targets, frames });
  expect(posture).toHaveLength(robot.joints.length);
  for (const values of [posture, ...postures.map(({ q }) => q)]) expect(values.every(Number.isFinite)).toBe(true);
  for (const { theta, d, a, alpha, lower, upper } of robot.joints) {
    for (const value of [theta, d, a, alpha]) expect(Number.isFinite(value)).toBe(true);
    expect(lower === undefined || upper === undefined || lower <= upper).toBe(true);
  }
  expect(new Set(postures.map(({ id }) => id)).size).toBe(postures.length);
  expect(new Set(targets.map(({ id }) => id)).size).toBe(targets.length);
  expect(new Set(frames.map(({ id }) => id)).size).toBe(frames.length);
  const named = (/** @type {string} */ kind) => frames.filter((frame) => frame.kind === kind).map(({ id }) => id);
  if (activeUser !== undefined) expect(named('user')).toContain(activeUser);
  for (const { frame } of targets) if (frame !== undefined) expect(named('user')).toContain(frame);
  if (activeTool !== undefined) {
    expect(named('tool')).toContain(activeTool);
    expect(frames.find(({ id }) => id === activeTool)).toMatchObject(robot.tool);
  }
  for (const { xyz, rpy, quaternion } of [robot.base, robot.tool, ...targets, ...frames, ...obstacles]) {
    expect(xyz).toHaveLength(3);
    expect([...xyz, ...(rpy ?? []), ...(quaternion ?? [])].every(Number.isFinite)).toBe(true);
    expect(rpy === undefined || (rpy.length === 3 && quaternion === undefined)).toBe(true);
    if (quaternion) expect(Math.hypot(...quaternion)).toBeCloseTo(1, 5);
  }
  expect(new Set(obstacles.map(({ id }) => id)).size).toBe(obstacles.length);
  for (const { kind, id, xyz, rpy, quaternion, ...sizes } of obstacles) {
    const names = { box: ['depth', 'height', 'width'], sphere: ['radius'], cylinder: ['height', 'radius'], plane: [] };
    expect(Object.keys(sizes).sort()).toEqual(names[kind]);
    for (const value of Object.values(sizes)) expect(value > 0 && value <= 1e9).toBe(true);
    expect(id).toMatch(/^[A-Za-z_][A-Za-z0-9_]{0,63}$/);
    expect([...xyz, ...(rpy ?? quaternion ?? [])]).not.toContain(undefined);
  }
  for (const { velocity = 1, acceleration = 1, jerk = 1, effort = 1, link } of robot.joints) {
    const { radius = 1, width = 1, height = 1, color = '#ffcc00' } = link;
    for (const value of [velocity, acceleration, jerk, effort, radius, width, height]) expect(value).toBeGreaterThan(0);
    expect(color).toMatch(/^#[0-9a-f]{6}$/i);
  }
  expect(robot.name.length).toBeLessThanOrEqual(400); // 200 characters, each of two units at most
}

/**
 * @param {import('../../../src/model/document.js').Doc['motionPrograms']} programs
 * @param {{ joints: number } & Pick<import('../../../src/model/document.js').Doc, 'targets' | 'frames'>} given
 */
function expectSoundPrograms(programs, { joints, targets, frames }) {
  expect(new Set(programs.map(({ id }) => id)).size).toBe(programs.length);
  for (const { name, steps } of programs) {
    expect(name.length).toBeLessThanOrEqual(400);
    expect(new Set(steps.map(({ id }) => id)).size).toBe(steps.length);
    for (const step of steps) {
      expect(Object.values(step)).not.toContain(undefined);
      if (!('target' in step)) continue;
      expect(step.speed > 0 && step.acceleration > 0 && step.acceleration <= 100).toBe(true);
      expect(step.kind === 'joint').toBe(step.speedUnit === '%');
      expect(step.kind === 'circular').toBe(step.via !== undefined);
      for (const target of [step.target, ...(step.via ? [step.via] : [])]) {
        if (target.kind === 'posture') expect(target.values).toHaveLength(joints);
        if (target.kind === 'target') expect(targets.map(({ id }) => id)).toContain(target.id);
        if (target.kind === 'pose') expect(target.xyz.every(Number.isFinite)).toBe(true);
      }
      const named = (/** @type {string} */ kind) => frames.filter((frame) => frame.kind === kind).map(({ id }) => id);
      if (step.tool !== undefined) expect(named('tool')).toContain(step.tool);
      if (step.frame !== undefined) expect(named('user')).toContain(step.frame);
    }
  }
}

describe('a session', () => {
  test('undoes all the way home, to the very same document, and is redone to the very same end', () => {
    fc.assert(
      fc.property(anyDocument, fc.array(anyAction, { maxLength: 60 }), (doc, actions) => {
        const store = start(deepFreeze(structuredClone(doc)));
        const first = store.state.doc;
        for (const action of actions) {
          tryTo(store, action);
          expectSound(store.state.doc);
          deepFreeze(store.state.doc);
        }
        store.dispatch({ type: 'end-gesture' });
        const last = store.state.doc;
        const { length } = store.state.future;
        while (store.state.past.length) store.dispatch({ type: 'undo' });
        expect(store.state.doc).toBe(first);
        while (store.state.future.length > length) store.dispatch({ type: 'redo' });
        expect(store.state.doc).toBe(last);
      }),
      { seed: SEED, numRuns: runs(150) },
    );
  });

  test('a command is refused by the reducer exactly when refusal() has a reason', () => {
    fc.assert(
      fc.property(anyDocument, anyAction, (doc, action) => {
        if (['undo', 'redo', 'end-gesture', 'cancel-gesture', 'show'].includes(action.type)) return;
        const state = startState(doc);
        const reason = refusal(doc, /** @type {import('../../../src/model/commands.js').Command} */ (action));
        if (reason) expect(() => reduce(state, action)).toThrow(reason.message);
        else expect(() => reduce(state, action)).not.toThrow();
      }),
      { seed: SEED, numRuns: runs(500) },
    );
  });

  test('an action that changes nothing gives the very same state', () => {
    const state = startState(puma());
    for (const action of /** @type {Action[]} */ ([
      { type: 'set-joint-field', joint: 1, field: 'a', value: 431.8 },
      { type: 'set-joint-value', joint: 0, value: state.doc.posture[0] },
      { type: 'set-posture', posture: [...state.doc.posture] },
      { type: 'undo' },
      { type: 'redo' },
      { type: 'end-gesture' },
      { type: 'cancel-gesture' },
      { type: 'show', change: { heldJoint: null } },
    ])) {
      expect(reduce(state, action)).toBe(state);
    }
  });

  test('what did not change is shared', () => {
    const before = startState(puma());
    const after = reduce(before, { type: 'set-joint-field', joint: 1, field: 'a', value: 330 });
    expect(after.doc.robot.joints[0]).toBe(before.doc.robot.joints[0]);
    expect(after.doc.posture).toBe(before.doc.posture);
    const jogged = reduce(before, moveFirst(5, 'a'));
    expect(jogged.doc.robot).toBe(before.doc.robot);
  });
});

test('a limit can be taken away, and only a limit', () => {
  const state = reduce(startState(puma()), { type: 'set-joint-field', joint: 0, field: 'lower', value: undefined });
  expect(state.doc.robot.joints[0]).not.toHaveProperty('lower');
  expect(() => reduce(state, { type: 'set-joint-field', joint: 0, field: 'a', value: undefined })).toThrow(
    'link length',
  );
});

test('a document in the store is frozen, all the way down', () => {
  const { doc } = reduce(startState(puma()), { type: 'set-joint-field', joint: 1, field: 'a', value: 400 });
  for (const part of [doc, doc.robot, doc.robot.joints, doc.robot.joints[1], doc.robot.joints[1].link, doc.posture]) {
    expect(Object.isFrozen(part)).toBe(true);
  }
});

test('a new number takes the place of the expression that was typed for the old one', () => {
  const doc = puma();
  const text = { a: 'sqrt(2)*300', d: '1/3' };
  const joints = doc.robot.joints.with(1, { ...doc.robot.joints[1], text });
  const after = reduce(startState({ ...doc, robot: { ...doc.robot, joints } }), {
    type: 'set-joint-field',
    joint: 1,
    field: 'a',
    value: 400,
  });
  expect(after.doc.robot.joints[1]).toMatchObject({ a: 400, text: { d: '1/3' } });
  expect(after.doc.robot.joints[1].text).not.toHaveProperty('a');
});

describe('a drag', () => {
  test('is one undo step', () => {
    const store = start();
    for (const value of [1, 2, 3, 4]) store.dispatch(moveFirst(value, 'drag'));
    store.dispatch({ type: 'end-gesture' });
    expect(store.state.past).toHaveLength(1);
    store.dispatch({ type: 'undo' });
    expect(store.state.doc.posture[0]).toBe(0);
  });

  test('two of them are two steps, even by the same name', () => {
    const store = start();
    for (const value of [1, 2]) {
      store.dispatch(moveFirst(value, 'drag'));
      store.dispatch({ type: 'end-gesture' });
    }
    expect(store.state.past).toHaveLength(2);
  });

  test('that ends where it began has changed nothing, and what could be redone still can', () => {
    const store = start();
    store.dispatch(moveFirst(9, 'before'));
    store.dispatch({ type: 'undo' });
    const before = store.state.doc;
    for (const value of [1, 2, 0]) store.dispatch(moveFirst(value, 'drag'));
    store.dispatch({ type: 'end-gesture' });
    expect(store.state.doc).toBe(before);
    expect([store.state.past.length, store.state.future.length]).toEqual([0, 1]);
  });

  test('that is cancelled leaves no trace, not even in redo', () => {
    const store = start();
    store.dispatch({ type: 'set-joint-field', joint: 0, field: 'a', value: 5 });
    store.dispatch({ type: 'undo' });
    const before = store.state;
    store.dispatch(moveFirst(1, 'drag'));
    store.dispatch(moveFirst(2, 'drag'));
    store.dispatch({ type: 'cancel-gesture' });
    expect(store.state).toEqual(before);
    store.dispatch({ type: 'redo' });
    expect(store.state.doc.robot.joints[0].a).toBe(5);
  });
});

describe('the session', () => {
  test('forgets what belonged to another robot, and nothing else', () => {
    const store = start();
    store.dispatch({
      type: 'show',
      change: { panel: 'code', target: [1, 2, 3, 4, 5, 6], cell: { joint: 5, field: 'a' } },
    });
    store.dispatch({ type: 'replace-document', doc: newDocument(LIBRARY.planar2r) });
    expect(store.state.session).toMatchObject({ panel: 'code', target: null, cell: null });
  });

  test('keeps the target while the table is edited, but not the answer to it', () => {
    const store = start();
    store.dispatch({ type: 'show', change: { target: [1, 2, 3, 4, 5, 6] } });
    store.dispatch({ type: 'set-joint-field', joint: 1, field: 'a', value: 400 });
    expect(store.state.session).toMatchObject({ target: [1, 2, 3, 4, 5, 6], answer: null });
  });
});

describe('recorded postures', () => {
  test('take the first free name', () => {
    const store = start();
    for (let i = 0; i < 3; i++) store.dispatch({ type: 'record-posture' });
    store.dispatch({ type: 'remove-posture', index: 1 });
    store.dispatch({ type: 'record-posture' });
    expect(store.state.doc.postures.map(({ id }) => id)).toEqual(['p1', 'p3', 'p2']);
  });

  test('keep the joint values of the moment', () => {
    const store = start();
    store.dispatch({ type: 'record-posture' });
    store.dispatch(moveFirst(77, 'a'));
    expect(store.state.doc.postures[0].q).toEqual(puma().posture);
  });
});
