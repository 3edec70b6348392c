/**
 * The place of a point by up to three joints, by turning and shifting points one joint after the other.
 * @import { Line, Vector } from '../../../src/kinematics/lines.js'
 */
import { expect, test } from 'vitest';
import { createRandom } from '../../../src/kinematics/random.js';
import { isDeficient, prepareRegional, solveRegional } from '../../../src/kinematics/solvers/regional.js';
import { SEED, runs } from '../../helpers/property.js';
import { rodrigues } from './oracle.js';

const random = createRandom(SEED);
const anyVector = () => /** @type {Vector} */ ([2 * random() - 1, 2 * random() - 1, 2 * random() - 1]);

/** @param {string} kinds @returns {Line[]} */
const anyLines = (kinds) =>
  [...kinds].map((kind) => {
    const axis = anyVector();
    const length = Math.hypot(...axis);
    return { slides: kind === 'P', axis: /** @type {Vector} */ (axis.map((v) => v / length)), point: anyVector() };
  });

/** @param {readonly Line[]} lines @param {ArrayLike<number>} q @param {Vector} centre @returns {Vector} */
const placeOf = (lines, q, centre) =>
  lines.reduceRight((p, { slides, axis, point }, i) => {
    if (slides) return /** @type {Vector} */ (p.map((value, k) => value + q[i] * axis[k]));
    const R = rodrigues(axis, q[i]);
    const from = p.map((value, k) => value - point[k]);
    return /** @type {Vector} */ (
      R.map((row, k) => point[k] + row.reduce((sum, value, j) => sum + value * from[j], 0))
    );
  }, centre);

/** @param {readonly Line[]} lines @param {ArrayLike<number>} p @param {ArrayLike<number>} q */
const apart = (lines, p, q) =>
  Math.max(0, ...lines.map(({ slides }, i) => Math.abs(slides ? p[i] - q[i] : 2 * Math.sin((p[i] - q[i]) / 2))));

const distance = (/** @type {Vector} */ a, /** @type {Vector} */ b) => Math.hypot(...a.map((v, i) => v - b[i]));

const MOST = { RRR: 4, RRP: 4, RPR: 4, PRR: 4, RPP: 2, PRP: 2, PPR: 2, PPP: 1, RR: 1, RP: 1, PR: 1, PP: 1, R: 1, P: 1 };

test.each(Object.entries(MOST))('%s: at most %i ways, each right, the one it came from among them', (kinds, most) => {
  let largest = 0;
  for (let i = 0; i < runs(60); i++) {
    const lines = anyLines(kinds);
    const centre = anyVector();
    const q = lines.map(({ slides }) => (slides ? 1 : Math.PI) * (2 * random() - 1));
    const P = placeOf(lines, q, centre);
    const found = solveRegional(prepareRegional(lines, centre), P);
    expect(Math.min(...found.map((solution) => apart(lines, solution.q, q)))).toBeLessThan(1e-6);
    const right = found.filter((solution) => distance(placeOf(lines, solution.q, centre), P) < 1e-9);
    expect(right.some((solution) => apart(lines, solution.q, q) < 1e-6)).toBe(true);
    // Curves that all but touch are said to: that comes near, and is for the caller to throw out.
    for (const solution of found) expect(distance(placeOf(lines, solution.q, centre), P)).toBeLessThan(0.01);
    for (const { free, coupled } of found) expect([free, coupled]).toEqual([[], []]);
    largest = Math.max(largest, right.length);
  }
  expect(largest).toBe(most);
});

test('a point out of reach has none', () => {
  for (const kinds of ['RRR', 'RPR', 'RR', 'R', 'P', 'PP']) {
    const lines = anyLines(kinds);
    expect(solveRegional(prepareRegional(lines, anyVector()), [40, 50, kinds === 'RPR' ? 1e3 : 60])).toEqual(
      kinds === 'RPR' ? expect.anything() : [],
    );
  }
});

/** @type {Vector} */
const X = [1, 0, 0];
/** @type {Vector} */
const Z = [0, 0, 1];

test('three parallel axes are one too many for a plane', () => {
  const lines = /** @type {Line[]} */ ([0, 0.5, 0.9].map((x) => ({ slides: false, axis: Z, point: [x, 0, 0] })));
  const regional = prepareRegional(lines, [1.2, 0, 0]);
  expect(isDeficient(regional)).toBe(true);
  const P = placeOf(lines, [0.3, 0.4, 0.5], [1.2, 0, 0]);
  const [solution] = solveRegional(regional, P);
  expect([solution.coupled, solution.isTurning]).toEqual([[0, 1, 2], true]);
  expect(distance(placeOf(lines, solution.q, [1.2, 0, 0]), P)).toBeLessThan(1e-12);
  expect(solveRegional(regional, [P[0], P[1], 0.1])).toEqual([]);
});

test('a centre on the first axis leaves the first joint free, one on the second the second', () => {
  const lines = /** @type {Line[]} */ ([
    { slides: false, axis: Z, point: [0, 0, 0] },
    { slides: false, axis: X, point: [0, 0, 0.5] },
    { slides: false, axis: X, point: [0, 0, 1] },
  ]);
  const regional = prepareRegional(lines, [0, 0, 1.6]);
  for (const { free } of solveRegional(regional, [0, 0, 1.3])) expect(free).toEqual([0]);
  expect(solveRegional(regional, [0, 0, 1.3])).toHaveLength(2);
  const folded = prepareRegional(lines, [0.2, 0, 1.5]);
  expect(solveRegional(folded, [0.2, 0, 0.5]).map(({ free }) => free)).toContainEqual([1]);
});

test('slides along one direction only count together', () => {
  const lines = /** @type {Line[]} */ ([
    { slides: true, axis: Z, point: [0, 0, 0] },
    { slides: true, axis: Z, point: [0, 0, 0] },
    { slides: true, axis: X, point: [0, 0, 0] },
  ]);
  const [{ q, coupled }] = solveRegional(prepareRegional(lines, [0, 0, 0]), [0.3, 0, 0.4]);
  expect(coupled).toEqual([0, 1]);
  expect(distance(placeOf(lines, q, [0, 0, 0]), [0.3, 0, 0.4])).toBeLessThan(1e-15);
});
