/** Configurations, S and T and positions that were published, and postures that none of them tells apart. */
import { expect, test } from 'vitest';
import { writeKrl } from '../../../src/karel/write/krl.js';
import { writeTp } from '../../../src/karel/write/tp.js';
import { tcpPose } from '../../../src/kinematics/forward.js';
import { compilePosture, compileRobot } from '../../../src/model/compile.js';
import { postureFromPendant } from '../../../src/model/controller/pendantNumbers.js';
import { neutralProgram } from '../../../src/model/controller/neutralProgram.js';
import { verifyCode } from '../../../src/model/controller/verifyCode.js';
import { LIBRARY, newDocument } from '../../../src/model/library.js';
import { poseInUnits } from '../../../src/model/numbers/poseNumbers.js';
import { WRITERS, WRITTEN } from './codePrograms.js';

/** @import { Doc, StepDoc } from '../../../src/model/document.js' */

/**
 * Published pairs of S and T of KUKA programs, with the signs of the axes that they stand for (facts of forums and programs): S 6 T 27
 * is A1, A2, A4 and A5 below zero, S 6 T 19 is A1, A2 and A5.
 */
test.for(
  /** @type {[string, number[], string][]} */ ([
    ['T 27', [-20, -70, 95, -40, -50, 30], "S 'B110',T 'B11011'"],
    ['T 19', [-20, -70, 95, 40, -50, 30], "S 'B110',T 'B10011'"],
  ]),
)('KUKA’s published S 6 with %s is written, and a wrong status or turn is found on its line', ([, axes, text]) => {
  const base = newDocument(LIBRARY.kuka_kr6_r900);
  const q = postureFromPendant(base.robot, axes);
  const target = {
    kind: /** @type {const} */ ('pose'),
    ...poseInUnits(tcpPose(compileRobot(base.robot), compilePosture(base.robot, q)), base.robot.units),
  };
  const manner = { speed: 10, speedUnit: '%', acceleration: 100, ending: { kind: 'fine' } };
  const steps = /** @type {StepDoc[]} */ ([
    { id: 'a', kind: 'joint', target: { kind: 'posture', values: q }, ...manner },
    { id: 'b', kind: 'joint', target, ...manner },
  ]);
  const doc = { ...base, posture: q, motionPrograms: [{ id: 'm', name: 'Published', steps }] };
  const { made } = neutralProgram(doc, doc.motionPrograms[0], { brand: 'kuka', ...WRITTEN });
  if (!made) throw new Error('Expected a program.');
  const { files } = writeKrl(made.program);
  expect(files[1].text).toContain(`${text}}`);
  expect(verifyCode(doc, made, files).matches).toBe(true);
  const line = files[0].text.split('\n').findIndex((one) => one.startsWith('PTP XP2')) + 1;
  for (const [from, to] of [
    ["S 'B110'", "S 'B010'"],
    ["S 'B110'", "S 'B100'"],
  ]) {
    const { matches, findings } = verifyCode(doc, made, [
      files[0],
      { ...files[1], text: files[1].text.replace(from, to) },
    ]);
    expect(matches).toBe(false);
    expect(findings.find(({ severity }) => severity === 'error')).toMatchObject({ file: files[0].name, line });
  }
});

test('a pose in a singular posture is gone to by joint values, since a configuration would leave open which', () => {
  const base = newDocument(LIBRARY.kuka_kr6_r900);
  const q = [-60, -120, 60, -60, 0, -60];
  const target = {
    kind: /** @type {const} */ ('pose'),
    ...poseInUnits(tcpPose(compileRobot(base.robot), compilePosture(base.robot, q)), base.robot.units),
  };
  const manner = { speed: 10, speedUnit: '%', acceleration: 100, ending: { kind: 'fine' } };
  const steps = /** @type {StepDoc[]} */ ([{ id: 'a', kind: 'joint', target, ...manner }]);
  const doc = { ...base, posture: q, motionPrograms: [{ id: 'm', name: 'Singular', steps }] };
  for (const [write, brand] of WRITERS) {
    const { made } = neutralProgram(doc, doc.motionPrograms[0], { brand, ...WRITTEN });
    if (!made) throw new Error('Expected a program.');
    const { files, notes } = write(made.program);
    expect(notes.map(({ message }) => message).join(' ')).toContain(
      'Step 1 goes to joint values: the posture there is singular',
    );
    expect(verifyCode(doc, made, files).matches).toBe(true);
  }
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
