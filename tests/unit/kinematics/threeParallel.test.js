/**
 * All postures of arms like Universal Robots', judged by the plain matrices of oracle.js.
 * @import { Family } from '../../../src/kinematics/solvers/candidates.js'
 * @import { ChainDescription } from '../../../src/kinematics/chain.js'
 */
import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { createChain } from '../../../src/kinematics/chain.js';
import { halfAngle } from '../../../src/kinematics/solvers/halfAngle.js';
import { createRandom } from '../../../src/kinematics/random.js';
import { geometricJacobian } from '../../../src/kinematics/jacobian.js';
import { singularValuesOf } from '../../../src/kinematics/measures/homogeneous.js';
import { onlyOnce } from '../../../src/kinematics/sameSolution.js';
import { goalFromStart, screwsOf } from '../../../src/kinematics/screws.js';
import { recogniseThreeParallel, solveThreeParallel } from '../../../src/kinematics/solvers/threeParallel.js';
import { SEED, runs } from '../../helpers/property.js';
import { anyPose, arm, columnMajor, largestDifference, oracleForward, sizeOf } from './oracle.js';
import { isUntold } from './untold.js';

const RIGHT = Math.PI / 2;
const TURN = 2 * Math.PI;
const TOLERANCES = { positionTolerance: 1e-9, orientationTolerance: 1e-9 };

/** Lengths in metres as Universal Robots publishes them (article "DH parameters for calculations of kinematics and dynamics"). */
const universal = (/** @type {[number, number, number, number, number, number]} */ [d1, a2, a3, d4, d5, d6]) => ({
  convention: /** @type {const} */ ('standard'),
  joints: [
    [0, RIGHT, d1],
    [a2, 0, 0],
    [a3, 0, 0],
    [0, RIGHT, d4],
    [0, -RIGHT, d5],
    [0, 0, d6],
  ].map(([a, alpha, d]) => ({ type: /** @type {const} */ ('revolute'), a, alpha, d, theta: 0 })),
});

/** @type {Record<string, ChainDescription>} */
const ARMS = {
  ur3: universal([0.1519, -0.24365, -0.21325, 0.11235, 0.08535, 0.0819]),
  ur5: arm('ur5'),
  ur10: universal([0.1273, -0.612, -0.5723, 0.163941, 0.1157, 0.0922]),
};

/** @param {ChainDescription} description @param {ArrayLike<number>} T_base_goal */
function solve(description, T_base_goal) {
  const chain = createChain(description);
  const constants = recogniseThreeParallel(screwsOf(chain));
  if (constants === null) throw new Error('not recognised');
  return solveThreeParallel(constants, goalFromStart(chain, T_base_goal));
}

/** How far apart two postures are, full turns aside. @param {ArrayLike<number>} p @param {ArrayLike<number>} q */
const apart = (p, q) => Math.max(...Array.from(p, (value, i) => Math.abs(2 * Math.sin((value - q[i]) / 2))));

/** @param {ChainDescription} description @param {ArrayLike<number>} q */
const goalAt = (description, q) => columnMajor(oracleForward(description, q).tcp);

/** The worst of some postures. @param {ChainDescription} description @param {ArrayLike<number>[]} postures @param {ArrayLike<number>} q */
const worstMiss = (description, postures, q) => {
  const goal = oracleForward(description, q).tcp;
  return Math.max(0, ...postures.map((p) => largestDifference(oracleForward(description, p).tcp, goal)));
};

const nearest = (/** @type {Float64Array[]} */ postures, /** @type {ArrayLike<number>} */ q) =>
  Math.min(Infinity, ...postures.map((p) => apart(p, q)));

/**
 * How well a pose that is rounded to 1e-16 can tell its posture: the less, the nearer to a singularity.
 * @param {ChainDescription} description @param {number[]} q
 */
function digitsLeft(description, q) {
  const chain = createChain(description);
  const { singularValues } = singularValuesOf(chain, geometricJacobian(chain, Float64Array.from(q)), { part: 'full' });
  return 5e-15 / singularValues[5];
}

const placesOf = (/** @type {Family[]} */ families) => families.map(({ q }) => q);

