/**
 * Numbers from textbooks and manuals: tests/fixtures/kinematics/golden.json has all 48, with their sources. Those that need
 * time laws or workspace areas are named here, and wait for the modules they are about.
 */
import { describe, expect, test } from 'vitest';
import { allInverseKinematics } from '../../../src/kinematics/allInverse.js';
import { axisAngleOf, poseFromAxisAngle } from '../../../src/kinematics/orientations/axisAngle.js';
import { createChain } from '../../../src/kinematics/chain.js';
import { dexterity, velocityEllipsoid } from '../../../src/kinematics/dexterity.js';
import { eulerAnglesOf, poseFromEulerAngles } from '../../../src/kinematics/orientations/eulerAngles.js';
import { linkFrames, tcpPose } from '../../../src/kinematics/forward.js';
import { finiteDifferenceJacobian, geometricJacobian } from '../../../src/kinematics/jacobian.js';
import { compose, invert, position, translation } from '../../../src/kinematics/pose.js';
import { poseFromQuaternion, quaternionOf } from '../../../src/kinematics/orientations/quaternion.js';
import { columnMajor, rotationOf, rowsOf } from './oracle.js';
import { fixture, publishedArm } from './publishedArms.js';

/** @import { JointRow } from '../../../src/kinematics/joint.js' */

/** @typedef {{ id: string, source: string, input: string, expected: unknown, tolerance: number }} Entry */
const entries = new Map(/** @type {Entry[]} */ (fixture('golden.json')).map((entry) => [entry.id, entry]));

const HALF_TURN = Math.PI;
/** @param {number} degrees */
const radians = (degrees) => (degrees * HALF_TURN) / 180;
/** @param {number[]} degrees */
const allRadians = (...degrees) => degrees.map(radians);
const [X, Y, Z] = [
  [1, 0, 0],
  [0, 1, 0],
  [0, 0, 1],
];
/** @param {number[]} axis @param {number} degrees */
const turn = (axis, degrees) => poseFromAxisAngle([0, 0, 0], axis, radians(degrees));
/** @param {ArrayLike<number>} T */
const rotationRows = (T) => rotationOf(rowsOf(T));

/** @param {Partial<JointRow>} row @returns {JointRow} */
const revolute = (row) => ({ type: 'revolute', a: 0, alpha: 0, d: 0, theta: 0, ...row });
/** @param {Partial<JointRow>} row @returns {JointRow} */
const prismatic = (row) => ({ ...revolute(row), type: 'prismatic' });
/** @param {number[]} lengths */
const planar = (...lengths) => createChain({ convention: 'standard', joints: lengths.map((a) => revolute({ a })) });
const puma = createChain(publishedArm('puma560'));
const PUMA_NOMINAL = allRadians(0, 45, 180, 0, 45, 0);

/** Found numbers against those of an entry, one by one, in any nesting. */
const used = new Set();
/** @param {string} id @param {unknown} found @param {number} [tolerance] */
function expectGolden(id, found, tolerance) {
  used.add(id);
  const entry = entries.get(id);
  if (!entry) throw new RangeError(`Expected the name of an entry, got ${id}.`);
  const [got, wanted] = [found, entry.expected].map((value) => [value].flat(3).map(Number));
  expect(got.length).toBe(wanted.length);
  got.forEach((value, i) => expect(Math.abs(value - wanted[i])).toBeLessThan((tolerance ?? entry.tolerance) + 1e-15));
}

/** What an entry says, for the few that are more than a list. @template T @param {string} id @returns {T} */
const expected = (id) => {
  used.add(id);
  return /** @type {T} */ (entries.get(id)?.expected);
};

