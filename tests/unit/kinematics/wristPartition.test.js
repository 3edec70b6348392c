/**
 * All postures of arms with a wrist.
 * @import { ChainDescription } from '../../../src/kinematics/chain.js'
 */
import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { createChain } from '../../../src/kinematics/chain.js';
import { geometricJacobian } from '../../../src/kinematics/jacobian.js';
import { singularValuesOf } from '../../../src/kinematics/measures/homogeneous.js';
import { polish } from '../../../src/kinematics/polish.js';
import { createRandom } from '../../../src/kinematics/random.js';
import { screwsOf } from '../../../src/kinematics/screws.js';
import { recogniseWristPartition } from '../../../src/kinematics/solvers/wristPartition.js';
import { SEED, runs } from '../../helpers/property.js';
import { anyPose, columnMajor, oracleForward } from './oracle.js';
import { RIGHT, anyPartitioned, apart, met, nearest, poseAt, repeats, solve, table, worst } from './partitioned.js';
import { publishedArm } from './publishedArms.js';

const random = createRandom(SEED);
/** @param {ChainDescription} description @param {number} [slide] metres either way */
const anywhere = ({ joints }, slide = 0.5) =>
  joints.map(({ type }) => (2 * random() - 1) * (type === 'revolute' ? Math.PI : slide));

/** How many postures reach a pose that one of them makes: all the counts that occur, the most last. */
const COUNTS = /** @type {const} */ ([
  ['planar2r', [1]],
  ['planar3r', [2]],
  ['scara_cobra600', [2]],
  ['cyl_rpp', [1]],
  ['polar_rrp', [1]],
  ['cart_ppp', [1]],
  ['stanford', [8]],
  ['puma560', [8]],
  ['kuka_kr5_arc', [4, 8]],
  ['kuka_kr6_r900', [4, 8]],
  ['kuka_kr210_l150', [4, 8]],
  ['fanuc_lrmate200id', [4, 8]],
  ['fanuc_m10ia', [4, 8]],
  ['abb_irb140', [4, 8]],
  ['abb_irb120', [8]],
  ['mitsubishi_rv2aj', [4]],
  ['kuka_youbot', [2, 4]],
]);

