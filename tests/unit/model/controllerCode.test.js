import fc from 'fast-check';
import { expect, test } from 'vitest';
import { writeFanucPair } from '../../../src/karel/fanucPair.js';
import { controllerCode } from '../../../src/model/controller/controllerCode.js';
import { conventionLines } from '../../../src/model/controller/controllerConvention.js';
import { LIBRARY, newDocument } from '../../../src/model/library.js';
import { runs, SEED } from '../../helpers/property.js';
import { readKarelPair } from '../karel/pairReader.js';

/** @import { ControllerDoc, Doc, RobotDoc } from '../../../src/model/document.js' */

const WRITTEN = { version: '0.1.0', generatedAt: '2026-07-01T12:00:00Z' };

/** @param {RobotDoc} robot @param {number[][]} values @returns {Doc} */
const recorded = (robot, ...values) => ({
  ...newDocument(robot),
  postures: values.map((q, i) => ({ id: `p${i + 1}`, q })),
});

/** @param {Record<number, Partial<ControllerDoc>>} changes  by joint @param {RobotDoc} [robot] @returns {RobotDoc} */
const withController = (changes, robot = LIBRARY.puma560) => ({
  ...robot,
  joints: robot.joints.map((joint, i) => ({ ...joint, controller: { ...joint.controller, ...changes[i] } })),
});
const FANUC_LIKE = withController({ 1: { sign: -1, offset: 90 }, 2: { coupledTo: 'joint_2', coupling: -1 } });

const codes = (/** @type {Doc} */ doc) => controllerCode(doc, WRITTEN).issues.map(({ code }) => code);

test('two postures of a Puma 560 become a KAREL and a TP file with the joint values of the model', () => {
  const [first, second] = [
    [0, 45, -180, 0, 45, 0],
    [30.5, -12.25, -90, 1.0625, -0.0001, 266],
  ];
  const { files, issues } = controllerCode(recorded(LIBRARY.puma560, first, second), WRITTEN);
  const slides = Array(6).fill(false);
  const pair = writeFanucPair({
    ...WRITTEN,
    programName: 'puma_560',
    robotName: 'Puma 560',
    convention: conventionLines(LIBRARY.puma560),
    points: [
      { name: 'p1', jointValues: first, slides },
      { name: 'p2', jointValues: second, slides },
    ],
  });
  expect(files).toEqual(pair.files);
  expect(files.map(({ name, language }) => [name, language])).toEqual([
    ['puma_560.kl', 'karel'],
    ['puma_mv.ls', 'fanuc-tp'],
  ]);
  expect(issues).toEqual([
    {
      severity: 'warning',
      code: 'no-controller-data',
      path: 'robot.joints',
      message:
        "Puma 560 has no controller data: the joint values in the code are the model's own, and the coupling of FANUC's J3 to J2 is not set.",
    },
  ]);
  expect(files[0].text).toContain("--   the model's own joint values; it has no controller data, and the coupling\n");
});

test('the values in the code are those of the pendant', () => {
  const { files, issues } = controllerCode(recorded(FANUC_LIKE, [1, 20, -30, 4, 5, 6], [0, 0, 0, 0, 0, 0]), WRITTEN);
  expect(issues).toEqual([]);
  expect(readKarelPair(files[0].text).points).toEqual([
    { register: 1, values: [1, 70, -100, 4, 5, 6] },
    { register: 2, values: [0, 90, -90, 0, 0, 0] },
  ]);
  const header = files[0].text.split('PROGRAM')[0];
  expect(header).toContain('--   J1 = q1\n--   J2 = -q2 + 90 deg\n--   J3 = q3 - J2\n--   J4 = q4\n');
});

test('the convention is written with its units, signs and factors', () => {
  const robot = withController(
    { 0: { coupledTo: 'joint_3', coupling: 0.5 }, 2: { sign: -1, offset: -7 } },
    LIBRARY.scara_cobra600,
  );
  expect(conventionLines(robot)).toEqual(['J1 = q1 + 0.5 J3', 'J2 = q2', 'J3 = -q3 - 7 mm', 'J4 = q4']);
});

