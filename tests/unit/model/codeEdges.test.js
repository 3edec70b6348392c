/**
 * Programs at the edges of what arms can do, written and verified: arms with few joints and a tilted base, arcs whose points lie close
 * together, joints at their limits and turned further than configurations tell. What decimals cost there is no fault of the code.
 */
import { expect, test } from 'vitest';
import { tcpPose } from '../../../src/kinematics/forward.js';
import { compilePosture, compileRobot } from '../../../src/model/compile.js';
import { planOfMove } from '../../../src/model/code/codeMoves.js';
import { postureAt } from '../../../src/model/program/planPosture.js';
import { neutralProgram } from '../../../src/model/controller/neutralProgram.js';
import { runCode } from '../../../src/model/controller/runCode.js';
import { verifyCode } from '../../../src/model/controller/verifyCode.js';
import { LIBRARY, newDocument } from '../../../src/model/library.js';
import { poseInUnits } from '../../../src/model/numbers/poseNumbers.js';
import { WRITERS, WRITTEN } from './codePrograms.js';

/** @import { MoveStep, PoseTarget, RobotDoc } from '../../../src/model/document.js' */

/** @param {RobotDoc} robot @param {readonly number[]} q @returns {PoseTarget} */
const poseAt = (robot, q) => ({
  kind: 'pose',
  ...poseInUnits(tcpPose(compileRobot(robot), compilePosture(robot, q)), robot.units),
});
const manner = /** @type {const} */ ({ acceleration: 100, ending: { kind: 'fine' } });
const byJoints = /** @type {const} */ ({ kind: 'joint', speed: 10, speedUnit: '%', ...manner });
const byTool = /** @type {const} */ ({ speed: 50, speedUnit: 'length/s', ...manner });

/** What is against it, in each language. @param {RobotDoc} robot @param {readonly (Omit<MoveStep, 'id'>)[]} moves */
function verified(robot, moves) {
  const steps = moves.map((move, i) => /** @type {MoveStep} */ ({ id: `s${i}`, ...move }));
  const doc = { ...newDocument(robot), motionPrograms: [{ id: 'm', name: 'Edge', steps }] };
  return WRITERS.map(([write, brand]) => {
    const { made, issues } = neutralProgram(doc, doc.motionPrograms[0], { brand, ...WRITTEN });
    if (!made) throw new Error(issues.map(({ message }) => message).join(' '));
    const { files, notes } = write(made.program);
    const { findings, matches, moves: checked } = verifyCode(doc, made, files);
    const errors = findings.filter(({ severity }) => severity === 'error').map(({ message }) => message);
    return { brand, files, errors, findings, matches, checked, notes: notes.map(({ message }) => message).join(' ') };
  });
}

test.for([
  ['planar2r', [20, 40], [24, 43]],
  ['planar3r', [20, 40, 30], [23, 44, 28]],
  ['scara_cobra600', [10, 40, 60, 20], [14, 43, 70, 25]],
  ['cyl_rpp', [10, 400, 300], [15, 420, 330]],
  ['mitsubishi_rv2aj', [10, 20, 60, 40, 20], [13, 24, 57, 42, 25]],
])(
  '%s on a tilted base: decimals put positions beside those that it can have, which is no reason to refuse them',
  (given) => {
    const [arm, from, to] = /** @type {[string, number[], number[]]} */ (given);
    const robot = { ...LIBRARY[arm], base: { xyz: [100, -200, 300], rpy: [10, 20, 30] } };
    const moves = [
      { ...byJoints, target: poseAt(robot, from) },
      { kind: /** @type {const} */ ('linear'), ...byTool, target: poseAt(robot, to) },
    ];
    for (const { brand, files, errors, matches } of verified(robot, moves)) {
      expect(errors).toEqual([]);
      expect(matches).toBe(true);
      if (brand !== 'kuka') continue;
      // the page takes the arm there, too
      let { posture } = newDocument(robot);
      for (const effect of runCode(files).effects) {
        const planned = planOfMove(newDocument(robot), posture, { ...effect, brand }, {});
        if ('message' in planned) throw new Error(planned.message);
        expect(planned.plan.refused).toBeFalsy();
        posture = postureAt(robot, planned.plan, { time: planned.plan.duration, start: posture });
      }
      to.forEach((value, i) => expect(Math.abs(posture[i] - value)).toBeLessThan(0.01));
    }
  },
);

test('an arc with its points close together leans on their decimals, and is the program’s arc all the same', () => {
  const robot = LIBRARY.abb_irb120;
  const q = [10, 20, 10, 30, 60, 15];
  const from = poseAt(robot, q);
  /** On a circle through the beginning. @param {number} degrees @returns {PoseTarget} */
  const on = (degrees) => {
    const [x, y, z] = from.xyz;
    const turn = (degrees * Math.PI) / 180;
    return { ...from, xyz: [x, y + 40 * Math.sin(turn), z + 40 * (1 - Math.cos(turn))] };
  };
  for (const via of [3, 290]) {
    const arc = { kind: /** @type {const} */ ('circular'), ...byTool, via: on(via), target: on(300) };
    for (const { errors, checked } of verified(robot, [{ ...byJoints, target: { kind: 'posture', values: q } }, arc])) {
      expect(errors).toEqual([]);
      const [, { deviation, rounding }] = checked;
      expect(deviation?.millimetres).toBeLessThan(rounding.millimetres);
    }
  }
});

