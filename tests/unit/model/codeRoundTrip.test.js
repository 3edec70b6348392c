/**
 * Programs → code → read again → run: the same moves. Numbers in the text are compared with the program's by this file's own
 * reading of the effects; where the arm goes, by the verification that a person is shown.
 */
import fc from 'fast-check';
import { expect, test } from 'vitest';
import { writeKarelMove } from '../../../src/karel/write/karelMove.js';
import { writeKrl } from '../../../src/karel/write/krl.js';
import { writePair } from '../../../src/karel/write/pair.js';
import { writeTp } from '../../../src/karel/write/tp.js';
import { tcpPose } from '../../../src/kinematics/forward.js';
import { compilePosture, compileRobot } from '../../../src/model/compile.js';
import { certificateStatus, readCertificate, withCertificate } from '../../../src/model/controller/certificate.js';
import { neutralProgram } from '../../../src/model/controller/neutralProgram.js';
import { runCode } from '../../../src/model/controller/runCode.js';
import { verifyCode } from '../../../src/model/controller/verifyCode.js';
import { limitsOf } from '../../../src/model/document.js';
import { LIBRARY, newDocument } from '../../../src/model/library.js';
import { poseInUnits } from '../../../src/model/numbers/poseNumbers.js';
import { runs, SEED } from '../../helpers/property.js';

/** @import { Doc, StepDoc } from '../../../src/model/document.js' */
/** @import { MadeProgram } from '../../../src/model/controller/neutralProgram.js' */

const ARMS = [
  ...['puma560', 'kuka_kr5_arc', 'kuka_kr6_r900', 'kuka_kr210_l150', 'fanuc_lrmate200id', 'fanuc_m10ia', 'abb_irb120'],
  ...['abb_irb140', 'ur5', 'stanford', 'scara_cobra600', 'planar3r'],
];
const WRITERS = /** @type {const} */ ([
  [writeTp, 'fanuc'],
  [writePair, 'fanuc'],
  [writeKarelMove, 'fanuc'],
  [writeKrl, 'kuka'],
]);
const WRITTEN = { version: '0.1.0', generatedAt: '2026-07-01T12:00:00Z' };

/** @typedef {{ kind: string, to: number[], speed: number, ending: { kind: string, value?: number } }} WantedStep */

const share = fc.double({ min: 0, max: 1, noNaN: true });
const anyStep = fc.record({
  kind: fc.constantFrom('joint', 'joint-pose', 'linear', 'linear', 'circular', 'wait', 'output', 'input', 'comment'),
  to: fc.array(share, { minLength: 12, maxLength: 12 }),
  speed: fc.integer({ min: 1, max: 100 }),
  ending: fc.oneof(
    fc.constant({ kind: 'fine' }),
    fc.record({ kind: fc.constantFrom('percent', 'distance'), value: fc.integer({ min: 1, max: 50 }) }),
  ),
});