/** How near the two nearest are. @param {Float64Array[]} postures */
const leastApart = (postures) =>
  Math.min(Infinity, ...postures.flatMap((p, i) => postures.slice(i + 1).map((q) => apart(p, q))));

/** @param {number} count @param {number} seed */
function randomPostures(count, seed) {
  const random = createRandom(seed);
  return Array.from({ length: count }, () => Array.from({ length: 6 }, () => (random() - 0.5) * TURN));
}

/**
 * Zero, or not nearly so: what is in line to 1e-9 is taken for being in line, and between that and 1e-6 digits are lost. How
 * near to a singularity postures may come without being lost has tests of its own.
 */
const zeroOrMore = (/** @type {fc.Arbitrary<number>} */ numbers) =>
  numbers.map((value) => (Math.abs(value) < 1e-6 ? 0 : value));
const angle = zeroOrMore(fc.double({ min: -3, max: 3, noNaN: true }));
const across = fc.oneof(fc.constantFrom(RIGHT, -RIGHT), fc.double({ min: 0.3, max: 2.8, noNaN: true }));
const along = fc.constantFrom(0, Math.PI);
const link = fc.double({ min: 0.1, max: 1, noNaN: true });
const anyLink = zeroOrMore(fc.double({ min: -1, max: 1, noNaN: true }));

/**
 * Arms with the structure and nothing else in common, in both conventions, the right way round and the other.
 * @type {fc.Arbitrary<{ description: ChainDescription, q: number[] }>}
 */
const anyThreeParallel = fc
  .record({
    convention: fc.constantFrom('standard', 'modified'),
    isReversed: fc.boolean(),
    base: fc.option(anyPose, { nil: undefined }),
    tool: fc.option(anyPose, { nil: undefined }),
    links: fc.tuple(
      fc.record({ a: anyLink, alpha: across }),
      fc.record({ a: link, alpha: along }),
      fc.record({ a: link, alpha: along }),
      fc.record({ a: anyLink, alpha: across }),
      fc.record({ a: fc.constant(0), alpha: across }),
    ),
    outer: fc.record({ a: anyLink, alpha: angle }),
    joints: fc.array(fc.record({ d: anyLink, theta: angle }), { minLength: 6, maxLength: 6 }),
    q: fc.array(angle, { minLength: 6, maxLength: 6 }),
  })
  .map(({ convention, isReversed, base, tool, links, outer, joints, q }) => {
    const between = isReversed ? links.toReversed() : links;
    const all = convention === 'standard' ? [...between, outer] : [outer, ...between];
    return {
      description: {
        convention: /** @type {'standard' | 'modified'} */ (convention),
        base,
        tool,
        joints: joints.map((joint, i) => ({ type: /** @type {const} */ ('revolute'), ...joint, ...all[i] })),
      },
      q,
    };
  });

