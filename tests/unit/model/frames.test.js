/** User frames and tools through the session: kept, chosen as on a controller, edited, removed, undone, saved. */
import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { readRobotXml, writeRobotXml } from '../../../src/io/robotXml.js';
import { jogFramePose } from '../../../src/model/jog/jogFrame.js';
import { createDerived } from '../../../src/model/derived.js';
import { seenFromUser, targetPose } from '../../../src/model/frames/frames.js';
import { LIBRARY, newDocument } from '../../../src/model/library.js';
import { refusal } from '../../../src/model/refusals.js';
import { reduce, startState } from '../../../src/model/session.js';
import { createStore } from '../../../src/model/store.js';
import { toolChange } from '../../../src/model/frames/toolChange.js';
import { validateDocument } from '../../../src/model/validate.js';
import { whatChanged } from '../../../src/model/whatChanged.js';
import { SEED, runs } from '../../helpers/property.js';

/** @typedef {import('../../../src/model/session.js').AppState} AppState */
/** @typedef {import('../../../src/model/session.js').Action} Action */
/** @typedef {import('../../../src/model/document.js').Doc} Doc */
/** @typedef {import('../../../src/model/store.js').Store<AppState, Action>} Page */

const start = (/** @type {string} */ id = 'puma560') =>
  /** @type {Page} */ (createStore(startState(newDocument(LIBRARY[id])), reduce));
const GRIPPER = { xyz: [0, 0, 120], rpy: [0, 0, 0] };
const BENT = { xyz: [30, 0, 80], rpy: [0, 45, 0] };
const TABLE = { xyz: [400, -200, 50], rpy: [0, 0, 90] };

/** @param {Page} store @param {...Action} actions */
function act(store, ...actions) {
  for (const action of actions) store.dispatch(action);
  expect(validateDocument(store.state.doc)).toEqual([]);
  return store.state.doc;
}
const add = (/** @type {'user' | 'tool'} */ kind, /** @type {typeof GRIPPER} */ pose) =>
  /** @type {Action} */ ({ type: 'add-frame', kind, pose });
const shown = (/** @type {Doc} */ { frames }) => frames.map(({ kind, id, number }) => `${kind} ${number} ${id}`);

/** Where the tool is by matrices multiplied here: rows of 4 numbers, millimetres. @param {Doc} doc */
const tcpOf = (doc) => Array.from(createDerived().tcp(doc));
/** @param {ArrayLike<number>} a @param {ArrayLike<number>} b */
const farthest = (a, b) => Math.max(...Array.from(a, (value, i) => Math.abs(value - b[i])));

test('names and numbers are given, changed, and refused twice', () => {
  const store = start();
  let doc = act(store, add('user', TABLE), add('tool', GRIPPER), add('tool', BENT));
  expect(shown(doc)).toEqual(['user 1 user_1', 'tool 1 tool_1', 'tool 2 tool_2']);
  doc = act(store, { type: 'rename-frame', index: 1, id: 'gripper' }, { type: 'number-frame', index: 1, number: 7 });
  expect(shown(doc)).toEqual(['user 1 user_1', 'tool 7 gripper', 'tool 2 tool_2']);
  expect(shown(act(store, add('tool', BENT))).at(-1)).toBe('tool 1 tool_1');
  const against = (/** @type {import('../../../src/model/commands.js').Command} */ command) =>
    refusal(doc, command)?.message ?? null;
  expect(against({ type: 'rename-frame', index: 0, id: 'gripper' })).toBe('Another tool is called "gripper" already.');
  expect(against({ type: 'rename-frame', index: 2, id: 'user_1' })).toBe(
    'Another user frame is called "user_1" already.',
  );
  expect(against({ type: 'rename-frame', index: 2, id: 'no blanks' })).toMatch('A name is a letter');
  expect(against({ type: 'number-frame', index: 2, number: 7 })).toBe('The tool gripper has the number 7 already.');
  expect(against({ type: 'number-frame', index: 0, number: 7 })).toBe(null); // of user frames none has it
  expect(against({ type: 'number-frame', index: 2, number: 0 })).toMatch('whole number above 0');
  expect(against({ type: 'choose-tool', index: 0 })).toBe('Frame "user_1" is no tool.');
  expect(against({ type: 'choose-user', index: 1 })).toBe('Frame "gripper" is no user frame.');
  expect(against({ type: 'choose-tool', index: 1, posture: [0] })).toBe('Expected 6 joint values, got 1.');
});