/** A program whose poses are those of postures near each other, so that most ways can be followed. @param {string} arm @param {readonly WantedStep[]} wanted @returns {Doc} */
function documentOf(arm, wanted) {
  const doc = newDocument(LIBRARY[arm]);
  const { robot } = doc;
  const chain = compileRobot(robot);
  let here = [...doc.posture];
  const near = (
    /** @type {readonly number[]} */ from,
    /** @type {readonly number[]} */ shares,
    /** @type {number} */ range,
  ) =>
    from.map((value, i) => {
      const { lower, upper } = limitsOf(robot.joints[i]);
      return Math.min(upper, Math.max(lower, value + (shares[i] - 0.5) * range));
    });
  const pose = (/** @type {readonly number[]} */ q) => ({
    kind: /** @type {const} */ ('pose'),
    ...poseInUnits(tcpPose(chain, compilePosture(robot, q)), robot.units),
  });
  const steps = wanted.map(({ kind, to, speed, ending }, i) => {
    const id = `s${i}`;
    if (kind === 'wait') return { id, kind, seconds: speed / 4 };
    if (kind === 'output') return { id, kind: 'set-output', output: speed, value: to[0] > 0.5 ? 'on' : 'off' };
    if (kind === 'input') return { id, kind: 'wait-input', input: speed, value: to[0] > 0.5 ? 'on' : 'off' };
    if (kind === 'comment') return { id, kind, text: `at; ${speed} % 'é'` };
    const isJoint = kind.startsWith('joint');
    const middle = near(here, to, isJoint ? 60 : 8);
    const end = isJoint ? middle : near(middle, to.slice(6), 8);
    here = end;
    const target = kind === 'joint' ? { kind: 'posture', values: end } : pose(end);
    const manner = {
      acceleration: 10 + speed / 2,
      ending,
      speed: isJoint ? speed : 5 * speed,
      speedUnit: isJoint ? '%' : 'length/s',
    };
    return { id, kind: isJoint ? 'joint' : kind, target, ...(kind === 'circular' && { via: pose(middle) }), ...manner };
  });
  return { ...doc, motionPrograms: [{ id: 'm', name: 'Round trip', steps: /** @type {StepDoc[]} */ (steps) }] };
}

/** As much of the program as the arm can do. @param {Doc} doc @param {'fanuc' | 'kuka'} brand @returns {{ doc: Doc, made: MadeProgram } | null} */
function madeOf(doc, brand) {
  const [program] = doc.motionPrograms;
  for (let steps = program.steps; steps.length > 0;) {
    const own = { ...doc, motionPrograms: [{ ...program, steps }] };
    const { made, issues } = neutralProgram(own, own.motionPrograms[0], { brand, ...WRITTEN });
    if (made) return { doc: own, made };
    const at = Number(/steps\.(\d+)/.exec(issues[0].path)?.[1] ?? -1);
    if (at < 0) return null;
    steps = steps.toSpliced(at, 1);
  }
  return null;
}

/** What the text says of a target must be the program's numbers, but for the third decimal and 24 bits. @param {MadeProgram} made @param {ReturnType<typeof runCode>['effects']} effects */
function expectNumbers(made, effects) {
  expect(effects).toHaveLength(made.moves.length);
  for (const [i, { position, isJoint, userFrame, toolFrame, motion }] of effects.entries()) {
    const { move } = made.moves[i];
    expect(motion).toBe({ joint: 'J', linear: 'L', circular: 'C' }[move.motion]);
    expect([userFrame, toolFrame]).toEqual([move.userFrame, move.tool]);
    const wanted = isJoint ? move.target.joints : move.target.position;
    for (const [k, value] of wanted.entries()) {
      const found = /** @type {number[]} */ (position)[k];
      expect(Math.abs(found - value)).toBeLessThan(0.0005 + 1e-9 + Math.abs(value) * 2 ** -23);
    }
  }
}

test('the same moves come back, in every language, on twelve arms', () => {
  /** @type {Record<string, number>} */
  const seen = {};
  let turn = 0;
  fc.assert(
    fc.property(fc.array(anyStep, { minLength: 2, maxLength: 5 }), (wanted) => {
      const arm = ARMS[turn++ % ARMS.length];
      const doc = documentOf(arm, wanted);
      for (const brand of /** @type {const} */ (['fanuc', 'kuka'])) {
        const tried = madeOf(doc, brand);
        if (!tried) continue;
        seen[arm] = (seen[arm] ?? 0) + tried.made.moves.length;
        for (const [write, own] of WRITERS) {
          if (own !== brand) continue;
          const { files } = write(tried.made.program);
          expectNumbers(tried.made, runCode(files).effects);
          const { moves, matches, findings } = verifyCode(tried.doc, tried.made, files);
          expect(findings.filter(({ severity }) => severity === 'error')).toEqual([]);
          expect(matches).toBe(true);
          for (const { deviation, rounding } of moves) {
            expect(deviation.millimetres).toBeLessThanOrEqual(Math.max(0.01, rounding.millimetres));
            expect(deviation.degrees).toBeLessThanOrEqual(Math.max(0.01, rounding.degrees));
          }
        }
      }
    }),
    // 20 programs, or 200: a longer run is ten times as many and not twenty
    { seed: SEED, numRuns: Math.max(20, runs(10)) },
  );
  expect(Object.keys(seen).sort()).toEqual([...ARMS].sort());
});

