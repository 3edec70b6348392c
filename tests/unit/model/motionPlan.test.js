/** A program of the document becomes moves for the kernel, in its units; what is assumed is named, what cannot be names its step. */
import { describe, expect, test } from 'vitest';
import { compileRobot } from '../../../src/model/compile.js';
import { atOnce } from '../../../src/model/inSlices.js';
import { LIBRARY, newDocument } from '../../../src/model/library.js';
import { motionMoves, movesInSlices, postureAt } from '../../../src/model/program/motionPlan.js';
import { planRequest } from '../../../src/model/program/planRequest.js';
import { READY_PROGRAMS } from '../../../src/model/program/readyPrograms.js';
import { readySteps } from '../../helpers/readySteps.js';
import { validateDocument } from '../../../src/model/validate.js';
import { answerPlanQuestion } from '../../../src/motion/planQuestion.js';
import { READY_WORDS } from '../../../src/ui/words/ready.js';

/** @typedef {import('../../../src/model/document.js').Doc} Doc */
/** @typedef {import('../../../src/model/document.js').StepDoc} StepDoc */
/** @typedef {import('../../../src/model/document.js').StepTarget} StepTarget */

const manner = /** @type {const} */ ({ acceleration: 50, ending: { kind: 'percent', value: 40 } });
/** @param {StepTarget} target @returns {StepDoc} */
const joint = (target) => ({ id: 'j', kind: 'joint', target, speed: 25, speedUnit: '%', ...manner });
/** @param {StepTarget} target @returns {import('../../../src/model/document.js').MoveStep} */
const line = (target) => ({ id: 'l', kind: 'linear', target, speed: 250, speedUnit: 'length/s', ...manner });
/** @param {Doc} doc @param {...StepDoc} steps @returns {Doc} */
const withSteps = (doc, ...steps) => {
  const made = {
    ...doc,
    motionPrograms: [{ id: 'm', name: 'M', steps: steps.map((step, i) => ({ ...step, id: `s${i}` })) }],
  };
  expect(validateDocument(made)).toEqual([]);
  return made;
};
const movesOf = (/** @type {Doc} */ doc) => motionMoves(doc, doc.motionPrograms[0]);

const puma = newDocument(LIBRARY.puma560);
/** The Puma 560 with its tool turned down in front of it, of which the pose is known by hand: its wrist is at (431.8, …) */
const place = /** @type {const} */ ({ kind: 'pose', xyz: [500, -150.05, 300], rpy: [180, 0, 0] });

