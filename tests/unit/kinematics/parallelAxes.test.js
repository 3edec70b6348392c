import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { createChain } from '../../../src/kinematics/chain.js';
import { inverseKinematics } from '../../../src/kinematics/inverse.js';
import { certainTurn } from '../../../src/kinematics/parallelAxes.js';
import { SEED, runs } from '../../helpers/property.js';
import {
  angleBetween,
  anyChain,
  anyPose,
  arm,
  columnMajor,
  oracleForward,
  rigid,
  rodrigues,
  rotationOf,
  rowsOf,
  times,
} from './oracle.js';

/** The same chain with every twist between joints straightened; the one before the first or after the last stays. */
const anyParallelChain = anyChain.map(({ description, q }) => {
  const outer = description.convention === 'standard' ? description.joints.length - 1 : 0;
  const joints = description.joints.map((row, i) => (i === outer ? row : { ...row, alpha: i % 3 === 0 ? Math.PI : 0 }));
  return { description: { ...description, joints }, q };
});

describe('an arm whose turning axes are parallel', () => {
  test('misses an orientation by no less than is said, at any posture', () => {
    fc.assert(
      fc.property(anyParallelChain, anyPose, ({ description, q }, goal) => {
        const { tcp } = oracleForward(description, q);
        const chain = createChain(description);
        expect(certainTurn(chain, goal, 'pose')).toBeLessThanOrEqual(angleBetween(tcp, rowsOf(goal)) + 1e-7);
        expect(certainTurn(chain, goal, 'position')).toBe(0);
      }),
      { seed: SEED, numRuns: runs(200) },
    );
  });
  test('misses by nothing what forward kinematics made', () => {
    fc.assert(
      fc.property(anyParallelChain, ({ description, q }) => {
        const goal = columnMajor(oracleForward(description, q).tcp);
        expect(certainTurn(createChain(description), goal, 'pose')).toBeLessThan(1e-13);
        expect(certainTurn(createChain(description), goal, 'position-and-tilt')).toBeLessThan(1e-13);
      }),
      { seed: SEED, numRuns: runs(200) },
    );
  });
  test('misses by nothing what forward kinematics made on a base, or with a tool, typed with six decimals', () => {
    const typed = Float64Array.of(
      0.612372,
      0.612372,
      -0.5,
      0,
      -0.707107,
      0.707107,
      0,
      0,
      0.353554,
      0.353553,
      0.866025,
      0,
      0,
      0,
      0,
      1,
    );
    for (const frames of [{ base: typed }, { tool: typed }, { base: typed, tool: typed }]) {
      const description = { ...arm('planar2r'), ...frames };
      const chain = createChain(description);
      for (const q of [
        [0.3, 0.8],
        [2, -1],
        [-1, 2.5],
      ]) {
        const goal = columnMajor(oracleForward(description, q).tcp);
        expect(certainTurn(chain, goal, 'pose')).toBe(0);
        expect(certainTurn(chain, goal, 'position-and-tilt')).toBe(0);
        expect(inverseKinematics(chain, goal).status).toBe('converged');
      }
    }
  });
  test('misses a tilt by the tilt', () => {
    const description = arm('scara_cobra600');
    const { tcp } = oracleForward(description, [0.1, 0.2, 0.1, 0.3]);
    for (const tilt of [1e-8, 0.1, 1, 3]) {
      const goal = rigid(times(rotationOf(tcp), rodrigues([1, 1, 0], tilt)), [0.4, 0.1, 0.2]);
      expect(certainTurn(createChain(description), columnMajor(goal), 'pose')).toBeCloseTo(tilt, 12);
      expect(certainTurn(createChain(description), columnMajor(goal), 'position-and-tilt')).toBeCloseTo(tilt, 12);
    }
  });
  test('does not search for what it cannot do', () => {
    const description = arm('scara_cobra600');
    const { tcp } = oracleForward(description, [0.1, 0.2, 0.1, 0.3]);
    const goal = columnMajor(times(tcp, rigid(rodrigues([1, 0, 0], 0.3), [0, 0, 0])));
    const { status, restarts } = inverseKinematics(createChain(description), goal);
    expect(status).toBe('subspace');
    expect(restarts).toBeLessThan(20);
  });
  test('is told from others: nothing is certain about a Puma 560, nor about an arm that only slides', () => {
    const goal = columnMajor(rigid(rodrigues([1, 2, 3], 1), [0.3, 0.2, 0.5]));
    expect(certainTurn(createChain(arm('puma560')), goal, 'pose')).toBe(0);
    const slide = { type: /** @type {const} */ ('prismatic'), a: 0, alpha: 0, d: 0, theta: 0 };
    expect(certainTurn(createChain({ convention: 'standard', joints: [slide] }), goal, 'pose')).toBe(0);
  });
});
