import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { createChain } from '../../../src/kinematics/chain.js';
import { descend } from '../../../src/kinematics/descent/dampedLeastSquares.js';
import { prepareSearch } from '../../../src/kinematics/descent/search.js';
import { SEED, runs } from '../../helpers/property.js';
import {
  angleBetween,
  anyPose,
  arm,
  columnMajor,
  distanceBetween,
  forwardCases,
  fromLine,
  inverseCases,
  oracleForward,
  rigid,
  rodrigues,
  rowsOf,
} from './oracle.js';

/** @import { ChainDescription } from '../../../src/kinematics/chain.js' */

const OPTIONS = { positionTolerance: 1e-9, orientationTolerance: 1e-9, maxIterations: 100 };
const { joints } = arm('puma560');
const bare = arm('puma560');
const held = {
  ...bare,
  base: columnMajor(rigid(rodrigues([1, 2, 3], 1), [0.1, -0.2, 0.3])),
  tool: columnMajor(rigid(rodrigues([3, -1, 2], 2), [-0.05, 0.1, 0.15])),
};
const puma = createChain(bare);
const pumaWithTool = createChain(held);
const anyStart = fc
  .array(fc.double({ min: 0, max: 1, noNaN: true }), { minLength: 6, maxLength: 6 })
  .map((parts) => parts.map((part, i) => joints[i].lower + part * (joints[i].upper - joints[i].lower)));

/** Half the weighted square, by the oracle. @param {ChainDescription} description @param {ArrayLike<number>} q @param {ArrayLike<number>} goal */
function costAt(description, q, goal) {
  const { tcp } = oracleForward(description, q);
  const distance = distanceBetween(tcp, rowsOf(goal)) / createChain(description).characteristicLength;
  return (distance ** 2 + angleBetween(tcp, rowsOf(goal)) ** 2) / 2;
}

describe('one descent', () => {
  test('ends no higher than it began, inside the limits, at the cost it states', () => {
    fc.assert(
      fc.property(
        anyStart,
        anyPose,
        fc.integer({ min: 0, max: 30 }),
        fc.boolean(),
        (start, goal, maxIterations, isSettling) => {
          const search = prepareSearch(pumaWithTool, goal, { ...OPTIONS, maxIterations });
          search.isSettling = isSettling;
          search.q.set(start);
          const end = descend(search);
          expect(search.iterations).toBeLessThanOrEqual(maxIterations);
          if (end === 'cut') expect(search.iterations).toBe(maxIterations);
          expect(search.cost).toBeLessThanOrEqual(costAt(held, start, goal) * (1 + 1e-7));
          expect(search.cost).toBeCloseTo(costAt(held, search.q, goal), 6);
          search.q.forEach((value, i) => expect(value >= joints[i].lower && value <= joints[i].upper).toBe(true));
        },
      ),
      { seed: SEED, numRuns: runs(150) },
    );
  });
  test('next to a solution, leaps included, ends no higher than it began either', () => {
    for (const line of inverseCases.puma560.nearSingular ?? []) {
      const goal = columnMajor(fromLine(line));
      for (const positionTolerance of [1e-9, 1e-300]) {
        const search = prepareSearch(puma, goal, { ...OPTIONS, positionTolerance });
        search.q.fill(0.1);
        descend(search);
        const first = search.cost;
        const end = descend(search);
        if (end !== 'met') expect(search.cost).toBeLessThanOrEqual(first);
        expect(Math.abs(search.cost - costAt(bare, search.q, goal))).toBeLessThan(1e-12);
      }
    }
  });
  test('from nearby takes two or three iterations, since a step follows its bend', () => {
    let iterations = 0;
    const postures = forwardCases.puma560.q;
    for (const q of postures) {
      const goal = columnMajor(oracleForward(bare, q).tcp);
      const search = prepareSearch(puma, goal, { ...OPTIONS, positionTolerance: 1e-6, orientationTolerance: 1e-6 });
      search.isBounded = false;
      q.forEach((value, i) => (search.q[i] = value + (i % 2 ? 0.08 : -0.06)));
      descend(search);
      iterations += search.iterations;
    }
    expect(iterations / postures.length).toBeLessThan(2.5); // 3.1 on straight steps
  });
  test('that cannot even be measured stays where it began', () => {
    const near = columnMajor(fromLine(inverseCases.puma560.reachable[0]));
    descend(prepareSearch(puma, near, OPTIONS)); // leaves something behind
    const far = near.slice();
    far[12] = 1e200;
    const search = prepareSearch(puma, far, OPTIONS);
    const start = [0.1, 0.2, -0.3, 0.4, 0.5, 0.6];
    search.q.set(start);
    expect(descend(search)).toBe('rest');
    expect(Array.from(search.q)).toEqual(start);
  });
});
