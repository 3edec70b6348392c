import { describe, expect, test } from 'vitest';
import { writeAnnihilator } from '../../../src/kinematics/solvers/general/annihilator.js';
import { posturesAt } from '../../../src/kinematics/solvers/general/backSubstitution.js';
import { fitCircle, SAMPLES, sampleAngle } from '../../../src/kinematics/solvers/general/circleFit.js';
import { evaluate } from '../../../src/kinematics/solvers/general/circleRoots.js';
import {
  factorise,
  nullVector,
  rankOf,
  solveFactorised,
} from '../../../src/kinematics/solvers/general/completePivoting.js';
import { writeDeterminant, writeDixonMatrix } from '../../../src/kinematics/solvers/general/dixon.js';
import {
  linesOf,
  loopProduct,
  multiply,
  writeGoalMotion,
} from '../../../src/kinematics/solvers/general/dualQuaternion.js';
import { eliminate, prepareElimination } from '../../../src/kinematics/solvers/general/elimination.js';
import { closeLoop, gapAt } from '../../../src/kinematics/solvers/general/loopClosure.js';
import { createChain } from '../../../src/kinematics/chain.js';
import { createRandom } from '../../../src/kinematics/random.js';
import { goalFromStart, screwsOf } from '../../../src/kinematics/screws.js';
import { SEED, runs } from '../../helpers/property.js';
import { columnMajor, oracleForward } from './oracle.js';

/** @import { ChainDescription } from '../../../src/kinematics/chain.js' */

const random = createRandom(SEED);
const any = (size = 1) => (2 * random() - 1) * size;
const many = (/** @type {number} */ count, size = 1) => Float64Array.from({ length: count }, () => any(size));

/** By the permutations. @param {number[][]} rows @returns {number} */
const determinantOf = (rows) =>
  rows.length === 0
    ? 1
    : rows[0].reduce(
        (sum, value, j) =>
          sum + (j % 2 ? -1 : 1) * value * determinantOf(rows.slice(1).map((row) => row.filter((_, k) => k !== j))),
        0,
      );

/** @returns {ChainDescription} */
const anyArm = () => ({
  convention: 'standard',
  joints: Array.from({ length: 6 }, () => ({ type: 'revolute', a: any(), alpha: any(3), d: any(), theta: any(3) })),
});

describe("Dixon's matrix", () => {
  /** 1, x, y, xy, z, … at a point. @param {number} x @param {number} y @param {number} z */
  const monomials = (x, y, z) => [1, x, y, x * y, z, x * z, y * z, x * y * z];
  test('is the determinant of the definition, over the three differences', () => {
    const M = many(32);
    const D = new Float64Array(36);
    writeDixonMatrix(M, D);
    const row = (/** @type {number[]} */ powers) =>
      [0, 1, 2, 3].map((i) => powers.reduce((sum, power, m) => sum + M[8 * i + m] * power, 0));
    for (let k = 0; k < 10; k++) {
      const [x, y, z, X, Y, Z] = many(6, 2);
      const rows = [monomials(x, y, z), monomials(X, y, z), monomials(X, Y, z), monomials(X, Y, Z)].map(row);
      const direct = determinantOf(rows) / ((x - X) * (y - Y) * (z - Z));
      const left = [1, X, X * X, Y, X * Y, X * X * Y];
      const right = [1, z, z * z, y, y * z, y * z * z];
      let form = 0;
      for (let i = 0; i < 6; i++) for (let j = 0; j < 6; j++) form += left[i] * D[6 * i + j] * right[j];
      expect(form).toBeCloseTo(direct, 8);
    }
  });
  test('is singular where the equations have a common solution, which its null vector tells', () => {
    const [x, y, z] = [0.7, -1.3, 2.1];
    const point = monomials(x, y, z);
    const M = many(32);
    for (let i = 0; i < 4; i++) M[8 * i] -= point.reduce((sum, power, m) => sum + M[8 * i + m] * power, 0);
    const D = new Float64Array(36);
    writeDixonMatrix(M, D);
    expect(factorise(D)).toBeLessThan(1e-12);
    const v = new Float64Array(6);
    nullVector(D, 5, 5, v);
    [1, z, z * z, y, y * z, y * z * z].forEach((value, i) => expect(v[i] / v[0]).toBeCloseTo(value, 8));
  });
  test('its determinant', () => {
    const A = many(36);
    const rows = [0, 1, 2, 3, 4, 5].map((i) => [...A.subarray(6 * i, 6 * i + 6)]);
    const out = new Float64Array(2);
    writeDeterminant(A.slice(), out);
    expect(out[0]).toBeCloseTo(determinantOf(rows), 12);
    A.set([...rows[0], ...rows[1], ...rows[2], ...rows[3], ...rows[4]]);
    for (let j = 0; j < 6; j++) A[30 + j] = rows[0][j] + rows[3][j] / 3;
    writeDeterminant(A.slice(), out);
    expect(Math.abs(out[0])).toBeLessThanOrEqual(1e-13 * out[1]); // or both are 0: seen at once
    for (let k = 0; k < 36; k += 6) A.set([0, 0, 0], k); // rank 3
    writeDeterminant(A, out);
    expect([...out].map(Math.abs)).toEqual([0, 0]);
  });
});