describe('moves', () => {
  test('are in metres, radians and shares; every number by hand', () => {
    const doc = withSteps(
      puma,
      joint({ kind: 'posture', values: [0, 45, -180, 0, 45, 90] }),
      { ...line(place), ending: { kind: 'distance', value: 10 }, law: 'quintic' },
      { ...line({ ...place, xyz: [500, 0, 300] }), speed: 90, speedUnit: 'angle/s' },
      { id: '', kind: 'wait', seconds: 0.5 },
    );
    const { moves, steps, issues } = movesOf(doc);
    expect(issues).toEqual([]);
    expect(steps).toEqual([0, 1, 2, 3]);
    const quarter = Math.PI / 4;
    expect(moves[0]).toEqual({
      ...{ kind: 'joint', speed: 0.25, acceleration: 0.5, ending: { kind: 'share', share: 0.4 } },
      posture: Float64Array.of(0, quarter, -4 * quarter, 0, quarter, 2 * quarter),
    });
    expect(moves[1]).toMatchObject({
      ...{ kind: 'linear', speed: 0.25, turnSpeed: Math.PI, acceleration: 2, law: 'quintic' },
      ending: { kind: 'distance', distance: 0.01 },
    });
    const { T_base_tcp } = /** @type {{ T_base_tcp: Float64Array }} */ (/** @type {unknown} */ (moves[1]));
    // half a turn about x: y and z point the other way
    [1, 0, 0, 0, 0, -1, 0, 0, 0, 0, -1, 0, 0.5, -0.15005, 0.3, 1].forEach((value, k) =>
      expect(T_base_tcp[k]).toBeCloseTo(value, 12),
    );
    expect(moves[2]).toMatchObject({ speed: 1, turnSpeed: Math.PI / 2, acceleration: 2 });
    expect(moves[3]).toEqual({ kind: 'wait', seconds: 0.5 });
  });

  test('of a step that is passed over, of outputs, labels and remarks there are none; indices stay those of the program', () => {
    const doc = withSteps(
      puma,
      { id: '', kind: 'comment', text: 'a' },
      { ...joint({ kind: 'posture', values: [1, 2, 3, 4, 5, 6] }), disabled: true },
      { id: '', kind: 'set-output', output: 1, value: 'on' },
      { id: '', kind: 'label', label: 'a' },
      joint({ kind: 'posture', values: [1, 2, 3, 4, 5, 6] }),
    );
    expect(movesOf(doc).steps).toEqual([4]);
  });

  test('go by a named target in its user frame, and by a pose in the frame of the step, with the tool of the step', () => {
    const doc = withSteps(
      {
        ...puma,
        frames: [
          { kind: 'user', id: 'table', xyz: [500, 0, 0] },
          { kind: 'tool', id: 'pen', xyz: [0, 0, 100] },
        ],
        targets: [{ id: 'aim', xyz: [0, -150.05, 300], rpy: [180, 0, 0], frame: 'table' }],
      },
      line({ kind: 'target', id: 'aim' }),
      { ...line({ ...place, xyz: [0, -150.05, 300] }), frame: 'table', tool: 'pen' },
    );
    const { moves } = movesOf(doc);
    const [a, b] = /** @type {import('../../../src/motion/moves.js').LinearMove[]} */ (/** @type {unknown} */ (moves));
    expect([...b.T_base_tcp]).toEqual([...a.T_base_tcp]);
    expect(a.chain).toBeUndefined();
    expect(b.chain?.tool?.[14]).toBeCloseTo(0.1, 14);
  });

  test('of a called program stand in its place, and name the call; a circle of calls is refused, an unknown program passed over', () => {
    const call = (/** @type {string} */ program) => /** @type {StepDoc} */ ({ id: 'c', kind: 'call', program });
    const there = joint({ kind: 'posture', values: [1, 2, 3, 4, 5, 6] });
    const doc = withSteps(puma, there, call('other'), call('ONLY_THERE'), there);
    const other = { id: 'other', name: 'Other', steps: [there, { ...there, id: 'k' }] };
    const both = { ...doc, motionPrograms: [...doc.motionPrograms, other] };
    expect(movesOf(both)).toMatchObject({ steps: [0, 1, 1, 3], issues: [] });
    expect(movesOf(both).assumptions).toContainEqual({ what: 'call', steps: [2] });
    const round = { ...both, motionPrograms: [doc.motionPrograms[0], { ...other, steps: [there, call('m')] }] };
    expect(movesOf(round)).toMatchObject({
      moves: [],
      issues: [{ step: 1, message: 'Step 2 of "Other": The program would call itself.' }],
    });
  });

  test('to a pose by the joints go to the configuration that is asked for, and to no other', () => {
    const at = (/** @type {string | undefined} */ configuration) => {
      const doc = withSteps(puma, joint({ ...place, ...(configuration !== undefined && { configuration }) }));
      return movesOf(doc);
    };
    const elbow = (/** @type {string} */ asked) => {
      const [move] = at(asked).moves;
      return 'posture' in move ? move.posture[2] : NaN;
    };
    const near = at(undefined);
    expect(near.issues).toEqual([]);
    const names = ['N U T', 'N D T', 'F U T', 'F D T', 'N U B', 'N D B', 'F U B', 'F D B'].filter(
      (name) => at(name).issues.length === 0,
    );
    expect(names.length).toBeGreaterThan(1);
    expect(new Set(names.map((name) => elbow(name).toFixed(6))).size).toBeGreaterThan(1);
    expect(at('X Y Z').issues[0].message).toBe('Step 1: The arm has no posture there in the configuration "X Y Z".');
    expect(postureAt(puma, { ...line({ ...place, xyz: [5000, 0, 0] }) })).toEqual({
      message: 'The arm does not reach this pose.',
    });
  });
});

