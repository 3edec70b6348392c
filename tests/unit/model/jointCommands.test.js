/** Which joints a robot has: postures keep their meaning, and what is refused says why. */
import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { tcpPose } from '../../../src/kinematics/forward.js';
import { applyCommand } from '../../../src/model/commands.js';
import { compilePosture, compileRobot } from '../../../src/model/compile.js';
import { refusal } from '../../../src/model/refusals.js';
import { reduce, startState } from '../../../src/model/session.js';
import { validateDocument } from '../../../src/model/validate.js';
import { SEED, runs } from '../../helpers/property.js';
import { documents } from '../io/documents.js';

/** @typedef {import('../../../src/model/commands.js').Command} Command */
/** @typedef {import('../../../src/model/document.js').Doc} Doc */
/** @typedef {import('../../../src/model/document.js').JointDoc} JointDoc */

/** @param {Partial<JointDoc>} more @param {number} i @returns {JointDoc} */
const joint = (more, i) => ({
  ...{ id: `joint_${i + 1}`, type: 'revolute', theta: 10 * i, d: i, a: 100 + i, alpha: 0 },
  link: { kind: 'auto' },
  controller: { sign: 1, offset: 0, coupling: 0 },
  ...more,
});

/** @param {Partial<JointDoc>[]} joints @returns {Doc} */
const docOf = (...joints) => ({
  robot: {
    ...{ name: 'test', info: {}, units: { length: 'mm', angle: 'deg' }, convention: 'standard' },
    base: { xyz: [0, 0, 0], rpy: [0, 0, 0] },
    tool: { xyz: [0, 0, 50], rpy: [0, 0, 0] },
    joints: joints.map(joint),
  },
  posture: joints.map((_, i) => i + 1),
  postures: [{ id: 'p1', q: joints.map((_, i) => 10 * (i + 1)) }],
  frames: [],
  targets: [],
  obstacles: [],
  motionPrograms: [],
  programs: [],
  extensions: [],
});

const idsOf = (/** @type {Doc} */ { robot }) => robot.joints.map(({ id }) => id);
const reason = (/** @type {Doc} */ doc, /** @type {Command} */ command) => refusal(doc, command)?.message ?? null;
const tcpOf = (/** @type {Doc} */ { robot, posture }) => tcpPose(compileRobot(robot), compilePosture(robot, posture));

test.each(/** @type {const} */ (['standard', 'modified']))(
  'a new joint changes nothing yet, wherever it is put (%s)',
  (convention) => {
    const doc = docOf({ alpha: 90 }, { alpha: -30, type: 'prismatic' }, {});
    const before = { ...doc, robot: { ...doc.robot, convention } };
    for (const after of [-1, 0, 1, 2]) {
      const now = applyCommand(before, { type: 'add-joint', after });
      expect(now.robot.joints[after + 1]).toMatchObject({ id: 'joint_4', type: 'revolute', a: 0, d: 0, home: 0 });
      expect(now.posture).toEqual([1, 2, 3].toSpliced(after + 1, 0, 0));
      expect(now.postures[0].q).toEqual([10, 20, 30].toSpliced(after + 1, 0, 0));
      tcpOf(now).forEach((value, k) => expect(value).toBeCloseTo(tcpOf(before)[k], 14));
    }
  },
);

describe('a duplicate', () => {
  test('stands after its original, under the first free name, at its home in every posture', () => {
    const doc = docOf({ home: 7 }, { id: 'joint_4', lower: 20, upper: 40 });
    const first = applyCommand(doc, { type: 'duplicate-joint', joint: 0 });
    expect(idsOf(first)).toEqual(['joint_1', 'joint_2', 'joint_4']);
    expect(first.robot.joints[1]).toEqual({ ...doc.robot.joints[0], id: 'joint_2' });
    expect(first.posture).toEqual([1, 7, 2]);
    expect(first.postures[0].q).toEqual([10, 7, 20]);
    // without a home: zero, brought inside the limits
    expect(applyCommand(doc, { type: 'duplicate-joint', joint: 1 }).posture).toEqual([1, 2, 20]);
  });
});

describe('removing a joint', () => {
  test('takes its value out of every posture, and what was coupled to it stands alone', () => {
    const coupled = { sign: /** @type {const} */ (-1), offset: 5, coupling: 1 };
    const doc = docOf({}, {}, { controller: { ...coupled, coupledTo: 'joint_2' } });
    const now = applyCommand(doc, { type: 'remove-joint', joint: 1 });
    expect([idsOf(now), now.posture, now.postures[0].q]).toEqual([
      ['joint_1', 'joint_3'],
      [1, 3],
      [10, 30],
    ]);
    expect(now.robot.joints[1].controller).toEqual({ sign: -1, offset: 5, coupling: 0 });
  });
});