test('elimination with complete pivoting solves, and tells the rank', () => {
  const A = many(36);
  const [b, x] = [many(6), new Float64Array(6)];
  const LU = A.slice();
  expect(factorise(LU)).toBeGreaterThan(1e-6);
  solveFactorised(LU, b, x);
  for (let i = 0; i < 6; i++) {
    expect(x.reduce((sum, value, j) => sum + A[6 * i + j] * value, -b[i])).toBeCloseTo(0, 10);
  }
  for (let j = 0; j < 6; j++) {
    A[30 + j] = A[j] - 2 * A[6 + j];
    A[24 + j] = A[12 + j] + A[18 + j];
  }
  const twice = A.slice();
  expect(factorise(twice)).toBeLessThan(1e-14);
  expect(rankOf(twice, 1e-13)).toBe(4);
  for (const free of [4, 5]) {
    nullVector(twice, 4, free, x);
    expect(Math.max(...x.map(Math.abs))).toBeGreaterThan(0.99);
    for (let i = 0; i < 6; i++) expect(x.reduce((sum, value, j) => sum + A[6 * i + j] * value, 0)).toBeCloseTo(0, 10);
  }
  expect(factorise(new Float64Array(36))).toBe(0);
});

test('the forms that vanish on four vectors do, and have the minors that those have', () => {
  const P = many(32);
  const forms = new Float64Array(32);
  expect(writeAnnihilator(P.slice(), forms)).toBeGreaterThan(1e-3);
  const row = (/** @type {Float64Array} */ A, /** @type {number} */ i) => [...A.subarray(8 * i, 8 * i + 8)];
  for (let i = 0; i < 4; i++) {
    for (let j = 0; j < 4; j++) {
      expect(row(forms, i).reduce((sum, value, k) => sum + value * row(P, j)[k], 0)).toBeCloseTo(0, 12);
    }
  }
  const minor = (/** @type {Float64Array} */ A, /** @type {number[]} */ columns) =>
    determinantOf([0, 1, 2, 3].map((i) => columns.map((k) => A[8 * i + k])));
  // complementary columns, sign of the shuffle
  expect(minor(forms, [0, 1, 2, 3])).toBeCloseTo(minor(P, [4, 5, 6, 7]), 12);
  expect(minor(forms, [4, 5, 6, 7])).toBeCloseTo(minor(P, [0, 1, 2, 3]), 12);
  expect(minor(forms, [0, 1, 2, 4])).toBeCloseTo(-minor(P, [3, 5, 6, 7]), 12);
  P.set(P.subarray(0, 8), 16);
  expect(writeAnnihilator(P.slice(), forms)).toBeLessThan(1e-15);
});

test('a fit on the circle gives back what was weighted, and no fit is made of too little', () => {
  const c = many(17);
  const weights = Float64Array.from({ length: SAMPLES }, (_, k) => (1.2 + Math.cos(sampleAngle(k))) ** 2);
  const fit = fitCircle(weights);
  if (!fit) throw new Error('Expected a fit.');
  const values = weights.map((weight, k) => weight * evaluate(c, sampleAngle(k))[0]);
  for (let j = 0; j < 17; j++) {
    expect(values.reduce((sum, value, k) => sum + fit.inverse[SAMPLES * j + k] * value, 0)).toBeCloseTo(c[j], 9);
  }
  expect(fitCircle(weights.map((weight, k) => (k < 16 ? weight : 0)))).toBe(null);
});

