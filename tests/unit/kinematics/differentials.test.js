import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { createChain } from '../../../src/kinematics/chain.js';
import {
  dampingAt,
  moveTwist,
  moveWrench,
  ratesFor,
  staticTorques,
  twistOf,
} from '../../../src/kinematics/differentials.js';
import { SEED, runs } from '../../helpers/property.js';
import { anyChain, columnMajor, oracleForward, rigid, rodrigues, rotationOf, sizeOf, transpose } from './oracle.js';
import { publishedArm, publishedForward } from './publishedArms.js';

/** @import { ChainDescription } from '../../../src/kinematics/chain.js' */
/** @import { JointRow } from '../../../src/kinematics/joint.js' */

/** @param {ArrayLike<number>} a @param {ArrayLike<number>} b */
const dot = (a, b) => Array.from(a).reduce((sum, value, i) => sum + value * b[i], 0);
/** @param {ArrayLike<number>} a @param {ArrayLike<number>} b */
const apart = (a, b) => Math.max(...Array.from(a, (value, i) => Math.abs(value - b[i])));
const numbers = (/** @type {number} */ count) =>
  fc.array(fc.double({ min: -1, max: 1, noNaN: true }), { minLength: count, maxLength: count });

/**
 * The twist of the TCP by central differences of whole poses along the motion: the oracle's, so nothing of the kernel's.
 * @param {ChainDescription} description
 * @param {ArrayLike<number>} q
 * @param {ArrayLike<number>} rates
 */
function twistByDifference(description, q, rates) {
  const h = 1e-5;
  const at = (/** @type {number} */ t) =>
    oracleForward(
      description,
      Array.from(q, (value, i) => value + t * rates[i]),
    ).tcp;
  const [before, here, after] = [at(-h), at(0), at(h)];
  const rate = here.map((row, i) => row.map((_, j) => (after[i][j] - before[i][j]) / (2 * h)));
  // Ṙ Rᵀ is the skew matrix of ω
  const W = [0, 1, 2].map((i) => [0, 1, 2].map((j) => dot(rate[i].slice(0, 3), here[j].slice(0, 3))));
  const w = [W[2][1] - W[1][2], W[0][2] - W[2][0], W[1][0] - W[0][1]].map((value) => value / 2);
  return [rate[0][3], rate[1][3], rate[2][3], ...w];
}

/** Solves A x = b by elimination with pivots. @param {number[][]} A @param {number[]} b */
function solve(A, b) {
  const M = A.map((row, i) => [...row, b[i]]);
  const n = b.length;
  for (let k = 0; k < n; k++) {
    const pivot = M.slice(k).reduce((best, row, i) => (Math.abs(row[k]) > Math.abs(M[best][k]) ? k + i : best), k);
    [M[k], M[pivot]] = [M[pivot], M[k]];
    for (let i = k + 1; i < n; i++) {
      const factor = M[i][k] / M[k][k];
      M[i] = M[i].map((value, j) => value - factor * M[k][j]);
    }
  }
  const x = Array(n).fill(0);
  for (let i = n - 1; i >= 0; i--) x[i] = (M[i][n] - dot(M[i].slice(i + 1, n), x.slice(i + 1))) / M[i][i];
  return x;
}

