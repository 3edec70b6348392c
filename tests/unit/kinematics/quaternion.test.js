import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { EULER_SEQUENCES, poseFromEulerAngles } from '../../../src/kinematics/orientations/eulerAngles.js';
import { poseFromQuaternion, quaternionOf } from '../../../src/kinematics/orientations/quaternion.js';
import { createRandom } from '../../../src/kinematics/random.js';
import { SEED, runs } from '../../helpers/property.js';
import { anyPose, columnMajor, largestDifference, rigid, rodrigues, rotationOf, rowsOf } from './oracle.js';

const QUARTER = Math.PI / 2;
const ORIGIN = [0, 0, 0];
const anyTurn = fc.double({ min: -Math.PI, max: Math.PI, noNaN: true });
const random = createRandom(SEED);

/** @param {number[]} axis @param {number} angle */
const turned = (axis, angle) => columnMajor(rigid(rodrigues(axis, angle), ORIGIN));

describe('a pose from a quaternion', () => {
  test('half-angle sine along the axis, and half-angle cosine', () => {
    fc.assert(
      fc.property(anyTurn, anyTurn, anyTurn, anyTurn, (x, y, z, angle) => {
        fc.pre(Math.hypot(x, y, z) > 0.1);
        const length = Math.hypot(x, y, z) / Math.sin(angle / 2);
        fc.pre(Number.isFinite(length));
        const xyzw = [x / length, y / length, z / length, Math.cos(angle / 2)];
        const found = rotationOf(rowsOf(poseFromQuaternion(ORIGIN, xyzw)));
        expect(largestDifference(found, rodrigues([x, y, z], angle))).toBeLessThan(2e-15);
      }),
      { seed: SEED, numRuns: runs(200) },
    );
  });
  test('of any length, tiny or huge: it is divided out', () => {
    for (const scale of [1, -1, 1e-200, 1e200, 5e-324, Number.MAX_VALUE]) {
      expect(poseFromQuaternion([1, 2, 3], [0, 0, scale, scale])).toEqual(
        poseFromEulerAngles([1, 2, 3], [QUARTER, 0, 0], 'ZYX'),
      );
    }
  });
  test('Craig, section 2.8: Euler parameters of 30° about [0.707 0.707 0]', () => {
    const xyzw = [0.1830127018922193, 0.1830127018922193, 0, 0.9659258262890683];
    const T = poseFromQuaternion(ORIGIN, xyzw);
    expect(largestDifference(rotationOf(rowsOf(T)), rodrigues([1, 1, 0], Math.PI / 6))).toBeLessThan(1e-15);
    xyzw.forEach((value, i) => expect(quaternionOf(T)[i]).toBeCloseTo(value, 15));
  });
  test('MathWorks, eul2quat([0 pi/2 0]) and eul2quat([pi/2 0 0], "ZYZ"), w first there', () => {
    const half = Math.sqrt(0.5);
    const pitched = quaternionOf(poseFromEulerAngles(ORIGIN, [0, QUARTER, 0], 'ZYX'));
    [0, half, 0, half].forEach((value, i) => expect(pitched[i]).toBeCloseTo(value, 15));
    const yawed = quaternionOf(poseFromEulerAngles(ORIGIN, [QUARTER, 0, 0], 'ZYZ'));
    [0, 0, half, half].forEach((value, i) => expect(yawed[i]).toBeCloseTo(value, 15));
  });
  test('what is no quaternion is refused', () => {
    expect(() => poseFromQuaternion(ORIGIN, [0, 0, 0, 0])).toThrow('Expected a quaternion that is not zero');
    expect(() => poseFromQuaternion(ORIGIN, [0, 0, 1])).toThrow('Expected a quaternion to be 4 numbers, got 3.');
    expect(() => poseFromQuaternion(ORIGIN, [0, 0, NaN, 1])).toThrow('got NaN at index 2');
    expect(() => poseFromQuaternion([0, Infinity, 0], [0, 0, 0, 1])).toThrow('got Infinity at index 1');
    const missing = /** @type {number[]} */ (/** @type {unknown} */ (undefined));
    expect(() => poseFromQuaternion(ORIGIN, missing)).toThrow('Expected a quaternion to be 4 numbers, got undefined.');
  });
});