test('a joint that is moved takes its values with it', () => {
  const doc = docOf({}, {}, {}, {});
  const now = applyCommand(doc, { type: 'move-joint', joint: 0, to: 2 });
  expect(idsOf(now)).toEqual(['joint_2', 'joint_3', 'joint_1', 'joint_4']);
  expect([now.posture, now.postures[0].q]).toEqual([
    [2, 3, 1, 4],
    [20, 30, 10, 40],
  ]);
  expect(applyCommand(doc, { type: 'move-joint', joint: 1, to: 1 })).toBe(doc);
});

describe('a change of type', () => {
  const rates = { velocity: 1, acceleration: 2, jerk: 3, effort: 4 };
  const full = { lower: -9, upper: 9, home: 3, ...rates, label: 'Elbow', text: { a: '99+1' } };

  test('between turning and sliding keeps the row and clears what was of its kind', () => {
    const controller = { sign: /** @type {const} */ (-1), offset: 5, coupling: 1, coupledTo: 'joint_1' };
    const leaning = { sign: /** @type {const} */ (1), offset: 2, coupling: -1, coupledTo: 'joint_2' };
    const doc = docOf({}, { ...full, controller }, { controller: leaning });
    const now = applyCommand(doc, { type: 'set-joint-type', joint: 1, jointType: 'prismatic' });
    expect(now.robot.joints[1]).toEqual({
      ...joint({ label: 'Elbow', text: { a: '99+1' } }, 1),
      type: 'prismatic',
      controller: { sign: -1, offset: 0, coupling: 0 },
    });
    expect(now.robot.joints[2].controller).toEqual({ sign: 1, offset: 2, coupling: 0 });
    expect([now.posture, now.postures[0].q]).toEqual([
      [1, 0, 3],
      [10, 0, 30],
    ]);
  });

  test('to turning without end loses its limits, and nothing else', () => {
    const doc = docOf({}, full);
    const now = applyCommand(doc, { type: 'set-joint-type', joint: 1, jointType: 'continuous' });
    expect(now.robot.joints[1]).toEqual(
      joint({ home: 3, ...rates, label: 'Elbow', text: { a: '99+1' }, type: 'continuous' }, 1),
    );
    expect(now.posture).toEqual(doc.posture);
    expect(applyCommand(doc, { type: 'set-joint-type', joint: 1, jointType: 'revolute' })).toBe(doc);
  });
});

test('a seventh joint, one of the last two, and what is no joint or no type are refused in words', () => {
  const two = docOf({}, {});
  const six = docOf({}, {}, {}, {}, {}, {});
  expect(reason(six, { type: 'add-joint', after: 5 })).toBe('A robot has at most six joints.');
  expect(reason(six, { type: 'duplicate-joint', joint: 0 })).toBe('A robot has at most six joints.');
  expect(reason(two, { type: 'remove-joint', joint: 0 })).toBe('A robot has at least two joints.');
  expect(reason(two, { type: 'add-joint', after: 2 })).toBe('Expected a joint index from −1 to 1, got 2.');
  expect(reason(two, { type: 'move-joint', joint: 0, to: -1 })).toBe('Expected a joint index from 0 to 1, got −1.');
  expect(reason(two, { type: 'remove-joint', joint: NaN })).toBe('Expected a joint index from 0 to 1, got NaN.');
  const spherical = /** @type {'revolute'} */ ('spherical');
  expect(reason(two, { type: 'set-joint-type', joint: 0, jointType: spherical })).toBe(
    'Expected revolute or prismatic or continuous as the type, got "spherical".',
  );
});

test('whatever joint command a sound document takes leaves it sound, and one undo brings the same object back', () => {
  const index = fc.integer({ min: -1, max: 6 });
  const anyCommand = /** @type {import('fast-check').Arbitrary<Command>} */ (
    fc.record({
      type: fc.constantFrom('add-joint', 'remove-joint', 'duplicate-joint', 'move-joint', 'set-joint-type'),
      ...{ after: index, joint: index, to: index },
      jointType: fc.constantFrom('revolute', 'prismatic', 'continuous'),
    })
  );
  fc.assert(
    fc.property(documents, anyCommand, (doc, command) => {
      if (refusal(doc, command)) return;
      const before = startState(doc);
      const after = reduce(before, command);
      expect(validateDocument(after.doc)).toEqual([]);
      if (after !== before) expect(reduce(after, { type: 'undo' }).doc).toBe(doc);
    }),
    { seed: SEED, numRuns: runs(300) },
  );
});