describe.each(Object.entries(ARMS))('%s', (name, description) => {
  test('every posture is among the solutions of its pose, and each solution meets it', () => {
    for (const q of randomPostures(runs(80), SEED)) {
      const { postures, families, isComplete } = solve(description, goalAt(description, q));
      expect(nearest(postures, q)).toBeLessThan(digitsLeft(description, q));
      expect(worstMiss(description, postures, q)).toBeLessThan(1e-13);
      expect([postures.length % 2, postures.length <= 8, families.length, isComplete]).toEqual([0, true, 0, true]);
      expect(leastApart(postures)).toBeGreaterThan(1e-4);
    }
  });
  test('a far goal has none, and that is proven', () => {
    const goal = goalAt(description, [0, 0, 0, 0, 0, 0]);
    goal[12] += 3;
    expect(solve(description, goal)).toEqual({ postures: [], families: [], isComplete: true });
  });
  test.each([1e-6, 1e-7, 1e-8])('%d from the wrist in line, nothing is lost or doubled', (delta) => {
    for (const [i, q] of randomPostures(runs(20), SEED).entries()) {
      q[4] = (i % 2 === 0 ? 0 : Math.PI) + (i % 4 < 2 ? delta : -delta);
      const { postures, families } = solve(description, goalAt(description, q));
      expect(families).toEqual([]);
      expect(worstMiss(description, postures, q)).toBeLessThan(1e-13);
      expect(nearest(postures, q)).toBeLessThan(digitsLeft(description, q));
      expect(leastApart(postures)).toBeGreaterThan(delta);
    }
  });
  test.each([1e-9, 1e-8, 1e-7, 1e-6])('%d from the wrist in line, and the elbow straight or folded too', (delta) => {
    const postures = randomPostures(runs(50), SEED);
    const found = postures.filter((q, i) => {
      q[4] = i % 2 === 0 ? delta : -delta;
      q[2] = i % 4 < 2 ? 0 : Math.PI;
      const { postures: all } = solve(description, goalAt(description, q));
      expect(worstMiss(description, all, q)).toBeLessThan(2e-9);
      return nearest(all, q) < 1e-6 / Math.sqrt(delta); // the digits are halved twice
    });
    expect(found.length).toBeGreaterThanOrEqual(0.96 * postures.length); // where a third singularity is near, one is lost
  });
  test.each([0, Math.PI])('elbow at %d: exactly there one posture, near it two', (elbow) => {
    for (const q of randomPostures(runs(20), SEED)) {
      q[4] = 1 + (q[4] + 3) / 6; // away from the other singularities
      q[3] = 1 - q[1] - elbow + (q[3] + 3) / 12;
      q[2] = elbow;
      const goal = goalAt(description, q);
      const exact = solve(description, goal).postures.filter((p) => apart(p, q) < 1e-3);
      // A bend β takes (u f / (u + f)) β²/2 off the reach, so what rounding adds to it, up to a hundred times 1e-16 m next to
      // other singularities, is the square of a bend: of one posture it makes two, ±3e-7 off. The pose does not tell them apart.
      expect(onlyOnce(createChain(description), goal, exact, TOLERANCES, true)).toHaveLength(1);
      for (const p of exact) expect(isUntold(description, q, p)).toBe(true);
      q[2] += 1e-6;
      const { postures } = solve(description, goalAt(description, q));
      expect(postures.filter((p) => apart(p, q) < 1e-4)).toHaveLength(2);
      expect(nearest(postures, q)).toBeLessThan(digitsLeft(description, q));
      expect(worstMiss(description, postures, q)).toBeLessThan(1e-13);
    }
  });
  test('at the edge of reach the straight arm is found, a little beyond too, farther out nothing', () => {
    const q = [0.4, -0.7, 0, 0.2, 1.1, 0.3];
    const shoulder = [Math.cos(0.4) * Math.cos(-0.7), Math.sin(0.4) * Math.cos(-0.7), Math.sin(-0.7)];
    const beyond = (/** @type {number} */ way) =>
      goalAt(description, q).map((value, i) => (i >= 12 && i < 15 ? value - way * shoulder[i - 12] : value));
    const found = (/** @type {number} */ way) =>
      solve(description, beyond(way)).postures.filter((p) => apart(p, q) < 1e-3).length;
    expect([-1e-8, 0, 1e-10, 1e-7].map(found)).toEqual([2, 1, 1, 0]);
  });
});