describe('the active tool', () => {
  test('is what the robot holds, chosen, edited from either side, and undone', () => {
    const store = start();
    act(store, add('tool', GRIPPER), add('tool', BENT));
    const before = store.state.doc;
    let doc = act(store, { type: 'choose-tool', index: 1 });
    expect([doc.activeTool, doc.robot.tool, doc.posture]).toEqual(['tool_2', BENT, before.posture]);
    expect(doc.robot.joints).toBe(before.robot.joints);
    doc = act(store, { type: 'edit-frame', index: 1, pose: GRIPPER });
    expect(doc.robot.tool).toEqual(GRIPPER);
    doc = act(store, { type: 'set-tool', pose: BENT });
    expect(doc.frames[1]).toEqual({ kind: 'tool', id: 'tool_2', number: 2, ...BENT });
    doc = act(store, { type: 'rename-frame', index: 1, id: 'bent' });
    expect(doc.activeTool).toBe('bent');
    for (let i = 0; i < 4; i++) act(store, { type: 'undo' });
    expect(store.state.doc).toBe(before);
    expect(act(store, { type: 'choose-tool', index: null })).toBe(before); // it is none already
  });

  test('leaves the flange itself when it is removed', () => {
    const store = start();
    const doc = act(store, add('tool', GRIPPER), { type: 'choose-tool', index: 0 }, { type: 'remove-frame', index: 0 });
    expect([doc.frames, doc.robot.tool.xyz, 'activeTool' in doc]).toEqual([[], [0, 0, 0], false]);
  });

  test('puts a tool that stands in no list into it, once', () => {
    const store = start();
    let doc = act(store, { type: 'set-tool', pose: BENT }, add('tool', GRIPPER), { type: 'choose-tool', index: 0 });
    expect(shown(doc)).toEqual(['tool 1 tool_1', 'tool 2 tool_2']);
    expect(doc.frames[1]).toMatchObject(BENT);
    doc = act(store, { type: 'choose-tool', index: 1 }, { type: 'choose-tool', index: null });
    expect(doc.frames).toHaveLength(2);
  });

  test('stays the tool of the robot in other units and in the other convention, there and back', () => {
    for (const tool of [GRIPPER, BENT, { xyz: [25, 0, 0], rpy: [90, 0, 0] }]) {
      const store = start('puma560');
      act(store, add('tool', tool), { type: 'choose-tool', index: 0 });
      const pose = tcpOf(store.state.doc);
      for (const action of /** @type {Action[]} */ ([
        { type: 'convert-convention', convention: 'modified' },
        { type: 'convert-units', units: { length: 'm', angle: 'rad' } },
        { type: 'convert-convention', convention: 'standard' },
      ])) {
        const doc = act(store, action);
        expect(doc.activeTool).toBe('tool_1');
        expect(farthest(tcpOf(doc), pose)).toBeLessThan(1e-12);
      }
    }
  });
});

