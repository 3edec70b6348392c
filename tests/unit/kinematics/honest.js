/**
 * What every answer of inverse kinematics owes, whatever its status.
 * @import { ChainDescription } from '../../../src/kinematics/chain.js'
 * @import { InverseResult } from '../../../src/kinematics/inverse.js'
 * @import { InverseOptions } from '../../../src/kinematics/descent/inverseOptions.js'
 * @import { Matrix } from './oracle.js'
 */
import { expect } from 'vitest';
import { angleBetween, distanceBetween, oracleForward, rotationOf } from './oracle.js';

/** The angle between the z axes of two frames. @param {Matrix} A @param {Matrix} B */
function tiltBetween(A, B) {
  const chord = Math.hypot(...[0, 1, 2].map((i) => A[i][2] - B[i][2]));
  return 2 * Math.asin(Math.min(1, chord / 2));
}

/**
 * @param {ChainDescription} description
 * @param {Matrix} goal
 * @param {InverseResult} result
 * @param {InverseOptions} [options]
 */
export function expectHonest(
  description,
  goal,
  result,
  { positionTolerance = 1e-9, orientationTolerance = 1e-9 } = {},
) {
  const { joints } = description;
  const { status, q, positionError, orientationError, task } = result;
  expect(q.length).toBe(joints.length);
  joints.forEach(({ lower = -Infinity, upper = Infinity }, i) => expect(q[i] >= lower && q[i] <= upper).toBe(true));

  const { tcp } = oracleForward(description, q);
  const scale = 1 + Math.hypot(...[0, 1, 2].map((i) => goal[i][3])) + Math.hypot(...[0, 1, 2].map((i) => tcp[i][3]));
  expect(Math.abs(positionError - distanceBetween(tcp, goal))).toBeLessThan(1e-13 * scale);
  // a chord says little about an angle near a half turn
  const blur = Math.max(Math.cos(orientationError / 2), 1e-6);
  expect(Math.abs(orientationError - angleBetween(tcp, goal))).toBeLessThan((1e-13 * scale) / blur);

  if (status === 'converged') {
    expect(distanceBetween(tcp, goal)).toBeLessThan(positionTolerance * (1 + 1e-6));
    expect(angleBetween(tcp, goal)).toBeLessThan(orientationTolerance * (1 + 1e-6));
  }
  const isMet = positionError <= positionTolerance && orientationError <= orientationTolerance;
  expect(status === 'converged').toBe(isMet);
  if (status === 'subspace') {
    expect(joints.length).toBeLessThan(6);
    expect(distanceBetween(tcp, goal)).toBeLessThan(positionTolerance * (1 + 1e-6));
    if (task?.met.includes('tool-axis')) expect(tiltBetween(tcp, goal)).toBeLessThan(orientationTolerance * (1 + 1e-6));
    // for an arm whose first axis is the root's z: how the tool leans, and how much it pitches, is in the third row
    const lean = Math.hypot(...[0, 1, 2].map((j) => tcp[2][j] - goal[2][j]));
    if (task?.met.includes('tilt')) expect(lean).toBeLessThan(orientationTolerance * (1 + 1e-6));
    if (task?.met.includes('pitch'))
      expect(Math.abs(tcp[2][2] - goal[2][2])).toBeLessThan(orientationTolerance * (1 + 1e-6));
    expect(task?.met).toContain('position');
  }
  expect(task !== undefined).toBe(status === 'subspace' || (status === 'outside-limits' && task !== undefined));
  expect(result.limit !== undefined).toBe(status === 'outside-limits');
  expect(result.reason === undefined).toBe(status === 'converged');
  expect(result.reason === 'joints').toBe(status === 'subspace');
  expect(result.reason === 'limits').toBe(status === 'outside-limits');
  expect(result.shortBy !== undefined).toBe(result.reason === 'distance');
  if (result.shortBy !== undefined) {
    // the place was found to be missed by so much; the posture for the whole pose may miss it by more
    expect(result.shortBy).toBeGreaterThan(0);
    expect(result.shortBy).toBeLessThanOrEqual(positionError * (1 + 1e-6) + 1e-9);
    expect(result.shortBy).toBeGreaterThanOrEqual(result.beyondReach ?? 0);
  }
  if (result.beyondReach !== undefined) expect([status, result.reason]).toEqual(['unreachable', 'distance']);
  expect(rotationOf(tcp).flat().every(Number.isFinite)).toBe(true);
  return result;
}
