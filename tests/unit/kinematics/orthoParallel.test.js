/** Eight postures at once. @import { ChainDescription } from '../../../src/kinematics/chain.js' */
import { describe, expect, test } from 'vitest';
import { createChain } from '../../../src/kinematics/chain.js';
import {
  FOLDED,
  SHOULDER_SINGULAR,
  WRIST_IN_LINE,
  recogniseOrthoParallel,
  writeOrthoParallelPostures,
} from '../../../src/kinematics/solvers/orthoParallel.js';
import { createRandom } from '../../../src/kinematics/random.js';
import { goalFromStart, screwsOf } from '../../../src/kinematics/screws.js';
import { solveWristPartition } from '../../../src/kinematics/solvers/wristPartition.js';
import { SEED, runs } from '../../helpers/property.js';
import { RIGHT, apart, miss, poseAt, prepare, table } from './partitioned.js';
import { ALL_ARMS, publishedArm } from './publishedArms.js';

const random = createRandom(SEED);
const out = new Float64Array(48);

const recognise = (/** @type {ChainDescription} */ description) =>
  recogniseOrthoParallel(screwsOf(createChain(description)));

/** @param {ChainDescription} description @param {ArrayLike<number>} T_base_goal */
function write(description, T_base_goal) {
  const chain = createChain(description);
  const constants = recogniseOrthoParallel(screwsOf(chain));
  if (!constants) throw new Error('Expected the arm to be recognised.');
  out.fill(NaN);
  const bits = writeOrthoParallelPostures(constants, goalFromStart(chain, T_base_goal), out);
  const postures = [0, 1, 2, 3, 4, 5, 6, 7].map((k) => ((bits >> k) & 1 ? out.slice(6 * k, 6 * k + 6) : null));
  return { bits, postures, found: postures.filter((p) => p !== null) };
}

const anywhere = () => Array.from({ length: 6 }, () => (2 * random() - 1) * Math.PI);
const COMMON = [
  'puma560',
  'kuka_kr5_arc',
  'kuka_kr6_r900',
  'kuka_kr210_l150',
  'fanuc_lrmate200id',
  'fanuc_m10ia',
  'abb_irb140',
  'abb_irb120',
];

test('which arms are of this kind', () => {
  expect(ALL_ARMS.filter((name) => recognise(publishedArm(name))).sort()).toEqual([...COMMON].sort());
});

test.each(COMMON)('%s: every posture meets the pose, and the one it came from is among them', (name) => {
  const description = publishedArm(name);
  for (let i = 0; i < runs(25); i++) {
    const q = anywhere();
    const { found, bits } = write(description, poseAt(description, q));
    expect(bits).toBeLessThan(256);
    expect(Math.min(...found.map((p) => apart(description, p, q)))).toBeLessThan(1e-8);
    expect(Math.max(...found.map((p) => miss(description, p, q)))).toBeLessThan(1e-13);
  }
});

/** Every sign and offset that the geometry allows. @returns {ChainDescription} */
function anyOrthoParallel() {
  const sign = () => (random() < 0.5 ? -1 : 1);
  const length = () => (random() < 0.3 ? 0 : sign() * (0.1 + 0.5 * random()));
  const angle = () => 6 * random() - 3;
  return table([
    [length(), sign() * RIGHT, length(), angle()],
    [0.3 + random(), random() < 0.5 ? 0 : Math.PI, length(), angle()],
    [length(), sign() * RIGHT, length(), angle()],
    [0, sign() * RIGHT, 0.3 + random(), angle()],
    [0, sign() * RIGHT, 0, angle()],
    [length(), angle(), length(), angle()],
  ]);
}

test('any arm of the kind: as by the general way', () => {
  for (let i = 0; i < runs(60); i++) {
    const description = anyOrthoParallel();
    const q = anywhere();
    const goal = poseAt(description, q);
    const { found } = write(description, goal);
    const { chain, constants } = prepare(description);
    const general = solveWristPartition({ ...constants, fast: null }, goalFromStart(chain, goal));
    expect(found).toHaveLength(general.postures.length);
    for (const p of found) {
      expect(miss(description, p, q)).toBeLessThan(1e-12);
      expect(Math.min(...general.postures.map((other) => apart(description, p, other)))).toBeLessThan(1e-6);
    }
  }
});