describe('published arms', () => {
  test.each(COUNTS)('%s: the posture that makes a pose is found, with the others, each once', (name, counts) => {
    const description = publishedArm(name);
    const seen = new Set();
    for (let i = 0; i < runs(8); i++) {
      const q = anywhere(description);
      const found = solve(description, poseAt(description, q));
      expect(nearest(description, found, q)).toBeLessThan(1e-7);
      expect(worst(description, found, q)).toBeLessThan(1e-11);
      expect(repeats(description, found.postures)).toBe(0);
      expect([found.families, found.isComplete]).toEqual([[], true]);
      expect(counts).toContain(found.postures.length);
      seen.add(found.postures.length);
    }
    expect(seen).toContain(counts.at(-1));
  });

  test('arms without a wrist are left to others', () => {
    for (const name of ['ur5', 'kinova_jaco']) {
      expect(recogniseWristPartition(screwsOf(createChain(publishedArm(name))))).toBeNull();
    }
    // A slide, a turn and a slide in one plane: the place leaves one joint open, which the orientation has to decide.
    const planar = table([
      [0, RIGHT, 0, 0, 'slides'],
      [0.3, RIGHT, 0],
      [0, 0, 0, 0, 'slides'],
    ]);
    expect(recogniseWristPartition(screwsOf(createChain(planar)))).toBeNull();
  });

  test('out of reach is proven', () => {
    for (const [name] of COUNTS) {
      if (name === 'cart_ppp' || name === 'cyl_rpp' || name === 'polar_rrp' || name === 'stanford') continue;
      const description = publishedArm(name);
      const far = columnMajor(oracleForward(description, anywhere(description)).tcp);
      far[12] += 20;
      expect(solve(description, far)).toEqual({ postures: [], families: [], isComplete: true });
    }
    const twisted = poseAt(publishedArm('planar2r'), [0.3, 0.4]);
    twisted.set([-twisted[4], -twisted[5], 0, 0, twisted[0], twisted[1], 0, 0]);
    expect(solve(publishedArm('planar2r'), twisted).postures).toEqual([]);
  });

  test('base, tool and convention do not matter', () => {
    const { joints } = publishedArm('kuka_kr5_arc');
    fc.assert(
      fc.property(anyPose, anyPose, fc.constantFrom('standard', 'modified'), (base, tool, convention) => {
        // As a modified table the twists and lengths move down by a row: the same arm but for its first and last link.
        const rows = joints.map((row, i) =>
          convention === 'standard' ? row : { ...row, a: joints[i - 1]?.a ?? 0, alpha: joints[i - 1]?.alpha ?? 0 },
        );
        const description = /** @type {ChainDescription} */ ({ convention, base, tool, joints: rows });
        const q = anywhere(description);
        const found = solve(description, poseAt(description, q));
        expect(nearest(description, found, q)).toBeLessThan(1e-6);
        expect(worst(description, found, q)).toBeLessThan(1e-11);
        expect(found.postures.length % 4).toBe(0);
      }),
      { seed: SEED, numRuns: runs(15) },
    );
  });

  test('the scale of the arm does not matter', () => {
    for (const scale of [1e-3, 1e3]) {
      const description = publishedArm('stanford', scale);
      const q = anywhere(description, 0.5 * scale);
      const found = solve(description, poseAt(description, q));
      expect(found.postures).toHaveLength(8);
      expect(
        Math.min(
          ...found.postures.map((p) =>
            apart(
              description,
              [...p].map((v, i) => (i === 2 ? v / scale : v)),
              q.map((v, i) => (i === 2 ? v / scale : v)),
            ),
          ),
        ),
      ).toBeLessThan(1e-8);
    }
  });
});

describe('any chain that is built to have a wrist', () => {
  const kinds = ['RRR', 'RRP', 'RPR', 'PRR', 'RPP', 'PRP', 'PPR', 'PPP'];
  const structures = [
    ...kinds.flatMap((regional) => [1, 2, 3].map((wrist) => /** @type {const} */ ([regional, wrist]))),
    ...['RR', 'RP', 'PR', 'PP', 'R', 'P'].flatMap((regional) =>
      [1, 2, 3].map((wrist) => /** @type {const} */ ([regional, wrist])),
    ),
    ...['RRP', 'RPP', 'PRP', 'PPP', 'RP', 'PP'].map((regional) => /** @type {const} */ ([regional, 0])),
    /** @type {const} */ (['', 2]),
    /** @type {const} */ (['', 3]),
  ];
  test.each(structures)('%s and %i turns about one point', (regional, wrist) => {
    for (let i = 0; i < runs(4); i++) {
      const { description, q } = anyPartitioned(random, regional, wrist, { isBackwards: i % 2 === 1 });
      const found = solve(description, poseAt(description, q));
      expect(nearest(description, found, q)).toBeLessThan(1e-6);
      const right = met(description, found, q);
      // What comes near is returned as well.
      expect(nearest(description, { ...found, postures: right }, q)).toBeLessThan(1e-6);
      expect(worst(description, found, q)).toBeLessThan(1e-3);
      expect(repeats(description, right)).toBe(0);
      expect(right.length).toBeLessThanOrEqual(8);
      expect([found.families, found.isComplete]).toEqual([[], true]);
    }
  });

  test.each(structures)(
    '%s and %i turns, perhaps a joint too many: nothing is lost without a word',
    (regional, wrist) => {
      for (let i = 0; i < runs(4); i++) {
        const { description, q } = anyPartitioned(random, regional, wrist, {
          isBackwards: i % 2 === 1,
          isSpecial: true,
        });
        if (!recogniseWristPartition(screwsOf(createChain(description)))) continue;
        const found = solve(description, poseAt(description, q));
        const isFound = found.families.length > 0 || nearest(description, found, q) < 1e-5;
        expect([isFound || !found.isComplete, description, q]).toEqual([true, description, q]);
        expect(worst(description, { ...found, postures: [] }, q)).toBeLessThan(1e-6);
      }
    },
  );

  test('three turns before the wrist put the elbow in up to four places', () => {
    const counts = Array.from({ length: 30 }, () => {
      const { description, q } = anyPartitioned(random, 'RRR', 3);
      return solve(description, poseAt(description, q)).postures.length;
    });
    expect(counts.every((count) => count % 2 === 0)).toBe(true);
    expect(Math.max(...counts)).toBeGreaterThan(2);
    expect(Math.max(...counts)).toBeLessThan(9);
  });

  test('axes that are all but parallel lose nothing', () => {
    for (const off of [1e-9, 1e-8, 1e-7, 3e-7, 1e-6, 1e-5, 1e-4, 1e-3]) {
      // Axes 2 and 3 all but parallel, axes 1 and 2 all but meeting
      const arm = table([
        [off, -RIGHT, 0.4],
        [0.6, off, 0],
        [0.12, RIGHT, 0],
        [0, -RIGHT, -0.62],
        [0, RIGHT, 0],
        [0, Math.PI, -0.115],
      ]);
      for (let i = 0; i < 10; i++) {
        const q = anywhere(arm);
        const found = solve(arm, poseAt(arm, q));
        expect(nearest(arm, found, q)).toBeLessThan(1e-5);
        expect(worst(arm, found, q)).toBeLessThan(1e-8);
      }
    }
  });
});