describe('wrist in line', () => {
  const description = ARMS.ur5;
  test('the postures of a circle are two families where the elbow never straightens, one where it does', () => {
    const inside = [0.3, -1.2, 1.5, 0.4, 0, 0.2];
    const outside = [0.3, -0.6, 0.1, 0.4, 0, 0.2];
    for (const [q, count] of /** @type {[number[], number][]} */ ([
      [inside, 2],
      [outside, 1],
    ])) {
      const { families, postures } = solve(description, goalAt(description, q));
      const here = families.filter((family) => apart([family.q[0]], [q[0]]) < 1e-6);
      expect(here).toHaveLength(count);
      expect(here[0]).toMatchObject({ kind: 'wrist', joints: [1, 2, 3, 5] });
      expect(worstMiss(description, placesOf(families), q)).toBeLessThan(1e-13);
      // the other shoulder has the wrist bent
      expect(nearest(postures, q)).toBeGreaterThan(1e-3);
      expect(worstMiss(description, postures, q)).toBeLessThan(1e-13);
    }
  });
  test('every such pose has a family, and its posture meets the pose', () => {
    const random = createRandom(SEED);
    for (let k = 0; k < runs(50); k++) {
      const q = Array.from({ length: 6 }, () => (random() - 0.5) * TURN);
      q[4] = k % 2 === 0 ? 0 : Math.PI;
      const { families } = solve(description, goalAt(description, q));
      expect(families.length).toBeGreaterThan(0);
      expect(
        nearest(
          families.map((family) => Float64Array.of(family.q[0], family.q[4])),
          [q[0], q[4]],
        ),
      ).toBeLessThan(1e-7);
      expect(worstMiss(description, placesOf(families), q)).toBeLessThan(1e-9);
    }
  });
  test('uncut by distance, only two joints move; cut on both sides, there are two pieces', () => {
    const onAxis4 = universal([0.089159, -0.425, -0.39225, 0.10915, 0, 0.0823]);
    const q = [0.3, -1.2, 1.5, 0.4, 0, 0.2];
    const { families } = solve(onAxis4, goalAt(onAxis4, q));
    expect(families.filter((family) => apart([family.q[0]], [q[0]]) < 1e-6).map(({ joints }) => joints)).toEqual([
      [3, 5],
      [3, 5],
    ]);
    // c as far from axis 2 as from axis 4, and farther from both than the straight arm is half long
    const long = universal([0.089159, -0.425, -0.39225, 0.10915, 0.42, 0.0823]);
    const toAxis2 = (/** @type {number} */ q4) => {
      const { frames } = oracleForward(long, [0, -1.2, 1.2, q4, 0, 0.2]);
      return Math.hypot(frames[5][0][3], frames[5][2][3] - 0.089159);
    };
    const q4 = Array.from({ length: 1000 }, (_, i) => i * 0.006).find(
      (value) => Math.abs(toAxis2(value) - 0.42) < 0.005,
    );
    const cut = [0, -1.2, 1.2, q4 ?? NaN, 0, 0.2];
    const pieces = solve(long, goalAt(long, cut)).families.filter((family) => apart([family.q[0]], [0]) < 1e-6);
    expect(pieces).toHaveLength(2);
    expect(Math.sign(pieces[0].q[2])).toBe(Math.sign(pieces[1].q[2]));
    expect(worstMiss(long, placesOf(pieces), cut)).toBeLessThan(1e-13);
  });
  test('the same at the other end of the chain has another name', () => {
    const { joints } = ARMS.ur5;
    const links = joints.slice(0, 5).toReversed();
    const turned = {
      convention: /** @type {const} */ ('standard'),
      joints: joints.map((row, i) => ({ ...row, ...links[i], d: 0.1, ...(i === 5 ? { a: 0, alpha: 0 } : {}) })),
    };
    const { families } = solve(turned, goalAt(turned, [0.2, 0, 0.4, -1.5, 1.2, -0.3]));
    expect(families.length).toBeGreaterThan(0);
    for (const { kind, joints: free } of families) expect([kind, free]).toEqual(['other', [0, 2, 3, 4]]);
  });
});

describe('shoulder', () => {
  /** UR5 without its shoulder offset: the wrist can come to stand on axis 1. */
  const centred = universal([0.089159, -0.425, -0.39225, 0, 0.09465, 0.0823]);

  /**
   * A posture with the point where axes 5 and 6 meet (in a standard table frame 5 stands there) as near to axis 1 as it gets.
   * @param {ChainDescription} description
   */
  function folded(description) {
    const q = [0.2, -1.2, 0, 0.3, 0.7, 0.4];
    const along = (/** @type {number} */ q3) => {
      const [x, y] = oracleForward(description, q.with(2, q3)).frames[5];
      return x[3] * Math.cos(q[0]) + y[3] * Math.sin(q[0]);
    };
    let [low, high] = [0, Math.PI];
    for (let k = 0; k < 60; k++) {
      const middle = (low + high) / 2;
      if (along(low) * along(middle) <= 0) high = middle;
      else low = middle;
    }
    expect(Math.abs(along(low))).toBeLessThan(1e-12);
    return q.with(2, low);
  }

  test('a wrist on axis 1 leaves q1 free where nothing tells its side', () => {
    const q = folded(centred);
    const { postures, families } = solve(centred, goalAt(centred, q));
    expect(postures).toEqual([]);
    expect(families.length).toBeGreaterThan(1);
    expect(families.every(({ kind }) => kind === 'shoulder')).toBe(true);
    expect(worstMiss(centred, placesOf(families), q)).toBeLessThan(1e-12);
    const near = solve(centred, goalAt(centred, q.with(2, q[2] + 1e-6)));
    expect(near.families).toEqual([]);
    expect(nearest(near.postures, q)).toBeLessThan(2e-6);
  });
  test('with an offset there is no such pose: on its edge the two values of q1 are one', () => {
    const q = folded(ARMS.ur5);
    const { postures, families } = solve(ARMS.ur5, goalAt(ARMS.ur5, q));
    expect(families).toEqual([]);
    expect(nearest(postures, q)).toBeLessThan(1e-6);
    expect(leastApart(postures)).toBeGreaterThan(1e-3);
  });
});