describe('rotations and frames', () => {
  test('Craig, examples 2.1 and 2.2: a vector turned, and mapped from one frame to another', () => {
    expectGolden('craig-2.1', position(compose(turn(Z, 30), translation([0, 2, 0]))));
    const T_A_B = compose(translation([10, 5, 0]), turn(Z, 30));
    expectGolden('craig-2.2', position(compose(T_A_B, translation([3, 7, 0]))));
  });
  test('Craig, example 2.5: the inverse of a frame', () => {
    expectGolden('craig-2.5', rowsOf(invert(compose(translation([4, 3, 0]), turn(Z, 30)))));
  });
  test('Craig, examples 2.8 and 2.9: a turn about a line, through the origin or not', () => {
    const R = turn([Math.SQRT1_2, Math.SQRT1_2, 0], 30);
    expectGolden('craig-2.8', rotationRows(R));
    const { axis, angle } = axisAngleOf(R);
    expect(angle).toBeCloseTo(radians(30), 12);
    [Math.SQRT1_2, Math.SQRT1_2, 0].forEach((value, i) => expect(axis[i]).toBeCloseTo(value, 12));
    const aside = compose(compose(translation([1, 2, 3]), R), translation([-1, -2, -3]));
    expectGolden('craig-2.9', position(aside));
  });
  test('Craig, section 2.8: Euler parameters', () => {
    expectGolden('craig-euler-params', Array.from(quaternionOf(turn([1, 1, 0], 30))));
    const R = poseFromQuaternion([0, 0, 0], /** @type {number[]} */ (expected('craig-euler-params')));
    expectGolden('craig-2.8', rotationRows(R));
  });
  test('Craig, equations 2.64 and 2.66: fixed angles there and back', () => {
    const R = poseFromEulerAngles([0, 0, 0], allRadians(10, 20, 30), 'xyz');
    const product = compose(compose(turn(Z, 30), turn(Y, 20)), turn(X, 10));
    R.forEach((value, i) => expect(value).toBeCloseTo(product[i], 14));
    expectGolden('craig-fixed-angles', Array.from(eulerAnglesOf(R, 'xyz').angles));
  });
  test('Craig, section 2.8: turns do not commute', () => {
    const pair = [compose(turn(Z, 90), turn(X, 90)), compose(turn(X, 90), turn(Z, 90))];
    expectGolden('order-matters', pair.map(rotationRows));
  });
  test('Corke, section 2.3.1: roll, pitch, yaw and Z–Y–Z Euler angles', () => {
    expectGolden('corke-rpy', rotationRows(poseFromEulerAngles([0, 0, 0], [0.1, 0.2, 0.3], 'xyz')));
    expectGolden('corke-eul', rotationRows(poseFromEulerAngles([0, 0, 0], [0.1, 0.2, 0.3], 'ZYZ')));
  });
  test('with the pitch at 90° only the difference of roll and yaw means anything', () => {
    const [one, other] = [allRadians(30, 90, 70), allRadians(0, 90, 40)].map((angles) =>
      poseFromEulerAngles([0, 0, 0], angles, 'xyz'),
    );
    expectGolden('rpy-gimbal', Math.max(...one.map((value, i) => Math.abs(value - other[i]))));
    expect(eulerAnglesOf(one, 'xyz').isGimbalLock).toBe(true);
  });
});

