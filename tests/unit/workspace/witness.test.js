/**
 * Inverse kinematics as a witness: it knows nothing of curves and cells. A place in the section and its cell may only disagree
 * where the boundary goes through the cell or one beside it.
 */
import { describe, expect, test } from 'vitest';
import { allInverseKinematics } from '../../../src/kinematics/allInverse.js';
import { createChain } from '../../../src/kinematics/chain.js';
import { inverseKinematics } from '../../../src/kinematics/inverse.js';
import { createRandom } from '../../../src/kinematics/random.js';
import { createSampler } from '../../../src/workspace/sampler.js';
import { sectionAtOnce } from '../../../src/workspace/section.js';
import { publishedArm } from '../kinematics/publishedArms.js';
import { rodrigues } from '../kinematics/oracle.js';
import { planar } from './arms.js';

/** @import { Chain } from '../../../src/kinematics/chain.js' */
/** @import { Cells } from '../../../src/workspace/cells.js' */
/** @import { Section, SectionOptions } from '../../../src/workspace/section.js' */

const isDeep = Boolean(process.env.DENAVIT_DEEP);

/** @type {Map<string, Section>} */
const known = new Map();

/** Several tests look at the same one. @param {Chain} chain @param {SectionOptions} options @returns {Section} */
function sectionOf(chain, options) {
  const key = JSON.stringify([chain.joints, options]);
  const section = known.get(key) ?? sectionAtOnce(chain, { ...options, withVolume: false });
  if (!section) throw new Error('Expected a section.');
  known.set(key, section);
  return section;
}

/** What the cells around a place say: 1 or 0 if they agree, else null. @param {Cells} cells @param {number} u @param {number} v */
function cellsAround(cells, u, v) {
  const [i, j] = [Math.floor((u - cells.u) / cells.size), Math.floor((v - cells.v) / cells.size)];
  const seen = new Set();
  for (let a = i - 1; a <= i + 1; a++) {
    for (let b = j - 1; b <= j + 1; b++) {
      const isThere = a >= 0 && b >= 0 && a < cells.columns && b < cells.rows;
      seen.add(isThere ? cells.reached[b * cells.columns + a] : 0);
    }
  }
  return seen.size === 1 ? [...seen][0] : null;
}

/** @param {number[][]} R rows @param {number[]} p */
const poseOf = (R, p) =>
  Float64Array.of(R[0][0], R[1][0], R[2][0], 0, R[0][1], R[1][1], R[2][1], 0, R[0][2], R[1][2], R[2][2], 0, ...p, 1);

const UPRIGHT = [
  [1, 0, 0],
  [0, 1, 0],
  [0, 0, 1],
];
const DOWN = [
  [1, 0, 0],
  [0, -1, 0],
  [0, 0, -1],
];

/** Whether a value is inside the limits, full turns taken as needed. @param {Chain} chain @param {number} joint @param {number} value */
function isWithin(chain, joint, value) {
  const { type, lower, upper } = chain.joints[joint];
  if (type === 'prismatic') return value >= lower && value <= upper;
  for (let turns = -2; turns <= 2; turns++) {
    const turned = value + turns * 2 * Math.PI;
    if (turned >= lower && turned <= upper) return true;
  }
  return false;
}

/** The joints that bring the TCP to its distance and height, whatever the others. @param {Chain} chain @param {number[][]} R @param {number[]} joints */
const byAllSolutions = (chain, R, joints) => (/** @type {number} */ u, /** @type {number} */ v) => {
  const { solutions, families } = allInverseKinematics(chain, poseOf(R, [u, 0, v]));
  return [...solutions, ...families].some(({ q }) => joints.every((joint) => isWithin(chain, joint, q[joint])));
};

/** @param {Chain} chain @param {number} directions  to look at before a search */
function byAnyOrientation(chain, directions) {
  const random = createRandom(11);
  const turns = Array.from({ length: directions }, () =>
    rodrigues([random() - 0.5, random() - 0.5, random() - 0.5], 2 * Math.PI * random()),
  );
  return (/** @type {number} */ u, /** @type {number} */ v) =>
    turns.some((R) => allInverseKinematics(chain, poseOf(R, [u, 0, v])).solutions.length > 0) ||
    inverseKinematics(chain, poseOf(turns[0], [u, 0, v])).reason !== 'distance';
}

