/** Orientations of base and tool in five notations: judged by products of plain turns, written here. */
import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { compilePose } from '../../../src/model/compile.js';
import { isNoPose } from '../../../src/model/noPose.js';
import { NOTATIONS, orientationOf, withOrientation } from '../../../src/model/numbers/orientationNotation.js';
import { SEED, runs } from '../../helpers/property.js';

/** @typedef {import('../../../src/model/document.js').PoseDoc} PoseDoc */

const UNITS = /** @type {const} */ ({ length: 'mm', angle: 'deg' });
const xyz = [1, 2, 3];

/** @param {number[][]} A @param {number[][]} B */
const times = (A, B) => A.map((row) => [0, 1, 2].map((k) => row.reduce((sum, value, i) => sum + value * B[i][k], 0)));
/** @param {'x' | 'y' | 'z'} axis @param {number} degrees */
function turn(axis, degrees) {
  const [c, s] = [Math.cos((degrees * Math.PI) / 180), Math.sin((degrees * Math.PI) / 180)];
  if (axis === 'x') return [[1, 0, 0], [0, c, -s], [0, s, c]]; // prettier-ignore
  if (axis === 'y') return [[c, 0, s], [0, 1, 0], [-s, 0, c]]; // prettier-ignore
  return [[c, -s, 0], [s, c, 0], [0, 0, 1]]; // prettier-ignore
}
/** What each notation means, by its definition. @param {string} notation @param {readonly number[]} numbers */
function rotation(notation, numbers) {
  const [a, b, c, w] = numbers;
  if (notation === 'rpy' || notation === 'wpr') return times(times(turn('z', c), turn('y', b)), turn('x', a));
  if (notation === 'abc') return times(times(turn('z', a), turn('y', b)), turn('x', c));
  if (notation === 'zyz') return times(times(turn('z', a), turn('y', b)), turn('z', c));
  return [
    [1 - 2 * (b * b + c * c), 2 * (a * b - c * w), 2 * (a * c + b * w)],
    [2 * (a * b + c * w), 1 - 2 * (a * a + c * c), 2 * (b * c - a * w)],
    [2 * (a * c - b * w), 2 * (b * c + a * w), 1 - 2 * (a * a + b * b)],
  ];
}
/** @param {PoseDoc} pose */
function rotationOf(pose) {
  const T = compilePose(pose, UNITS);
  return [0, 1, 2].map((row) => [0, 1, 2].map((column) => T[4 * column + row]));
}
/** @param {number[][]} A @param {number[][]} B */
const difference = (A, B) => Math.max(...A.flatMap((row, i) => row.map((value, k) => Math.abs(value - B[i][k]))));

const angle = fc.oneof(fc.integer({ min: -180, max: 180 }), fc.constantFrom(0, 90, -90, 180, 30.25), fc.double({ min: -400, max: 400, noNaN: true })); // prettier-ignore
const angles = fc.tuple(angle, angle, angle);
const quaternion = fc
  .array(fc.double({ min: -1, max: 1, noNaN: true }), { minLength: 4, maxLength: 4 })
  .filter((q) => Math.hypot(...q) > 0.1)
  .map((q) => q.map((value) => value / Math.hypot(...q)));
/** @type {fc.Arbitrary<PoseDoc>} */
const anyPose = fc.oneof(angles.map((rpy) => ({ xyz, rpy })), quaternion.map((q) => ({ xyz, quaternion: q }))); // prettier-ignore

test('whatever is typed in a notation turns the frame by its definition', () => {
  fc.assert(
    fc.property(anyPose, fc.constantFrom(...NOTATIONS), angles, quaternion, (pose, notation, typed, q) => {
      const numbers = notation === 'quaternion' ? q : typed;
      const now = withOrientation(pose, notation, numbers, UNITS);
      expect(now.xyz).toBe(pose.xyz);
      expect('quaternion' in now).toBe(notation === 'quaternion');
      expect(difference(rotationOf(now), rotation(notation, numbers))).toBeLessThan(1e-13);
    }),
    { seed: SEED, numRuns: runs(500) },
  );
});

test('what is shown in a notation is that orientation, and the very numbers where the document keeps them', () => {
  fc.assert(
    fc.property(anyPose, fc.constantFrom(...NOTATIONS), (pose, notation) => {
      const { numbers, isKept } = orientationOf(pose, notation, UNITS);
      expect(difference(rotation(notation, numbers), rotationOf(pose))).toBeLessThan(1e-13);
      const own = pose.quaternion ? ['quaternion'] : ['rpy', 'wpr', 'abc'];
      expect(isKept).toBe(own.includes(notation));
      if (!isKept) return;
      const again = withOrientation(pose, notation, numbers, UNITS);
      expect(again).toEqual(pose);
    }),
    { seed: SEED, numRuns: runs(500) },
  );
});

describe('by hand:', () => {
  test('FANUC W P R are roll, pitch, yaw; KUKA A B C the same backwards', () => {
    const pose = { xyz, rpy: [10, 20, 30] };
    expect(orientationOf(pose, 'wpr', UNITS)).toEqual({ numbers: [10, 20, 30], isKept: true });
    expect(orientationOf(pose, 'abc', UNITS)).toEqual({ numbers: [30, 20, 10], isKept: true });
    expect(withOrientation(pose, 'abc', [1, 2, 3], UNITS)).toEqual({ xyz, rpy: [3, 2, 1] });
  });
  test('right angles are round numbers in every notation', () => {
    const quarter = { xyz, quaternion: [Math.SQRT1_2, 0, 0, Math.SQRT1_2] };
    expect(orientationOf(quarter, 'rpy', UNITS)).toEqual({ numbers: [90, 0, 0], isKept: false });
    expect(orientationOf({ xyz, rpy: [90, 0, 0] }, 'zyz', UNITS).numbers).toEqual([-90, 90, 90]);
    expect(withOrientation(quarter, 'zyz', [-90, 90, 90], UNITS)).toEqual({ xyz, rpy: [90, 0, 0] });
  });
  test('no shift and no turn are none, however written', () => {
    expect(isNoPose({ xyz: [0, 0, 0] })).toBe(true);
    expect(isNoPose({ xyz: [0, 0, 0], quaternion: [0, 0, 0, -1] })).toBe(true);
    expect(isNoPose({ xyz: [0, 0, 0], rpy: [0, 360, 0] })).toBe(false);
    expect(isNoPose({ xyz: [0, 1e-9, 0], rpy: [0, 0, 0] })).toBe(false);
  });
});