describe('forward kinematics', () => {
  test('Craig, example 3.3 and the exercises of chapter 3: the planar 3R arm, wrist and hand', () => {
    const hand = createChain({
      convention: 'modified',
      joints: [revolute({}), revolute({ a: 4 }), revolute({ a: 3 })],
      tool: translation([2, 0, 0]),
    });
    const wrist = linkFrames(hand, allRadians(10, 20, 30)).subarray(48);
    const phi = (eulerAnglesOf(wrist, 'xyz').angles[2] * 180) / HALF_TURN;
    expectGolden('craig-3.3-3R', [wrist[12], wrist[13], phi]);
    const hands = [allRadians(0, 0, 0), allRadians(10, 20, 30), allRadians(90, 90, 90)].map((q) => tcpPose(hand, q));
    expectGolden(
      'craig-ex-3R-hand',
      hands.map((T) => [T[12], T[13]]),
    );
  });
  test('Spong, example 3.6: the SCARA', () => {
    const scara = createChain({
      convention: 'standard',
      joints: [revolute({ a: 0.4 }), revolute({ a: 0.3, alpha: HALF_TURN }), prismatic({}), revolute({ d: 0.1 })],
    });
    const T = tcpPose(scara, [0.3, 0.5, 0.2, 0.7]);
    expectGolden('spong-scara', [T[12], T[13], T[14], Math.atan2(T[1], T[0])]);
  });
  test('Spong, example 3.5: the Stanford arm', () => {
    const stanford = createChain({
      convention: 'standard',
      joints: [
        revolute({ alpha: -HALF_TURN / 2 }),
        revolute({ alpha: HALF_TURN / 2, d: 0.154 }),
        prismatic({}),
        revolute({ alpha: -HALF_TURN / 2 }),
        revolute({ alpha: HALF_TURN / 2 }),
        revolute({ d: 0.263 }),
      ],
    });
    expectGolden('spong-stanford', position(tcpPose(stanford, [0.1, 0.2, 0.3, 0.4, 0.5, 0.6])));
  });
  test('Corke, section 7.2: the Puma 560 at qn and at zero', () => {
    expectGolden('corke-puma-qn-fk', rowsOf(tcpPose(puma, PUMA_NOMINAL)));
    expectGolden('corke-puma-qz', position(tcpPose(puma, [0, 0, 0, 0, 0, 0])));
  });
  test('Universal Robots: the UR5 at zero', () => {
    const { convention, joints } = publishedArm('ur5');
    const ur5 = createChain({ convention, joints: [{ ...joints[0], d: 0.089159 }, ...joints.slice(1)] });
    expectGolden('ur5-zero', position(tcpPose(ur5, [0, 0, 0, 0, 0, 0])));
  });
  test('Lynch & Park, example 4.5: a UR5 with its lengths in millimetres, as a product of exponentials', () => {
    const [W1, W2, L1, L2, H1, H2] = [0.109, 0.082, 0.425, 0.392, 0.089, 0.095];
    // their base is half a turn about z from the maker's; their tool frame, at zero, has the rows below
    const joints = [
      revolute({ alpha: HALF_TURN / 2, d: H1 }),
      revolute({ a: -L1 }),
      revolute({ a: -L2 }),
      revolute({ alpha: HALF_TURN / 2, d: W1 }),
      revolute({ alpha: -HALF_TURN / 2, d: H2 }),
      revolute({ d: W2 }),
    ];
    const home = columnMajor([
      [-1, 0, 0, L1 + L2],
      [0, 0, 1, W1 + W2],
      [0, 1, 0, H1 - H2],
      [0, 0, 0, 1],
    ]);
    const base = turn(Z, 180);
    const flange = tcpPose(createChain({ convention: 'standard', base, joints }), [0, 0, 0, 0, 0, 0]);
    const tool = compose(invert(flange), home);
    expect(Math.hypot(...position(tool))).toBeLessThan(1e-15); // only turned
    const chain = createChain({ convention: 'standard', base, joints, tool });
    expectGolden('lynchpark-ur5', rowsOf(tcpPose(chain, allRadians(0, -90, 0, 0, 90, 0))));
  });
  test('Modern Robotics, FKinBody: a turn, a slide, and a screw of 0.1 m/rad as a turn and a slide', () => {
    const chain = createChain({
      convention: 'standard',
      base: translation([0, 4, 0]),
      joints: [
        revolute({ alpha: -HALF_TURN / 2 }),
        prismatic({ d: 2, alpha: -HALF_TURN / 2 }),
        revolute({}),
        prismatic({}),
      ],
      tool: compose(translation([0, 0, -2]), turn(Z, 180)),
    });
    expectGolden('modernrobotics-FKinBody', rowsOf(tcpPose(chain, [HALF_TURN / 2, 3, HALF_TURN, 0.1 * HALF_TURN])));
  });
});

