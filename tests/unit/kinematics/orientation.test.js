import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { isPose } from '../../../src/kinematics/pose.js';
import { poseFromRollPitchYaw, rollPitchYawOf } from '../../../src/kinematics/orientation.js';
import { SEED, runs } from '../../helpers/property.js';
import { anyPose, columnMajor, largestDifference, rigid, rodrigues, rotationOf, rowsOf, times } from './oracle.js';

const QUARTER = Math.PI / 2;
const anyTurn = fc.double({ min: -Math.PI, max: Math.PI, noNaN: true });
const ORIGIN = [0, 0, 0];
/** @param {number[]} rpy */
const byRodrigues = ([roll, pitch, yaw]) =>
  times(rodrigues([0, 0, 1], yaw), times(rodrigues([0, 1, 0], pitch), rodrigues([1, 0, 0], roll)));

describe('roll, pitch, yaw', () => {
  test('are turns about fixed x, then y, then z', () => {
    fc.assert(
      fc.property(anyTurn, anyTurn, anyTurn, (...rpy) => {
        const found = rotationOf(rowsOf(poseFromRollPitchYaw(ORIGIN, rpy)));
        expect(largestDifference(found, byRodrigues(rpy))).toBeLessThan(3e-15); // 4 ulp of π count as π
      }),
      { seed: SEED, numRuns: runs(200) },
    );
  });
  test('are exact at all 64 combinations of right angles, without a minus zero', () => {
    const quarters = [0, QUARTER, Math.PI, -QUARTER];
    for (const roll of quarters) {
      for (const pitch of quarters) {
        for (const yaw of quarters) {
          const T = poseFromRollPitchYaw([0, 0, 0], [roll, pitch, yaw]);
          for (const value of T) expect([-1, 0, 1].some((exact) => Object.is(exact, value))).toBe(true);
          expect(isPose(T)).toBe(true);
        }
      }
    }
  });
  test('come back from any orientation, and give it again', () => {
    fc.assert(
      fc.property(anyPose, (T) => {
        const [roll, pitch, yaw] = rollPitchYawOf(T);
        expect(Math.abs(pitch)).toBeLessThanOrEqual(QUARTER);
        const again = poseFromRollPitchYaw(T.subarray(12, 15), [roll, pitch, yaw]);
        expect(largestDifference(rowsOf(again), rowsOf(T))).toBeLessThan(2e-15);
      }),
      { seed: SEED, numRuns: runs(300) },
    );
  });
  test('give the orientation again at every distance from gimbal lock', () => {
    for (const sign of [1, -1]) {
      for (const away of [0, 1e-17, 1e-15, 1e-13, 1e-11, 1e-9, 1e-8, 1e-7, 1e-5, 1e-3]) {
        for (const [roll, yaw] of [
          [0.5, -2],
          [0, 0],
          [3, 3],
          [-1, 0.2],
        ]) {
          const T = columnMajor(rigid(byRodrigues([roll, sign * (QUARTER - away), yaw]), ORIGIN));
          const again = poseFromRollPitchYaw(ORIGIN, rollPitchYawOf(T));
          expect(largestDifference(rowsOf(again), rowsOf(T))).toBeLessThan(3e-15);
        }
      }
    }
  });
  test('at gimbal lock have yaw 0 and all of the turn in roll', () => {
    // Craig, section 2.8: at pitch 90° only yaw − roll is defined
    const [roll, pitch, yaw] = rollPitchYawOf(poseFromRollPitchYaw(ORIGIN, [0.5, QUARTER, 1.2]));
    expect([pitch, yaw]).toEqual([QUARTER, 0]);
    expect(roll).toBeCloseTo(0.5 - 1.2, 14);
    const [other, down, none] = rollPitchYawOf(poseFromRollPitchYaw(ORIGIN, [0.5, -QUARTER, 1.2]));
    expect([down, none]).toEqual([-QUARTER, 0]);
    expect(other).toBeCloseTo(0.5 + 1.2, 14);
  });
  test('of a half turn about z are 0, 0, π: never −π', () => {
    for (const zero of [0, -0]) {
      const T = Float64Array.of(-1, zero, 0, 0, -zero, -1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1);
      expect(rollPitchYawOf(T)).toEqual([0, 0, Math.PI]);
    }
  });
  test('rpy2r(0.1, 0.2, 0.3) is the matrix in Corke, Robotics, Vision and Control, section 2.3.1', () => {
    const T = poseFromRollPitchYaw(ORIGIN, [0.1, 0.2, 0.3]);
    const printed = [
      [0.9363, -0.2751, 0.2184],
      [0.2896, 0.9564, -0.037],
      [-0.1987, 0.0978, 0.9752],
    ];
    expect(largestDifference(printed, rowsOf(T))).toBeLessThan(6e-5);
  });
  test.each([
    [[0, 0], [0, 0, 0], 'Expected a position to be 3 numbers, got 2.'],
    [[0, 0, NaN], [0, 0, 0], 'Expected a position to be finite, got NaN at index 2.'],
    [[0, 0, 0], [0, Infinity, 0], 'Expected roll, pitch, yaw to be finite, got Infinity at index 1.'],
  ])('%j with %j is refused', (xyz, rpy, words) => {
    expect(() => poseFromRollPitchYaw(xyz, rpy)).toThrow(words);
  });
});