describe('an arm with five joints or fewer', () => {
  test.each(['kuka_youbot', 'mitsubishi_rv2aj'])(
    '%s: with its wrist over axis 1 the orientation says where it looks',
    (name) => {
      const description = publishedArm(name);
      const chain = createChain(description);
      const [{ a: a1 }, { a: a2 }, { a: a3 }] = description.joints;
      for (const off of [0, 1e-10, 1e-8, 1e-6, 1e-4]) {
        for (let i = 0; i < 10; i++) {
          // Elbow at a right angle, or near it: the distance from axis 1 is a1 + R cos(q2 + φ)
          const bend = RIGHT + (random() - 0.5);
          const [x, y] = [a2 + a3 * Math.cos(bend), a3 * Math.sin(bend)];
          const q2 = Math.acos(-a1 / Math.hypot(x, y)) - Math.atan2(y, x) + off; // their theta are 0
          const q = [3 * random(), q2, bend, 3 * random() + 0.1, 3 * random()];
          const found = solve(description, poseAt(description, q));
          expect(nearest(description, found, q)).toBeLessThan(1e-5);
          expect(worst(description, found, q)).toBeLessThan(1e-5);
          expect(found.families).toEqual([]);
          // A pose with nine decimals: its place says nothing of q1 any more; its orientation does, the less the more upright
          // the tool is. Twelve numbers that are off by 5e-10 are a twist of length e, or less: √3 of that by the place, and
          // ½ |Σ aᵢ × δaᵢ| by the three axes. Newton's method is then off by no more than 2e/σ, with σ the least singular
          // value, where e ≤ σ²/2 (Kantorovich, with bends of order 1); nearer to upright such a pose does not tell.
          const rounded = poseAt(description, q).map((value) => Math.round(value * 1e9) / 1e9);
          const e = 5e-10 * Math.hypot(Math.sqrt(3) / chain.characteristicLength, 1.5 * Math.sqrt(3));
          const { singularValues } = singularValuesOf(chain, geometricJacobian(chain, q), { part: 'full' });
          const least = singularValues[4];
          if (least ** 2 < 2 * e) continue;
          const near = solve(description, rounded);
          for (const posture of near.postures) polish(chain, rounded, posture);
          expect(nearest(description, near, q)).toBeLessThan((2 * e) / least);
        }
      }
    },
  );

  test('pointing straight up over axis 1 is a family of its own', () => {
    const description = publishedArm('mitsubishi_rv2aj');
    const q2 = Math.acos(0) - Math.atan2(0.1, 0.28);
    const q = [0.4, q2, RIGHT, -q2 - RIGHT, 0.7];
    const { postures, families } = solve(description, poseAt(description, q));
    expect(postures).toEqual([]);
    expect(families.map(({ kind, joints }) => [kind, joints])).toEqual([
      ['shoulder', [0, 4]],
      ['shoulder', [0, 4]],
    ]);
    expect(worst(description, { postures, families, isComplete: true }, q)).toBeLessThan(1e-12);
  });

  test('a SCARA folded onto axis 1 can turn there', () => {
    const arm = table([
      [0.3, 0, 0.4],
      [0.3, Math.PI, 0],
      [0, 0, 0, 0, 'slides'],
      [0, 0, 0],
    ]);
    const { postures, families } = solve(arm, poseAt(arm, [0.2, Math.PI, 0.1, 0.5]));
    expect(postures).toEqual([]);
    expect(families.map(({ kind, joints }) => [kind, joints])).toEqual([['shoulder', [0, 3]]]);
  });

  test('a planar arm with a joint too many is redundant, and says that it is not sure of more', () => {
    const arm = table([
      [0.5, 0, 0],
      [0.4, 0, 0],
      [0.3, 0, 0],
      [0.1, 0, 0],
    ]);
    const q = [0.3, 0.5, -0.8, 0.2];
    const found = solve(arm, poseAt(arm, q));
    expect(found.families.map(({ kind, joints }) => [kind, joints])).toEqual([['other', [0, 1, 2, 3]]]);
    expect(worst(arm, found, q)).toBeLessThan(1e-12);
    expect(found.isComplete).toBe(false);
  });

  test('two joints about one axis only count together', () => {
    const arm = table([
      [0, 0, 0.2],
      [0.3, RIGHT, 0.1],
      [0.3, 0, 0],
      [0, RIGHT, 0.2],
    ]);
    const q = [0.3, 0.4, 0.5, 0.6];
    const found = solve(arm, poseAt(arm, q));
    expect(found.postures).toEqual([]);
    expect(found.families.map(({ kind, joints }) => [kind, joints])).toContainEqual(['other', [0, 1]]);
    expect(worst(arm, found, q)).toBeLessThan(1e-12);
  });
});