describe('a tool change', () => {
  const withTools = () => {
    const store = start();
    act(store, add('tool', GRIPPER), add('tool', BENT), { type: 'choose-tool', index: 0 });
    act(store, { type: 'set-posture', posture: [10, 60, -170, 20, 40, -30] });
    return store;
  };

  test('keeps the flange: the posture stays, and the TCP moves', () => {
    const store = withTools();
    const { doc } = store.state;
    const { command } = toolChange(doc, 1, 'flange');
    expect(command).toEqual({ type: 'choose-tool', index: 1 });
    const after = act(store, /** @type {Action} */ (command));
    expect(after.posture).toBe(doc.posture);
    const there = tcpOf(after).slice(12, 15);
    const moved = Math.hypot(
      ...tcpOf(doc)
        .slice(12, 15)
        .map((value, k) => value - there[k]),
    );
    expect(moved).toBeCloseTo(Math.hypot(0.03, 0.04), 12);
  });

  test('keeps the TCP: the arm moves in the same step, and one undo brings all of it back', () => {
    const store = withTools();
    const { doc } = store.state;
    for (const index of [1, null]) {
      const { command } = toolChange(doc, index, 'tcp');
      const after = act(store, /** @type {Action} */ (command));
      expect(farthest(tcpOf(after), tcpOf(doc))).toBeLessThan(1e-6);
      expect(Math.max(...after.posture.map((value, i) => Math.abs(value - doc.posture[i])))).toBeGreaterThan(1);
      expect(act(store, { type: 'undo' })).toBe(doc);
    }
  });

  test('says what is missing where the arm cannot keep the TCP', () => {
    const store = withTools();
    act(store, add('tool', { xyz: [0, 0, 3000], rpy: [0, 0, 0] }));
    const { command, answer } = toolChange(store.state.doc, 2, 'tcp');
    expect([command, answer?.status]).toEqual([null, 'unreachable']);
    const planar = start('planar3r');
    act(planar, add('tool', { xyz: [0, 0, 100], rpy: [0, 0, 0] }));
    expect(toolChange(planar.state.doc, 0, 'tcp').answer?.isMet).toBe(false);
  });

  test('keeps any TCP that the new tool was at, or says that it cannot', () => {
    const angle = fc.integer({ min: -90, max: 90 });
    fc.assert(
      fc.property(fc.tuple(angle, angle, angle, angle, angle, angle), fc.boolean(), (posture, isFirst) => {
        const store = withTools();
        act(store, { type: 'set-posture', posture }, { type: 'choose-tool', index: isFirst ? 0 : 1 });
        const { doc } = store.state;
        const { command, answer } = toolChange(doc, isFirst ? 1 : 0, 'tcp');
        if (!command) expect(answer.isMet).toBe(false);
        else expect(farthest(tcpOf(act(store, command)), tcpOf(doc))).toBeLessThan(1e-4);
      }),
      { seed: SEED, numRuns: runs(20) },
    );
  });
});

describe('a user frame', () => {
  test('is the world where none is active, and wherever it was chosen then', () => {
    const store = start();
    act(store, add('user', TABLE), { type: 'choose-user', index: 0 });
    const { handle, jog, jacobian, numbers } = store.state.session;
    store.dispatch({
      type: 'show',
      change: {
        handle: { ...handle, axes: 'user' },
        jog: { ...jog, frame: 'user' },
        jacobian: { ...jacobian, frame: 'user' },
        targetFrom: 'user',
        numbers: { ...numbers, frame: 'tool', from: 'user' },
      },
    });
    const derived = createDerived();
    const { doc } = store.state;
    const axes = jogFramePose(derived.chain(doc), derived.posture(doc), 'user', derived.user(doc));
    expect(Array.from(axes.slice(0, 3))).toEqual([0, 1, 0]);
    expect(Array.from(derived.user(doc).slice(12, 15))).toEqual([0.4, -0.2, 0.05]);
    act(store, { type: 'rename-frame', index: 0, id: 'table' });
    expect([store.state.doc.activeUser, store.state.session.jog.frame]).toEqual(['table', 'user']);
    act(store, { type: 'remove-frame', index: 0 });
    const { session } = store.state;
    const { handle: axesNow, jog: jogNow, jacobian: rows, numbers: shownNow, targetFrom } = session;
    const chosen = [axesNow.axes, jogNow.frame, rows.frame, shownNow.from, targetFrom];
    expect(chosen).toEqual(chosen.map(() => 'world'));
  });

  test('takes its targets along, and leaves them where they are when it goes', () => {
    const store = start();
    const at = { xyz: [100, 0, 20], rpy: [180, 0, 0] };
    let doc = act(store, add('user', TABLE), { type: 'add-target', pose: at, frame: 'user_1' });
    // 100 along the frame's x, which is the world's y
    const place = (/** @type {Doc} */ now) => Array.from(targetPose(now, now.targets[0]).slice(12, 15));
    expect(farthest(place(doc), [0.4, -0.1, 0.07])).toBeLessThan(1e-12);
    const back = seenFromUser(doc, 'user_1', targetPose(doc, doc.targets[0]));
    expect(farthest(back.slice(12, 15), [0.1, 0, 0.02])).toBeLessThan(1e-12);
    doc = act(store, { type: 'edit-frame', index: 0, pose: { ...TABLE, xyz: [500, -200, 50] } });
    expect(farthest(place(doc), [0.5, -0.1, 0.07])).toBeLessThan(1e-12);
    doc = act(store, { type: 'rename-frame', index: 0, id: 'table' });
    expect(doc.targets[0].frame).toBe('table');
    doc = act(store, { type: 'remove-frame', index: 0 });
    expect(doc.targets).toEqual([{ id: 'aim_1', xyz: [500, -100, 70], rpy: [expect.closeTo(180), 0, 90] }]);
    expect(refusal(doc, { type: 'add-target', pose: at, frame: 'table' })?.message).toBe(
      'There is no user frame "table".',
    );
  });
});