describe('any arm with three parallel axes and two that meet', () => {
  test('is solved: its posture is among the solutions, and each of them meets the pose', () => {
    fc.assert(
      fc.property(anyThreeParallel, ({ description, q }) => {
        const { postures, families, isComplete } = solve(description, goalAt(description, q));
        const size = sizeOf(description);
        const all = [...postures, ...placesOf(families)];
        expect(all.length).toBeGreaterThan(0);
        expect(all.length).toBeLessThanOrEqual(24);
        expect(all.flatMap((p) => Array.from(p)).every(Number.isFinite)).toBe(true);
        expect(worstMiss(description, all, q)).toBeLessThan(1e-9 * size);
        if (families.length > 0) return;
        expect(isComplete).toBe(true);
        // Where solutions meet, at two singularities at once, a quarter of the digits is left: to be polished.
        expect(nearest(postures, q)).toBeLessThan(leastApart(postures) > 0.1 ? 1e-5 : 5e-3);
      }),
      { seed: SEED, numRuns: runs(200) },
    );
  });
  test('the same arm on another base has the same solutions', () => {
    fc.assert(
      fc.property(anyThreeParallel, anyPose, ({ description, q }, base) => {
        const moved = { ...description, base };
        const here = solve(description, goalAt(description, q));
        const there = solve(moved, goalAt(moved, q));
        fc.pre(here.families.length === 0 && Math.min(leastApart(here.postures), leastApart(there.postures)) > 1e-3);
        for (const p of here.postures) expect(nearest(there.postures, p)).toBeLessThan(1e-6);
        expect(there.postures).toHaveLength(here.postures.length);
      }),
      { seed: SEED, numRuns: runs(50) },
    );
  });
});

describe('what is not such an arm is left to others', () => {
  const { joints } = arm('ur5');
  const changed = (/** @type {number} */ i, /** @type {object} */ change) =>
    recogniseThreeParallel(
      screwsOf(
        createChain({
          convention: 'standard',
          joints: joints.map((row, k) => (k === i ? { ...row, ...change } : row)),
        }),
      ),
    );
  test.each(
    /** @type {[string, number, object][]} */ ([
      ['axes 3 and 4 a little apart', 2, { alpha: 1e-6 }],
      ['axes 5 and 6 that pass each other', 4, { a: 1e-6 }],
      ['axes 5 and 6 in line', 4, { alpha: 0 }],
      ['a fourth parallel axis', 0, { alpha: 0 }],
      ['axes 2 and 3 that are one', 1, { a: 0 }],
      ['a sliding joint', 2, { type: 'prismatic' }],
    ]),
  )('%s', (_, i, change) => {
    expect(changed(i, change)).toBeNull();
  });
  test('an arm without any length', () => {
    const pointLike = joints.map((row) => ({ ...row, a: 0, d: 0 }));
    expect(recogniseThreeParallel(screwsOf(createChain({ convention: 'standard', joints: pointLike })))).toBeNull();
  });
  test.each(/** @type {const} */ (['puma560', 'scara_cobra600', 'planar2r']))('%s', (name) => {
    expect(recogniseThreeParallel(screwsOf(createChain(arm(name))))).toBeNull();
  });
});

describe('halfAngle', () => {
  test('keeps the digits of angles that an arccosine would lose', () => {
    for (const small of [1e-3, 1e-5, 1e-7]) {
      const [a, b] = [Math.sin(small / 2), Math.cos(small / 2)];
      expect(halfAngle(a, a, b, b, 1) / small).toBeCloseTo(1, 8);
    }
  });
});