test.for([
  [[], 'A motion needs at least 2 recorded postures; none is recorded.'],
  [[[0, 0, 0, 0, 0, 0]], 'A motion needs at least 2 recorded postures; one is recorded.'],
])('fewer than two postures give no files: case %#', ([values, message]) => {
  expect(controllerCode(recorded(FANUC_LIKE, .../** @type {number[][]} */ (values)), WRITTEN)).toEqual({
    files: [],
    issues: [{ severity: 'error', code: 'few-postures', path: 'postures', message }],
  });
});

test('a posture outside the limits is written, with a warning that names posture, joint and limit', () => {
  const { files, issues } = controllerCode(
    recorded(FANUC_LIKE, [0, 0, 0, 0, 0, 0], [160.5, 0, -226, 0, 100, 0]),
    WRITTEN,
  );
  expect(files).toHaveLength(2);
  expect(issues).toEqual([
    {
      severity: 'warning',
      code: 'outside-limits',
      path: 'postures.1.q.0',
      message: 'Posture "p2" has J1 at 160.5 deg, above its upper limit of 160 deg.',
    },
    {
      severity: 'warning',
      code: 'outside-limits',
      path: 'postures.1.q.2',
      message: 'Posture "p2" has J3 at -226 deg, below its lower limit of -225 deg.',
    },
  ]);
});

test('a value a rounding error past its limit is at the limit', () => {
  const beyond = 160 * (1 + 2 ** -52);
  expect(beyond).toBeGreaterThan(160);
  expect(codes(recorded(FANUC_LIKE, [0, 0, 0, 0, 0, 0], [beyond, 0, 0, 0, 0, 0]))).toEqual([]);
});

test('several turns of an unlimited joint are kept, with a warning beyond one', () => {
  /** @type {RobotDoc} */
  const endless = {
    ...FANUC_LIKE,
    joints: FANUC_LIKE.joints.with(5, {
      ...FANUC_LIKE.joints[5],
      type: 'continuous',
      lower: undefined,
      upper: undefined,
      label: 'tool',
    }),
  };
  const { files, issues } = controllerCode(recorded(endless, [0, 0, 0, 0, 0, 360], [0, 0, 0, 0, 0, -725.25]), WRITTEN);
  expect(readKarelPair(files[0].text).points.map(({ values }) => values[5])).toEqual([360, -725.25]);
  expect(issues).toEqual([
    {
      severity: 'warning',
      code: 'many-turns',
      path: 'postures.1.q.5',
      message:
        'Posture "p2" has J6 (tool) at -725.25 deg, more than a full turn from zero; the model has no limit there, but a controller\'s axis has.',
    },
  ]);
});

test('turns are counted only where the model has no limit', () => {
  const lowest = { ...FANUC_LIKE.joints[5], lower: -1000, upper: undefined };
  const robot = { ...FANUC_LIKE, joints: FANUC_LIKE.joints.with(5, lowest) };
  const { issues } = controllerCode(recorded(robot, [0, 0, 0, 0, 0, -900], [0, 0, 0, 0, 0, 900]), WRITTEN);
  expect(issues.map(({ code, path }) => [code, path])).toEqual([['many-turns', 'postures.1.q.5']]);
});

test.for(
  /** @type {Partial<ControllerDoc>[]} */ ([{ sign: -1 }, { offset: 1 }, { coupledTo: 'joint_1', coupling: 1 }]),
)('one joint with %j is controller data', (controller) => {
  expect(codes(recorded(withController({ 1: controller }), [0, 0, 0, 0, 0, 0], [0, 0, 0, 0, 0, 0]))).toEqual([]);
});

test.for(/** @type {Partial<ControllerDoc>[]} */ ([{ coupledTo: 'joint_1', coupling: 0 }, { coupling: 1 }]))(
  'a coupling that does nothing, %j, is no controller data',
  (controller) => {
    const doc = recorded(withController({ 1: controller }), [0, 0, 0, 0, 0, 0], [0, 0, 0, 0, 0, 0]);
    expect(codes(doc)).toEqual(['no-controller-data']);
  },
);

