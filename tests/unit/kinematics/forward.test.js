import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { createChain } from '../../../src/kinematics/chain.js';
import { linkFrames, tcpPose } from '../../../src/kinematics/forward.js';
import { translation } from '../../../src/kinematics/pose.js';
import { SEED, runs } from '../../helpers/property.js';
import { anyChain, arm, forwardCases, largestDifference, oracleForward, rowsOf, sizeOf } from './oracle.js';

/** @import { JointRow } from '../../../src/kinematics/joint.js' */

/** @param {Float64Array} frames @param {number} i */
const frameOf = (frames, i) => rowsOf(frames.subarray(16 * i, 16 * i + 16));
/** @param {number[]} degrees */
const radians = (...degrees) => degrees.map((value) => (value * Math.PI) / 180);

describe('any chain, both conventions, with base and tool', () => {
  test('the tool pose and every frame are the product of the printed matrices', () => {
    fc.assert(
      fc.property(anyChain, ({ description, q }) => {
        const chain = createChain(description);
        const { frames, tcp } = oracleForward(description, q);
        const tolerance = 1e-14 * sizeOf(description) * (1 + chain.dof);
        expect(largestDifference(rowsOf(tcpPose(chain, q)), tcp)).toBeLessThan(tolerance);
        const found = linkFrames(chain, q);
        expect(found.length).toBe(16 * (chain.dof + 1));
        frames.forEach((T, i) => expect(largestDifference(frameOf(found, i), T)).toBeLessThan(tolerance));
      }),
      { seed: SEED, numRuns: runs(300) },
    );
  });
  test('what is written into `out` is what is returned without it', () => {
    fc.assert(
      fc.property(anyChain, ({ description, q }) => {
        const chain = createChain(description);
        const out = new Float64Array(16).fill(7);
        expect(tcpPose(chain, q, out)).toBe(out);
        expect(out).toEqual(tcpPose(chain, q));
        const frames = new Float64Array(16 * (chain.dof + 1)).fill(7);
        expect(linkFrames(chain, q, frames)).toBe(frames);
        expect(frames).toEqual(linkFrames(chain, q));
      }),
      { seed: SEED, numRuns: runs(50) },
    );
  });
});

describe('right angles', () => {
  test('are exact in every entry of a chain of right angles at zero', () => {
    const [a, alpha, d, theta] = [2, Math.PI / 2, 3, -Math.PI / 2];
    for (const convention of /** @type {const} */ (['standard', 'modified'])) {
      for (const type of /** @type {const} */ (['revolute', 'prismatic'])) {
        /** @type {JointRow} */
        const row = { type, a, alpha, d, theta };
        const chain = createChain({
          convention,
          joints: [row, { ...row, alpha: Math.PI }, { ...row, theta: Math.PI }, row],
        });
        for (const value of linkFrames(chain, [0, 0, 0, 0])) expect(Number.isInteger(value)).toBe(true);
      }
    }
  });
  test('keep the planar arm in its plane at every posture', () => {
    const chain = createChain(arm('planar2r'));
    for (const q of forwardCases.planar2r.q) expect(tcpPose(chain, q)[14]).toBe(0);
  });
});

describe('numbers printed in books', () => {
  const puma = createChain(arm('puma560'));
  test('Corke, Robotics, Vision and Control, section 7.2: the Puma 560 at qn', () => {
    const printed = [
      [0, 0, 1, 0.5963],
      [0, 1, 0, -0.1501],
      [-1, 0, 0, 0.6575],
      [0, 0, 0, 1],
    ];
    expect(largestDifference(rowsOf(tcpPose(puma, radians(0, 45, 180, 0, 45, 0))), printed)).toBeLessThan(6e-5);
  });
  test('Universal Robots, parameters for calculations of kinematics: the UR5 at zero', () => {
    const { convention, joints } = arm('ur5');
    const ur5 = createChain({ convention, joints: [{ ...joints[0], d: 0.089159 }, ...joints.slice(1)] }); // as they print it
    const [x, y, z] = tcpPose(ur5, [0, 0, 0, 0, 0, 0]).subarray(12, 15);
    expect(Math.hypot(x + 0.81725, y + 0.19145, z + 0.005491)).toBeLessThan(1e-15);
  });
  test('Craig, chapter 3, exercise: the planar 3R with links 4, 3 and 2 m, as Craig writes it', () => {
    /** @type {JointRow} */
    const row = { type: 'revolute', a: 0, alpha: 0, d: 0, theta: 0 };
    const hand = createChain({
      convention: 'modified',
      joints: [row, { ...row, a: 4 }, { ...row, a: 3 }],
      tool: translation([2, 0, 0]),
    });
    for (const [q, x, y] of /** @type {const} */ ([
      [[0, 0, 0], 9, 0],
      [[10, 20, 30], 7.5373, 3.9266],
      [[90, 90, 90], -3, 2],
    ])) {
      const T = tcpPose(hand, radians(...q));
      expect(Math.hypot(T[12] - x, T[13] - y)).toBeLessThan(1e-4);
    }
    const wrist = linkFrames(hand, radians(10, 20, 30)).subarray(48);
    expect(Math.hypot(wrist[12] - 6.537, wrist[13] - 2.195)).toBeLessThan(6e-4); // printed with three decimals
  });
});

test('an arm may have 64 joints, and no more', () => {
  /** @type {JointRow[]} */
  const joints = Array.from({ length: 64 }, (_, i) => ({ type: 'revolute', a: 0.1, alpha: i, d: 0.2, theta: 0 }));
  /** @type {{ convention: 'standard', joints: JointRow[] }} */
  const description = { convention: 'standard', joints };
  const q = joints.map((_, i) => i / 10);
  const T = tcpPose(createChain(description), q);
  expect(largestDifference(rowsOf(T), oracleForward(description, q).tcp)).toBeLessThan(1e-12);
  const tooLong = { ...description, joints: [...joints, joints[0]] };
  expect(() => createChain(tooLong)).toThrow('Expected at most 64 joints, got 65.');
});

describe('wrong calls', () => {
  const chain = createChain(arm('puma560'));
  test.each([
    [[0, 0, 0, 0, 0], RangeError, 'Expected 6 joint values, got 5.'],
    [[], RangeError, 'Expected 6 joint values, got 0.'],
    [[0, 0, NaN, 0, 0, 0], RangeError, 'Expected joint value 3 to be a finite number, got NaN.'],
    [[0, 0, 0, 0, 0, -Infinity], RangeError, 'Expected joint value 6 to be a finite number, got -Infinity.'],
    [
      /** @type {number[]} */ (/** @type {unknown} */ (undefined)),
      TypeError,
      'Expected 6 joint values, got undefined.',
    ],
  ])('the posture %j is refused', (q, type, words) => {
    for (const call of [() => tcpPose(chain, q), () => linkFrames(chain, q)]) {
      expect(call).toThrow(type);
      expect(call).toThrow(words);
    }
  });
  test('too little room is refused, not half filled', () => {
    const q = new Float64Array(6);
    expect(() => tcpPose(chain, q, new Float64Array(12))).toThrow('Expected room for 16 numbers, got 12.');
    expect(() => linkFrames(chain, q, new Float64Array(96))).toThrow('Expected room for 112 numbers, got 96.');
  });
});