test('steps are named by what they did', () => {
  const store = start();
  const did = (/** @type {Action[]} */ ...actions) => {
    const before = store.state.doc;
    return whatChanged(before, act(store, ...actions));
  };
  expect(did(add('user', TABLE))).toEqual({ what: 'list', list: 'frames', change: 'added', id: 'user_1' });
  act(store, add('tool', GRIPPER), add('tool', BENT));
  expect(did({ type: 'choose-tool', index: 1 })).toEqual({ what: 'tool-chosen', id: 'tool_1' });
  expect(did({ type: 'choose-user', index: 0 })).toEqual({ what: 'user-chosen', id: 'user_1' });
  const renamed = did({ type: 'rename-frame', index: 1, id: 'gripper' });
  expect(renamed).toEqual({ what: 'list', list: 'frames', change: 'renamed', id: 'gripper' });
  expect(did({ type: 'edit-frame', index: 1, pose: BENT })).toEqual({ what: 'tool' });
  expect(did({ type: 'remove-frame', index: 1 })).toMatchObject({ change: 'removed', id: 'gripper' });
  expect(did({ type: 'choose-user', index: null })).toEqual({ what: 'user-chosen', id: null });
});

test('what is active is saved, and a file in which the tool differs from the active one is refused', () => {
  const store = start();
  act(store, add('tool', GRIPPER), { type: 'choose-tool', index: 0 });
  const doc = act(store, add('user', TABLE), { type: 'choose-user', index: 1 });
  const saved = writeRobotXml(doc);
  expect(saved).toContain('<frames activeUser="user_1" activeTool="tool_1">');
  expect(readRobotXml(saved).doc).toEqual(doc);
  const others = readRobotXml(saved.replace('<tool xyz="0 0 120"', '<tool xyz="0 0 121"'));
  expect(others.doc).toBe(null);
  expect(others.issues.map(({ message }) => message)).toEqual([
    expect.stringMatching(/^Line \d+: the active tool "tool_1" and the tool of the robot have different numbers; /),
  ]);
  const gone = readRobotXml(saved.replace('activeUser="user_1"', 'activeUser="tool_1"'));
  expect(gone.issues.map(({ message }) => message)).toEqual([
    expect.stringMatching(/^Line \d+: the model refers to the user frame "tool_1"; /),
  ]);
  // written otherwise, the same tool is the same
  expect(readRobotXml(saved.replace('<tool xyz="0 0 120" rpy="0 0 0"/>', '<tool xyz="0 0 120"/>')).issues).toEqual([]);
});
