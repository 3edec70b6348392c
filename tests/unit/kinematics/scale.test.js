/** An arm in other units, or ten times as large, is the same arm. */
import { describe, expect, test } from 'vitest';
import { createChain } from '../../../src/kinematics/chain.js';
import { inverseKinematics } from '../../../src/kinematics/inverse.js';
import { runs } from '../../helpers/property.js';
import { columnMajor, fromLine, rigid, rodrigues, rotationOf, times } from './oracle.js';
import { ALL_ARMS, publishedArm, publishedInverse } from './publishedArms.js';

/** @import { Matrix } from './oracle.js' */

/** Millimetres and kilometres for metres, inches, and two that are no power of anything. */
const SCALES = [1e-3, 0.0254, 1 / 3, 7, 1e3];

/** Every n-th. @template T @param {T[]} list @param {number} count */
const sampleOf = (list, count) => list.filter((_, i) => i % Math.ceil(list.length / count) === 0);

/** @param {Matrix} goal @param {number} scale */
const moved = (goal, scale) => goal.map((row, i) => row.map((value, j) => (j === 3 && i < 3 ? value * scale : value)));

/**
 * The goal for the arm as it is, and with every length scaled: arm, goal, slides of the seed, position tolerance.
 * @param {string} name @param {Matrix} goal @param {number} scale @param {number[]} [seed]
 */
function expectSame(name, goal, scale, seed) {
  const { joints } = publishedArm(name);
  const units = joints.map(({ type }) => (type === 'prismatic' ? scale : 1));
  const scaledSeed = seed?.map((value, i) => value * units[i]);
  const one = inverseKinematics(createChain(publishedArm(name)), columnMajor(goal), { seed, positionTolerance: 1e-9 });
  const other = inverseKinematics(createChain(publishedArm(name, scale)), columnMajor(moved(goal, scale)), {
    seed: scaledSeed,
    positionTolerance: 1e-9 * scale,
  });
  expect(other.status).toBe(one.status);
  units.forEach((unit, i) => expect(Math.abs(other.q[i] / unit - one.q[i])).toBeLessThan(1e-6));
  expect(Math.abs(other.positionError / scale - one.positionError)).toBeLessThan(1e-6);
  expect(Math.abs(other.orientationError - one.orientationError)).toBeLessThan(1e-6);
  return one.status;
}

describe.each(ALL_ARMS)('scaled by 10⁻³ … 10³, %s', (name) => {
  const { reachable, postures, unreachable } = publishedInverse(name);
  test('meets the same poses at the same postures', () => {
    for (const scale of SCALES) {
      for (const line of sampleOf(reachable, runs(4)))
        expect(expectSame(name, fromLine(line), scale)).toBe('converged');
    }
  });
  test('and from a given seed', () => {
    for (const scale of SCALES) {
      for (const i of sampleOf([...reachable.keys()], runs(2))) {
        const seed = postures[(i + 1) % postures.length];
        expect(expectSame(name, fromLine(reachable[i]), scale, seed)).toBe('converged');
      }
    }
  });
  test('fails in the same way at the same goals', () => {
    // arms of fewer joints are asked for what they cannot do: another orientation at a place they can reach
    const tilt = rodrigues([1, 2, 3], 0.7);
    const impossible =
      unreachable?.map(([, ...line]) => fromLine(line)) ??
      reachable.map(fromLine).map((T) =>
        rigid(
          times(tilt, rotationOf(T)),
          [0, 1, 2].map((i) => T[i][3]),
        ),
      );
    for (const scale of [1e-3, 7, 1e3]) {
      for (const goal of sampleOf(impossible, runs(3))) expect(expectSame(name, goal, scale)).not.toBe('converged');
    }
  });
});
