import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { createChain } from '../../../src/kinematics/chain.js';
import { translation } from '../../../src/kinematics/pose.js';
import { SEED, runs } from '../../helpers/property.js';
import { ARMS, anyChain, arm, oracleForward } from './oracle.js';

/** @import { ChainDescription } from '../../../src/kinematics/chain.js' */
/** @import { JointRow } from '../../../src/kinematics/joint.js' */

/** @param {Partial<JointRow>} [fields] @returns {JointRow} */
const joint = (fields) => ({ type: 'revolute', a: 1, alpha: 0, d: 0, theta: 0, ...fields });
/** @param {Partial<ChainDescription>} [fields] */
const chain = (fields) => createChain({ convention: 'standard', joints: [joint(), joint()], ...fields });
/** A wrong value, as a caller without types passes it. @template T @param {unknown} value */
const wrong = (value) => /** @type {T} */ (value);

describe('a chain', () => {
  test('keeps what it was given, frozen, missing limits as infinite', () => {
    const base = translation([1, 2, 3]);
    const rows = [joint({ upper: 2 }), joint({ type: 'prismatic', lower: 0 })];
    const made = chain({ base, joints: rows });
    expect(made.dof).toBe(2);
    expect(made.convention).toBe('standard');
    expect(made.base).toEqual(base);
    expect(made.joints[0]).toEqual({ ...rows[0], lower: -Infinity });
    expect(made.joints[1]).toEqual({ ...rows[1], upper: Infinity });
    for (const part of [made, made.joints, ...made.joints]) expect(Object.isFrozen(part)).toBe(true);
  });
  test('does not change when what it was given, or gave, is changed', () => {
    const base = translation([1, 2, 3]);
    const row = joint();
    const made = chain({ base, joints: [row] });
    base[12] = 9;
    row.a = 9;
    made.base[12] = 9;
    made.tool[12] = 9;
    expect(made.base[12]).toBe(1);
    expect(made.tool[12]).toBe(0);
    expect(made.joints[0].a).toBe(1);
    expect(made.packed.base[12]).toBe(1);
  });
  test.each([
    [{ joints: [] }, RangeError, 'Expected at least 1 joint, got 0.'],
    [{ joints: wrong('RRR') }, TypeError, "Expected the joints to be an array, got 'RRR'."],
    [{ joints: wrong([joint(), null]) }, TypeError, 'Expected joint 2 to be an object, got null.'],
    [
      { convention: wrong('craig') },
      RangeError,
      "Expected the convention to be 'standard' or 'modified', got 'craig'.",
    ],
    [{ convention: wrong(undefined) }, RangeError, "to be 'standard' or 'modified', got undefined."],
    [
      { joints: [joint({ type: wrong('continuous') })] },
      RangeError,
      "Expected joint 1 to be 'revolute' or 'prismatic', got 'continuous'.",
    ],
    [
      { joints: [joint(), joint({ alpha: NaN })] },
      RangeError,
      "Expected joint 2's alpha to be a finite number, got NaN.",
    ],
    [{ joints: [joint({ d: Infinity })] }, RangeError, "Expected joint 1's d to be a finite number, got Infinity."],
    [{ joints: [joint({ a: wrong('1') })] }, RangeError, "Expected joint 1's a to be a finite number, got '1'."],
    [
      { joints: [joint({ theta: wrong(undefined) })] },
      RangeError,
      "Expected joint 1's theta to be a finite number, got undefined.",
    ],
    [{ joints: [joint({ lower: NaN })] }, RangeError, "Expected joint 1's lower limit to be a number, got NaN."],
    [
      { joints: [joint({ upper: wrong(null) })] },
      RangeError,
      "Expected joint 1's upper limit to be a number, got null.",
    ],
    [
      { joints: [joint({ lower: 1, upper: -1 })] },
      RangeError,
      "Expected joint 1's lower limit to be at most its upper limit, got 1 and -1.",
    ],
    [
      { joints: [joint({ lower: Infinity })] },
      RangeError,
      "Expected joint 1's lower limit to be at most its upper limit",
    ],
    [{ base: new Float64Array(12) }, RangeError, 'Expected the base to be a pose'],
    [{ tool: new Float64Array(16) }, RangeError, 'Expected the tool to be a pose'],
    [{ tool: wrong(7) }, TypeError, 'Expected the tool to be a pose'],
  ])('refuses %o', (fields, type, words) => {
    expect(() => chain(fields)).toThrow(type);
    expect(() => chain(fields)).toThrow(words);
  });
  test('may have a joint that cannot move', () => {
    expect(chain({ joints: [joint({ lower: 1, upper: 1 })] }).joints[0].upper).toBe(1);
  });
});