describe('Jacobians and what follows from them', () => {
  test('Corke, sections 8.1 and 8.2: the Puma 560 at qn, and how well it moves there', () => {
    const [exact, forward] = [geometricJacobian, finiteDifferenceJacobian].map((jacobian) =>
      jacobian(puma, PUMA_NOMINAL),
    );
    const rows = (/** @type {Float64Array} */ J) =>
      [0, 1, 2, 3, 4, 5].map((r) => [0, 1, 2, 3, 4, 5].map((k) => J[6 * k + r]));
    expectGolden('corke-puma-J', rows(exact), 1e-12);
    expectGolden('corke-puma-J', rows(forward), 1e-6);
    expectGolden('corke-puma-manip', dexterity(puma, PUMA_NOMINAL, { lengthScale: 1 }).manipulability);
  });
  test('Craig, examples 5.3 and 5.4: det J of the 2R arm is l₁ l₂ sin θ₂', () => {
    const J = geometricJacobian(planar(0.5, 0.5), [0.3, 0.9]);
    expectGolden('craig-5.3', J[0] * J[7] - J[1] * J[6]);
  });
  test('Siciliano, example 3.8: the manipulability of the 2R arm', () => {
    expectGolden('siciliano-manip', dexterity(planar(0.5, 0.4), [-1, 0.8], { part: 'linear' }).manipulability);
  });
  test('Siciliano, section 3.3.1: det J of the anthropomorphic arm', () => {
    const [a2, a3] = [0.4, 0.3];
    const chain = createChain({
      convention: 'standard',
      joints: [revolute({ alpha: HALF_TURN / 2 }), revolute({ a: a2 }), revolute({ a: a3 })],
    });
    const J = geometricJacobian(chain, [0.3, 0.5, -0.8]);
    const [u, v, w] = [0, 6, 12].map((from) => Array.from(J.subarray(from, from + 3)));
    const det =
      u[0] * (v[1] * w[2] - v[2] * w[1]) + u[1] * (v[2] * w[0] - v[0] * w[2]) + u[2] * (v[0] * w[1] - v[1] * w[0]);
    expectGolden('siciliano-anthropomorphic-det', det);
  });
  test.each([30, 90, 150])('Lynch & Park, section 5.4: the ellipse of the 2R arm with its elbow at %i°', (degrees) => {
    const id = `ellipsoid-2R-${degrees}`;
    const { sigma, w, cond } = /** @type {{ sigma: number[], w: number, cond: number }} */ (expected(id));
    for (const first of [0, 1.1]) {
      const q = [first, radians(degrees)];
      const { singularValues, manipulability, conditionNumber } = dexterity(planar(1, 1), q, { part: 'linear' });
      const { halfLengths, rank } = velocityEllipsoid(planar(1, 1), q);
      expect(rank).toBe(2);
      [...sigma, w, cond, ...sigma].forEach((value, i) => {
        const found = [singularValues[0], singularValues[1], manipulability, conditionNumber, ...halfLengths][i];
        expect(Math.abs(found - value)).toBeLessThan(1e-9);
      });
    }
  });
  test('Lynch & Park, example 6.1: Newton and Raphson on the Jacobian of the 2R arm, step by step', () => {
    const chain = planar(1, 1);
    const goal = tcpPose(chain, allRadians(30, 90));
    let q = allRadians(0, 30);
    const iterates = [q];
    for (let step = 0; step < 3; step++) {
      const T = tcpPose(chain, q);
      const away = compose(invert(T), goal);
      const w = Math.atan2(away[1], away[0]);
      // the body twist that takes T to the goal in unit time: the matrix logarithm, in the plane
      const [half, [x, y]] = [w / 2, position(away)];
      const cot = half / Math.tan(half);
      const V = [w, cot * x + half * y, cot * y - half * x];
      if (step === 0) expectGolden('lynchpark-newton-V0', V);
      const J = geometricJacobian(chain, q);
      const columns = [0, 6].map((from) => [
        J[from + 5],
        T[0] * J[from] + T[1] * J[from + 1],
        T[4] * J[from] + T[5] * J[from + 1],
      ]);
      const dot = (/** @type {number[]} */ u, /** @type {number[]} */ v) =>
        u.reduce((sum, value, i) => sum + value * v[i], 0);
      const [uu, uv, vv] = [dot(columns[0], columns[0]), dot(columns[0], columns[1]), dot(columns[1], columns[1])];
      const [ur, vr] = columns.map((column) => dot(column, V));
      const det = uu * vv - uv * uv;
      q = [q[0] + (vv * ur - uv * vr) / det, q[1] + (uu * vr - uv * ur) / det];
      iterates.push(q);
    }
    expectGolden(
      'lynchpark-newton',
      iterates.map((each) => each.map((value) => (value * 180) / HALF_TURN)),
    );
  });
});