/** One program with everything, on arms of both brands. */
const shares = (/** @type {number} */ from) => Array.from({ length: 12 }, (_, i) => ((i * 37 + from * 11) % 100) / 100);
const FIXED = ['joint', 'linear', 'joint-pose', 'circular', 'output', 'linear'].map((kind, i) => ({
  ...{ kind, to: shares(i), speed: 20 + i },
  ending: i % 2 ? { kind: 'fine' } : { kind: 'percent', value: 50 },
}));
const fixed = (/** @type {string} */ arm, /** @type {'fanuc' | 'kuka'} */ brand) => {
  const tried = madeOf(documentOf(arm, FIXED), brand);
  if (!tried) throw new Error('Expected a program.');
  expect(tried.made.moves).toHaveLength(5);
  return tried;
};

test('a certificate fits its files, and no others: any digit that is another one, another file of the set, another arm', () => {
  for (const [write, brand] of WRITERS) {
    const { doc, made } = fixed('fanuc_m10ia', brand);
    const { deviation } = verifyCode(doc, made, write(made.program).files);
    const { files } = withCertificate(made.program, write, {}, doc.robot, deviation);
    expect(certificateStatus(files, doc.robot)).toEqual(files.map(() => 'valid'));
    expect(readCertificate(files[0].text)).toMatchObject({ version: '0.1.0' });
    expect(readCertificate(files[0].text)?.millimetres).toBeGreaterThanOrEqual(deviation.millimetres);
    expect(verifyCode(doc, made, files).matches).toBe(true);
    const dos = files.map((file) => ({ ...file, text: file.text.replace(/\r?\n/g, '\n') }));
    expect(certificateStatus(dos, doc.robot)).toEqual(files.map(() => 'valid'));
    const digits = [...files[0].text.matchAll(/\d/g)].map(({ index }) => index);
    for (let i = 0; i < digits.length; i += Math.ceil(digits.length / 60)) {
      const at = digits[i];
      const { text } = files[0];
      const other = text.slice(0, at) + ((Number(text[at]) + 1) % 10) + text.slice(at + 1);
      const [status] = certificateStatus([{ ...files[0], text: other }, ...files.slice(1)], doc.robot);
      expect(status).not.toBe('valid');
    }
    if (files.length > 1) expect(certificateStatus([files[0]], doc.robot)).toEqual(['other-files']);
    expect(certificateStatus(files, LIBRARY.puma560)).toEqual(files.map(() => 'other-model'));
    expect(certificateStatus(write(made.program).files, doc.robot)).toEqual(files.map(() => 'none'));
  }
});

