/** The kernel against the published arms, all 22 of them: what others computed for the same tables. */
import { describe, expect, test } from 'vitest';
import { createChain } from '../../../src/kinematics/chain.js';
import { linkFrames, tcpPose } from '../../../src/kinematics/forward.js';
import { inverseKinematics } from '../../../src/kinematics/inverse.js';
import { finiteDifferenceJacobian, geometricJacobian } from '../../../src/kinematics/jacobian.js';
import { createRandom } from '../../../src/kinematics/random.js';
import { SEED, runs } from '../../helpers/property.js';
import { expectHonest } from './honest.js';
import {
  angleBetween,
  columnMajor,
  distanceBetween,
  fromLine,
  largestDifference,
  oracleForward,
  rigid,
  rotationOf,
  rowsOf,
  times,
} from './oracle.js';
import {
  ALL_ARMS,
  fixture,
  publishedArm,
  publishedForward,
  publishedInverse,
  publishedReach,
  withSixJoints,
} from './publishedArms.js';

/** @import { InverseOptions } from '../../../src/kinematics/descent/inverseOptions.js' */
/** @import { Matrix } from './oracle.js' */

/** Of the 200 poses of an arm, this many in the quick run; the deep one takes them all. */
const SAMPLE = runs(15);
const SAMPLE_NEAR = runs(5);

/**
 * Every n-th, so that a sample is of the whole list.
 * @template T @param {T[]} list @param {number} count @returns {T[]}
 */
const sampleOf = (list, count) => list.filter((_, i) => i % Math.ceil(list.length / count) === 0);

/**
 * A Jacobian without units: metres a radian over the reach; what a slide does, and turns a radian, have none as they are.
 * @param {ArrayLike<number>} rows  6 × n row by row
 * @param {string} name
 */
function withoutUnits(rows, name) {
  const { joints } = publishedArm(name);
  const n = joints.length;
  return Array.from(rows, (value, i) =>
    i < 3 * n && joints[i % n].type === 'revolute' ? value / publishedReach(name) : value,
  );
}

/** Column by column, as the kernel keeps it → row by row, as the fixtures do. @param {ArrayLike<number>} J */
const rowByRow = (J) => Array.from(J, (_, i) => J[6 * (i % (J.length / 6)) + Math.floor((6 * i) / J.length)]);

/** @param {ArrayLike<number>} A @param {number[]} B */
const apart = (A, B) => Math.max(...Array.from(A, (value, i) => Math.abs(value - B[i])));

/**
 * Solve, and judge the answer by the oracle alone as well as by what it says of itself.
 * @param {string} name @param {Matrix} goal @param {InverseOptions} [options]
 */
function expectConverged(name, goal, options) {
  const description = publishedArm(name);
  const result = inverseKinematics(createChain(description), columnMajor(goal), options);
  expect(result.status).toBe('converged');
  const { tcp } = oracleForward(description, result.q);
  expect(distanceBetween(tcp, goal)).toBeLessThan(1e-9 * (1 + 1e-6));
  expect(angleBetween(tcp, goal)).toBeLessThan(1e-9 * (1 + 1e-6));
  description.joints.forEach(({ lower, upper }, i) => expect(result.q[i] >= lower && result.q[i] <= upper).toBe(true));
  return expectHonest(description, goal, result, options);
}

test('there are 22 arms of 2 to 6 joints, 14 of them with six', () => {
  expect(ALL_ARMS.length).toBe(22);
  expect(ALL_ARMS.filter(withSixJoints).length).toBe(14);
  expect(new Set(ALL_ARMS.map((name) => publishedArm(name).joints.length))).toEqual(new Set([2, 3, 4, 5, 6]));
});

