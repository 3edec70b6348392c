import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { createChain } from '../../../src/kinematics/chain.js';
import { recogniseGeneralSix, solveGeneralSix } from '../../../src/kinematics/solvers/general/generalSix.js';
import { createRandom } from '../../../src/kinematics/random.js';
import { goalFromStart, screwsOf } from '../../../src/kinematics/screws.js';
import { SEED, runs } from '../../helpers/property.js';
import {
  angleBetween,
  columnMajor,
  distanceBetween,
  fromLine,
  oracleForward,
  rigid,
  rodrigues,
  sizeOf,
} from './oracle.js';
import { fixture, poseOf, publishedArm, publishedInverse } from './publishedArms.js';
import { differenceOf, searchAll, turnsApart } from './searchAll.js';

/** @import { ChainDescription } from '../../../src/kinematics/chain.js' */
/** @import { Candidates } from '../../../src/kinematics/solvers/candidates.js' */
/** @import { Matrix } from './oracle.js' */

/** @param {ChainDescription} description */
function solverOf(description) {
  const chain = createChain(description);
  const constants = recogniseGeneralSix(screwsOf(chain));
  if (!constants) throw new Error('Expected the arm to be recognised.');
  return (/** @type {Matrix} */ goal) => solveGeneralSix(constants, goalFromStart(chain, columnMajor(goal)));
}

/** @param {ChainDescription} description @param {ArrayLike<number>} a @param {ArrayLike<number>} b */
const apart = ({ joints }, a, b) =>
  Math.max(...joints.map(({ type }, i) => (type === 'prismatic' ? Math.abs(a[i] - b[i]) : turnsApart(a[i], b[i]))));

/** Each posture is there, and no other. @param {ChainDescription} description @param {Matrix} goal @param {Candidates} found */
function expectTrue(description, goal, { postures }, nearest = 1e-8) {
  for (const q of postures) {
    const { tcp } = oracleForward(description, q);
    expect(distanceBetween(tcp, goal)).toBeLessThan(1e-9 * sizeOf(description));
    expect(angleBetween(tcp, goal)).toBeLessThan(1e-9);
  }
  postures.forEach((q, i) => {
    for (const other of postures.slice(0, i)) expect(apart(description, q, other)).toBeGreaterThan(nearest);
  });
}

/** @param {ChainDescription} description @param {Candidates} found @param {ArrayLike<number>} q */
const wayTo = (description, { postures }, q) => Math.min(...postures.map((other) => apart(description, q, other)));

const away = (/** @type {number} */ min, /** @type {number} */ max) =>
  fc.tuple(fc.double({ min, max, noNaN: true }), fc.boolean()).map(([size, isNegative]) => (isNegative ? -size : size));
const turning = { type: fc.constant(/** @type {const} */ ('revolute')), theta: away(0, 3) };
/** Nothing special about it: no axes parallel, or meeting. */
const anyRow = fc.record({ ...turning, a: away(0.1, 1), alpha: away(0.3, 2.8), d: away(0.1, 1) });
/** Axes that meet, or are square to each other, or both; never two in line. */
const specialRow = fc.record({
  ...turning,
  a: fc.constantFrom(0, 0, 0.1, 0.5),
  alpha: fc.constantFrom(Math.PI / 2, -Math.PI / 2, 1, -0.6),
  d: fc.constantFrom(0, 0.1, -0.4),
});
/** @param {fc.Arbitrary<ChainDescription['joints'][number]>} row @param {number} count */
const armOf = (row, count) =>
  fc.record({
    description: fc.record({
      convention: fc.constantFrom(/** @type {const} */ ('standard'), 'modified'),
      joints: fc.array(row, { minLength: count, maxLength: count }),
    }),
    q: fc.array(fc.double({ min: -3, max: 3, noNaN: true }), { minLength: count, maxLength: count }),
  });

const BENT = ['kinova_mico', 'kinova_jaco'];
const {
  joints: manseurRows,
  pose: manseurPose,
  postures: manseurPostures,
} = /** @type {{ joints: number[][], pose: number[], postures: number[][] }} */ (fixture('manseur16.json'));
/** @type {ChainDescription} */
const manseur = {
  convention: 'standard',
  joints: manseurRows.map(([a, alpha, d]) => ({ type: 'revolute', a, alpha, d, theta: 0 })),
};

