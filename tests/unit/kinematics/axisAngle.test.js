import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import {
  axisAngleOf,
  poseFromAxisAngle,
  poseFromRotationVector,
  rotationVectorOf,
} from '../../../src/kinematics/orientations/axisAngle.js';
import { createRandom } from '../../../src/kinematics/random.js';
import { SEED, runs } from '../../helpers/property.js';
import { anyPose, columnMajor, largestDifference, rigid, rodrigues, rotationOf, rowsOf } from './oracle.js';

const ORIGIN = [0, 0, 0];
const { PI } = Math;
const random = createRandom(SEED);
const anyAxis = () => [random() - 0.5, random() - 0.5, random() - 0.5];
const unit = (/** @type {number[]} */ axis) => axis.map((value) => value / Math.hypot(...axis));
/** @param {ArrayLike<number>} T @param {number[][]} R */
const offBy = (T, R) => largestDifference(rotationOf(rowsOf(T)), R);
/** @param {ArrayLike<number>} found @param {number[]} expected @param {number} tolerance */
const expectNear = (found, expected, tolerance) =>
  expected.forEach((value, i) => expect(Math.abs(found[i] - value)).toBeLessThanOrEqual(tolerance));

/** From 1e-20 to a full turn, some next to none, a half and a full turn. @param {number} n */
const anAngle = (n) => {
  const small = 10 ** (-20 * random());
  return [small, PI - small, PI + small, 2 * PI - small, 2 * PI * random()][n % 5];
};

describe('a pose from an axis and an angle', () => {
  test('is the one of Rodrigues, whatever the length of the axis', () => {
    for (let n = 0; n < 900; n++) {
      const [axis, angle] = [anyAxis(), (n % 2 ? -1 : 1) * anAngle(n)];
      const R = rodrigues(axis, angle);
      const scaled = axis.map((value) => value * [1, 1e-200, 1e200][n % 3]);
      expect(offBy(poseFromAxisAngle(ORIGIN, scaled, angle), R)).toBeLessThan(4e-15); // 4 ulp of 2π count as 2π
      const vector = unit(axis).map((value) => value * angle);
      expect(offBy(poseFromRotationVector(ORIGIN, vector), R)).toBeLessThan(6e-15);
    }
  });
  test('is exact at multiples of a right angle, about diagonals too if it is a half turn', () => {
    for (const [axis, quarters, x, y, z] of /** @type {[number[], number, number[], number[], number[]][]} */ ([
      [[0, 0, 2], 1, [0, 1, 0], [-1, 0, 0], [0, 0, 1]],
      [[0, 0, -2], 1, [0, -1, 0], [1, 0, 0], [0, 0, 1]],
      [[0.1, 0, 0], -1, [1, 0, 0], [0, 0, -1], [0, 1, 0]],
      [[0, 7, 0], 5, [0, 0, -1], [0, 1, 0], [1, 0, 0]],
      [[0, 1, 0], 2, [-1, 0, 0], [0, 1, 0], [0, 0, -1]],
      [[1, 1, 0], 2, [0, 1, 0], [1, 0, 0], [0, 0, -1]],
      [[0, 3, -3], -2, [-1, 0, 0], [0, 0, -1], [0, -1, 0]],
      [[1, 2, 3], 4, [1, 0, 0], [0, 1, 0], [0, 0, 1]],
      [[1, 2, 3], 0, [1, 0, 0], [0, 1, 0], [0, 0, 1]],
    ])) {
      const exact = Float64Array.of(...x, 0, ...y, 0, ...z, 0, 1, 2, 3, 1);
      expect(poseFromAxisAngle([1, 2, 3], axis, (quarters * PI) / 2)).toEqual(exact);
      const vector = unit(axis).map((value) => (value * quarters * PI) / 2);
      expect(poseFromRotationVector([1, 2, 3], vector)).toEqual(exact);
    }
  });
  test('keeps all the digits of a tiny turn', () => {
    for (const angle of [1e-5, 1e-9, 1e-100, 1e-300]) {
      for (const T of [poseFromAxisAngle(ORIGIN, [0, 0, 5], angle), poseFromRotationVector(ORIGIN, [0, 0, angle])]) {
        expect([T[1], T[4]]).toEqual([Math.sin(angle), -Math.sin(angle)]);
        expect(rotationVectorOf(T)[2] / angle).toBeCloseTo(1, 15);
      }
    }
  });
  test('Craig, example 2.8: 30° about [0.707 0.707 0]', () => {
    const printed = [
      [0.933, 0.067, 0.354],
      [0.067, 0.933, -0.354],
      [-0.354, 0.354, 0.866],
    ];
    const T = poseFromAxisAngle(ORIGIN, [0.707, 0.707, 0], PI / 6);
    expect(offBy(T, printed)).toBeLessThan(6e-4);
    const { axis, angle } = axisAngleOf(T);
    expectNear(axis, [Math.SQRT1_2, Math.SQRT1_2, 0], 3e-16);
    expect(angle).toBeCloseTo(PI / 6, 15);
  });
});