test('a digit of a move that is another one is found by running the code, on its line', () => {
  for (const [write, brand] of WRITERS) {
    const { doc, made } = fixed('fanuc_m10ia', brand);
    const { files } = write(made.program);
    const numbers = files.flatMap(({ text }, f) =>
      [...text.matchAll(/(?<=[ =(,-])(\d+)\.(\d)\d\d(?!\d)/g)].map(({ index, 1: whole }) => [
        f,
        index + whole.length - 1,
        index,
      ]),
    );
    expect(numbers.length).toBeGreaterThan(25);
    for (let i = 0; i < numbers.length; i += 3) {
      const [f, at] = numbers[i];
      const changed = files.map((file, k) =>
        k === f
          ? { ...file, text: file.text.slice(0, at) + ((Number(file.text[at]) + 1) % 10) + file.text.slice(at + 1) }
          : file,
      );
      const { matches, findings } = verifyCode(doc, made, changed);
      expect(matches).toBe(false);
      expect(findings.filter(({ severity, line }) => severity === 'error' && line > 0).length).toBeGreaterThan(0);
    }
  }
});

test('a wrong configuration, frame, speed, corner or motion type is found on its line', () => {
  const { doc, made } = fixed('fanuc_m10ia', 'fanuc');
  const [file] = writeTp(made.program).files;
  const lineOf = (/** @type {RegExp} */ pattern) => file.text.split('\n').findIndex((line) => pattern.test(line)) + 1;
  const found = (/** @type {RegExp} */ from, /** @type {string} */ to) => {
    expect(file.text).toMatch(from);
    const { findings, matches } = verifyCode(doc, made, [{ ...file, text: file.text.replace(from, to) }]);
    expect(matches).toBe(false);
    return findings
      .filter(({ severity }) => severity === 'error')
      .map(({ line, message }) => `${line} ${message}`)
      .join('\n');
  };
  expect(found(/UTOOL_NUM=0/, 'UTOOL_NUM=7')).toContain('tool 7');
  expect(found(/J P\[1\] 20%/, 'J P[1] 30%')).toContain(
    `${lineOf(/J P\[1\]/)} This is not as in the program: a speed of 30 %, not 20`,
  );
  expect(found(/L P\[2\]/, 'J P[2]')).toContain(String(lineOf(/L P\[2\]/)));
  expect(found(/CNT50/, 'FINE')).toContain('it stops at the end');
  expect(found(/(P\[3\]\{[^']*')[NF]/, '$1F')).toContain(
    `${lineOf(/J P\[3\]/)} This is not as in the program: another posture`,
  );
  expect(found(/ {2}\d+:J P\[3\].*;\r\n/, '')).toContain('makes 4 moves, the program 5');
});

/** R-2000iB/165F with a tool of 55 mm, as published with a posture and its pose (ONE Robotics 2013, "The perils of six-axis robots"). */
test('the published posture of an R-2000iB is written as the published position', () => {
  const { joints } = LIBRARY.fanuc_m10ia;
  const sizes = [
    [0, 312],
    [0, 1075],
    [0, 225],
    [-1280, 0],
    [0, 0],
    [-270, 0],
  ];
  const robot = {
    ...LIBRARY.fanuc_m10ia,
    joints: joints.map((joint, i) => ({ ...joint, d: i === 0 ? 670 : sizes[i][0], a: sizes[i][1] })),
  };
  const pendant = [7.962, -5.284, -36.25, 77.661, -51.975, -79.273];
  const q = pendant.with(2, pendant[2] + pendant[1]);
  const base = newDocument(robot);
  const target = {
    kind: /** @type {const} */ ('pose'),
    ...poseInUnits(tcpPose(compileRobot(robot), compilePosture(robot, q)), robot.units),
  };
  /** @type {Doc} */
  const doc = {
    ...base,
    posture: q,
    motionPrograms: [
      {
        id: 'm',
        name: 'Published',
        steps: [
          { id: 'a', kind: 'joint', target, speed: 10, speedUnit: '%', acceleration: 100, ending: { kind: 'fine' } },
        ],
      },
    ],
  };
  const { made } = neutralProgram(doc, doc.motionPrograms[0], { brand: 'fanuc', ...WRITTEN });
  if (!made) throw new Error('Expected a program.');
  const [{ text }] = writeTp(made.program).files;
  expect(text).toContain("CONFIG : 'N U T, 0, 0, 0'");
  const numbers = [...text.slice(text.indexOf('/POS')).matchAll(/[XYZWPR] = +(-?[\d.]+)/g)].map(([, value]) =>
    Number(value),
  );
  [1500, 0, 360, 135, -45, 0].forEach((value, i) =>
    expect(Math.abs(numbers[i] - value)).toBeLessThan(i < 3 ? 0.02 : 0.002),
  );
});
