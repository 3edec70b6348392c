/**
 * The eight postures of arms with a spherical wrist, written as code and run again: configurations and S and T are judged by
 * closed forms for the wrist's place in the arm's plane, which share nothing with the names of postures in the kernel.
 */
import { expect, test } from 'vitest';
import { writeKrl } from '../../../src/karel/write/krl.js';
import { writeTp } from '../../../src/karel/write/tp.js';
import { allInverseKinematics } from '../../../src/kinematics/allInverse.js';
import { tcpPose } from '../../../src/kinematics/forward.js';
import { compilePosture, compileRobot, postureFromKernel } from '../../../src/model/compile.js';
import { pendantValues } from '../../../src/model/controller/controllerValues.js';
import { neutralProgram } from '../../../src/model/controller/neutralProgram.js';
import { verifyCode } from '../../../src/model/controller/verifyCode.js';
import { LIBRARY, newDocument } from '../../../src/model/library.js';
import { poseInUnits } from '../../../src/model/numbers/poseNumbers.js';

/** @import { Doc, RobotDoc, StepDoc } from '../../../src/model/document.js' */

const cos = (/** @type {number} */ degrees) => Math.cos((degrees * Math.PI) / 180);
const sin = (/** @type {number} */ degrees) => Math.sin((degrees * Math.PI) / 180);
const atan2 = (/** @type {number} */ y, /** @type {number} */ x) => (Math.atan2(y, x) * 180) / Math.PI;
const turnOf = (/** @type {number} */ value) => Math.sign(value) * Math.floor((Math.abs(value) + 180) / 360) + 0;

/** By the manual's words for an M-10iA, from pendant values. @param {number[]} J */
function fanucText([j1, j2, j3, j4, j5, j6]) {
  const [a1, a2, a3, d4] = [150, 600, 200, 640];
  const x = a1 + a2 * sin(j2) + d4 * cos(j3) - a3 * sin(j3);
  const straight = 90 - atan2(a3, d4);
  const up = sin(straight - (j2 + j3)) > 0;
  return `${j5 < 0 ? 'N' : 'F'} ${up ? 'U' : 'D'} ${x >= 0 ? 'T' : 'B'}, ${turnOf(j1)}, ${turnOf(j4)}, ${turnOf(j6)}`;
}

/** For a KR 6 R900 sixx. @param {number[]} A */
function kukaText(A) {
  const [, a2, a3, , a5] = A;
  const [a1, l2, l3, e] = [25, 455, 420, 35];
  const x = a1 + l2 * cos(a2) + l3 * cos(a2 + a3) + e * sin(a2 + a3);
  const status = (x >= 0 ? 0 : 1) + (sin(a3 - atan2(e, l3)) >= 0 ? 2 : 0) + (sin(a5) < 0 ? 4 : 0);
  const turn = A.reduce((sum, value, i) => sum + (value < 0 ? 2 ** i : 0), 0);
  return `S 'B${status.toString(2).padStart(3, '0')}',T 'B${turn.toString(2).padStart(3, '0')}'`;
}

const manner = /** @type {const} */ ({ speed: 10, speedUnit: '%', acceleration: 100, ending: { kind: 'fine' } });

/** @param {RobotDoc} robot @param {number[]} posture @param {'fanuc' | 'kuka'} brand @param {StepDoc} step */
function madeOf(robot, posture, brand, step) {
  /** @type {Doc} */
  const doc = { ...newDocument(robot), posture, motionPrograms: [{ id: 'm', name: 'Branch', steps: [step] }] };
  const options = { brand, version: '0', generatedAt: '2026-07-01T12:00:00Z' };
  const { made } = neutralProgram(doc, doc.motionPrograms[0], options);
  if (!made) throw new Error('Expected a program.');
  return { doc, made };
}

test.for(
  /** @type {const} */ ([
    ['fanuc_m10ia', 'fanuc', [20, 15, -25, 40, -50, 30]],
    ['kuka_kr6_r900', 'kuka', [20, -70, 95, 40, 50, 30]],
  ]),
)('all eight postures of %s', ([arm, brand, q]) => {
  const unlimited = {
    ...LIBRARY[arm],
    joints: LIBRARY[arm].joints.map((joint) => ({ ...joint, lower: undefined, upper: undefined })),
  };
  const chain = compileRobot(unlimited);
  const T = tcpPose(chain, compilePosture(unlimited, q));
  const { solutions } = allInverseKinematics(chain, T);
  expect(solutions).toHaveLength(8);
  const texts = solutions.map((solution) => {
    const posture = postureFromKernel(unlimited, solution.q);
    const target = { kind: /** @type {const} */ ('pose'), ...poseInUnits(T, unlimited.units) };
    const { doc, made } = madeOf(unlimited, posture, brand, { id: 'a', kind: 'joint', target, ...manner });
    const { files } = (brand === 'fanuc' ? writeTp : writeKrl)(made.program);
    const text =
      brand === 'fanuc' ? /CONFIG : '([^']*)'/.exec(files[0].text)?.[1] : /S '.*'(?=\})/.exec(files[1].text)?.[0];
    expect(text).toBe((brand === 'fanuc' ? fanucText : kukaText)(pendantValues(unlimited, posture)));
    expect(verifyCode(doc, made, files).matches).toBe(true);
    return text;
  });
  expect(new Set(texts).size).toBe(8);
});

test.for(
  /** @type {const} */ ([
    ['fanuc_m10ia', 'fanuc', [20, 15, -25, 180, -50, 30], [20, 15, -25, 0, -50, 30]],
    ['kuka_kr6_r900', 'kuka', [20, -70, 95, 0, 50, 30], [20, -70, 95, 180, 50, 30]],
  ]),
)('where a turn gets another number, %s is sent to joint values, and is told why', ([arm, brand, onBorder, off]) => {
  const robot = {
    ...LIBRARY[arm],
    joints: LIBRARY[arm].joints.map((joint) => ({ ...joint, lower: undefined, upper: undefined })),
  };
  const write = brand === 'fanuc' ? writeTp : writeKrl;
  for (const posture of [onBorder, off]) {
    const T = tcpPose(compileRobot(robot), compilePosture(robot, posture));
    const target = { kind: /** @type {const} */ ('pose'), ...poseInUnits(T, robot.units) };
    const { doc, made } = madeOf(robot, [...posture], brand, { id: 'a', kind: 'joint', target, ...manner });
    const { files, notes } = write(made.program);
    const told = notes.filter(({ message }) => message.includes('where its turn gets another number'));
    expect(told).toHaveLength(posture === onBorder ? 1 : 0);
    expect(verifyCode(doc, made, files).matches).toBe(true);
  }
});