describe('an arm of six turning joints', () => {
  test('of any geometry gets the posture back that made the pose, and hardly ever doubts that the list is whole', () => {
    let [poses, doubts] = [0, 0];
    fc.assert(
      fc.property(armOf(anyRow, 6), ({ description, q }) => {
        const goal = oracleForward(description, q).tcp;
        const found = solverOf(description)(goal);
        expectTrue(description, goal, found);
        expect(wayTo(description, found, q)).toBeLessThan(1e-4); // it may be next to a singularity
        poses++;
        if (!found.isComplete) doubts++;
      }),
      { seed: SEED, numRuns: runs(15) },
    );
    expect(doubts).toBeLessThanOrEqual(poses / 50);
  });
  test('whose axes meet or are square to each other never claims to know them all while one is missing', () => {
    fc.assert(
      fc.property(armOf(specialRow, 6), ({ description, q }) => {
        const chain = createChain(description);
        const constants = recogniseGeneralSix(screwsOf(chain));
        if (!constants) return; // three axes in one point or plane, and so on: for the closed forms, or redundant
        const goal = oracleForward(description, q).tcp;
        const found = solveGeneralSix(constants, goalFromStart(chain, columnMajor(goal)));
        expectTrue(description, goal, found);
        if (found.isComplete) expect(wayTo(description, found, q)).toBeLessThan(1e-4);
      }),
      { seed: SEED, numRuns: runs(12) },
    );
  });
  test.each(BENT)('%s: each of the published poses, without a doubt', (name) => {
    const description = publishedArm(name);
    const solve = solverOf(description);
    let count = 0;
    const postures = publishedInverse(name).postures.slice(0, runs(60));
    for (const q of postures) {
      const goal = poseOf(name, q);
      const found = solve(goal);
      expectTrue(description, goal, found);
      expect(wayTo(description, found, q)).toBeLessThan(1e-9);
      expect(found.isComplete).toBe(true);
      expect(found.postures.length % 2).toBe(0);
      count += found.postures.length;
    }
    expect(count / postures.length).toBeGreaterThan(6);
  });
  test.each(BENT)('%s: every posture that two long searches found, and no other', (name) => {
    const { arms } = /** @type {{ arms: Record<string, number[][]> }} */ (fixture('solutionCounts.json'));
    const description = publishedArm(name);
    const solve = solverOf(description);
    for (const line of arms[name]) {
      const found = solve(poseOf(name, line.slice(0, 6)));
      expect(found.postures.length).toBe(line.length / 6 - 1);
      for (let i = 6; i < line.length; i += 6) {
        expect(wayTo(description, found, line.slice(i, i + 6))).toBeLessThan(1e-6);
      }
    }
  });
  test.each(BENT)('%s: where axes 1 and 6 are parallel, as for a tool that points down', (name) => {
    const description = publishedArm(name);
    const solve = solverOf(description);
    const random = createRandom(SEED);
    let doubts = 0;
    for (let k = 0; k < 20; k++) {
      const down = rigid(
        [
          [1, 0, 0],
          [0, -1, 0],
          [0, 0, -1],
        ],
        [0.2 + 0.2 * random(), 0.3 * random() - 0.15, 0.3 * random()],
      );
      const found = solve(down);
      expectTrue(description, down, found);
      expect(found.postures.length % 2).toBe(0);
      if (!found.isComplete) doubts++;
    }
    expect(doubts).toBeLessThanOrEqual(2);
  });
  test.each(BENT)('%s: next to a singularity', (name) => {
    const description = publishedArm(name);
    const solve = solverOf(description);
    for (const q of publishedInverse(name).nearSingularPostures ?? []) {
      const goal = poseOf(name, q);
      const found = solve(goal);
      expectTrue(description, goal, found);
      expect(wayTo(description, found, q)).toBeLessThan(1e-6);
      expect(found.isComplete).toBe(true);
    }
  });
  test.each(BENT)('%s: none for a pose that is out of reach, and that is certain', (name) => {
    const solve = solverOf(publishedArm(name));
    for (const [x, y, z] of [
      [3, 0, 0],
      [0, -1, 2],
      [0.9, 0.9, 0.9],
    ]) {
      expect(solve(rigid(rodrigues([1, 2, 3], 1), [x, y, z]))).toEqual({
        postures: [],
        families: [],
        isComplete: true,
      });
    }
  });
  test('the arm of Manseur and Doty has its sixteen', () => {
    const goal = fromLine(manseurPose);
    const found = solverOf(manseur)(goal);
    expectTrue(manseur, goal, found);
    expect(found.postures.length).toBe(16);
    expect(found.isComplete).toBe(true);
    for (const q of manseurPostures) expect(wayTo(manseur, found, q)).toBeLessThan(3e-9);
  });
  test('solutions that share the angle of the hidden joint are all found', () => {
    const chain = createChain(manseur);
    const constants = recogniseGeneralSix(screwsOf(chain));
    // All of these postures come in pairs with the same angles of joints 1 and 2.
    const sharing = (constants?.eliminations ?? []).filter(({ hidden }) => hidden < 2);
    expect(sharing.length).toBeGreaterThan(0);
    for (const elimination of sharing) {
      const alone = { ...constants, eliminations: [elimination] };
      const goal = goalFromStart(chain, columnMajor(fromLine(manseurPose)));
      expect(solveGeneralSix(/** @type {NonNullable<typeof constants>} */ (alone), goal).postures.length).toBe(16);
    }
  });
  test('an independent search finds nothing else', () => {
    for (const [name, seed] of /** @type {const} */ ([
      ['kinova_mico', 1],
      ['', 2],
    ])) {
      for (let k = 0; k < 1; k++) {
        const random = createRandom(seed + 100 * k);
        const between = (/** @type {number} */ low, /** @type {number} */ high) => low + (high - low) * random();
        /** @type {ChainDescription} */
        const description = name
          ? publishedArm(name)
          : {
              convention: 'standard',
              joints: Array.from({ length: 6 }, () => ({
                type: /** @type {const} */ ('revolute'),
                a: between(-1, 1),
                alpha: between(-3, 3),
                d: between(-1, 1),
                theta: 0,
              })),
            };
        const goal = oracleForward(
          description,
          Array.from({ length: 6 }, () => between(-3, 3)),
        ).tcp;
        const found = solverOf(description)(goal);
        const searched = searchAll(description, goal, runs(30), random);
        expect(searched.length).toBeGreaterThan(0);
        for (const q of searched) expect(wayTo(description, found, q)).toBeLessThan(1e-6);
        expect(found.postures.length).toBeGreaterThanOrEqual(searched.length);
      }
    }
  });
  test('the same solutions whatever the unit of length', () => {
    const [q] = publishedInverse('kinova_mico').postures;
    const inMetres = solverOf(publishedArm('kinova_mico'))(poseOf('kinova_mico', q));
    for (const scale of [1e-3, 1e3]) {
      const description = publishedArm('kinova_mico', scale);
      const scaled = solverOf(description)(oracleForward(description, q).tcp);
      expect(scaled.postures.length).toBe(inMetres.postures.length);
      for (const other of inMetres.postures) expect(wayTo(description, scaled, other)).toBeLessThan(1e-9);
    }
  });
});

