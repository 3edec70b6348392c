/** Lines through singular postures: followed no farther than to where the sign of the determinant would change. */
import { describe, expect, test } from 'vitest';
import { createChain } from '../../../src/kinematics/chain.js';
import { geometricJacobian } from '../../../src/kinematics/jacobian.js';
import { followPath } from '../../../src/motion/followPath.js';
import { pathMomentAt } from '../../../src/motion/posturePath.js';
import { linePath } from '../../../src/motion/toolPath.js';
import { createToolSystem } from '../../../src/motion/toolSystem.js';
import { arm, columnMajor, oracleForward } from '../kinematics/oracle.js';

/** Of the Jacobian, by differences of matrices and by expansion along the first row. @param {ReturnType<typeof arm>} description @param {ArrayLike<number>} q */
function determinantOf(description, q) {
  const step = 1e-6;
  const columns = Array.from(q, (_, i) => {
    const [A, B] = [-step, step].map(
      (by) =>
        oracleForward(
          description,
          Array.from(q, (value, k) => (k === i ? value + by : value)),
        ).tcp,
    );
    const T = oracleForward(description, q).tcp;
    const rate = [0, 1, 2, 3].map((row) =>
      [0, 1, 2, 3].map((column) => (B[row][column] - A[row][column]) / (2 * step)),
    );
    // the turning rate from the rate of the rotation: R' Rᵀ
    const spin = (/** @type {number} */ row, /** @type {number} */ column) =>
      [0, 1, 2].reduce((sum, k) => sum + rate[row][k] * T[column][k], 0);
    return [rate[0][3], rate[1][3], rate[2][3], spin(2, 1), spin(0, 2), spin(1, 0)];
  });
  return expanded(columns);
}

/** @param {number[][]} M @returns {number} */
function expanded(M) {
  if (M.length === 1) return M[0][0];
  return M[0].reduce(
    (sum, value, k) =>
      sum + (k % 2 ? -1 : 1) * value * expanded(M.slice(1).map((row) => row.filter((_, j) => j !== k))),
    0,
  );
}

/** The tool where the axes of the wrist meet, so that a turn of joint 5 leaves it in its place. @param {'puma560' | 'ur5'} name */
function toTheWrist(name) {
  const description = arm(name);
  const { d } = description.joints[5];
  return { ...description, tool: Float64Array.of(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, -d, 1) };
}

/** The wrist is straight halfway between these postures, and nothing else changes. */
const THROUGH = /** @type {const} */ ([
  ['puma560', 'the wrist', [0.3, 0.6, -2.6, 0, 0.4, 0.2], [0.3, 0.6, -2.6, 0, -0.4, 0.2]],
  ['ur5', 'the wrist', [0.3, -1.2, 1.6, -0.7, 0.4, 0.4], [0.3, -1.2, 1.6, -0.7, -0.4, 0.4]],
]);

describe('the determinant', () => {
  test.each(/** @type {const} */ (['puma560', 'ur5']))('of %s has the size and the sign of the Jacobian’s', (name) => {
    const description = arm(name);
    const chain = createChain(description);
    const system = createToolSystem(6);
    for (const q of [
      [0.3, 0.6, -2.6, 0.4, 0.9, 0.2],
      [0.3, 0.6, -2.6, 0.4, -0.9, 0.2],
      [0.3, -1.2, 1.6, -0.7, 0.9, 0.4],
      [0.3, -1.2, -1.6, -0.7, 0.9, 0.4],
      [-1, 0.2, 0.4, 2, -0.1, 1],
    ]) {
      system.set(geometricJacobian(chain, Float64Array.from(q)), 1);
      const wanted = determinantOf(description, q);
      expect(Math.abs(system.determinant / wanted - 1)).toBeLessThan(1e-6);
    }
  });
});

describe('a line through a singular posture', () => {
  test.each(THROUGH)(
    'of %s, %s: refused where the sign of the determinant would change, and not before',
    (name, _, from, to) => {
      const description = toTheWrist(name);
      const chain = createChain(description);
      expect(determinantOf(description, from) * determinantOf(description, to)).toBeLessThan(0);
      const way = linePath(...ends(description, from, to));
      for (const share of [1, 0.8]) {
        const found = followPath(chain, way, from, { to: share });
        if (found.status !== 'refused') throw new Error('It was gone through.');
        expect(found.reason).toBe('singularity');
        expect(Math.abs(found.share - 0.5)).toBeLessThan(1e-3);
        expect(Math.abs(found.posture[4])).toBeLessThan(1e-3);
      }
      // up to there it can be followed, and from the other side too
      for (const [begin, line] of /** @type {const} */ ([
        [from, way],
        [to, linePath(...ends(description, to, from))],
      ])) {
        const near = followPath(chain, line, begin, { to: 0.49 });
        if (near.status !== 'done') throw new Error('It was refused.');
        const sign = Math.sign(determinantOf(description, begin));
        for (let share = 0; share < 0.49; share += 0.03) {
          expect(Math.sign(determinantOf(description, pathMomentAt(near.path, share).posture))).toBe(sign);
        }
      }
    },
  );
});

/** @param {ReturnType<typeof arm>} description @param {readonly number[]} from @param {readonly number[]} to @returns {[Float64Array, Float64Array]} */
const ends = (description, from, to) => [
  columnMajor(oracleForward(description, from).tcp),
  columnMajor(oracleForward(description, to).tcp),
];
