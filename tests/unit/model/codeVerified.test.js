/** What verification finds in code: altered digits, other postures, frames, speeds and corners, each on its line; and certificates. */
import { expect, test } from 'vitest';
import { writeKarelMove } from '../../../src/karel/write/karelMove.js';
import { writeTp } from '../../../src/karel/write/tp.js';
import { certificateStatus, readCertificate, withCertificate } from '../../../src/model/controller/certificate.js';
import { valuesInside } from '../../../src/model/controller/insideLimits.js';
import { postureFromPendant } from '../../../src/model/controller/pendantNumbers.js';
import { verifyCode } from '../../../src/model/controller/verifyCode.js';
import fc from 'fast-check';
import { limitsOf } from '../../../src/model/document.js';
import { LIBRARY, newDocument } from '../../../src/model/library.js';
import { runs, SEED } from '../../helpers/property.js';
/** @import { StepDoc } from '../../../src/model/document.js' */
import { documentOf, fixed, FIXED, madeOf, WRITERS, WRITTEN } from './codePrograms.js';
import { tcpPose } from '../../../src/kinematics/forward.js';
import { compilePosture, compileRobot } from '../../../src/model/compile.js';
import { neutralProgram } from '../../../src/model/controller/neutralProgram.js';
import { poseInUnits } from '../../../src/model/numbers/poseNumbers.js';

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

