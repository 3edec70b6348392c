/** What of a document is written, with which options, what is against it, and what its header and certificate say. */
import fc from 'fast-check';
import { expect, test } from 'vitest';
import { dexterity } from '../../../src/kinematics/dexterity.js';
import { compilePosture, compileRobot } from '../../../src/model/compile.js';
import { atOnce } from '../../../src/model/inSlices.js';
import { certificateStatus } from '../../../src/model/controller/certificate.js';
import { readFrameNumber, readOption } from '../../../src/model/controller/codeOptions.js';
import { codeSet, fileName, statusOf } from '../../../src/model/controller/codeSets.js';
import { codeSources, sourceOfText } from '../../../src/model/controller/codeSource.js';
import { conventionLines } from '../../../src/model/controller/controllerConvention.js';
import { verifyCode } from '../../../src/model/controller/verifyCode.js';
import { certified, writeCode } from '../../../src/model/controller/writeCode.js';
import { LIBRARY, newDocument } from '../../../src/model/library.js';
import { runs, SEED } from '../../helpers/property.js';
import { readWritten } from '../karel/writtenReader.js';

/** @import { CodeFormat, ControllerDoc, Doc, MoveStep, RobotDoc } from '../../../src/model/document.js' */
/** @import { CodeOptions } from '../../../src/model/controller/writeCode.js' */

const FORMATS = /** @type {CodeFormat[]} */ (['pair', 'tp', 'karel-move', 'krl']);

/** @param {Doc} doc @param {CodeFormat} [format] @param {CodeOptions} [options] @param {number} [index]  of the source */
const writtenOf = (doc, format = 'pair', options = {}, index = 0) =>
  atOnce(
    writeCode(doc, {
      ...{ source: codeSources(doc)[index], format, options, start: doc.posture },
      ...{ version: '0.1.0', generatedAt: '2026-07-01T12:00:00Z' },
    }),
  );

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
const REST = [0, 0, 0, 0, 0, 0];

/** The joint values of the KAREL half of a pair, six by six. @param {ReturnType<typeof writtenOf>} written */
function jointValues({ files, made }) {
  const all = readWritten(files[0]).flatMap((line) => / joints\[\d\] = (.*)$/.exec(line)?.slice(1) ?? []);
  const count = made?.program.slides.length ?? 0;
  return Array.from({ length: all.length / count }, (_, i) => all.slice(i * count, (i + 1) * count).map(Number));
}

test('what there is to write: programs with moves, two postures, any target', () => {
  const doc = recorded(FANUC_LIKE, REST);
  expect(codeSources(doc)).toEqual([]);
  const more = {
    ...recorded(FANUC_LIKE, REST, [1, 2, 3, 4, 5, 6]),
    targets: [{ id: 't', xyz: [400, 0, 300], rpy: [0, 90, 0] }],
    motionPrograms: [
      { id: 'empty', name: 'Empty', steps: [{ id: 'a', kind: /** @type {const} */ ('comment'), text: 'nothing' }] },
      { id: 'm', name: 'Main', steps: [moveTo([0, 10, 0, 0, 0, 0])] },
    ],
  };
  expect(codeSources(more).map(({ kind }) => kind)).toEqual(['program', 'postures', 'targets']);
  for (const [i, source] of codeSources(more).entries()) {
    const written = writtenOf(more, 'tp', {}, i);
    expect(written.files).toHaveLength(1);
    expect(sourceOfText(more, written.files[0].text)).toEqual(source);
  }
});

/** @param {number[]} values @param {Partial<MoveStep>} [more] @returns {MoveStep} */
const moveTo = (values, more) => ({
  ...{ id: 'a', kind: 'joint', target: { kind: 'posture', values }, speed: 40, speedUnit: '%', acceleration: 100 },
  ...{ ending: { kind: 'fine' }, ...more },
});
/** @param {MoveStep[]} steps @param {RobotDoc} [robot] @returns {Doc} */
const programmed = (steps, robot = FANUC_LIKE) => ({
  ...newDocument(robot),
  motionPrograms: [{ id: 'm', name: 'Main', steps: steps.map((step, i) => ({ ...step, id: `s${i}` })) }],
});