describe.each(ALL_ARMS)('%s', (name) => {
  const chain = createChain(publishedArm(name));
  const forward = publishedForward(name);
  const reach = publishedReach(name);

  /** Positions over the reach, so that all twelve numbers are without unit. @param {Matrix} A @param {Matrix} B */
  const poseApart = (A, B) => {
    const scaled = [A, B].map((T) => T.map((row) => row.map((value, j) => (j === 3 ? value / reach : value))));
    return largestDifference(scaled[0], scaled[1]);
  };

  test('tool poses are the published ones within 1e-12, lengths over the reach', () => {
    expect(forward.q.length).toBe(50);
    forward.q.forEach((q, i) =>
      expect(poseApart(rowsOf(tcpPose(chain, q)), fromLine(forward.tcp[i]))).toBeLessThan(1e-12),
    );
    const { postures, reachable } = publishedInverse(name);
    postures.forEach((q, i) =>
      expect(poseApart(rowsOf(tcpPose(chain, q)), fromLine(reachable[i]))).toBeLessThan(1e-12),
    );
  });
  test('all frames are the published ones within 1e-12, lengths over the reach', () => {
    expect(forward.frames.length).toBe(5);
    for (const [index, ...values] of forward.frames) {
      const frames = linkFrames(chain, forward.q[index]);
      expect(values.length).toBe(12 * chain.dof);
      for (let i = 1; i <= chain.dof; i++) {
        const found = rowsOf(frames.subarray(16 * i, 16 * i + 16));
        expect(poseApart(found, fromLine(values.slice(12 * (i - 1), 12 * i)))).toBeLessThan(1e-12);
      }
    }
  });
  test('the geometric Jacobian is the published one within 1e-12, forward differences within 1e-6, central 1e-9', () => {
    expect(forward.jacobians.length).toBe(50);
    for (const [index, ...rows] of forward.jacobians) {
      const q = forward.q[index];
      const published = withoutUnits(rows, name);
      const isWithin = (/** @type {Float64Array} */ J, /** @type {number} */ tolerance) =>
        expect(apart(withoutUnits(rowByRow(J), name), published)).toBeLessThan(tolerance);
      isWithin(geometricJacobian(chain, q), 1e-12);
      isWithin(finiteDifferenceJacobian(chain, q), 1e-6);
      isWithin(finiteDifferenceJacobian(chain, q, { method: 'central' }), 1e-9);
    }
  });
  test('every pose that a posture inside the limits has is met from the default seed', () => {
    const { reachable } = publishedInverse(name);
    expect(reachable.length).toBe(200);
    for (const line of sampleOf(reachable, SAMPLE)) expectConverged(name, fromLine(line));
  });
  test('and from within 0.05 rad of that posture, slides within what 0.05 rad moves at full reach', () => {
    const { reachable, postures } = publishedInverse(name);
    const random = createRandom(SEED);
    const indices = sampleOf([...reachable.keys()], SAMPLE);
    for (const i of indices) {
      const seed = postures[i].map((value, k) => {
        const most = publishedArm(name).joints[k].type === 'prismatic' ? 0.05 * reach : 0.05;
        return value + most * (2 * random() - 1);
      });
      expectConverged(name, fromLine(reachable[i]), { seed });
    }
  });
});

describe.each(ALL_ARMS.filter(withSixJoints))('%s', (name) => {
  const { nearSingular = [], nearSingularPostures = [] } = publishedInverse(name);
  test('poses of postures 1e-2 to 1e-8 from a singular one are met from the default seed', () => {
    expect(nearSingular.length).toBe(50);
    for (const line of sampleOf(nearSingular, SAMPLE_NEAR)) expectConverged(name, fromLine(line));
  });
  test('and from within 0.05 rad of them', () => {
    const random = createRandom(SEED);
    for (const i of sampleOf([...nearSingular.keys()], SAMPLE_NEAR)) {
      const seed = nearSingularPostures[i].map((value) => value + 0.05 * (2 * random() - 1));
      expectConverged(name, fromLine(nearSingular[i]), { seed });
    }
  });
});

/** 2uuᵀ − 1. @param {number[]} axis */
function exactHalfTurn(axis) {
  const square = axis.reduce((sum, value) => sum + value * value, 0);
  return axis.map((x, i) => axis.map((y, j) => (2 * x * y) / square - (i === j ? 1 : 0)));
}

const halfTurns = /** @type {{ arms: Record<string, number[][]> }} */ (fixture('halfTurns.json')).arms;

describe('exactly a half turn, on the spot, from the seed', () => {
  test('is in the fixtures for every arm that can make one', () => {
    expect(Object.keys(halfTurns).length).toBe(18);
    expect(Object.values(halfTurns).every((records) => records.length === 12)).toBe(true);
  });
  test.each(Object.keys(halfTurns))('is made by %s', (name) => {
    for (const record of halfTurns[name]) {
      const [seed, axis] = [record.slice(0, -3), record.slice(-3)];
      const start = oracleForward(publishedArm(name), seed).tcp;
      const place = start.slice(0, 3).map((row) => row[3]);
      const goal = rigid(times(exactHalfTurn(axis), rotationOf(start)), place);
      expect(angleBetween(start, goal)).toBeCloseTo(Math.PI, 6);
      expectConverged(name, goal, { seed });
    }
  });
});