describe('any arm', () => {
  test('does what the rates say, as seen from the base and from the tool', () => {
    fc.assert(
      fc.property(anyChain, numbers(7), ({ description, q }, seven) => {
        const chain = createChain(description);
        const rates = seven.slice(0, chain.dof);
        const wanted = twistByDifference(description, q, rates);
        const tolerance = 1e-8 * sizeOf(description);
        expect(apart(twistOf(chain, q, rates), wanted)).toBeLessThan(tolerance);
        const R = transpose(rotationOf(oracleForward(description, q).tcp));
        const inTool = [...R.map((row) => dot(row, wanted.slice(0, 3))), ...R.map((row) => dot(row, wanted.slice(3)))];
        expect(apart(twistOf(chain, q, rates, { frame: 'tool' }), inTool)).toBeLessThan(tolerance);
      }),
      { seed: SEED, numRuns: runs(150) },
    );
  });
  test('virtual work: what the joints put in is what the wrench takes out, in either frame', () => {
    fc.assert(
      fc.property(anyChain, numbers(7), numbers(6), ({ description, q }, seven, wrench) => {
        const chain = createChain(description);
        const rates = seven.slice(0, chain.dof);
        const tolerance = 1e-7 * sizeOf(description);
        const power = dot(wrench, twistByDifference(description, q, rates));
        expect(Math.abs(dot(staticTorques(chain, q, wrench), rates) - power)).toBeLessThan(tolerance);
        const R = rotationOf(oracleForward(description, q).tcp);
        const inBase = [...R.map((row) => dot(row, wrench.slice(0, 3))), ...R.map((row) => dot(row, wrench.slice(3)))];
        expect(apart(staticTorques(chain, q, wrench, { frame: 'tool' }), staticTorques(chain, q, inBase))).toBeLessThan(
          1e-12 * sizeOf(description),
        );
      }),
      { seed: SEED, numRuns: runs(150) },
    );
  });
  test('is asked for no rates that are not numbers, nor beyond 20 times the twist, and told what it achieves', () => {
    fc.assert(
      fc.property(anyChain, numbers(6), ({ description, q }, twist) => {
        const chain = createChain(description);
        const L = chain.characteristicLength;
        const { rates, achievedTwist, isDamped, damping } = ratesFor(chain, q, twist);
        expect([...rates, ...achievedTwist, damping].every(Number.isFinite)).toBe(true);
        expect(isDamped).toBe(damping > 0);
        const turning = Math.hypot(
          ...rates.map((rate, i) => (description.joints[i].type === 'prismatic' ? rate / L : rate)),
        );
        const asked = Math.hypot(...twist.map((value, i) => (i < 3 ? value / L : value)));
        expect(turning).toBeLessThanOrEqual(20 * asked * (1 + 1e-9));
        expect(apart(achievedTwist, twistByDifference(description, q, rates))).toBeLessThan(
          1e-8 * sizeOf(description) * (1 + Math.hypot(...rates)) ** 3,
        );
      }),
      { seed: SEED, numRuns: runs(200) },
    );
  });
  test('gets the damped least squares rates that the normal equations give', () => {
    fc.assert(
      fc.property(anyChain, numbers(6), fc.constantFrom(0.05, 0.3), ({ description, q }, twist, damping) => {
        const chain = createChain(description);
        const L = chain.characteristicLength;
        fc.pre(L > 1e-3); // or the normal equations are no judge: a slide that is out by a billion lengths drowns λ² in them
        const slides = description.joints.map(({ type }) => type === 'prismatic');
        const { rates } = ratesFor(chain, q, twist, { damping, part: 'full' });
        const columns = q.map((_, k) =>
          twistOf(
            chain,
            q,
            q.map((__, i) => Number(i === k)),
          ).map((value, i) => (i < 3 ? value / L : value) * (slides[k] ? L : 1)),
        );
        const goal = twist.map((value, i) => (i < 3 ? value / L : value));
        const A = columns.map((a, i) => columns.map((b, j) => dot(a, b) + (i === j ? damping ** 2 : 0)));
        const wanted = solve(
          A,
          columns.map((a) => dot(a, goal)),
        ).map((value, i) => (slides[i] ? value * L : value));
        // a motion below 1e-9 is one that the arm does not have: it would count with at most 1e-9 / λ²
        expect(apart(rates, wanted)).toBeLessThan(1e-6 * (1 + Math.hypot(...wanted)));
      }),
      { seed: SEED, numRuns: runs(150) },
    );
  });
});

describe('six joints away from singularities', () => {
  test.each(['puma560', 'ur5', 'stanford', 'kinova_mico'])('%s: there and back exactly, undamped', (name) => {
    const chain = createChain(publishedArm(name));
    const twist = [0.1, -0.2, 0.3, 0.4, -0.5, 0.6];
    let undamped = 0;
    for (const q of publishedForward(name).q) {
      for (const frame of /** @type {const} */ (['base', 'tool'])) {
        const { rates, achievedTwist, isDamped } = ratesFor(chain, q, twist, { frame });
        expect(apart(twistOf(chain, q, rates, { frame }), achievedTwist)).toBeLessThan(1e-13);
        if (isDamped) continue;
        undamped++;
        expect(apart(achievedTwist, twist)).toBeLessThan(1e-12);
      }
    }
    expect(undamped).toBeGreaterThan(50);
  });
});