describe('all solutions', () => {
  /** Modulo full turns. @param {ArrayLike<number>} a @param {ArrayLike<number>} b */
  const turnApart = (a, b) =>
    Math.max(...Array.from(a, (value, i) => Math.abs(Math.atan2(Math.sin(value - b[i]), Math.cos(value - b[i])))));
  /** @param {{ q: Float64Array }[]} solutions @param {number[][]} wanted @param {number} tolerance */
  function expectAll(solutions, wanted, tolerance) {
    expect(solutions.length).toBe(wanted.length);
    for (const q of wanted) expect(Math.min(...solutions.map((each) => turnApart(each.q, q)))).toBeLessThan(tolerance);
  }
  test('Craig, exercises of chapter 4: the planar 3R arm has two for the hand', () => {
    const hand = createChain({
      convention: 'modified',
      joints: [revolute({}), revolute({ a: 4 }), revolute({ a: 3 })],
      tool: translation([2, 0, 0]),
    });
    const { solutions } = allInverseKinematics(hand, compose(translation([7.5373, 3.9266, 0]), turn(Z, 60)));
    const wanted = /** @type {number[][]} */ (expected('craig-ch4-3R-ik')).map((q) => allRadians(...q));
    expectAll(solutions, wanted, radians(0.06));
  });
  test('Corke, section 7.2.2: the Puma 560 at qn has eight', () => {
    const { solutions } = allInverseKinematics(puma, tcpPose(puma, PUMA_NOMINAL));
    const wanted = /** @type {{ q: number[] }[]} */ (expected('puma-qn-8-solutions'));
    expectAll(
      solutions,
      wanted.map(({ q }) => q),
      1e-8,
    );
  });
  test('and so it has at any pose that is nothing special', () => {
    const { solutions, complete } = allInverseKinematics(puma, tcpPose(puma, [0.3, 0.7, -0.4, 0.5, 0.9, -0.2]));
    expectGolden('puma-8-solutions', solutions.length);
    expect(complete).toBe(true);
  });
  test('a UR5 has eight', () => {
    const { q: wanted, T } = /** @type {{ q: number[][], T: number[][] }} */ (expected('ur5-8-solutions'));
    const { convention, joints } = publishedArm('ur5');
    const ur5 = createChain({ convention, joints: [{ ...joints[0], d: 0.089159 }, ...joints.slice(1)] }); // the maker's
    const goal = tcpPose(ur5, [0.3, -1.2, 1.1, -0.7, 0.9, 0.4]);
    rowsOf(goal).forEach((row, r) => row.forEach((value, c) => expect(Math.abs(value - T[r][c])).toBeLessThan(1e-12)));
    const { solutions } = allInverseKinematics(ur5, goal);
    expectAll(solutions, wanted, 1e-6);
  });
});

/** What the kernel has no module for yet. */
const LATER = {
  'time laws': [
    'craig-7.1',
    'craig-7.lspb',
    'spong-cubic',
    'spong-lspb',
    'siciliano-cubic',
    'siciliano-trap',
    'time-scaling',
    'biagiotti-3.9',
    'biagiotti-3.10',
  ],
  workspace: ['workspace-2R', 'workspace-2R-limits', 'workspace-sphere', 'workspace-scara', 'workspace-budget'],
};

test('all 48 are either held to here or named as waiting', () => {
  expect(entries.size).toBe(48);
  expect([...used, ...Object.values(LATER).flat()].sort()).toEqual([...entries.keys()].sort());
});