describe('next to a singularity', () => {
  /** Joint by joint, a posture where the Jacobian's determinant is zero. @param {ChainDescription} description @param {number[]} q @param {number} joint */
  function singularNear(description, q, joint) {
    const at = (/** @type {number} */ value) => {
      const posture = q.with(joint, value);
      const J = differenceOf(description, posture);
      return determinant(J);
    };
    let low = q[joint];
    const sign = Math.sign(at(low));
    let high = low;
    while (high < low + 7 && Math.sign(at(high)) === sign) high += 0.2;
    if (high >= low + 7) return null;
    low = high - 0.2;
    for (let k = 0; k < 45; k++) {
      const middle = (low + high) / 2;
      if (Math.sign(at(middle)) === sign) low = middle;
      else high = middle;
    }
    return low;
  }
  /** @param {Matrix} rows @returns {number} */
  function determinant(rows) {
    const [[first, ...others], ...below] = rows
      .toSorted((a, b) => Math.abs(b[0]) - Math.abs(a[0]))
      .map((row) => [...row]);
    if (below.length === 0) return first;
    const rest = below.map(([lead, ...row]) => row.map((value, j) => value - (lead / first) * others[j]));
    // the sign changes with the order of the rows, which sorting does not tell: count the inversions
    const order = rows.map((_, i) => i).toSorted((a, b) => Math.abs(rows[b][0]) - Math.abs(rows[a][0]));
    const inversions = order.reduce((sum, a, i) => sum + order.slice(i + 1).filter((b) => b < a).length, 0);
    return (inversions % 2 ? -1 : 1) * first * determinant(rest);
  }
  test.each([1e-6, 1e-4])('by %d, both postures are found, and each once', (way) => {
    const random = createRandom(SEED);
    const description = publishedArm('kinova_jaco');
    const solve = solverOf(description);
    let tried = 0;
    while (tried < runs(3)) {
      const start = Array.from({ length: 6 }, () => 6 * random() - 3);
      const joint = 1 + Math.floor(4 * random());
      const singular = singularNear(description, start, joint);
      if (singular === null) continue;
      tried++;
      const q = start.with(joint, singular + way);
      const goal = oracleForward(description, q).tcp;
      const found = solve(goal);
      expectTrue(description, goal, found);
      expect(wayTo(description, found, q)).toBeLessThan(way / 2);
    }
  });
  // Newton's method rests half-way between these and their mirrors, 3e-5 from either, where the loop is open by 1e-12: a list
  // that took the place for a solution was a solution short, and called itself complete.
  test.each([
    [[2.9667975241318345, 0.08081508474424481, -0.01622316260379415, -2.6507631498388946, 0.011682281736284494, 0.79]],
    [[-0.4637439544312656, 1.3174687391147017, 2.719028470572084, 0.9450132558122277, 0.17979596799773048, 1.6]],
  ])('the place between two solutions is not listed in the place of one: %j', (q) => {
    const description = publishedArm('kinova_jaco');
    const goal = oracleForward(description, q).tcp;
    const found = solverOf(description)(goal);
    expectTrue(description, goal, found);
    expect(found.isComplete).toBe(true);
    expect(wayTo(description, found, q)).toBeLessThan(5e-7);
    for (const other of found.postures) {
      expect(distanceBetween(oracleForward(description, other).tcp, goal)).toBeLessThan(1e-13);
    }
  });
});

