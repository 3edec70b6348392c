/**
 * Orientations by turns about given directions, by Rodrigues' formula.
 * @import { Vector } from '../../../src/kinematics/lines.js'
 */
import { expect, test } from 'vitest';
import { createRandom } from '../../../src/kinematics/random.js';
import { solveTurns } from '../../../src/kinematics/solvers/wristTurns.js';
import { SEED, runs } from '../../helpers/property.js';
import { largestDifference, rodrigues, times, transpose } from './oracle.js';

const random = createRandom(SEED);

/** @returns {Vector} */
function anyDirection() {
  const v = [random() - 0.5, random() - 0.5, random() - 0.5];
  const length = Math.hypot(...v);
  return /** @type {Vector} */ (v.map((value) => value / length));
}

/** @param {readonly number[][]} axes @param {ArrayLike<number>} angles */
const made = (axes, angles) =>
  axes.reduce((R, axis, i) => times(R, rodrigues([...axis], angles[i])), rodrigues([0, 0, 1], 0));

/** @param {readonly Vector[]} axes @param {number[]} angles */
function solve(axes, angles) {
  const R = made(axes, angles);
  const solutions = solveTurns(axes, transpose(R).flat());
  const members = [...solutions.angles, ...solutions.families.map((family) => family.angles)];
  return { ...solutions, worst: Math.max(0, ...members.map((some) => largestDifference(made(axes, some), R))) };
}

const same = (/** @type {number[]} */ p, /** @type {number[]} */ q) =>
  p.every((value, i) => Math.abs(Math.sin((value - q[i]) / 2)) < 1e-7);
const anyAngle = () => (2 * random() - 1) * Math.PI;

test('three turns about any directions have two solutions, or one where the two meet', () => {
  for (let i = 0; i < runs(300); i++) {
    const axes = [anyDirection(), anyDirection(), anyDirection()];
    const q = axes.map(anyAngle);
    const { angles, families, worst } = solve(axes, q);
    expect([angles.length, families.length]).toEqual([2, 0]);
    expect(worst).toBeLessThan(1e-12);
    expect(angles.some((some) => same(some, q))).toBe(true);
  }
});

test('what three turns cannot reach has no solution', () => {
  // The last axis stays within 0.7 rad of the second, and that within 0.7 rad of the first.
  const axes = /** @type {Vector[]} */ ([0, 0.7, 1.4].map((angle) => [Math.sin(angle), 0, Math.cos(angle)]));
  const upsideDown = transpose(rodrigues([1, 0, 0], Math.PI)).flat();
  expect(solveTurns(axes, upsideDown)).toEqual({ angles: [], families: [], isComplete: true });
});

test('at the end of what three turns reach the two solutions are one', () => {
  const axes = /** @type {Vector[]} */ ([0, 0.7, 1.2].map((angle) => [Math.sin(angle), 0, Math.cos(angle)]));
  for (const second of [0, Math.PI]) {
    const { angles, worst } = solve(axes, [0.3, second, -0.4]);
    expect(angles).toHaveLength(1);
    expect(worst).toBeLessThan(1e-14);
  }
});

test('fewer turns have one solution, or none', () => {
  for (let count = 0; count < 3; count++) {
    for (let i = 0; i < runs(50); i++) {
      const axes = Array.from({ length: count }, anyDirection);
      const q = axes.map(anyAngle);
      const { angles, worst } = solve(axes, q);
      expect(angles).toHaveLength(1);
      expect(worst).toBeLessThan(1e-12);
      const elsewhere = transpose(made([anyDirection(), anyDirection(), anyDirection()], [1, 2, 3])).flat();
      expect(solveTurns(axes, elsewhere).angles).toEqual([]);
    }
  }
});

test.each([1, -1])('the first and the last axis in line: only their sum counts (%i)', (sign) => {
  const axes = /** @type {Vector[]} */ ([
    [0, 0, 1],
    [Math.sin(0.8), 0, Math.cos(0.8)],
    [0, 0, sign],
  ]);
  for (const second of [0, 1e-10]) {
    const { angles, families, worst } = solve(axes, [0.3, second, 0.4]);
    expect(angles).toEqual([]);
    expect(families.map(({ moving }) => moving)).toEqual([[0, 2]]);
    expect(worst).toBeLessThan(1e-9);
  }
  for (const second of [1e-3, 1e-6, 1e-8]) {
    const q = [0.3, second, 0.4];
    const { angles, families, worst } = solve(axes, q);
    expect(families).toEqual([]);
    expect(worst).toBeLessThan(1e-14);
    const bends = angles.map((some) => Math.sin(some[1]) / second).sort();
    expect(bends).toEqual([expect.closeTo(-1, 6), expect.closeTo(1, 6)]);
  }
});

test('neighbours about one direction make families', () => {
  const [a, b] = [anyDirection(), anyDirection()];
  const cases = /** @type {const} */ ([
    [[a, a], [[0, 1]]],
    [[a, a, b], [[0, 1]]],
    [[a, b, b], [[1, 2]]],
    [[a, a, a], [[0, 1, 2]]],
  ]);
  for (const [axes, moving] of cases) {
    const { angles, families, worst } = solve(axes, [0.1, 0.2, 0.3]);
    expect(angles).toEqual([]);
    expect(families.map((family) => family.moving)).toEqual(moving);
    expect(worst).toBeLessThan(1e-12);
  }
});

test('four turns are one too many: members of what they make, even where the first is not to be zero', () => {
  for (let i = 0; i < runs(100); i++) {
    const axes = Array.from({ length: 4 }, anyDirection);
    const { angles, families, isComplete, worst } = solve(axes, axes.map(anyAngle));
    expect(angles).toEqual([]);
    expect(families.length).toBeGreaterThan(0);
    expect(families[0].moving).toEqual([0, 1, 2, 3]);
    expect(worst).toBeLessThan(1e-7);
    expect(isComplete).toBe(true);
  }
});