test('recorded postures are joint moves at a fifth of the rates, called after the robot, with the pendant’s values', () => {
  const written = writtenOf(recorded(FANUC_LIKE, [1, 20, -30, 4, 5, 6], REST));
  expect(written.issues).toEqual([]);
  expect(written.files.map(({ name, language }) => [name, language])).toEqual([
    ['puma_560.kl', 'karel'],
    ['puma_mv.ls', 'fanuc-tp'],
  ]);
  expect(jointValues(written)).toEqual([
    [1, 70, -100, 4, 5, 6],
    [0, 90, -90, 0, 0, 0],
  ]);
  expect(readWritten(written.files[1]).filter((line) => line.startsWith('J'))).toEqual([
    'J PR[1] 20% FINE    ;',
    'J PR[2] 20% FINE    ;',
  ]);
  const header = written.files[0].text.split('PROGRAM')[0];
  expect(header).toContain('--   J1 = q1\n--   J2 = -q2 + 90 deg\n--   J3 = q3 - J2\n--   J4 = q4\n');
  expect(header).toContain('-- Check none: not verified yet\n');
});

test('the convention is written with its units, signs and factors', () => {
  const robot = withController(
    { 0: { coupledTo: 'joint_3', coupling: 0.5 }, 2: { sign: -1, offset: -7 } },
    LIBRARY.scara_cobra600,
  );
  expect(conventionLines(robot)).toEqual(['J1 = q1 + 0.5 J3', 'J2 = q2', 'J3 = -q3 - 7 mm', 'J4 = q4']);
});

test.for(
  /** @type {[string, RobotDoc, number[], string, string][]} */ ([
    [
      'outside of its limits',
      FANUC_LIKE,
      [160.5, 0, 0, 0, 0, 0],
      'outside-limits',
      'Step 2 has J1 at 160.5 deg, above its upper limit of 160 deg.',
    ],
    [
      'of several turns without a limit',
      {
        ...FANUC_LIKE,
        joints: FANUC_LIKE.joints.with(5, {
          ...FANUC_LIKE.joints[5],
          ...{ type: /** @type {const} */ ('continuous'), lower: undefined, upper: undefined, label: 'tool' },
        }),
      },
      [0, 0, 0, 0, 0, -725.25],
      'many-turns',
      "Step 2 has J6 (tool) at -725.25 deg, more than a full turn from zero; the model has no limit there, but a controller's axis has.",
    ],
    [
      'of an arm without controller data',
      LIBRARY.puma560,
      REST,
      'no-controller-data',
      "Puma 560 has no controller data: the joint values in the code are the model's own, and the coupling of FANUC's J3 to J2 is not set.",
    ],
  ]),
)('a posture %s is written, with a warning', ([, robot, values, code, message]) => {
  const { files, issues } = writtenOf(recorded(robot, REST, values));
  expect(files).toHaveLength(2);
  expect(issues).toMatchObject([{ severity: 'warning', code, message }]);
});

test('a value at its limit but for a rounding error is at the limit; one beyond what a controller takes gives no files', () => {
  expect(writtenOf(recorded(FANUC_LIKE, REST, [160 * (1 + 2 ** -52), 0, 0, 0, 0, 0])).issues).toEqual([]);
  const { files, issues } = writtenOf(recorded(FANUC_LIKE, REST, [0, 0, 0, 0, 0, 1e6]));
  expect(files).toEqual([]);
  expect(issues).toMatchObject([{ severity: 'error', code: 'value-too-large' }]);
});

test('a slide is written in millimetres, and other than six axes are said not to be verified', () => {
  const written = writtenOf(recorded(LIBRARY.scara_cobra600, [0, 0, 0, 0], [10, 20, 150.5, 30]));
  expect(jointValues(written)[1]).toEqual([10, 20, 150.5, 30]);
  expect(written.files[0].text).toContain(
    '-- Joint values, J1, J2, J4 in degrees, J3 in mm, as the teach pendant shows',
  );
  expect(written.notes.map(({ code }) => code)).toContain('axis-count');
});