test('a number that takes the tool farther than decimals could is found, however much they cost elsewhere', () => {
  const manner = { acceleration: 100, ending: { kind: 'fine' } };
  const byJoints = { kind: 'joint', speed: 10, speedUnit: '%', ...manner };
  const byTool = { speed: 50, speedUnit: 'length/s', ...manner };
  /** @typedef {[string, number, number[], (number[])[], number, number]} Row  the arm, how it is written, postures as seen from its home, which number is off and by what */
  const rows = /** @type {Row[]} */ ([
    // a line after joint values, whose decimals cost ten times as much
    ['kuka_kr210_l150', 0, [3, -4, 5, 20, 40, 6], [[6, -7, 8, 22, 42, 4]], 0, 0.02],
    // joint values: no more than their own decimals, and of the posture at the end alone
    ['ur10', 2, [20, 10, 20, 30, 50, 60], [], 1, 0.003],
    // the tool's turn, on arms with few joints
    ['mitsubishi_rv2aj', 3, [10, 20, 60, 40, 20], [[13, 24, 57, 42, 25]], 4, 0.03],
    // joint values are gone to though the place alone is met on the way
    [
      'spherical_wrist',
      0,
      [10, 40, 20],
      [
        [30, 40, 20],
        [50, 40, 20],
      ],
      2,
      30,
    ],
  ]);
  for (const [arm, writer, from, [to, end], number, off] of rows) {
    const home = newDocument(LIBRARY[arm]);
    const { robot } = home;
    const away = (/** @type {number[]} */ q) => home.posture.map((value, i) => value + q[i]);
    const pose = (/** @type {number[]} */ q) => ({
      kind: 'pose',
      ...poseInUnits(tcpPose(compileRobot(robot), compilePosture(robot, away(q))), robot.units),
    });
    const steps = /** @type {StepDoc[]} */ ([
      { id: 'a', target: { kind: 'posture', values: away(from) }, ...byJoints },
      ...(to && !end ? [{ id: 'b', kind: 'linear', target: pose(to), ...byTool }] : []),
      ...(end ? [{ id: 'b', kind: 'circular', via: pose(to), target: pose(end), ...byTool }] : []),
    ]);
    const doc = { ...home, motionPrograms: [{ id: 'm', name: 'Off', steps }] };
    const [write, brand] = WRITERS[writer];
    const { made } = neutralProgram(doc, doc.motionPrograms[0], { brand, ...WRITTEN });
    if (made?.moves.length !== steps.length) throw new Error(`Expected ${arm} to do it.`);
    const matches = (/** @type {number} */ by) => {
      const { program } = made;
      const wrong = program.steps.map((step, i) => {
        if (step.kind !== 'move' || i < program.steps.length - 1) return step;
        const { joints, position } = step.target;
        const [ours, theirs] = [joints, position].map((values) => values.with(number, values[number] + by));
        return { ...step, target: { ...step.target, joints: ours, position: theirs } };
      });
      return verifyCode(doc, made, write({ ...program, steps: wrong }).files).matches;
    };
    expect([arm, matches(0), matches(off), matches(-off)]).toEqual([arm, true, false, false]);
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

test('a speed that a controller does not take is said; another one, or one in another unit, is an error', () => {
  const quick = FIXED.map((step) => (step.kind === 'linear' ? { ...step, speed: 500 } : step));
  const tried = madeOf(documentOf('fanuc_m10ia', quick), 'fanuc');
  if (!tried) throw new Error('Expected a program.');
  const [file] = writeTp(tried.made.program).files;
  const { matches, findings } = verifyCode(tried.doc, tried.made, [file]);
  expect(matches).toBe(true);
  expect(findings.filter(({ code }) => code === 'speed-limit').map(({ message }) => message)).toEqual([
    'The program asks for 2500 mm/s; the controller takes 2000.',
    'The program asks for 2500 mm/s; the controller takes 2000.',
  ]);
  for (const other of ['1999mm/sec', '300deg/sec']) {
    const changed = { ...file, text: file.text.replace('2000mm/sec', other) };
    expect(verifyCode(tried.doc, tried.made, [changed]).matches).toBe(false);
  }
});

test('code of a person is run from where the arm is, and looked at without a program', () => {
  const doc = { ...newDocument(LIBRARY.fanuc_m10ia), posture: [0, 0, 0, 0, -40, 0] };
  /** @type {(name: string, language: 'karel' | 'fanuc-tp', lines: string[]) => import('../../../src/karel/write/neutral.js').CodeFile} */
  const fileOf = (name, language, lines) => ({ name, language, text: lines.join('\n') + '\n' });
  const karel = fileOf('up.kl', 'karel', [
    ...['PROGRAM up', 'VAR', '  here : XYZWPR', 'BEGIN', '  here = CURPOS(0, 0)', '  here.z = here.z + 50.0'],
    ...[
      '  WITH $MOTYPE = LINEAR, $SPEED = 100.0 MOVE TO here',
      '  here.z = here.z + 9000.0',
      '  MOVE TO here',
      'END up',
    ],
  ]);
  const up = verifyCode(doc, null, [karel]);
  expect(up).toMatchObject({ isCompared: false, matches: false, moves: [{ line: 7, motion: 'linear' }] });
  expect(up.findings.map(({ line, code }) => [line, code])).toEqual([
    [7, 'deprecated-move'],
    [7, 'frames'],
    [9, 'deprecated-move'],
    [9, 'impossible'],
  ]);
  const near = fileOf('n.kl', 'karel', [
    'PROGRAM n',
    'VAR',
    '  a : XYZWPR',
    'BEGIN',
    '  a = CURPOS(0, 0)',
    '  MOVE RELATIVE a',
    'END n',
  ]);
  expect(verifyCode(doc, null, [near]).findings.at(-1)).toMatchObject({ severity: 'error', line: 6 });
  const unset = fileOf('u.kl', 'karel', [
    'PROGRAM u',
    'VAR',
    '  a : XYZWPR',
    'BEGIN',
    '  a.x = 1.0',
    '  MOVE TO a',
    'END u',
  ]);
  expect(verifyCode(doc, null, [unset]).matches).toBe(false);
  const tp = fileOf('lift.ls', 'fanuc-tp', [
    ...[
      '/PROG  LIFT',
      '/ATTR',
      'DEFAULT_GROUP\t= 1,*,*,*,*;',
      '/MN',
      '   1:  PR[1]=LPOS ;',
      '   2:  PR[1,3]=PR[1,3]+30 ;',
    ],
    ...['   3:L PR[1] 100mm/sec FINE    ;', '/POS', '/END'],
  ]);
  const krl = {
    name: 'k.src',
    language: /** @type {const} */ ('krl'),
    text: 'DEF k ( )\nBAS (#TOOL,0)\nPTP XP1\nEND\n',
  };
  const dat = { ...krl, name: 'k.dat', text: 'DEFDAT k\nDECL POS XP1={X 900,Y 100,Z 900,A 0,B 90,C 0}\nENDDAT\n' };
  expect(verifyCode(doc, null, [krl, dat]).findings.map(({ code, line }) => [code, line])).toEqual([
    ['frames', 3],
    ['no-status', 3],
  ]);
  const lift = verifyCode(doc, null, [tp]);
  expect(lift.moves).toHaveLength(1);
  expect(lift.findings.map(({ code, line }) => [code, line])).toEqual([['frames', 7]]);
});

test('frames that a MOVE sets of another group are not those of the arm', () => {
  const { doc, made } = fixed('fanuc_m10ia', 'fanuc');
  const [file] = writeKarelMove(made.program).files;
  const missing = (/** @type {string} */ text) =>
    verifyCode(doc, made, [{ ...file, text }])
      .findings.filter(({ code }) => code === 'frames')
      .map(({ message }) => message.split(' are ')[0].split(' is ')[0]);
  expect(missing(file.text)).toEqual([]);
  expect(missing(file.text.replaceAll('$GROUP[1].$UFRAME', '$GROUP[2].$UFRAME'))).toEqual(['$UFRAME']);
  expect(missing(file.text.replaceAll('$GROUP[1]', '$GROUP[2]'))).toEqual(['$UTOOL and $UFRAME']);
});

test('a joint at its limit is written to the inside of it, however the pendant counts, and no further than a decimal', () => {
  const limit = fc.double({ min: 20, max: 300, noNaN: true });
  const anyArm = fc.record({
    ...{
      lower: fc.array(limit, { minLength: 6, maxLength: 6 }),
      upper: fc.array(limit, { minLength: 6, maxLength: 6 }),
    },
    ...{ sign: fc.constantFrom(1, -1), offset: fc.double({ min: -90, max: 90, noNaN: true }) },
    coupling: fc.constantFrom(0, -1, 1),
    at: fc.array(fc.constantFrom('lower', 'upper'), { minLength: 6, maxLength: 6 }),
  });
  fc.assert(
    fc.property(anyArm, ({ lower, upper, sign, offset, coupling, at }) => {
      const controller = { ...LIBRARY.fanuc_m10ia.joints[0].controller, sign: /** @type {1 | -1} */ (sign), offset };
      const robot = {
        ...LIBRARY.fanuc_m10ia,
        joints: LIBRARY.fanuc_m10ia.joints.map((joint, i) => ({
          ...{ ...joint, lower: -lower[i], upper: upper[i] },
          controller: i === 2 ? { ...controller, coupling, coupledTo: 'joint_2' } : controller,
        })),
      };
      const posture = at.map((side, i) => limitsOf(robot.joints[i])[/** @type {'lower' | 'upper'} */ (side)]);
      const written = valuesInside(robot, posture).map((value) => Number(value.toFixed(3)));
      postureFromPendant(robot, written.map(Math.fround)).forEach((value, i) => {
        const limits = limitsOf(robot.joints[i]);
        expect(value).toBeGreaterThanOrEqual(limits.lower);
        expect(value).toBeLessThanOrEqual(limits.upper);
        expect(Math.abs(value - posture[i])).toBeLessThan(0.0031);
      });
    }),
    { seed: SEED, numRuns: runs(100) },
  );
});

test('a program that goes to the limits of an arm is verified without a joint past one, in every language', () => {
  const doc = newDocument(LIBRARY.fanuc_m10ia);
  const manner = { speed: 20, speedUnit: '%', acceleration: 100, ending: { kind: 'fine' } };
  const steps = doc.robot.joints.flatMap((joint, i) =>
    Object.values(limitsOf(joint)).map((value, k) => {
      const target = { kind: 'posture', values: doc.posture.with(i, value) };
      return { id: `s${i}${k}`, kind: 'joint', target, ...manner };
    }),
  );
  const atLimits = { ...doc, motionPrograms: [{ id: 'm', name: 'Limits', steps: /** @type {StepDoc[]} */ (steps) }] };
  for (const [write, brand] of WRITERS) {
    const tried = madeOf(atLimits, brand);
    if (!tried) throw new Error('Expected a program.');
    const { matches, findings } = verifyCode(tried.doc, tried.made, write(tried.made.program).files);
    expect(matches).toBe(true);
    expect(findings.filter(({ code }) => code === 'limit')).toEqual([]);
  }
});

test('a program of a controller: its inputs and flags come, frames that the model does not have are said, and why it was stopped, on its line', () => {
  const doc = { ...newDocument(LIBRARY.fanuc_m10ia), posture: [0, 0, 0, 0, -40, 0] };
  const found = (/** @type {string[]} */ ...lines) => {
    const text = ['/PROG  A', '/ATTR', '/MN', ...lines.map((line, i) => `${i + 1}:${line} ;`), '/POS', '/END', ''];
    const { moves, findings } = verifyCode(doc, null, [
      { name: 'a.ls', language: 'fanuc-tp', text: text.join('\r\n') },
    ]);
    return [moves.length, ...findings.map(({ code, line }) => `${code} ${line}`)];
  };
  const up = ['UFRAME_NUM=3', 'UTOOL_NUM=0', 'PR[1]=LPOS', 'PR[1,3]=PR[1,3]+10', 'L PR[1] 100mm/sec FINE'];
  const waits = ['WAIT RI[1]=ON', 'WAIT F[2:ok]=ON AND UI[3]=OFF', 'WAIT DI[1]=OFF'];
  expect(found(...up, ...waits, 'L PR[1] 50mm/sec FINE')).toEqual([2, 'unknown-frame 8']);
  expect(found('R[1]=0', 'WAIT R[1]=1', 'R[1]=2')).toEqual([0, 'budget 5']);
  expect(found('R[1]=0', 'ABORT')).toEqual([0, 'aborted 5']);
});

test('a line after joint values begins where their decimals have put the arm: no fault of the line', () => {
  const doc = newDocument(LIBRARY.planar2r);
  const step = { speed: 50, speedUnit: '%', acceleration: 100, ending: { kind: 'fine' } };
  const steps = [
    { id: 'a', kind: 'joint', target: { kind: 'posture', values: [41.2454902, 56.5654912] }, ...step },
    {
      id: 'b',
      kind: 'linear',
      target: { kind: 'pose', xyz: [616, 1500, 0], rpy: [0, 0, 90] },
      ...step,
      speed: 100,
      speedUnit: 'length/s',
    },
  ];
  const own = { ...doc, motionPrograms: [{ id: 'm', name: 'Line', steps: /** @type {StepDoc[]} */ (steps) }] };
  for (const [write, brand] of WRITERS) {
    const tried = madeOf(own, brand);
    if (tried?.made.moves.length !== 2) throw new Error('Expected both moves.');
    const { matches, findings, moves } = verifyCode(own, tried.made, write(tried.made.program).files);
    expect([matches, findings.filter(({ severity }) => severity === 'error')]).toEqual([true, []]);
    const [{ rounding: before }, { rounding, deviation }] = moves;
    expect(rounding.millimetres).toBeGreaterThanOrEqual(before.millimetres);
    expect(deviation?.millimetres).toBeLessThan(rounding.millimetres);
  }
});

test('what a loop does again and again is said once, and how often', () => {
  const text =
    "PROGRAM p\n%NOLOCKGROUP\nVAR i : INTEGER\nBEGIN\n  FOR i = 1 TO 3 DO\n    WRITE('again', CR)\n  ENDFOR\nEND p\n";
  const { findings } = verifyCode(newDocument(LIBRARY.puma560), null, [{ name: 'p.kl', language: 'karel', text }]);
  expect(findings.map(({ message }) => message)).toEqual(['again (3 times)']);
});