describe('singular postures', () => {
  /** The third joint value that has the forearm in line with the upper arm. @param {ChainDescription} arm */
  const straight = ({ joints }) => -Math.atan2(-Math.sin(joints[2].alpha) * joints[3].d, joints[2].a) - joints[2].theta;

  test.each(['puma560', 'stanford', 'kuka_kr5_arc', 'abb_irb120'])(
    '%s: a wrist in line is a family for each elbow',
    (name) => {
      const description = publishedArm(name);
      for (let i = 0; i < 10; i++) {
        const q = anywhere(description);
        q[4] = 0;
        const found = solve(description, poseAt(description, q));
        expect(found.families.length).toBeGreaterThan(0);
        for (const { kind, joints } of found.families) expect([kind, joints]).toEqual(['wrist', [3, 5]]);
        expect(worst(description, found, q)).toBeLessThan(1e-11);
        const member = found.families.find(
          (family) =>
            apart(description, [...family.q.slice(0, 3), 0, family.q[4], 0], [...q.slice(0, 3), 0, q[4], 0]) < 1e-6,
        );
        expect(member).toBeDefined();
      }
    },
  );

  test.each(['puma560', 'stanford', 'kuka_kr5_arc'])(
    '%s: near a wrist in line both postures are there, and are two',
    (name) => {
      const description = publishedArm(name);
      for (const off of [1e-3, 1e-6, 1e-8]) {
        for (let i = 0; i < 10; i++) {
          const q = anywhere(description);
          q[4] = off;
          const found = solve(description, poseAt(description, q));
          expect(found.families).toEqual([]);
          expect(worst(description, found, q)).toBeLessThan(1e-12);
          const regional = found.postures.filter(
            (p) => apart(description, [...p.slice(0, 3), 0, 0, 0], [...q.slice(0, 3), 0, 0, 0]) < 1e-6,
          );
          expect(regional).toHaveLength(2);
          // A pose that is rounded to 1e-16 has the bend of the wrist to no more than that.
          const [first, second] = regional.map((p) => p[4]);
          expect(Math.abs(Math.abs(first) / off - 1)).toBeLessThan(1e-3);
          expect(Math.abs(first + second)).toBeLessThan(1e-12);
        }
      }
    },
  );

  test.each(['puma560', 'abb_irb120'])('%s: a stretched elbow is there once, a nearly stretched one twice', (name) => {
    const description = publishedArm(name);
    for (const [off, count] of [
      [0, 4],
      [1e-10, 4],
      [1e-6, 8],
      [1e-3, 8],
    ]) {
      for (let i = 0; i < 10; i++) {
        const q = anywhere(description);
        q[2] = straight(description) + off;
        const found = solve(description, poseAt(description, q));
        expect([off, found.postures.length]).toEqual([off, count]);
        expect(nearest(description, found, q)).toBeLessThan(1e-6);
      }
    }
  });

  /** A posture that has the wrist centre over axis 1. @param {ChainDescription} arm @param {number} off */
  function overAxis1(arm, off) {
    const q = anywhere(arm);
    const [{ a: a1 }, { a: a2, theta: theta2 }, { a: a3, alpha, theta: theta3 }, { d }] = arm.joints;
    q[2] = straight(arm) + RIGHT + random() - 0.5;
    const fore = [a3, -Math.sin(alpha) * d];
    const [c, s] = [Math.cos(q[2] + theta3), Math.sin(q[2] + theta3)];
    const [x, y] = [a2 + c * fore[0] - s * fore[1], s * fore[0] + c * fore[1]];
    q[1] = Math.acos(-a1 / Math.hypot(x, y)) - Math.atan2(y, x) - theta2 + off;
    return q;
  }

  const UPRIGHT = ['abb_irb120', 'kuka_kr5_arc'];
  test.each(UPRIGHT)('%s: a wrist centre on axis 1 is a family for each bend of elbow and wrist', (name) => {
    const description = publishedArm(name);
    for (const off of [0, 1e-12, 1e-10]) {
      const q = overAxis1(description, off);
      const found = solve(description, poseAt(description, q));
      expect(found.postures).toEqual([]);
      expect(found.families).toHaveLength(4);
      for (const { kind, joints } of found.families) expect([kind, joints]).toEqual(['shoulder', [0, 3, 4, 5]]);
      expect(worst(description, found, q)).toBeLessThan(1e-9);
      const elbow = (/** @type {ArrayLike<number>} */ p) => [0, p[1], p[2], 0, 0, 0];
      const across = found.families.map((family) => apart(description, elbow(family.q), elbow(q)));
      expect(Math.min(...across)).toBeLessThan(1e-8);
    }
  });

  test.each(UPRIGHT)('%s: near axis 1 the postures are isolated, and right', (name) => {
    const description = publishedArm(name);
    for (const off of [1e-3, 1e-6, 1e-7]) {
      const q = overAxis1(description, off);
      const found = solve(description, poseAt(description, q));
      expect([found.families.length, found.postures.length]).toEqual([0, 8]);
      expect(worst(description, found, q)).toBeLessThan(1e-12);
      expect(nearest(description, found, q)).toBeLessThan(1e-6);
    }
  });

  test('a wrist centre on axis 2 leaves that axis free', () => {
    const description = publishedArm('stanford');
    const q = [0.3, 0.4, 0, 0.5, 0.6, 0.7];
    const found = solve(description, poseAt(description, q));
    expect(found.families.map(({ kind, joints }) => [kind, joints])).toContainEqual(['other', [1, 3, 4, 5]]);
    expect(worst(description, found, q)).toBeLessThan(1e-8);
  });
});