test('nothing is said of FANUC’s arms that an arm has not, and axes of a KUKA are A1 to A6', () => {
  const about = (/** @type {RobotDoc} */ robot, /** @type {CodeFormat} */ format) => {
    const { files, issues, notes } = writtenOf(
      recorded(
        robot,
        robot.joints.map(() => 10),
        robot.joints.map(() => 20),
      ),
      format,
    );
    const text = files.map((file) => file.text.replace(/\s+(?:--|;|\d+:\s*!)?\s*/g, ' ')).join(' ');
    return { text, said: [...issues, ...notes].map(({ message }) => message).join(' ') };
  };
  for (const format of /** @type {const} */ (['pair', 'karel-move'])) {
    const gantry = about(LIBRARY.cart_ppp, format);
    expect(gantry.text).toContain('User frame 0 is taken to be the base of the model; tool 0');
    expect(gantry.said).not.toContain('coupling of FANUC');
    expect(gantry.said).toContain('this arm has 3');
    expect(about(LIBRARY.scara_cobra600, format).text).toContain(
      'taken to be on axis 1, 387 mm from the base of the model',
    );
    expect(about(LIBRARY.ur5, format).said).toContain('coupling of FANUC');
  }
  expect(about(LIBRARY.puma560, 'tp').text).toContain('UFRAME 0 is the world, on axis 1');
  const kuka = about(LIBRARY.kuka_kr210_l150, 'krl').text;
  expect(kuka).toContain('Joint values, A1 to A6 in degrees');
  expect(kuka).toContain('A3 = q3 + 90 deg');
});

test('corners by a distance: what MOVE and PTP have no word for is said', () => {
  const doc = programmed([
    moveTo([0, 10, 0, 0, 40, 0], { ending: { kind: 'distance', value: 5 } }),
    moveTo([0, 20, 0, 0, 40, 0]),
  ]);
  const said = (/** @type {CodeFormat} */ format) =>
    writtenOf(doc, format)
      .notes.map(({ message }) => message)
      .join(' ');
  expect(said('karel-move')).toContain('by a distance they are written as NODECEL');
  expect(said('krl')).toContain('C_PTP C_DIS');
});

/** @param {RobotDoc} robot @param {readonly number[]} pendant */
function isSingularInDecimals(robot, pendant) {
  const near = pendant.map((value) => Number(value.toFixed(3)));
  const q = robot.joints.map(
    ({ controller: { coupledTo, sign, offset } }, j) =>
      sign * (near[j] + (coupledTo === 'joint_2' ? near[1] : 0) - offset),
  );
  const { rank, freedoms } = dexterity(compileRobot(robot), compilePosture(robot, q));
  return rank < freedoms;
}

test('postures of any arm come out as they went in, to half a thousandth; where that would be a singular one, to a thousandth', () => {
  const anyCase = fc.constantFrom(...Object.values(LIBRARY)).chain((robot) => {
    const value = fc.double({ min: -720, max: 720, noNaN: true });
    const q = fc.array(value, { minLength: robot.joints.length, maxLength: robot.joints.length });
    return fc.record({ robot: fc.constant(robot), values: fc.array(q, { minLength: 2, maxLength: 6 }) });
  });
  fc.assert(
    fc.property(anyCase, ({ robot, values }) => {
      const read = jointValues(writtenOf(recorded(robot, ...values)));
      expect(read).toHaveLength(values.length);
      read.forEach((written, i) => {
        // where the controller counts J3 from the horizontal, J2 is not in its number; KUKA counts from elsewhere
        const expected = robot.joints.map(({ controller: { coupledTo, sign, offset } }, j) => {
          const own = sign * values[i][j] + offset;
          return coupledTo === 'joint_2' ? own - values[i][1] : own;
        });
        const off = written.map((value, j) => Math.abs(value - expected[j])).sort((a, b) => a - b);
        const most = off.pop();
        expect(off.pop()).toBeLessThanOrEqual(0.0005 + 1e-9);
        expect(most).toBeLessThanOrEqual(isSingularInDecimals(robot, expected) ? 0.001 : 0.0005 + 1e-9);
      });
    }),
    { seed: SEED, numRuns: runs(30) },
  );
});

