import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { allInverseKinematics } from '../../../src/kinematics/allInverse.js';
import { createChain } from '../../../src/kinematics/chain.js';
import { SEED, runs } from '../../helpers/property.js';
import { angleBetween, columnMajor, distanceBetween, oracleForward, rigid, rodrigues } from './oracle.js';
import { publishedArm as arm } from './publishedArms.js';
import { isUntold } from './untold.js';

/** @import { ChainDescription } from '../../../src/kinematics/chain.js' */
/** @import { AllInverseOptions, AllSolutions } from '../../../src/kinematics/allInverse.js' */
/** @import { Matrix } from './oracle.js' */

/** The arms of the library whose list of solutions is proven, and how many there are at a generic pose at the most. @type {[string, number][]} */
const ARMS = [
  ['puma560', 8],
  ['ur3', 8],
  ['ur5', 8],
  ['ur10', 8],
  ['stanford', 8],
  ['kuka_kr6_r900', 8],
  ['kuka_kr5_arc', 8],
  ['kuka_kr210_l150', 8],
  ['fanuc_lrmate200id', 8],
  ['fanuc_m10ia', 8],
  ['abb_irb120', 8],
  ['abb_irb140', 8],
  ['mitsubishi_rv2aj', 4],
  ['kuka_youbot', 4],
  ['scara_cobra600', 2],
  ['planar2r', 1],
  ['planar3r', 2],
  ['cyl_rpp', 1],
  ['polar_rrp', 2],
  ['cart_ppp', 1],
];
const BENT = /** @type {const} */ (['kinova_mico', 'kinova_jaco']);

/** The angle by which two joint values differ, full turns aside. @param {number} a @param {number} b */
const turnsApart = (a, b) => Math.abs(Math.atan2(Math.sin(a - b), Math.cos(a - b)));

/** @param {ChainDescription} description @param {ArrayLike<number>} a @param {ArrayLike<number>} b */
const apart = ({ joints }, a, b) =>
  Math.max(...joints.map(({ type }, i) => (type === 'prismatic' ? Math.abs(a[i] - b[i]) : turnsApart(a[i], b[i]))));

/**
 * Whether a list has a posture: to six digits; or, next to a singularity, one that the pose does not tell from it: the straight
 * way to it never leaves the pose by more than 1e-8, or a bent one not even in the last digit.
 * @param {ChainDescription} description @param {AllSolutions} all @param {number[]} q
 */
const has = (description, { solutions }, q) =>
  solutions.some((solution) => {
    if (apart(description, solution.q, q) < 1e-6 || isUntold(description, q, [...solution.q])) return true;
    const goal = oracleForward(description, q).tcp;
    return [0.25, 0.5, 0.75].every((part) => {
      const between = q.map((value, i) => {
        const way = solution.q[i] - value;
        return (
          value + part * (description.joints[i].type === 'prismatic' ? way : Math.atan2(Math.sin(way), Math.cos(way)))
        );
      });
      const { tcp } = oracleForward(description, between);
      return distanceBetween(tcp, goal) < 1e-8 && angleBetween(tcp, goal) < 1e-8;
    });
  });

/** What every list owes. @param {ChainDescription} description @param {Matrix} goal @param {AllSolutions} all */
function expectTrue(description, goal, { solutions }) {
  for (const { q, withinLimits, positionError, orientationError, limitMargin } of solutions) {
    const { tcp } = oracleForward(description, q);
    expect(distanceBetween(tcp, goal)).toBeLessThan(1e-9);
    expect(angleBetween(tcp, goal)).toBeLessThan(1e-9);
    expect(Math.abs(positionError - distanceBetween(tcp, goal))).toBeLessThan(1e-12);
    expect(Math.abs(orientationError - angleBetween(tcp, goal))).toBeLessThan(1e-12);
    const isInside = description.joints.every(
      ({ lower = -Infinity, upper = Infinity }, i) => q[i] >= lower && q[i] <= upper,
    );
    expect(withinLimits).toBe(isInside);
    if (limitMargin) expect(limitMargin.share >= 0).toBe(isInside);
  }
  solutions.forEach(({ q }, i) => {
    for (const { q: other } of solutions.slice(0, i)) expect(apart(description, q, other)).toBeGreaterThan(1e-8);
  });
}

/** Any posture of an arm, limits and all. @param {ChainDescription} description */
const anyPosture = ({ joints }) =>
  fc.tuple(
    ...joints.map(({ type, lower, upper }) =>
      type === 'prismatic'
        ? fc.double({ min: lower ?? -1, max: upper ?? 1, noNaN: true })
        : fc.double({ min: -Math.PI, max: Math.PI, noNaN: true }),
    ),
  );

/** @param {ChainDescription} description @param {ArrayLike<number>} q @param {AllInverseOptions} [options] */
function solve(description, q, options) {
  const goal = oracleForward(description, q).tcp;
  const all = allInverseKinematics(createChain(description), columnMajor(goal), options);
  expectTrue(description, goal, all);
  return all;
}