describe('damping', () => {
  const chain = createChain(publishedArm('puma560'));
  const lostAt = (/** @type {number} */ q5) => [0.1, 0.5, -0.3, 0.4, q5, 0.2];
  test('begins at a singular value of 0.05 and grows without a jump to 0.05 at none', () => {
    expect(dampingAt(0.05)).toBe(0);
    expect(dampingAt(0.05 - 1e-12)).toBeLessThan(1e-6);
    expect(dampingAt(0.03)).toBeCloseTo(0.04, 14);
    expect(dampingAt(0)).toBe(0.05);
  });
  test('keeps the rates down on the way through the wrist singularity, and they go to zero in the worst direction', () => {
    const twist = [0, 0, 0, 0.3, 0.5, -0.4];
    let before = ratesFor(chain, lostAt(0.2), twist).rates;
    for (let q5 = 0.2; q5 > -0.2; q5 -= 1e-3) {
      const { rates, damping } = ratesFor(chain, lostAt(q5), twist);
      expect(Math.hypot(...rates)).toBeLessThan(20);
      expect(apart(rates, before)).toBeLessThan(1); // no jump
      expect(damping <= 0.05).toBe(true);
      before = rates;
    }
    const undamped = ratesFor(chain, lostAt(1e-3), twist, { damping: 0 });
    expect(undamped.isDamped).toBe(false);
    expect(Math.hypot(...undamped.rates)).toBeGreaterThan(100);
    expect(apart(undamped.achievedTwist, twist)).toBeLessThan(1e-10);
  });
  test('at a singularity, undamped: what cannot be made is left out, the rest is made', () => {
    const possible = twistOf(chain, lostAt(0), [0.1, -0.2, 0.3, 0.2, 0.5, 0.2]);
    const { rates, achievedTwist } = ratesFor(chain, lostAt(0), possible, { damping: 0 });
    expect(apart(achievedTwist, possible)).toBeLessThan(1e-13);
    expect(apart(rates, [0.1, -0.2, 0.3, 0.2, 0.5, 0.2])).toBeLessThan(1e-12); // the least ones: joints 4 and 6 share
  });
  test('does not depend on the unit of length', () => {
    for (const name of ['puma560', 'stanford']) {
      const slides = publishedArm(name).joints.map(({ type }) => type === 'prismatic');
      const q = [0.1, 0.5, 0.4, 0.4, 0.03, 0.2];
      const twist = [0.1, 0.2, -0.1, 0.3, 0.5, -0.4];
      const wanted = ratesFor(createChain(publishedArm(name)), q, twist);
      expect(wanted.isDamped).toBe(true);
      for (const scale of [1e-3, 1e3]) {
        const found = ratesFor(
          createChain(publishedArm(name, scale)),
          q.map((value, i) => (slides[i] ? value * scale : value)),
          twist.map((value, i) => (i < 3 ? value * scale : value)),
        );
        expect(Math.abs(found.damping - wanted.damping)).toBeLessThan(1e-12);
        expect(
          apart(
            found.rates.map((value, i) => (slides[i] ? value / scale : value)),
            wanted.rates,
          ),
        ).toBeLessThan(1e-10);
      }
    }
  });
});

