import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { createChain } from '../../../src/kinematics/chain.js';
import { finiteDifferenceJacobian, geometricJacobian } from '../../../src/kinematics/jacobian.js';
import { SEED, runs } from '../../helpers/property.js';
import { anyChain, arm, columnMajor, forwardCases, oracleForward, rigid, rodrigues, sizeOf } from './oracle.js';

/** @import { ChainDescription } from '../../../src/kinematics/chain.js' */

/** The largest difference of two Jacobians. @param {ArrayLike<number>} A @param {ArrayLike<number>} B */
const apart = (A, B) => Math.max(...Array.from(A, (value, i) => Math.abs(value - B[i])));
/**
 * The founding formula with a whole forward kinematics for each difference: by the oracle, so with its rounding too.
 * Orientation: the axial vector of R(x + h) Rᵀ, which for small h is the rotation vector.
 * @param {ChainDescription} description
 * @param {number[]} q
 * @param {number} h
 */
function byDefinition(description, q, h) {
  const T = oracleForward(description, q).tcp;
  return q.flatMap((_, k) => {
    const moved = oracleForward(
      description,
      q.map((value, i) => (i === k ? value + h : value)),
    ).tcp;
    const D = [0, 1, 2].map((i) => [0, 1, 2].map((j) => [0, 1, 2].reduce((sum, m) => sum + moved[i][m] * T[j][m], 0)));
    const linear = [0, 1, 2].map((i) => (moved[i][3] - T[i][3]) / h);
    return [...linear, (D[2][1] - D[1][2]) / (2 * h), (D[0][2] - D[2][0]) / (2 * h), (D[1][0] - D[0][1]) / (2 * h)];
  });
}

describe('any chain, both conventions, slides included', () => {
  test('the finite differences agree with geometry', () => {
    fc.assert(
      fc.property(anyChain, ({ description, q }) => {
        const chain = createChain(description);
        const exact = geometricJacobian(chain, q);
        const size = sizeOf(description);
        expect(apart(finiteDifferenceJacobian(chain, q), exact)).toBeLessThan(1e-6 * size);
        expect(apart(finiteDifferenceJacobian(chain, q, { method: 'central' }), exact)).toBeLessThan(1e-9 * size);
      }),
      { seed: SEED, numRuns: runs(200) },
    );
  });
  test('the forward difference is the founding formula, at coarse steps too', () => {
    fc.assert(
      fc.property(anyChain, fc.constantFrom(1e-3, 1e-4), ({ description, q }, step) => {
        const joints = description.joints.map((row) => ({ ...row, type: /** @type {const} */ ('revolute') }));
        const turning = { ...description, joints };
        const chain = createChain(turning);
        const J = finiteDifferenceJacobian(chain, q, { step });
        // the axial vector is sin(h)/h of the rotation vector
        const tolerance = sizeOf(description) * (1e-11 + step * step);
        expect(apart(J, byDefinition(turning, q, step))).toBeLessThan(tolerance);
        const halving = apart(J, geometricJacobian(chain, q));
        expect(halving).toBeLessThan(step * sizeOf(description)); // the error of the formula itself: at most h/2 · |p″|
      }),
      { seed: SEED, numRuns: runs(100) },
    );
  });
  test('the smallest step is as good as the derivative: nothing is lost by subtracting', () => {
    fc.assert(
      fc.property(anyChain, ({ description, q }) => {
        const chain = createChain(description);
        const J = finiteDifferenceJacobian(chain, q, { step: 1e-13 });
        expect(apart(J, geometricJacobian(chain, q))).toBeLessThan(1e-12 * sizeOf(description));
      }),
      { seed: SEED, numRuns: runs(50) },
    );
  });
  test('a step of more than half a turn turns the shorter way', () => {
    const q = forwardCases.puma560.q[0];
    const chain = createChain(arm('puma560'));
    const J = finiteDifferenceJacobian(chain, q, { step: 5 });
    geometricJacobian(chain, q).forEach((value, at) => {
      if (at % 6 > 2) expect(J[at]).toBeCloseTo((value * (5 - 2 * Math.PI)) / 5, 12);
    });
  });
  test('a step of half a radian turns by half a radian', () => {
    fc.assert(
      fc.property(anyChain, ({ description, q }) => {
        const chain = createChain(description);
        const J = finiteDifferenceJacobian(chain, q, { step: 0.5 });
        description.joints.forEach(({ type }, i) => {
          const turn = Math.hypot(...J.subarray(6 * i + 3, 6 * i + 6));
          if (type === 'revolute') expect(turn).toBeCloseTo(1, 12);
          else expect(turn).toBe(0);
        });
      }),
      { seed: SEED, numRuns: runs(50) },
    );
  });
  test('a base far away costs no digits', () => {
    const base = columnMajor(rigid(rodrigues([1, 2, 3], 1), [1e6, -1e6, 1e6]));
    const chain = createChain({ ...arm('puma560'), base });
    const q = forwardCases.puma560.q[0];
    const near = geometricJacobian(
      createChain({ ...arm('puma560'), base: columnMajor(rigid(rodrigues([1, 2, 3], 1), [0, 0, 0])) }),
      q,
    );
    expect(apart(finiteDifferenceJacobian(chain, q), near)).toBeLessThan(1e-6);
  });
});

test('Corke, Robotics, Vision and Control, section 8.1: the Puma 560 at qn', () => {
  const J = geometricJacobian(createChain(arm('puma560')), [0, Math.PI / 4, Math.PI, 0, Math.PI / 4, 0]);
  const printed = [
    [0.1501, 0.0144, 0.3197, 0, 0, 0],
    [0.5963, 0, 0, 0, 0, 0],
    [0, 0.5963, 0.291, 0, 0, 0],
  ];
  printed.forEach((row, r) => row.forEach((value, k) => expect(Math.abs(J[6 * k + r] - value)).toBeLessThan(6e-5)));
});

describe('calls', () => {
  const chain = createChain(arm('scara_cobra600'));
  const q = [0.1, 0.2, 0.05, 0.3];
  test('what is written into `out` is what is returned without it', () => {
    const out = new Float64Array(24).fill(7);
    expect(geometricJacobian(chain, q, out)).toBe(out);
    expect(out).toEqual(geometricJacobian(chain, q));
    for (const method of /** @type {const} */ (['forward', 'central'])) {
      expect(finiteDifferenceJacobian(chain, q, { method, out })).toBe(out);
      expect(out).toEqual(finiteDifferenceJacobian(chain, q, { method }));
    }
  });
  test('that are wrong are refused', () => {
    const sideways = /** @type {'forward'} */ (/** @type {unknown} */ ('sideways'));
    expect(() => finiteDifferenceJacobian(chain, q, { method: sideways })).toThrow(
      "'forward' or 'central', got 'sideways'",
    );
    for (const step of [0, -1e-7, NaN, Infinity]) {
      expect(() => finiteDifferenceJacobian(chain, q, { step })).toThrow(`Expected a positive step, got ${step}.`);
    }
    for (const jacobian of [finiteDifferenceJacobian, geometricJacobian]) {
      expect(() => jacobian(chain, [1, 2])).toThrow('Expected 4 joint values, got 2.');
      expect(() => jacobian(chain, [1, 2, NaN, 4])).toThrow('Expected joint value 3');
    }
    expect(() => geometricJacobian(chain, q, new Float64Array(36))).toThrow('Expected room for 24 numbers, got 36.');
    expect(() => finiteDifferenceJacobian(chain, q, { out: new Float64Array(6) })).toThrow(
      'Expected room for 24 numbers, got 6.',
    );
  });
});