/** Of few places in `npm test`: the finer ones are for the full counts. @type {SectionOptions} */
const COARSE = { cell: 4e-3, tolerance: 5e-4 };

/** @type {[name: string, judge: (chain: Chain) => (u: number, v: number) => boolean, count: number, options: SectionOptions][]} */
const CASES = [
  ['puma560', (chain) => byAllSolutions(chain, UPRIGHT, [1, 2]), 100, isDeep ? { cell: 2e-3 } : COARSE],
  [
    'scara_cobra600',
    (chain) => byAllSolutions(chain, DOWN, [1, 2]),
    60,
    isDeep ? { cell: 1e-3, tolerance: 1e-4 } : COARSE,
  ],
  ['ur5', (chain) => byAnyOrientation(chain, 12), 10, isDeep ? {} : { cell: 8e-3, tolerance: 2e-4 }],
];

describe('inverse kinematics and the section agree, but for a cell at the boundary,', () => {
  test.each(CASES)('for %s', (name, judge, few, options) => {
    const chain = createChain(publishedArm(name));
    const section = sectionOf(chain, options);
    const { extent, cells } = section;
    if (!extent) throw new Error('Expected an extent.');
    const isReached = judge(chain);
    const random = createRandom(name.length);
    const between = (/** @type {number[]} */ [low, high]) => low + (1.2 * random() - 0.1) * (high - low);
    const count = isDeep ? 10_000 : few;
    let [told, disagreed] = [0, 0];
    for (let k = 0; k < count; k++) {
      const [u, v] = [Math.abs(between(extent.u)), between(extent.v)];
      const cell = cellsAround(cells, u, v);
      if (cell === null) continue;
      told++;
      if ((cell === 1) !== isReached(u, v)) disagreed++;
    }
    expect(disagreed).toBe(0);
    expect(told).toBeGreaterThan(0.8 * count);
  });
});

describe('no sampled place is outside of the section of', () => {
  test.each([
    ['puma560', {}],
    ['stanford', {}],
    ['puma560', { withLimits: false }],
  ])('%s %j', (name, options) => {
    const chain = createChain(publishedArm(name));
    const { frame, cells } = sectionOf(chain, { ...options, ...(isDeep ? { cell: 2e-3 } : COARSE) });
    const count = isDeep ? 1e6 : 5000;
    const places = new Float32Array(3 * count);
    createSampler(chain, options).fill(0, places);
    let outside = 0;
    for (let k = 0; k < places.length; k += 3) {
      const r = [0, 1, 2].map((axis) => places[k + axis] - frame.origin[axis]);
      const height = r.reduce((sum, value, axis) => sum + value * frame.v[axis], 0);
      const out = Math.sqrt(Math.max(0, r.reduce((sum, value) => sum + value * value, 0) - height * height));
      if (cellsAround(cells, out, height) === 0) outside++;
    }
    expect(outside).toBe(0);
  });
});

test('a planar arm with a joint to spare: its critical curves are circles, its area is counted', () => {
  const section = sectionOf(createChain(planar([0.5, 0.3, 0.15])), { cell: 4e-3, tolerance: 1e-4 });
  const area = Math.PI * (0.95 ** 2 - 0.05 ** 2);
  expect(section.sides).toBe('estimated');
  expect(Math.abs(section.area - area)).toBeLessThan(section.areaError);
  const radii = section.curves.map(({ places }) => {
    const all = Array.from({ length: places.length / 2 }, (_, i) => Math.hypot(places[2 * i], places[2 * i + 1]));
    expect(Math.max(...all) - Math.min(...all)).toBeLessThan(1e-9);
    return Math.round(all[0] * 1e6) / 1e6;
  });
  expect(new Set(radii)).toEqual(new Set([0.05, 0.35, 0.65, 0.95]));
});
