/** The target in every form: what is shown is what is kept, what is typed is what is meant. */
import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { poseFromXyzwpr } from '../../../src/model/aim/aim.js';
import { ORIENTATION_FORMS, orientationForm } from '../../../src/model/numbers/orientationForms.js';
import { firstRobot } from '../../../src/model/shelf.js';
import { targetFrom, targetNumbers } from '../../../src/model/aim/targetForm.js';
import { targetGivenIn, targetSeenFrom } from '../../../src/model/aim/targetFrame.js';
import { targetFromMatrix, targetRows } from '../../../src/model/aim/targetMatrix.js';
import { SEED, runs } from '../../helpers/property.js';

/** @template T @param {import('fast-check').Arbitrary<T>} any @param {(value: T) => void} holds */
const property = (any, holds) => fc.assert(fc.property(any, holds), { seed: SEED, numRuns: runs(60) });

const robot = firstRobot;
const angle = fc.oneof(fc.double({ min: -180, max: 180, noNaN: true }), fc.constantFrom(0, 90, -90, 180, 45));
const anyTarget = fc.tuple(...Array.from({ length: 3 }, () => fc.double({ min: -2e3, max: 2e3, noNaN: true })), angle, angle, angle); // prettier-ignore

/** @param {ArrayLike<number>} a @param {ArrayLike<number>} b */
const apart = (a, b) => Math.max(...Array.from(a, (value, i) => Math.abs(value - b[i])));

test.each(ORIENTATION_FORMS.map((form) => [form.name, form]))('%s: there and back is the same pose', (_, form) =>
  property(anyTarget, (target) => {
    const { target: again } = targetFrom(form, robot, targetNumbers(form, robot, target));
    expect(again && apart(poseFromXyzwpr(robot, again), poseFromXyzwpr(robot, target))).toBeLessThan(3e-8);
  }),
);

test('FANUC and KUKA write the kept numbers themselves, to the last digit', () =>
  property(anyTarget, (target) => {
    expect(targetNumbers(orientationForm('wpr'), robot, target)).toEqual(target);
    const [x, y, z, w, p, r] = target;
    expect(targetNumbers(orientationForm('abc'), robot, target)).toEqual([x, y, z, r, p, w]);
    expect(targetFrom(orientationForm('abc'), robot, [x, y, z, r, p, w]).target).toEqual(target);
  }));

describe('a matrix', () => {
  const flat = (/** @type {readonly number[]} */ target) => targetRows(robot, target).flat();

  test('there and back is the same pose, with its last row or without', () =>
    property(anyTarget, (target) => {
      for (const count of [12, 16]) {
        const { target: again } = targetFromMatrix(robot, flat(target).slice(0, count));
        expect(again && apart(poseFromXyzwpr(robot, again), poseFromXyzwpr(robot, target))).toBeLessThan(1e-7);
        expect(again?.slice(0, 3)).toEqual([3, 7, 11].map((k) => flat(target)[k]));
      }
    }));

  test('that is nearly one is refused, and the nearest rotation is square', () =>
    property(
      fc.tuple(anyTarget, fc.array(fc.double({ min: -0.02, max: 0.02, noNaN: true }), { minLength: 9, maxLength: 9 })),
      ([target, noise]) => {
        // prettier-ignore
        const rows = flat(target).map((value, k) => (k < 12 && k % 4 < 3 ? value + noise[3 * (k >> 2) + (k % 4)] : value)); // prettier-ignore
        const { fault } = targetFromMatrix(robot, rows);
        if (!fault) return; // noise of next to nothing
        expect(fault.kind).toBe('skew');
        const mended = fault.mended ?? [];
        const columns = [0, 1, 2].map((j) => [0, 1, 2].map((i) => mended[4 * i + j]));
        columns.forEach((a, i) => columns.forEach((b, j) =>
        expect(a.reduce((sum, value, k) => sum + value * b[k], 0)).toBeCloseTo(i === j ? 1 : 0, 12))); // prettier-ignore
        // nearest: R'M is symmetric exactly for the polar factor
        const given = [0, 1, 2].map((j) => [0, 1, 2].map((i) => rows[4 * i + j]));
        const S = columns.map((a) => given.map((b) => a.reduce((sum, value, k) => sum + value * b[k], 0)));
        expect(Math.max(Math.abs(S[0][1] - S[1][0]), Math.abs(S[0][2] - S[2][0]), Math.abs(S[1][2] - S[2][1]))).toBeLessThan(1e-9); // prettier-ignore
        expect(targetFromMatrix(robot, mended).fault).toBeNull();
      },
    ));

  test('that is none says what is against it', () => {
    const mirrored = [1, 0, 0, 1, 0, 1, 0, 2, 0, 0, -1, 3, 0, 0, 0, 1];
    expect(targetFromMatrix(robot, mirrored).fault).toMatchObject({ kind: 'left-handed', mended: null });
    const across = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 100, 200, 300, 1];
    expect(targetFromMatrix(robot, across).fault?.kind).toBe('bottom-row');
    const twice = [2, 0, 0, 1, 0, 2, 0, 2, 0, 0, 2, 3, 0, 0, 0, 1];
    expect(targetFromMatrix(robot, twice).fault).toMatchObject({ kind: 'skew', by: 3, mended: null });
  });
});

describe('a target in a user frame', () => {
  // at 400, −200, 50, turned by a right angle about Z
  const T_world_user = Float64Array.of(0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0, 0.4, -0.2, 0.05, 1);

  test('has the numbers that a controller shows there', () =>
    property(anyTarget, ([x, y, z, w, p, r]) => {
      fc.pre(Math.abs(p) < 89); // where W and R are angles of their own
      const seen = targetSeenFrom(robot, T_world_user, [x, y, z, w, p, r]);
      [y + 200, 400 - x, z - 50, w, p].forEach((value, k) => {
        const apart = Math.abs(seen[k] - value);
        expect(k < 3 ? apart : Math.min(apart, Math.abs(apart - 360))).toBeLessThan(1e-6);
      });
      expect(Math.abs(Math.sin((((seen[5] - r + 90) / 2) * Math.PI) / 180))).toBeLessThan(1e-7);
    }));

  test('there and back is the same pose, and in the world the same numbers', () =>
    property(anyTarget, (target) => {
      const again = targetGivenIn(robot, T_world_user, targetSeenFrom(robot, T_world_user, target));
      expect(apart(poseFromXyzwpr(robot, again), poseFromXyzwpr(robot, target))).toBeLessThan(1e-9);
      expect(targetSeenFrom(robot, null, target)).toBe(target);
      expect(targetGivenIn(robot, null, target)).toBe(target);
    }));

  test('rounding leaves no digits where there is nothing', () => {
    expect(targetSeenFrom(robot, T_world_user, [400, -200, 50, 0, 0, 90])).toEqual([0, 0, 0, 0, 0, 0]);
    expect(targetSeenFrom(robot, T_world_user, [500, -200, 50, 180, 0, 90]).slice(0, 3)).toEqual([0, -100, 0]);
  });
});