describe('other arms', () => {
  test('a slide among six joints, anywhere', () => {
    for (let slide = 0; slide < 6; slide++) {
      const random = createRandom(slide + 1);
      const any = (/** @type {number} */ size) => (2 * random() - 1) * size;
      /** @type {ChainDescription} */
      const description = {
        convention: 'standard',
        joints: Array.from({ length: 6 }, (_, i) => ({
          type: i === slide ? 'prismatic' : 'revolute',
          a: any(1),
          alpha: any(3),
          d: any(1),
          theta: any(3),
        })),
      };
      const solve = solverOf(description);
      for (let k = 0; k < 5; k++) {
        const q = Array.from({ length: 6 }, () => any(2));
        const goal = oracleForward(description, q).tcp;
        const found = solve(goal);
        expectTrue(description, goal, found);
        expect(wayTo(description, found, q)).toBeLessThan(1e-7);
        expect(found.isComplete).toBe(true);
      }
    }
  });
  test('five joints of any geometry: the posture back, and none for a pose beside what they reach', () => {
    fc.assert(
      fc.property(armOf(anyRow, 5), ({ description, q }) => {
        const goal = oracleForward(description, q).tcp;
        const solve = solverOf(description);
        const found = solve(goal);
        expectTrue(description, goal, found);
        expect(wayTo(description, found, q)).toBeLessThan(1e-4);
        expect(found.postures.every(({ length }) => length === 5)).toBe(true);
        const beside = rigid(
          rodrigues([0.3, -0.5, 0.8], 0.3).map((row) =>
            [0, 1, 2].map((j) => row.reduce((sum, value, k) => sum + value * goal[k][j], 0)),
          ),
          goal.slice(0, 3).map((row) => row[3]),
        );
        for (const other of solve(beside).postures) {
          expect(angleBetween(oracleForward(description, other).tcp, beside)).toBeLessThan(1e-5);
        }
      }),
      { seed: SEED, numRuns: runs(8) },
    );
  });
  test('postures from which the joints can move are named as a family, not listed as points', () => {
    const description = publishedArm('puma560');
    const q = [0.3, 0.5, -0.4, 0.7, 0, 0.2]; // axes 4 and 6 in line
    const goal = oracleForward(description, q).tcp;
    const { postures, families, isComplete } = solverOf(description)(goal);
    expect(isComplete).toBe(false);
    expect(families.map(({ kind, joints }) => [kind, joints])).toContainEqual(['other', [3, 5]]);
    for (const { q: member } of families) {
      expect(distanceBetween(oracleForward(description, member).tcp, goal)).toBeLessThan(1e-9);
    }
    for (const other of postures) expect(Math.abs(Math.sin(other[4]))).toBeGreaterThan(1e-3);
  });
  test('are not recognised with fewer joints, or two in line', () => {
    const joints = publishedArm('kinova_mico').joints;
    const inLine = { ...joints[1], a: 0, alpha: 0 };
    for (const some of [joints.slice(0, 4), [...joints, joints[1]], [joints[0], inLine, ...joints.slice(1, 5)]]) {
      expect(recogniseGeneralSix(screwsOf(createChain({ convention: 'standard', joints: some })))).toBe(null);
    }
  });
});