test('options: name, registers, speed, the frame of positions and frames’ numbers', () => {
  const user = { id: 'bench', kind: /** @type {const} */ ('user'), xyz: [100, 0, 0], rpy: [0, 0, 90] };
  const reach = { ...programmed([moveTo([0, 10, 0, 0, 40, 0])], LIBRARY.fanuc_m10ia), frames: [user] };
  const options = {
    programName: 'pick',
    firstRegister: 7,
    speed: 50,
    userFrame: 'bench',
    numbers: { 'user bench': 5 },
  };
  const { files } = writtenOf(reach, 'pair', options);
  expect(files.map(({ name }) => name)).toEqual(['pick.kl', 'pick_mv.ls']);
  expect(readWritten(files[1])).toEqual(['  UFRAME_NUM=5 ;', '  UTOOL_NUM=0 ;', 'J PR[7] 20% FINE    ;']);
  expect(readWritten(writtenOf(reach, 'krl', options).files[0])).toContain('BAS (#BASE,5)');
  expect(writtenOf(reach, 'pair', { firstRegister: 2000 }).issues).toEqual([]);
  expect(writtenOf(recorded(FANUC_LIKE, REST, REST), 'pair', { firstRegister: 2000 })).toMatchObject({
    files: [],
    issues: [{ severity: 'error', code: 'registers', path: 'firstRegister' }],
  });
});

test('user frames and tools, also under other numbers, are where the code says in every language', () => {
  const user = { id: 'bench', kind: /** @type {const} */ ('user'), xyz: [300, 100, 50], rpy: [0, 0, 90] };
  const tool = { id: 'grip', kind: /** @type {const} */ ('tool'), xyz: [0, 20, 120], rpy: [0, 0, 0] };
  const robot = LIBRARY.fanuc_m10ia;
  const frames = { tool: 'grip', frame: 'bench' };
  const steps = [
    moveTo([0, 10, 0, 0, 40, 0], { tool: 'grip' }),
    moveTo([], { ...frames, target: { kind: 'pose', xyz: [100, -500, 700], rpy: [180, 0, 0] } }),
    moveTo([], {
      ...{ ...frames, kind: 'linear', speed: 100, speedUnit: 'length/s' },
      target: { kind: 'pose', xyz: [150, -500, 700], rpy: [180, 0, 0] },
    }),
  ];
  const doc = { ...programmed(steps, robot), frames: [user, tool] };
  for (const format of FORMATS) {
    const options = { numbers: { 'user bench': 4, 'tool grip': 6 } };
    const written = writtenOf(doc, format, options);
    expect(written.issues.filter(({ severity }) => severity === 'error')).toEqual([]);
    const { matches, deviation } = verifyCode(written.doc, written.made, written.files);
    expect(matches).toBe(true);
    expect(deviation.millimetres).toBeLessThan(0.05);
    if (format !== 'karel-move') continue;
    const bare = { ...written.files[0], text: written.files[0].text.replace('$MNUTOOL[1, 6]', '$MOR_GRP[1].$NILPOS') };
    expect(bare.text).not.toBe(written.files[0].text);
    expect(verifyCode(written.doc, written.made, [bare]).matches).toBe(false);
  }
});

test.for(
  /** @type {[CodeFormat, 'programName' | 'firstRegister' | 'speed', string, string | number | null][]} */ ([
    ['pair', 'programName', ' Pick ', 'Pick'],
    ['pair', 'programName', 'pick_part_2', null],
    ['krl', 'programName', 'pick_part_2', 'pick_part_2'],
    ['pair', 'firstRegister', '12', 12],
    ['pair', 'firstRegister', '0', null],
    ['pair', 'firstRegister', '1.5', null],
    ['pair', 'firstRegister', '2001', null],
    ['tp', 'speed', '12.5', 12.5],
    ['tp', 'speed', '0.5', null],
    ['tp', 'speed', '101', null],
    ['tp', 'speed', 'fast', null],
  ]),
)('%s: %s %j', ([format, field, text, value]) => {
  const found = readOption(format, field, text);
  if (value === null) expect(found).toMatchObject({ message: expect.stringMatching(/^Expected .*got /is) });
  else expect(found).toEqual({ value });
});