describe('motions as dual quaternions', () => {
  test('multiply as the matrices do', () => {
    for (let k = 0; k < 20; k++) {
      const description = anyArm();
      description.joints[k % 6].type = 'prismatic';
      const chain = createChain(description);
      const screws = screwsOf(chain);
      const q = [...many(6, 3)];
      const [byJoints, byPose] = [new Float64Array(8), new Float64Array(8)];
      const inLengths = q.map((value, i) => (screws.slides[i] ? value / screws.length : value));
      loopProduct({ lines: linesOf(screws), slides: screws.slides }, inLengths, byJoints);
      writeGoalMotion(screws, goalFromStart(chain, columnMajor(oracleForward(description, q).tcp)), byPose);
      const sign = byJoints.reduce((sum, value, i) => sum + value * byPose[i], 0) > 0 ? 1 : -1;
      byJoints.forEach((value, i) => expect(value - sign * byPose[i]).toBeCloseTo(0, 12));
    }
  });
  test('have units that square to −1, but for slides', () => {
    const line = Float64Array.of(0, 0, 0.6, 0.8, 0, 1, 0, 0);
    const square = new Float64Array(8);
    multiply(line, 0, line, 0, square, 0);
    [-1, 0, 0, 0, 0, 0, 0, 0].forEach((value, i) => expect(square[i]).toBeCloseTo(value, 15));
  });
});

describe('an elimination', () => {
  const even = fitCircle(new Float64Array(SAMPLES).fill(1));
  if (!even) throw new Error('Expected a fit.');
  test('of every kind is zero at the posture that made the pose, and fits degree 8', () => {
    let [kinds, doubtful] = [0, 0];
    for (let k = 0; k < runs(5); k++) {
      const screws = screwsOf(createChain(anyArm()));
      const lines = linesOf(screws);
      const goal = new Float64Array(8);
      for (const [order, count] of /** @type {const} */ ([
        ['before', 6],
        ['after', 6],
        ['between', 4],
      ])) {
        for (let first = 0; first < count; first++) {
          const elimination = prepareElimination(lines, screws.slides, order, first, even);
          if (!elimination) throw new Error('Expected neighbours of an arm with nothing special to be skew.');
          const q = many(6, 3);
          loopProduct({ lines, slides: screws.slides }, q, goal);
          const { coefficients, noise, size } = eliminate(elimination, lines, goal);
          if (noise / size > 1e-3) doubtful++;
          kinds++;
          expect(Math.abs(evaluate(coefficients, q[elimination.hidden])[0])).toBeLessThan(noise);
        }
      }
    }
    expect(doubtful / kinds).toBeLessThan(0.05);
  });
  test('leads back to the posture, without polishing, slides included', () => {
    for (let slide = 0; slide < 6; slide++) {
      const description = anyArm();
      description.joints[slide].type = 'prismatic';
      const screws = screwsOf(createChain(description));
      const loop = { lines: linesOf(screws), slides: screws.slides, goal: new Float64Array(8) };
      for (const order of /** @type {const} */ (['before', 'after', 'between'])) {
        for (let first = 0; first < 4; first++) {
          const elimination = prepareElimination(loop.lines, loop.slides, order, first, even);
          if (!elimination) continue;
          const q = many(6, 2);
          loopProduct(loop, q, loop.goal);
          const { noise, size } = eliminate(elimination, loop.lines, loop.goal);
          if (!(noise < 1e-6 * size)) continue;
          const gaps = posturesAt(elimination, loop, q[elimination.hidden]).map((posture) => gapAt(loop, posture));
          expect(Math.min(...gaps)).toBeLessThan(1e-7);
        }
      }
    }
  });
  test('is of no use for neighbours that meet, or for a hidden slide', () => {
    const description = anyArm();
    description.joints[1].a = 0; // axes 2 and 3 meet
    description.joints[4].type = 'prismatic';
    const screws = screwsOf(createChain(description));
    const lines = linesOf(screws);
    expect(prepareElimination(lines, screws.slides, 'before', 1, even)).toBe(null);
    expect(prepareElimination(lines, screws.slides, 'after', 1, even)).toBe(null);
    expect(prepareElimination(lines, screws.slides, 'between', 3, even)).toBe(null);
    expect(prepareElimination(lines, screws.slides, 'before', 0, even)).not.toBe(null);
  });
});

test('a loop is closed from nearby, and from far away it is said when it is not', () => {
  const screws = screwsOf(createChain(anyArm()));
  const loop = { lines: linesOf(screws), slides: screws.slides, goal: new Float64Array(8) };
  const q = many(6, 3);
  loopProduct(loop, q, loop.goal);
  expect(gapAt(loop, q)).toBeLessThan(1e-14);
  const start = q.map((value) => value + any(1e-3));
  expect(gapAt(loop, start)).toBeGreaterThan(1e-5);
  expect(closeLoop(loop, start, 10)).toBe(true);
  start.forEach((value, i) => expect(value).toBeCloseTo(q[i], 10));
  loop.goal.set([1, 0, 0, 0, 0, 9, 9, 9]);
  expect(closeLoop(loop, start, 20)).toBe(false);
});