test('a value beyond what a controller takes gives no files', () => {
  const { files, issues } = controllerCode(recorded(FANUC_LIKE, [0, 0, 0, 0, 0, 0], [0, 0, 0, 0, 0, 1e6]), WRITTEN);
  expect(files).toEqual([]);
  expect(issues).toMatchObject([{ severity: 'error', code: 'value-too-large', path: 'postures.1.q.5' }]);
});

test('a slide is written in millimetres, and an arm with four axes comes with a warning', () => {
  const { files, issues } = controllerCode(
    recorded(LIBRARY.scara_cobra600, [0, 0, 0, 0], [10, 20, 150.5, 30]),
    WRITTEN,
  );
  expect(readKarelPair(files[0].text).points[1].values).toEqual([10, 20, 150.5, 30]);
  expect(files[0].text).toContain('-- Joint values, J1, J2, J4 in degrees, J3 in mm, are meant');
  expect(issues.map(({ code, path }) => [code, path])).toEqual([
    ['no-controller-data', 'robot.joints'],
    ['axis-count', 'postures'],
  ]);
});

test('a program name that is asked for is used, or the change is said; one made from the robot’s name is not an issue', () => {
  const doc = recorded(FANUC_LIKE, [0, 0, 0, 0, 0, 0], [1, 1, 1, 1, 1, 1]);
  expect(controllerCode(doc, { ...WRITTEN, programName: 'pick' }).files[0].name).toBe('pick.kl');
  expect(controllerCode(doc, { ...WRITTEN, programName: 'pick' }).issues).toEqual([]);
  expect(controllerCode(doc, { ...WRITTEN, programName: 'pick & place' }).issues).toMatchObject([
    { severity: 'warning', code: 'program-name-changed', path: 'programName' },
  ]);
  expect(controllerCode({ ...doc, robot: { ...FANUC_LIKE, name: 'Müllers Arm №5' } }, WRITTEN).issues).toEqual([]);
});

test('postures of any arm come out as they went in, to half a thousandth', () => {
  const anyCase = fc.constantFrom(...Object.values(LIBRARY)).chain((robot) => {
    const value = fc.double({ min: -720, max: 720, noNaN: true });
    const q = fc.array(value, { minLength: robot.joints.length, maxLength: robot.joints.length });
    return fc.record({ robot: fc.constant(robot), values: fc.array(q, { minLength: 2, maxLength: 6 }) });
  });
  fc.assert(
    fc.property(anyCase, ({ robot, values }) => {
      const { files } = controllerCode(recorded(robot, ...values), WRITTEN);
      const read = readKarelPair(files[0].text).points.map((point) => point.values);
      read.forEach((written, i) =>
        written.forEach((value, j) => {
          // where the controller counts J3 from the horizontal, J2 is not in its number
          const { coupledTo } = robot.joints[j].controller;
          const expected = coupledTo === 'joint_2' ? values[i][j] - values[i][1] : values[i][j];
          expect(Math.abs(value - expected)).toBeLessThanOrEqual(0.0005 + 1e-12);
        }),
      );
      expect(read.map((written) => written.length)).toEqual(values.map((q) => q.length));
    }),
    { seed: SEED, numRuns: runs(100) },
  );
});

test('as many postures as a document can hold', () => {
  const many = Array.from({ length: 999 }, (_, i) => [i / 10, 0, 0, 0, 0, 0]);
  const { files, issues } = controllerCode(recorded(FANUC_LIKE, ...many), WRITTEN);
  expect(readKarelPair(files[0].text).points[998]).toEqual({ register: 999, values: [99.8, 90, -90, 0, 0, 0] });
  expect(issues.map(({ code }) => code)).toEqual(['many-registers']);
});

test('the same document gives the same code', () => {
  const doc = recorded(FANUC_LIKE, [0, 0, 0, 0, 0, 0], [1, 1, 1, 1, 1, 1]);
  expect(controllerCode(doc, WRITTEN)).toEqual(controllerCode(structuredClone(doc), WRITTEN));
});
