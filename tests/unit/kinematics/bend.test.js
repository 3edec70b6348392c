import fc from 'fast-check';
import { expect, test } from 'vitest';
import { writeBend } from '../../../src/kinematics/descent/bend.js';
import { createChain } from '../../../src/kinematics/chain.js';
import { geometricJacobian } from '../../../src/kinematics/jacobian.js';
import { SEED, runs } from '../../helpers/property.js';
import { anyChain, oracleForward, rotationOf, sizeOf, times, transpose } from './oracle.js';

/** @import { ChainDescription } from '../../../src/kinematics/chain.js' */
/** @import { Matrix } from './oracle.js' */

/** Of R: (R₂₁ − R₁₂, …) / 2, for a small turn its rotation vector. @param {Matrix} R */
const axial = (R) => [R[2][1] - R[1][2], R[0][2] - R[2][0], R[1][0] - R[0][1]].map((value) => value / 2);

/**
 * How the TCP is accelerated while the joints go at steady rates, by second differences of whole poses.
 * @param {ChainDescription} description
 * @param {number[]} q
 * @param {number[]} rates
 */
function acceleration(description, q, rates) {
  const h = 1e-3;
  const [before, at, after] = [-h, 0, h].map(
    (t) =>
      oracleForward(
        description,
        q.map((v, i) => v + t * rates[i]),
      ).tcp,
  );
  const linear = [0, 1, 2].map((i) => (after[i][3] - 2 * at[i][3] + before[i][3]) / (h * h));
  const turned = (/** @type {Matrix} */ T) => axial(times(rotationOf(T), transpose(rotationOf(at))));
  const [one, other] = [turned(after), turned(before)];
  return [...linear, ...one.map((value, i) => (value + other[i]) / (h * h))];
}

test('the second step makes up for half of what the TCP is accelerated by along the first', () => {
  fc.assert(
    fc.property(
      anyChain,
      fc.infiniteStream(fc.integer({ min: -1000, max: 1000 })), // doubles are mostly next to nothing
      fc.double({ min: 0.1, max: 10, noNaN: true }),
      ({ description, q }, stream, weight) => {
        const step = Float64Array.from(q, () => stream.next().value / 1000);
        const J = geometricJacobian(createChain(description), q);
        const right = new Float64Array(q.length);
        writeBend(J, weight, step, new Float64Array(q.length).fill(1), right);
        const b = acceleration(description, q, [...step]).map((value, k) => (k < 3 ? value * weight : value));
        const expected = q.map((_, i) => -0.5 * b.reduce((sum, value, k) => sum + J[6 * i + k] * value, 0));
        // second differences err by h²/12 of the fourth derivative
        const speed = step.reduce((sum, value) => sum + Math.abs(value), 0);
        const arm = Math.max(...J.map(Math.abs));
        const tolerance = 2e-7 * speed ** 4 * (1 + weight * arm ** 2) + 1e-8 * (1 + weight * sizeOf(description) ** 2);
        right.forEach((value, i) => expect(Math.abs(value - expected[i])).toBeLessThan(tolerance));
      },
    ),
    { seed: SEED, numRuns: runs(200) },
  );
});

test('a joint without a gradient stays', () => {
  const J = Float64Array.from({ length: 18 }, (_, i) => Math.sin(i * i));
  const right = new Float64Array(3);
  writeBend(J, 1, Float64Array.of(1, 2, 3), Float64Array.of(1, 0, -1), right);
  expect(Array.from(right, (value) => value === 0)).toEqual([false, true, false]);
});