describe('all solutions', () => {
  test.each(ARMS)('of %s: the posture that made the pose is among at most %i, all true', (name, most) => {
    const description = arm(name);
    const chain = createChain(description);
    fc.assert(
      fc.property(anyPosture(description), (q) => {
        const goal = oracleForward(description, q).tcp;
        const all = allInverseKinematics(chain, columnMajor(goal));
        expectTrue(description, goal, all);
        expect(all.complete).toBe(true);
        expect(all.solutions.length).toBeLessThanOrEqual(most);
        if (all.families.length === 0) expect(has(description, all, q)).toBe(true);
      }),
      { seed: SEED, numRuns: runs(40) },
    );
  });
  test.each(BENT)(
    'of %s, whose wrist is bent: the posture that made the pose is among at most 16, all true',
    (name) => {
      const description = arm(name);
      const chain = createChain(description);
      fc.assert(
        fc.property(anyPosture(description), (q) => {
          const goal = oracleForward(description, q).tcp;
          const all = allInverseKinematics(chain, columnMajor(goal));
          expectTrue(description, goal, all);
          expect(all.solutions.length).toBeLessThanOrEqual(16);
          if (all.families.length === 0) expect(has(description, all, q)).toBe(true);
        }),
        { seed: SEED, numRuns: runs(15) },
      );
    },
  );
  test('next to several singularities at once, where elimination loses a posture, a search finds it', () => {
    const description = arm('kinova_mico');
    const q = [0, 0, 0, 0.013549542610312338, 0, 0];
    const all = solve(description, q);
    expect(all.complete).toBe(false);
    expect(has(description, all, q)).toBe(true);
  });
  test('where the shoulder is within rounding of a singularity, the bend of the wrist is known no better', () => {
    // Joint 2 at −ε and at ε make the same pose but for d₃²ε²/2b = 3e-16 m, so both stand in the list as one, at 0, and the wrist
    // makes up for it, bent by ε. But the posture that made the pose has the wrist in line: its outer axes turn as they like,
    // and where they stand a quarter turn off, a straight way leads to the one in the list.
    const description = arm('stanford');
    const q = [0, -2.6e-8, 0.3048, 0, 0, 7e-10];
    const all = solve(description, q);
    expect(has(description, all, q)).toBe(true);
    for (const told of [q.with(1, -1e-5), q.with(4, 1e-5), q.with(2, 0.3049)]) {
      const others = all.solutions.filter((solution) => isUntold(description, told, [...solution.q]));
      expect(others).toEqual([]);
    }
    const far = { ...all, solutions: all.solutions.filter(({ q: other }) => other[2] < 0) };
    expect([far.solutions.length, has(description, far, q)]).toEqual([2, false]);
  });
  test('a generic pose of a Puma 560 has eight, each with another name', () => {
    const { solutions } = solve(arm('puma560'), [0.4, 0.9, -2.2, 0.5, 0.7, -1]);
    expect(solutions.length).toBe(8);
    const names = solutions.map(({ name }) => `${name.shoulder} ${name.elbow} ${name.wrist}`);
    expect(new Set(names).size).toBe(8);
    expect(solutions.every(({ fanuc }) => /^[NF] [UD] [TB], -?\d+, -?\d+, -?\d+$/.test(fanuc.text ?? ''))).toBe(true);
    expect(solutions.every(({ kuka }) => Number.isInteger(kuka.status) && Number.isInteger(kuka.turn))).toBe(true);
  });
  test('a wrist in line is a family by name, not a heap of points', () => {
    const { solutions, families, complete } = solve(arm('puma560'), [0.4, 0.9, -2.2, 0.5, 0, -1]);
    expect(complete).toBe(true);
    expect(families.some(({ kind, joints }) => kind === 'wrist' && joints.includes(3) && joints.includes(5))).toBe(
      true,
    );
    expect(solutions.length).toBeLessThanOrEqual(6);
  });
  test('next to a singularity none is lost and none doubled', () => {
    for (const [name, joint] of /** @type {const} */ ([
      ['puma560', 4],
      ['ur5', 4],
      ['stanford', 4],
      ['kuka_kr6_r900', 4],
    ])) {
      for (const off of [1e-3, 1e-5, 1e-6, -1e-6, 1e-7]) {
        const q = [0.4, name === 'ur5' ? -0.9 : 0.9, name === 'stanford' ? 0.4 : -1.2, 0.5, 0.7, -1];
        const generic = solve(arm(name), q).solutions.length;
        q[joint] = off;
        const { solutions, families } = solve(arm(name), q);
        expect([name, off, families.length]).toEqual([name, off, 0]);
        expect(solutions.length % 2).toBe(0);
        expect(Math.abs(solutions.length - generic)).toBeLessThanOrEqual(4);
        expect(Math.min(...solutions.map((solution) => apart(arm(name), solution.q, q)))).toBeLessThan(1e-6);
      }
    }
  });
  test('a pose out of reach has none, and that is proven', () => {
    const goal = columnMajor(rigid(rodrigues([1, 2, 3], 1), [50, 0, 0]));
    for (const [name] of ARMS) {
      if (arm(name).joints.some(({ type }) => type === 'prismatic')) continue; // without its limits a slide goes anywhere
      expect(allInverseKinematics(createChain(arm(name)), goal)).toMatchObject({
        solutions: [],
        families: [],
        complete: true,
      });
    }
  });
});