describe('worked examples', () => {
  /** @param {Partial<JointRow>} row @returns {JointRow} */
  const revolute = (row) => ({ type: 'revolute', a: 0, alpha: 0, d: 0, theta: 0, ...row });
  const arm = createChain({ convention: 'standard', joints: [revolute({ a: 1 }), revolute({ a: 0.5 })] });
  const [c1, s1, c12, s12] = [Math.cos(0.4), Math.sin(0.4), Math.cos(1.1), Math.sin(1.1)];
  test('Craig, section 5.9: the torques of a planar 2R arm, τ1 = (l1 s2) fx + (l2 + l1 c2) fy and τ2 = l2 fy in the tool frame', () => {
    const [c2, s2] = [Math.cos(0.7), Math.sin(0.7)];
    const torques = staticTorques(arm, [0.4, 0.7], [3, 4, 0, 0, 0, 0], { frame: 'tool' });
    expect(apart(torques, [s2 * 3 + (0.5 + c2) * 4, 0.5 * 4])).toBeLessThan(1e-14);
  });
  test('Craig, example 5.5 (resolved rate): the rates of a planar 2R arm at 1 m/s along x, q̇1 = c12 / (l1 s2)', () => {
    const { rates, achievedTwist } = ratesFor(arm, [0.4, 0.7], [1, 0, 0, 0, 0, 0]);
    const s2 = Math.sin(0.7);
    expect(apart(rates, [c12 / s2, -c1 / (0.5 * s2) - c12 / s2])).toBeLessThan(1e-13);
    expect(apart(achievedTwist.subarray(0, 3), [1, 0, 0])).toBeLessThan(1e-14);
  });
  test('its TCP moves along (−s, c) of each arm', () => {
    expect(apart(twistOf(arm, [0.4, 0.7], [1, 0]), [-s1 - 0.5 * s12, c1 + 0.5 * c12, 0, 0, 0, 1])).toBeLessThan(1e-15);
  });
  test('a gantry that carries 10 N downwards pushes its slide up by 10 N', () => {
    const gantry = createChain({ convention: 'standard', joints: [{ ...revolute({}), type: 'prismatic' }] });
    expect(Array.from(staticTorques(gantry, [0.3], [0, 0, 10, 0, 0, 5]))).toEqual([10]);
  });
});

describe('another point of the same body', () => {
  test('has the twist that the arm with that point as its tool has, and the wrench that takes the same torques', () => {
    const tool = columnMajor(rigid(rodrigues([0, 0, 1], 0), [0.1, -0.2, 0.3]));
    const description = publishedArm('puma560');
    const [bare, tooled] = [createChain(description), createChain({ ...description, tool })];
    fc.assert(
      fc.property(numbers(6), numbers(6), numbers(6), (q, rates, wrench) => {
        const R = rotationOf(oracleForward(description, q).tcp);
        const offset = R.map((row) => dot(row, [0.1, -0.2, 0.3]));
        expect(apart(moveTwist(twistOf(bare, q, rates), offset), twistOf(tooled, q, rates))).toBeLessThan(1e-14);
        const there = moveWrench(wrench, offset);
        expect(apart(staticTorques(tooled, q, there), staticTorques(bare, q, wrench))).toBeLessThan(1e-14);
      }),
      { seed: SEED, numRuns: runs(50) },
    );
  });
});

test('wrong calls are refused', () => {
  const chain = createChain(publishedArm('planar2r'));
  const sideways = /** @type {'base'} */ (/** @type {unknown} */ ('sideways'));
  expect(() => twistOf(chain, [0, 0], [1])).toThrow('Expected 2 joint rates, got 1.');
  expect(() => twistOf(chain, [0, 0], [1, Infinity])).toThrow('Expected finite joint rates, got Infinity.');
  expect(() => twistOf(chain, [0, 0], [1, 1], { frame: sideways })).toThrow("'base' or 'tool', got 'sideways'");
  expect(() => ratesFor(chain, [0, 0], [1, 0, 0])).toThrow('Expected 6 numbers in the twist, got 3.');
  expect(() => ratesFor(chain, [0, 0, 0], [1, 0, 0, 0, 0, 0])).toThrow('Expected 2 joint values, got 3.');
  for (const damping of [-1, NaN, Infinity]) {
    expect(() => ratesFor(chain, [0, 0], [1, 0, 0, 0, 0, 0], { damping })).toThrow(`at least 0, got ${damping}`);
  }
  expect(() => staticTorques(chain, [0, 0], [1, 0, 0, 0, 0, NaN])).toThrow(
    'Expected finite numbers in the wrench, got NaN.',
  );
  expect(() => moveWrench([1, 0, 0, 0, 0, 0], [1, 0])).toThrow('Expected 3 numbers in the offset, got 2.');
});
