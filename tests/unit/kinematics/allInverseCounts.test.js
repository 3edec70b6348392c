/**
 * All postures of a pose, against many-start searches and somebody else's closed forms: tests/fixtures/kinematics/
 * makeSolutionCounts.py says how. The quick run takes every third pose; the deep one all.
 */
import { describe, expect, test } from 'vitest';
import { allInverseKinematics } from '../../../src/kinematics/allInverse.js';
import { createChain } from '../../../src/kinematics/chain.js';
import { runs } from '../../helpers/property.js';
import { angleBetween, columnMajor, distanceBetween, oracleForward } from './oracle.js';
import { fixture, publishedArm, publishedReach } from './publishedArms.js';

const { arms } = /** @type {{ arms: Record<string, number[][]> }} */ (fixture('solutionCounts.json'));
const POSES = 40;
const STEP = Math.max(1, Math.floor(POSES / runs(13)));

/** @param {number[]} values @param {number} n */
const inRows = (values, n) => Array.from({ length: values.length / n }, (_, i) => values.slice(n * i, n * (i + 1)));

/** How far two postures are apart, full turns aside; slides over the reach. @param {string} name @param {ArrayLike<number>} a @param {ArrayLike<number>} b */
const apart = (name, a, b) =>
  Math.max(
    ...publishedArm(name).joints.map(({ type }, i) =>
      type === 'prismatic'
        ? Math.abs(a[i] - b[i]) / publishedReach(name)
        : Math.abs(Math.atan2(Math.sin(a[i] - b[i]), Math.cos(a[i] - b[i]))),
    ),
  );

test('the fixtures have 40 poses each for 14 arms, with 1 to 10 postures', () => {
  expect(Object.keys(arms).length).toBe(14);
  const counts = Object.entries(arms).flatMap(([name, records]) => {
    expect(records.length).toBe(POSES);
    return records.map((record) => record.length / publishedArm(name).joints.length - 1);
  });
  expect([Math.min(...counts), Math.max(...counts)]).toEqual([1, 10]);
});

describe.each(Object.keys(arms))('%s', (name) => {
  const description = publishedArm(name);
  const n = description.joints.length;
  test('has the postures that independent searches find, each once, and no others', () => {
    for (const record of arms[name].filter((_, i) => i % STEP === 0)) {
      const [q, ...wanted] = inRows(record, n);
      const goal = oracleForward(description, q).tcp;
      const { solutions, families } = allInverseKinematics(createChain(description), columnMajor(goal));
      expect(families).toEqual([]);
      expect(solutions.length).toBe(wanted.length);
      for (const known of [q, ...wanted])
        expect(solutions.filter((found) => apart(name, found.q, known) < 1e-6).length).toBe(1);
      for (const found of solutions) {
        const { tcp } = oracleForward(description, found.q);
        expect(distanceBetween(tcp, goal)).toBeLessThan(1e-9 * (1 + 1e-6));
        expect(angleBetween(tcp, goal)).toBeLessThan(1e-9 * (1 + 1e-6));
        const isInside = description.joints.every(({ lower, upper }, i) => found.q[i] >= lower && found.q[i] <= upper);
        expect(found.withinLimits).toBe(isInside);
      }
      expect(solutions.some(({ withinLimits }) => withinLimits)).toBe(true); // q is
    }
  });
});
