import { expect, test } from 'vitest';
import { createChain } from '../../../src/kinematics/chain.js';
import { determinantAt } from '../../../src/kinematics/determinant.js';
import { publishedArm } from './publishedArms.js';

test('of a Puma 560 it is the product that its geometry gives', () => {
  // With a spherical wrist the determinant is that of the arm times that of the wrist, −sin q5 (Siciliano et al. 2009, 3.3.1)
  const arm = publishedArm('puma560');
  const chain = createChain(arm);
  const at = (/** @type {number[]} */ q) => determinantAt(chain, q);
  const q = [0.3, 0.4, 0.5, -0.7, 0.9, 0.2];
  const withWrist = (/** @type {number} */ q5) => at(q.with(4, q5));
  expect(withWrist(0.3) / withWrist(0.9)).toBeCloseTo(Math.sin(0.3) / Math.sin(0.9), 10);
  expect(withWrist(-0.9) / withWrist(0.9)).toBeCloseTo(-1, 10);
  expect(Math.abs(withWrist(0))).toBeLessThan(1e-15);
  // which turns of joints 1, 4 and 6 do not change
  expect(at([1, 0.4, 0.5, 1.1, 0.9, -1])).toBeCloseTo(at(q), 12);
});
