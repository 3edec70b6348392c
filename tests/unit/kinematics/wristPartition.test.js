import { expect, test } from 'vitest';
import { createChain } from '../../../src/kinematics/chain.js';
import { createRandom } from '../../../src/kinematics/random.js';
import { goalFromStart, screwsOf } from '../../../src/kinematics/screws.js';
import { recogniseWristPartition, solveWristPartition } from '../../../src/kinematics/wristPartition.js';
import { angleBetween, arm, columnMajor, distanceBetween, oracleForward } from './oracle.js';

test('a Puma 560 has eight postures for a pose, the one it came from among them', () => {
  const random = createRandom(560);
  const description = arm('puma560');
  const chain = createChain(description);
  const constants = recogniseWristPartition(screwsOf(chain));
  if (!constants) throw new Error('Expected the arm to be recognised.');
  for (let i = 0; i < 50; i++) {
    const q = description.joints.map(() => (2 * random() - 1) * Math.PI);
    const { tcp } = oracleForward(description, q);
    const { postures, families, isComplete } = solveWristPartition(constants, goalFromStart(chain, columnMajor(tcp)));
    expect([postures.length, families.length, isComplete]).toEqual([8, 0, true]);
    for (const found of postures) {
      const reached = oracleForward(description, found).tcp;
      expect(distanceBetween(reached, tcp)).toBeLessThan(1e-11);
      expect(angleBetween(reached, tcp)).toBeLessThan(1e-11);
    }
    expect(postures.some((found) => found.every((value, j) => Math.abs(Math.sin((value - q[j]) / 2)) < 1e-10))).toBe(
      true,
    );
  }
});
