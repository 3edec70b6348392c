/**
 * Of all solutions, inverse kinematics gives the one that is nearest to the seed: held against the lists of postures that
 * others made (tests/fixtures/kinematics/makeSolutionCounts.py).
 */
import { describe, expect, test } from 'vitest';
import { createChain } from '../../../src/kinematics/chain.js';
import { inverseKinematics } from '../../../src/kinematics/inverse.js';
import { createRandom } from '../../../src/kinematics/random.js';
import { SEED, runs } from '../../helpers/property.js';
import { columnMajor, oracleForward } from './oracle.js';
import { fixture, publishedArm } from './publishedArms.js';

const { arms } = /** @type {{ arms: Record<string, number[][]> }} */ (fixture('solutionCounts.json'));
const POSES = runs(10);
const SEEDS = 3;
const TURN = 2 * Math.PI;

/** Every value inside the limits that differs by full turns. @param {{ type: string, lower: number, upper: number }} row @param {number} value */
function turnsOf({ type, lower, upper }, value) {
  if (type === 'prismatic') return value >= lower - 1e-9 && value <= upper + 1e-9 ? [value] : [];
  const first = value + TURN * Math.ceil((lower - 1e-9 - value) / TURN);
  return Array.from({ length: 4 }, (_, k) => first + TURN * k).filter((turned) => turned <= upper + 1e-9);
}

describe.each(Object.keys(arms))('%s', (name) => {
  const description = publishedArm(name);
  const { joints } = description;
  const n = joints.length;
  const chain = createChain(description);
  const unit = joints.map(({ type }) => (type === 'prismatic' ? chain.characteristicLength : 1));
  /** @param {ArrayLike<number>} a @param {ArrayLike<number>} b */
  const way = (a, b) => Math.hypot(...unit.map((one, i) => (a[i] - b[i]) / one));

  test('no solution inside the limits is nearer to the seed than the answer', () => {
    const random = createRandom(SEED);
    for (const record of arms[name].slice(0, POSES)) {
      const rows = Array.from({ length: record.length / n }, (_, i) => record.slice(n * i, n * (i + 1)));
      const goal = columnMajor(oracleForward(description, rows[0]).tcp);
      for (let k = 0; k < SEEDS; k++) {
        const seed = joints.map(({ lower, upper }) => lower + (upper - lower) * random());
        const { status, q } = inverseKinematics(chain, goal, { seed });
        expect(status).toBe('converged');
        const ways = rows.map((row) => {
          const nearest = row.map((value, i) =>
            turnsOf(joints[i], value).reduce(
              (best, turned) => (Math.abs(turned - seed[i]) < Math.abs(best - seed[i]) ? turned : best),
              Infinity,
            ),
          );
          return way(nearest, seed);
        });
        expect(way(q, seed)).toBeLessThan(Math.min(...ways) + 1e-5);
      }
    }
  });
});