describe('the axis and angle of a pose', () => {
  test('are a unit vector and at most a half turn, and give the pose again', () => {
    fc.assert(
      fc.property(anyPose, (T) => {
        const { axis, angle } = axisAngleOf(T);
        expect(Math.abs(Math.hypot(...axis) - 1)).toBeLessThanOrEqual(4.5e-16);
        expect(angle).toBeGreaterThanOrEqual(0);
        expect(angle).toBeLessThanOrEqual(PI);
        const position = T.subarray(12, 15);
        expect(largestDifference(rowsOf(poseFromAxisAngle(position, axis, angle)), rowsOf(T))).toBeLessThan(3e-15);
        const vector = rotationVectorOf(T);
        expect(largestDifference(rowsOf(poseFromRotationVector(position, vector)), rowsOf(T))).toBeLessThan(3e-15);
        expectNear(
          vector,
          Array.from(axis, (value) => value * angle),
          0,
        );
      }),
      { seed: SEED, numRuns: runs(300) },
    );
  });
  test('are the ones that made it, or the shorter way round', () => {
    for (let n = 0; n < 900; n++) {
      const [axis, angle] = [unit(anyAxis()), anAngle(n)];
      const found = axisAngleOf(columnMajor(rigid(rodrigues(axis, angle), ORIGIN)));
      const shorter = angle > PI ? 2 * PI - angle : angle;
      expect(Math.abs(found.angle - shorter)).toBeLessThan(2e-15);
      if (PI - shorter < 1e-14) continue; // either axis will do; the next test has the rule
      const sign = angle > PI ? -1 : 1;
      expectNear(
        rotationVectorOf(columnMajor(rigid(rodrigues(axis, angle), ORIGIN))),
        axis.map((value) => sign * value * shorter),
        4e-15,
      );
      // an axis has as many digits as a turn by the angle leaves it
      expectNear(
        found.axis,
        axis.map((value) => sign * value),
        2e-15 / Math.min(1, shorter),
      );
    }
  });
  test('of a half turn: the angle is π, and the first component of the axis that is not zero is positive', () => {
    const axes = [];
    for (const x of [-1, 0, 1]) for (const y of [-1, 0, 1]) for (const z of [-1, 0, 1]) axes.push([x, y, z]);
    for (let n = 0; n < 100; n++) axes.push(anyAxis());
    for (const axis of axes.filter((values) => values.some((value) => value !== 0))) {
      const leading = axis.find((value) => value !== 0) ?? 1;
      const expected = unit(axis).map((value) => value * Math.sign(leading));
      for (const T of [
        poseFromAxisAngle(ORIGIN, axis, PI),
        columnMajor(rigid(rodrigues(axis, PI), ORIGIN)), // with what rounding makes of sin π
      ]) {
        const found = axisAngleOf(T);
        expect(Math.abs(found.angle - PI)).toBeLessThanOrEqual(5e-16);
        if (found.angle === PI) expectNear(found.axis, expected, 1e-15);
        expect(offBy(poseFromAxisAngle(ORIGIN, found.axis, found.angle), rotationOf(rowsOf(T)))).toBeLessThan(2e-15);
      }
      expect(axisAngleOf(poseFromAxisAngle(ORIGIN, axis, PI)).angle).toBe(PI);
    }
  });
  test('of a half turn about y do not hang on the sign of what rounding left', () => {
    for (const dirt of [1e-17, -1e-17]) {
      const { axis, angle } = axisAngleOf([-1, dirt, 0, 0, dirt, 1, 0, 0, 0, 0, -1, 0, 0, 0, 0, 1]);
      expect([axis[1], angle]).toEqual([1, PI]);
    }
  });
  test('of no turn are z and 0, and the rotation vector is zero', () => {
    const none = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 9, 9, 9, 1];
    expect(axisAngleOf(none)).toEqual({ axis: Float64Array.of(0, 0, 1), angle: 0 });
    expect(rotationVectorOf(none)).toEqual(new Float64Array(3));
    expect(poseFromRotationVector([9, 9, 9], [0, -0, 0])).toEqual(Float64Array.from(none));
  });
  test('are written into out', () => {
    const T = poseFromAxisAngle(ORIGIN, [1, 2, 3], 1);
    const out = { axis: new Float64Array(3), angle: NaN };
    expect(axisAngleOf(T, out)).toBe(out);
    expect(out).toEqual(axisAngleOf(T));
    const vector = new Float64Array(3);
    expect(rotationVectorOf(T, vector)).toBe(vector);
    expect(vector).toEqual(rotationVectorOf(T));
    const pose = new Float64Array(16).fill(3);
    expect(poseFromRotationVector(ORIGIN, vector, pose)).toBe(pose);
    expectNear(pose, Array.from(T), 5e-16);
  });
});

describe('wrong calls are refused', () => {
  test.each([
    [
      'an axis of zero',
      () => poseFromAxisAngle(ORIGIN, [0, -0, 0], 1),
      'Expected an axis that is not zero, got 0 0 0.',
    ],
    [
      'an axis with NaN',
      () => poseFromAxisAngle(ORIGIN, [0, NaN, 0], 1),
      'Expected an axis to be finite, got NaN at index 1.',
    ],
    [
      'an endless angle',
      () => poseFromAxisAngle(ORIGIN, [0, 0, 1], Infinity),
      'Expected an angle to be finite, got Infinity.',
    ],
    ['no position', () => poseFromAxisAngle([], [0, 0, 1], 1), 'Expected a position to be 3 numbers, got 0.'],
    ['two numbers', () => poseFromRotationVector(ORIGIN, [1, 2]), 'Expected a rotation vector to be 3 numbers, got 2.'],
    [
      'a turn beyond all numbers',
      () => poseFromRotationVector(ORIGIN, [1.5e308, 1.5e308, 0]),
      'to be finite, got Infinity.',
    ],
    ['no pose', () => axisAngleOf([1, 0, 0]), 'got 3 numbers'],
    ['a pose with NaN', () => rotationVectorOf(new Float64Array(16).fill(NaN)), 'got NaN at index 0'],
    [
      'no room',
      () => rotationVectorOf(poseFromAxisAngle(ORIGIN, [0, 0, 1], 1), new Float64Array(2)),
      'room for 3 numbers',
    ],
  ])('%s', (_, call, words) => {
    expect(call).toThrow(words);
  });
});