describe('the quaternion of a pose', () => {
  test('has unit length to the last digit and a scalar part that is not negative, and gives the pose again', () => {
    fc.assert(
      fc.property(anyPose, (T) => {
        const q = quaternionOf(T);
        expect(Math.abs(Math.hypot(...q) - 1)).toBeLessThanOrEqual(4.5e-16);
        expect(q[3]).toBeGreaterThanOrEqual(0);
        const again = poseFromQuaternion(T.subarray(12, 15), q);
        expect(largestDifference(rowsOf(again), rowsOf(T))).toBeLessThan(2e-15);
      }),
      { seed: SEED, numRuns: runs(400) },
    );
  });
  test('is half-angle sine along the axis, at every angle, near none and near a half turn too', () => {
    for (let n = 0; n < 900; n++) {
      const axis = [random() - 0.5, random() - 0.5, random() - 0.5];
      const length = Math.hypot(...axis);
      const small = 10 ** (-20 * random());
      const angle = [small, Math.PI - small, Math.PI * random()][n % 3];
      const q = quaternionOf(turned(axis, angle));
      // the axis of a half turn but for rounding has either sign
      const sign = q[0] * axis[0] < 0 ? -1 : 1;
      if (Math.PI - angle > 1e-14) expect(sign).toBe(1);
      axis.forEach((value, i) => {
        const expected = (value / length) * Math.sin(angle / 2);
        expect(Math.abs(sign * q[i] - expected)).toBeLessThan(1e-15);
      });
      expect(Math.abs(sign * q[3] - Math.cos(angle / 2))).toBeLessThan(1e-15);
    }
  });
  test('of a tiny turn has all its digits', () => {
    for (const angle of [1e-5, 1e-10, 1e-100, 1e-300]) {
      const [x, y, z, w] = quaternionOf(turned([0, -1, 0], angle));
      expect([x, z, w]).toEqual([0, 0, Math.cos(angle / 2)]);
      expect(Math.abs(y / (-angle / 2) - 1)).toBeLessThan(1e-10);
    }
  });
  test('is exact, and gives the pose exactly, for the 24 turns of a cube', () => {
    const seen = new Set();
    for (const first of [0, 1, 2, 3]) {
      for (const middle of [0, 1, 2, 3]) {
        for (const last of [0, 1, 2, 3]) {
          const angles = [first, middle, last].map((count) => count * QUARTER);
          const T = poseFromEulerAngles(ORIGIN, angles, EULER_SEQUENCES[0]);
          const q = quaternionOf(T);
          for (const value of q) {
            expect([0, 0.5, Math.SQRT1_2, 1].some((exact) => Math.abs(Math.abs(value) - exact) <= 1.2e-16)).toBe(true);
            expect(Object.is(value, -0)).toBe(false);
          }
          expect(poseFromQuaternion(ORIGIN, q)).toEqual(T);
          seen.add(q.join());
        }
      }
    }
    expect(seen.size).toBe(24);
  });
  test('of a half turn has a first component, of those that are not zero, that is positive', () => {
    for (const [axis, expected] of [
      [
        [1, 0, 0],
        [1, 0, 0, 0],
      ],
      [
        [0, 1, 0],
        [0, 1, 0, 0],
      ],
      [
        [0, 0, 1],
        [0, 0, 1, 0],
      ],
      [
        [0, 3, -4],
        [0, 0.6, -0.8, 0],
      ],
      [
        [-2, 3, 6],
        [2 / 7, -3 / 7, -6 / 7, 0],
      ],
    ]) {
      for (const sign of [1, -1]) {
        const [x, y, z] = axis.map((value) => (sign * value) / Math.hypot(...axis));
        // 2 a aᵀ − 1, symmetric to the last bit
        const R = [
          [2 * x * x - 1, 2 * x * y, 2 * x * z],
          [2 * y * x, 2 * y * y - 1, 2 * y * z],
          [2 * z * x, 2 * z * y, 2 * z * z - 1],
        ];
        const q = quaternionOf(columnMajor(rigid(R, ORIGIN)));
        expected.forEach((value, i) => expect(q[i]).toBeCloseTo(value, 15));
        expect(Object.is(q[3], 0)).toBe(true);
      }
    }
  });
  test('is written into out; what is no pose is refused', () => {
    const out = new Float64Array(4);
    expect(quaternionOf(turned([1, 2, 3], 1), out)).toBe(out);
    expect(out).toEqual(quaternionOf(turned([1, 2, 3], 1)));
    expect(() => quaternionOf(turned([1, 2, 3], 1).with(9, NaN))).toThrow('got NaN at index 9');
    expect(() => quaternionOf([1, 0, 0, 0])).toThrow('got 4 numbers');
    expect(() => quaternionOf(turned([1, 2, 3], 1), new Float64Array(3))).toThrow(
      'Expected room for 4 numbers, got 3.',
    );
  });
});