describe('limits, full turns and order', () => {
  test('limits are ignored unless asked for, and full turns are taken so that a solution is inside if it can be', () => {
    const description = arm('puma560');
    const q = [0.4, 0.9, -2.2, 0.5, 0.7, -1];
    const turned = {
      ...description,
      joints: description.joints.map((row, i) => (i === 5 ? { ...row, lower: 4, upper: 7 } : row)),
    };
    const { solutions } = solve(turned, q);
    const same = solutions.find((solution) => apart(turned, solution.q, q) < 1e-6);
    expect(same?.q[5]).toBeCloseTo(-1 + 2 * Math.PI, 8);
    const inside = solve(turned, q, { onlyWithinLimits: true }).solutions;
    expect(inside.length).toBeGreaterThan(0);
    expect(inside.length).toBe(solutions.filter(({ withinLimits }) => withinLimits).length);
    expect(inside.length).toBeLessThan(solutions.length);
  });
  test('a margin is the least room to a limit, as a share of half the range', () => {
    const { solutions } = solve(arm('planar2r'), [0.5, 1]);
    const [{ limitMargin }] = solutions;
    expect(limitMargin?.joint).toBe(1);
    expect(limitMargin?.room).toBeCloseTo(Math.PI - 1, 9);
    expect(limitMargin?.share).toBeCloseTo((Math.PI - 1) / Math.PI, 9);
  });
  test('with a seed the nearest comes first, and full turns are taken towards it', () => {
    const description = arm('ur5');
    const seed = [0.4 - 2 * Math.PI, -0.9, 1.2, 0.5, 0.7, -1];
    const { solutions } = solve(description, [0.4, -0.9, 1.2, 0.5, 0.7, -1], { seed });
    expect([...solutions[0].q].map((value, i) => value - seed[i])).toEqual(seed.map(() => expect.closeTo(0, 8)));
    const ways = solutions.map(({ q }) => Math.hypot(...q.map((value, i) => value - seed[i])));
    expect(ways).toEqual([...ways].sort((a, b) => a - b));
  });
});

describe('an arm that no solver knows', () => {
  /** Six joints, one of them a slide, and no three axes that meet. @type {ChainDescription} */
  const odd = {
    convention: 'standard',
    joints: [
      { type: 'revolute', a: 0.1, alpha: 1.1, d: 0.3, theta: 0 },
      { type: 'revolute', a: 0.4, alpha: 0.4, d: 0.1, theta: 0 },
      { type: 'prismatic', a: 0.05, alpha: 1.3, d: 0.3, theta: 0.2, lower: -0.5, upper: 0.5 },
      { type: 'revolute', a: 0.1, alpha: -1.2, d: 0.2, theta: 0 },
      { type: 'revolute', a: 0.08, alpha: 0.9, d: 0.1, theta: 0 },
      { type: 'revolute', a: 0.03, alpha: 0.3, d: 0.1, theta: 0 },
    ],
  };
  test('is searched; what is found is true, and never called complete', () => {
    const all = solve(odd, [0.2, 0.5, 0.1, -0.7, 1, 0.4]);
    expect(Math.min(...all.solutions.map(({ q }) => apart(odd, q, [0.2, 0.5, 0.1, -0.7, 1, 0.4])))).toBeLessThan(1e-6);
    if (all.method === 'search') expect(all.complete).toBe(false);
    expect(solve(odd, [0.2, 0.5, 0.1, -0.7, 1, 0.4])).toEqual(all);
  });
  test('four parallel axes in a plane have one motion too many: a family', () => {
    const link = { type: /** @type {const} */ ('revolute'), a: 0.3, alpha: 0, d: 0, theta: 0 };
    const snake = { convention: /** @type {const} */ ('standard'), joints: [link, link, link, link] };
    const { families, complete, solutions } = solve(snake, [0.3, 0.5, -0.4, 0.8]);
    expect(families.length).toBeGreaterThan(0);
    expect(families[0].joints.length).toBeGreaterThan(2);
    expect(solutions.length).toBe(0);
    expect(complete && solutions.length > 0).toBe(false);
  });
});

test('wrong calls say what was expected', () => {
  const chain = createChain(arm('planar2r'));
  const goal = columnMajor(rigid(rodrigues([0, 0, 1], 0), [1, 0, 0]));
  expect(() => allInverseKinematics(chain, new Float64Array(15))).toThrow(/16/);
  expect(() => allInverseKinematics(chain, goal, { seed: [0] })).toThrow('Expected 2 joint values, got 1.');
  expect(() => allInverseKinematics(chain, goal, { positionTolerance: 0 })).toThrow(/positive/);
  expect(() => allInverseKinematics(chain, goal, { randomSeed: 0.5 })).toThrow(/whole number/);
});