test('numbers of frames are whole, above 0, and each once', () => {
  expect(readFrameNumber('3', [1, 2])).toEqual({ value: 3 });
  expect(readFrameNumber('2', [1, 2])).toMatchObject({ message: 'Another frame has the number 2 already.' });
  for (const text of ['0', '-1', '1.5', 'x', '100']) expect(readFrameNumber(text, [])).toHaveProperty('message');
});

test('ways by splines and blends are joint moves in code, and what that costs is in deviation, findings and certificate', () => {
  const steps = [
    moveTo([0, 10, -100, 0, 40, 0]),
    moveTo([40, 20, -80, 10, 30, 0], { law: 'cubicSpline', ending: { kind: 'percent', value: 10 } }),
    moveTo([20, -30, -90, 0, 50, 20], { law: 'cubicSpline', ending: { kind: 'percent', value: 10 } }),
    moveTo([-10, 0, -120, 0, 40, 0], { law: 'cubicSpline' }),
  ];
  for (const format of FORMATS) {
    const written = writtenOf(programmed(steps), format);
    expect(written.notes.map(({ code }) => code)).toContain('lost-law');
    const verification = verifyCode(written.doc, written.made, written.files);
    expect(verification.matches).toBe(true);
    expect(verification.deviation.millimetres).toBeGreaterThan(5);
    expect(verification.findings.filter(({ code }) => code === 'lost-law')).toHaveLength(3);
    const [first] = atOnce(certified(written, verification));
    expect(first.text).toContain(`Check ${(Math.ceil(verification.deviation.millimetres * 1e4) / 1e4).toFixed(4)}mm`);
    if (format === 'tp') expect(first.text).toMatch(/J P\[2\] 40% CNT100/);
  }
  const plain = writtenOf(
    programmed(steps.map((step) => ({ ...step, law: /** @type {const} */ ('timeOptimal') }))),
    'tp',
  );
  expect(plain.notes.map(({ code }) => code)).not.toContain('lost-law');
  expect(verifyCode(plain.doc, plain.made, plain.files).deviation.millimetres).toBeLessThan(0.1);
});

test('the texts of a document know their files, their sets and their certificates; verified code names its program', () => {
  const doc = recorded(FANUC_LIKE, REST, [0, 10, 0, 0, 10, 0]);
  for (const format of FORMATS) {
    const written = writtenOf(doc, format);
    const files = atOnce(certified(written, verifyCode(written.doc, written.made, written.files)));
    expect(certificateStatus(files, doc.robot)).toEqual(files.map(() => 'valid'));
    const programs = files.map(({ name, language, text }) => ({
      ...{ id: name.replace('.', '_').replace(/_(kl|ls|src)$/, ''), language },
      text: text.replaceAll('\r\n', '\n'),
    }));
    expect(programs.map(fileName)).toEqual(files.map(({ name }) => name));
    const other = { id: 'other', language: /** @type {const} */ ('karel'), text: 'PROGRAM other\nBEGIN\nEND other\n' };
    for (const chosen of programs) {
      const set = codeSet([other, ...programs.toReversed()], chosen);
      expect(set.map(({ file }) => file)).toEqual(files);
      expect(statusOf([other, ...programs.toReversed()], chosen, doc.robot)).toBe('valid');
      const altered = { ...chosen, text: chosen.text.replace('CAUTION', 'CAUTIOM') };
      const changed = programs.map((program) => (program === chosen ? altered : program));
      expect(statusOf(changed, altered, doc.robot)).toBe('altered');
      for (const companion of changed)
        if (companion !== altered) expect(statusOf(changed, companion, doc.robot)).toBe('other-files');
    }
    expect(statusOf([other], other, doc.robot)).toBe('none');
    expect(verifyCode(doc, null, files)).toMatchObject({ isCompared: false, matches: true });
  }
});

test('the same document gives the same code', () => {
  const doc = recorded(FANUC_LIKE, REST, [1, 1, 1, 1, 1, 1]);
  expect(writtenOf(doc).files).toEqual(writtenOf(structuredClone(doc)).files);
});