test('what neither the robot nor the program says is assumed, and named; what the robot says is taken', () => {
  const [first, ...others] = puma.robot.joints.map((joint) => ({
    ...joint,
    ...{ velocity: undefined, acceleration: undefined, jerk: undefined },
  }));
  const robot = { ...puma.robot, joints: [{ ...first, velocity: 90, acceleration: 180 }, ...others] };
  const doc = withSteps({ ...puma, robot }, line(place), { id: '', kind: 'wait-input', input: 1, value: 'on' });
  const { limits, assumptions } = movesOf(doc);
  expect(limits.rates[0]).toBeCloseTo(Math.PI / 2, 14);
  expect(limits.accelerations[0]).toBeCloseTo(Math.PI, 14);
  expect(limits.rates[1]).toBe(Math.PI);
  expect(limits.accelerations[1]).toBe(4 * Math.PI);
  expect(limits.jerks).toBeUndefined();
  expect(assumptions).toEqual([
    { what: 'joint-rate', joints: [1, 2, 3, 4, 5] },
    { what: 'joint-acceleration', joints: [1, 2, 3, 4, 5] },
    { what: 'tool-turn', steps: [0] },
    { what: 'tool-acceleration', steps: [0] },
    { what: 'input', steps: [1] },
  ]);
});

test('are found posture by posture, so that nobody waits for more than one', () => {
  const poses = Array.from({ length: 9 }, (_, i) => ({ ...place, xyz: /** @type {const} */ ([500, -150 + i, 300]) }));
  const doc = withSteps(puma, ...poses.slice(0, 5).map(line), ...poses.slice(5).map(joint));
  const run = movesInSlices(doc, doc.motionPrograms[0], doc.posture);
  const shares = [];
  let turn = run.next();
  for (; !turn.done; turn = run.next()) shares.push(turn.value);
  expect(shares).toEqual([0, 1, 2, 3, 4, 5, 5, 5, 5, 5, 5, 6, 7, 8].map((done) => done / 9)); // at the sixth where the lines lead
  expect(turn.value).toEqual(movesOf(doc));
});

test.each(['puma560', 'ur5', 'planar2r'])('ready programs for %s are sound, and can be run', (id) => {
  const doc = newDocument(LIBRARY[id]);
  for (const ready of READY_PROGRAMS.filter((_, i) => id === 'puma560' || i < 2 || i > 4)) {
    const steps = readySteps(doc, ready, READY_WORDS.comments);
    expect(steps, ready).not.toBeNull();
    const made = withSteps(doc, ...(steps ?? []).map((step) => /** @type {StepDoc} */ ({ ...step, id: 's' })));
    const question = { doc: made, program: made.motionPrograms[0], start: made.posture };
    const { request, issues } = atOnce(planRequest(question, compileRobot(made.robot)));
    expect(issues, ready).toEqual([]);
    expect(answerPlanQuestion(request).refused, ready).toBe(null);
  }
});

test.each(['puma560', 'cart_ppp', 'kuka_kr6_r900'])(
  'the textbook’s points are 10, 35, 25 and 10° of the first joint of %s',
  (id) => {
    const doc = newDocument(LIBRARY[id]);
    const steps = readySteps(doc, 'points', READY_WORDS.comments) ?? [];
    const first = steps.map((step) => ('target' in step && 'values' in step.target ? step.target.values[0] : NaN));
    const [from, farthest] = first;
    // as in Craig 7.3, but from where the arm begins; a slide goes as far in its own measure
    const swing = id === 'cart_ppp' ? farthest - from : Math.sign(farthest - from) * 25;
    expect(Math.abs(swing)).toBeGreaterThan(0);
    const wanted = [10, 35, 25, 10, 35, 25, 10].map((value) => from + ((value - 10) / 25) * swing);
    first.forEach((value, i) => expect(value).toBeCloseTo(wanted[i], 4));
  },
);