describe('reach', () => {
  test('is never exceeded, from the shoulder, by any posture inside the limits', () => {
    fc.assert(
      fc.property(anyChain, ({ description, q }) => {
        const joints = description.joints.map((row, i) =>
          row.type === 'prismatic' ? { ...row, lower: Math.min(q[i], 0), upper: Math.max(q[i], 0) } : row,
        );
        const { shoulder, reach } = createChain({ ...description, joints });
        const { tcp } = oracleForward(description, q);
        const distance = Math.hypot(...shoulder.map((value, k) => tcp[k][3] - value));
        expect(distance).toBeLessThanOrEqual(reach * (1 + 1e-12) + 1e-12);
      }),
      { seed: SEED, numRuns: runs(300) },
    );
  });
  test('of the Stanford arm is no more than the lengths in its table add up to, the slide at its farther end', () => {
    // Robotics Toolbox for Python 1.5.0, models/DH/Stanford.py
    const quarter = Math.PI / 2;
    const made = chain({
      joints: [
        joint({ a: 0, d: 0.412, alpha: -quarter }),
        joint({ a: 0, d: 0.154, alpha: quarter }),
        joint({ type: 'prismatic', a: 0.0203, theta: -quarter, lower: 0.3048, upper: 1.27 }),
        joint({ a: 0, alpha: -quarter }),
        joint({ a: 0, alpha: quarter }),
        joint({ a: 0 }),
      ],
    });
    expect(made.reach).toBeLessThanOrEqual(0.154 + Math.hypot(0.0203, 1.27) + 1e-12);
  });
  test('is exceeded by none when the base is typed with six decimals', () => {
    const base = Float64Array.of(0.707107, 0.707107, 0, 0, -0.707107, 0.707107, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1);
    const { reach } = chain({ base });
    const { tcp } = oracleForward({ convention: 'standard', base, joints: [joint(), joint()] }, [0, 0]);
    expect(Math.hypot(tcp[0][3], tcp[1][3])).toBeGreaterThan(2);
    expect(Math.hypot(tcp[0][3], tcp[1][3])).toBeLessThanOrEqual(reach);
  });
  test('of a planar arm is the sum of its links, from the first axis', () => {
    const made = createChain(arm('planar2r'));
    expect([made.reach, ...made.shoulder]).toEqual([2, 0, 0, 0]);
  });
  test('of the Puma 560 is that of its wrist centre: upper arm and forearm in line, the shoulder offset across', () => {
    const forearm = Math.hypot(0.4318, 0.0203);
    const made = createChain(arm('puma560'));
    const exact = Math.hypot(0.4318 + forearm, 0.15005);
    expect(made.reach).toBeGreaterThanOrEqual(exact);
    expect(made.reach).toBeLessThan(1.001 * exact);
    expect(made.shoulder[2]).toBeCloseTo(0.67183, 3);
  });
  test('does not count offsets that only slide a frame along parallel axes', () => {
    const plain = chain({ joints: [joint(), joint(), joint()] });
    const shifted = chain({ joints: [joint({ d: 574.24 }), joint({ d: -1000 }), joint({ d: 425.76 })] });
    expect(shifted.reach).toBeCloseTo(plain.reach, 9);
    expect(shifted.characteristicLength).toBeCloseTo(plain.characteristicLength, 9);
  });
  test('counts a limited slide at its farther end, and is infinite with an unlimited one', () => {
    const slide = { type: /** @type {const} */ ('prismatic'), a: 0, d: 1 };
    expect(chain({ joints: [joint({ ...slide, lower: -1, upper: 3 })] }).reach).toBeCloseTo(2, 12); // either way from the middle
    expect(chain({ joints: [joint(), joint({ ...slide, lower: -1, upper: 3 })] }).reach).toBeCloseTo(3, 9);
    expect(chain({ joints: [joint(), joint({ ...slide, lower: 0 })] }).reach).toBe(Infinity);
  });
  test('is the same under either convention for the same arm', () => {
    // the planar arm as Craig writes it: link lengths one row later, the last in the tool
    const standard = chain({ joints: [joint({ a: 4 }), joint({ a: 3 }), joint({ a: 2 })] });
    const modified = chain({
      convention: 'modified',
      joints: [joint({ a: 0 }), joint({ a: 4 }), joint({ a: 3 })],
      tool: translation([2, 0, 0]),
    });
    expect(modified.reach).toBe(standard.reach);
    expect(modified.characteristicLength).toBe(standard.characteristicLength);
  });
});

describe('the characteristic length', () => {
  test('is half the reach of an arm whose slides are limited', () => {
    for (const name of ARMS) {
      const made = createChain(arm(name));
      expect(made.characteristicLength).toBeCloseTo(made.reach / 2, 12);
    }
  });
  test('grows with the arm', () => {
    for (const name of ARMS) {
      const one = createChain(arm(name)).characteristicLength;
      for (const scale of [1e-3, 0.5, 1e3]) {
        expect(createChain(arm(name, scale)).characteristicLength / (one * scale)).toBeCloseTo(1, 9);
      }
    }
  });
  test('is positive and finite for every chain, 1 m for one without any length', () => {
    fc.assert(
      fc.property(anyChain, ({ description }) => {
        const length = createChain(description).characteristicLength;
        expect(length > 0 && length < Infinity).toBe(true);
      }),
      { seed: SEED, numRuns: runs(200) },
    );
    const wrist = [joint({ a: 0, alpha: Math.PI / 2 }), joint({ a: 0, alpha: -Math.PI / 2 }), joint({ a: 0 })];
    expect(chain({ joints: wrist }).characteristicLength).toBe(1);
  });
});