describe('which posture is which', () => {
  const description = publishedArm('abb_irb140');
  /** Postures with both shoulders in reach. */
  const cases = Array.from({ length: 60 }, anywhere)
    .map((q) => write(description, poseAt(description, q)))
    .filter(({ bits }) => bits === 255);

  test('both elbows and both wrists belong to one shoulder', () => {
    expect(cases.length).toBeGreaterThan(20);
    for (const { found } of cases) {
      for (let k = 0; k < 8; k++) {
        expect(found[k][0]).toBe(found[k & 4][0]);
        expect(found[k].slice(0, 3)).toEqual(found[k & 6].slice(0, 3));
        expect(Math.abs(Math.sin(found[k][4] + found[k ^ 1][4]))).toBeLessThan(1e-12);
      }
    }
  });

  test('bits: in front of axis 1, the elbow bent the way of axis 2, the wrist the way of axis 5', () => {
    const { found } = write(description, poseAt(description, [0.1, 0.2, 0.3, 0.4, 0.5, 0.6]));
    // The table of this arm turns axis 5 the way that bends it forward.
    expect(apart(description, found[0], [0.1, 0.2, 0.3, 0.4, 0.5, 0.6])).toBeLessThan(1e-12);
    expect(found[1][4]).toBeCloseTo(-0.5, 12);
    expect(found.filter(([q1]) => Math.cos(q1 - 0.1) > 0.99)).toHaveLength(4);
  });
});

describe('at the edges', () => {
  const description = table([
    [0, -RIGHT, 0.3],
    [0.4, 0, 0],
    [0, -RIGHT, 0],
    [0, RIGHT, 0.4],
    [0, -RIGHT, 0],
    [0, 0, 0.1],
  ]);

  test('a stretched elbow leaves half of the postures', () => {
    const { bits } = write(description, poseAt(description, [0.3, 0.4, -RIGHT, 0.5, 0.6, 0.7]));
    expect(bits).toBe(0b00110011);
  });

  test('a wrist in line, a centre on axis 1 and one on axis 2 are said so', () => {
    expect(write(description, poseAt(description, [0.3, 0.4, 0.5, 0.6, 0, 0.7])).bits & WRIST_IN_LINE).not.toBe(0);
    const upright = [0.3, -RIGHT - 0.4, RIGHT + 0.3, 0.5, 0.6, 0.7];
    // Links of the same length make an isosceles triangle: half the bend of the elbow brings the wrist over the
    // shoulder.
    upright[1] = -RIGHT - (upright[2] + RIGHT) / 2;
    expect(write(description, poseAt(description, upright)).bits & SHOULDER_SINGULAR).not.toBe(0);
    expect(write(description, poseAt(description, [0.3, 0.4, RIGHT, 0.5, 0.6, 0.7])).bits & FOLDED).not.toBe(0);
  });

  test('out of reach there is nothing', () => {
    const goal = poseAt(description, [0.3, 0.4, 0.5, 0.6, 0.7, 0.8]);
    goal[12] += 3;
    expect(write(description, goal).bits).toBe(0);
    const puma = publishedArm('puma560');
    const near = poseAt(puma, [0, 0, 0, 0, 0, 0]);
    // Nearer to axis 1 than the wrist is to the side of it
    near[12] = 0.05;
    near[13] = 0.05;
    expect(write(puma, near).bits).toBe(0);
  });

  test('whatever the pose, no number that is written is none', () => {
    for (let i = 0; i < runs(40); i++) {
      const q = anywhere().map((value) => (random() < 0.7 ? Math.round(value / RIGHT) * RIGHT : value));
      for (const p of write(description, poseAt(description, q)).found) {
        expect(p.every(Number.isFinite)).toBe(true);
        expect(miss(description, p, q)).toBeLessThan(1e-6);
      }
    }
  });
});