test('a pose at the limit of a joint is gone to, whatever its decimals make of the joint, and that is said', () => {
  const tilted = { xyz: [100, -200, 300], rpy: [10, 20, 30] };
  const robot = { ...LIBRARY.cart_ppp, base: tilted };
  const { upper = 0 } = robot.joints[1];
  let said = 0;
  for (const first of [110, 230, 350, 470]) {
    const moves = [
      { ...byJoints, target: { kind: /** @type {const} */ ('posture'), values: [first, upper - 100, 200] } },
      { kind: /** @type {const} */ ('linear'), ...byTool, target: poseAt(robot, [first + 10, upper, 210]) },
      { kind: /** @type {const} */ ('linear'), ...byTool, target: poseAt(robot, [first + 20, upper - 50, 220]) },
    ];
    for (const { errors, findings } of verified(robot, moves)) {
      expect(errors).toEqual([]);
      said += findings.filter(({ code }) => code === 'limit').length;
    }
  }
  expect(said).toBeGreaterThan(0);
});

test.for(
  /** @type {[string, string, number[]][]} */ ([
    ['fanuc_m10ia', 'fanuc', [19, 20, 10, 30, -186, 40]],
    ['abb_irb140', 'kuka', [19, 20, 10, 30, 60, 380]],
  ]),
)('%s, turned further than its configuration tells, is sent to joint values', ([arm, brand, q]) => {
  const robot = LIBRARY[arm];
  for (const one of verified(robot, [
    { ...byJoints, target: { kind: 'posture', values: q } },
    { ...byJoints, target: poseAt(robot, q.with(0, 25)) },
  ])) {
    expect(one.errors).toEqual([]);
    if (one.brand === brand) expect(one.notes).toContain('Step 2 goes to joint values: an axis is turned so far');
  }
});

test.for(
  /** @type {[string, number[], number][]} */ ([
    ['kuka_kr5_arc', [10, -80, 20, 30, 0, 40], 4],
    ['abb_irb120', [10, 20, 10, 30, 0, 15], 4],
    ['fanuc_m10ia', [10, 20, -5, 30, 0, 15], 4],
    ['planar2r', [20, 0], 1],
  ]),
)('%s next to a singular posture: decimals do not put it there, nor to the other side', ([arm, q, bent]) => {
  const robot = LIBRARY[arm];
  const { sign } = robot.joints[bent].controller;
  const target = (/** @type {number} */ value) => ({
    kind: /** @type {const} */ ('posture'),
    values: q.with(bent, value),
  });
  for (const value of [1e-5, 4e-4, 9e-4, -1e-5, -4e-4, -9e-4, 0]) {
    for (const { files, checked, matches } of verified(robot, [{ ...byJoints, target: target(value) }])) {
      expect(matches).toBe(true);
      expect(checked[0].margins.singularity === 0).toBe(value === 0);
      const [{ position }] = runCode(files).effects;
      const written = /** @type {number[]} */ (position)[bent];
      expect(Math.sign(written) + 0).toBe(sign * Math.sign(value) + 0);
      expect(Math.abs(written - sign * value)).toBeLessThan(1e-3);
    }
  }
});

test('a line begins next to a singular posture in code as in the program', () => {
  const robot = LIBRARY.kuka_kr5_arc;
  const from = [-60, -155, -15, -60, 1e-4, -60];
  const moves = [
    { ...byJoints, target: { kind: /** @type {const} */ ('posture'), values: from } },
    { kind: /** @type {const} */ ('linear'), ...byTool, target: poseAt(robot, [-68, -163, -15, -68, 8, -68]) },
  ];
  for (const { errors } of verified(robot, moves)) expect(errors).toEqual([]);
  const into = [{ ...moves[0], target: { kind: /** @type {const} */ ('posture'), values: from.with(4, 0) } }, moves[1]];
  expect(() => verified(robot, into)).toThrow('it stands in a singular posture, from which it cannot go this way');
});

test('a slide that is too slow for a speed would have to slide, a joint to turn', () => {
  const quick = { ...byTool, speed: 1900 };
  for (const [arm, from, to, word] of /** @type {[string, number[], number[], string][]} */ ([
    ['cart_ppp', [100, 100, 100], [200, 100, 100], 'slide'],
    ['planar2r', [20, 40], [24, 43], 'turn'],
  ])) {
    const { joints } = LIBRARY[arm];
    const robot = { ...LIBRARY[arm], joints: joints.map((joint) => ({ ...joint, velocity: 10 })) };
    const moves = [
      { ...byJoints, target: { kind: /** @type {const} */ ('posture'), values: from } },
      { kind: /** @type {const} */ ('linear'), ...quick, target: poseAt(robot, to) },
    ];
    for (const { findings } of verified(robot, moves))
      expect(findings.find(({ code }) => code === 'rate')?.message).toMatch(`would have to ${word} at`);
  }
});
