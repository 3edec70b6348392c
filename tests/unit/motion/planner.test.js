/** Ways around obstacles: found where there are, never through something, never claimed where there are none. */
import { describe, expect, test } from 'vitest';
import { createChain } from '../../../src/kinematics/chain.js';
import { armBodies } from '../../../src/motion/clearance/armBodies.js';
import { createWorkcell } from '../../../src/motion/clearance/workcell.js';
import { planAround, planAtOnce } from '../../../src/motion/planner/planAround.js';
import { PLANAR, pointsOn } from './workcells.js';

/** @import { PlanarCase } from './workcells.js' */

const DEGREE = Math.PI / 180;
const SEEDS = process.env.DENAVIT_DEEP ? 20 : 2;
const ITERATIONS = 10_000;

/** @param {PlanarCase} given */
function problemOf({ links, capsule_radius: radius, limits_deg, obstacles_xyr, start_deg, goal_deg }) {
  const [lower, upper] = limits_deg.map((limit) => limit * DEGREE);
  const chain = createChain({
    convention: 'standard',
    joints: links.map((a) => ({ type: 'revolute', a, alpha: 0, d: 0, theta: 0, lower, upper })),
  });
  const obstacles = obstacles_xyr.map(([x, y, r]) => ({
    kind: /** @type {const} */ ('sphere'),
    centre: [x, y, 0],
    radius: r,
  }));
  return {
    cell: createWorkcell(armBodies(chain, [radius, radius]), obstacles),
    from: start_deg.map((value) => value * DEGREE),
    to: goal_deg.map((value) => value * DEGREE),
  };
}

/** By the place on each link that is nearest to a circle's centre. @param {PlanarCase} given @param {ArrayLike<number>} q  rad */
function isClear({ links, capsule_radius, obstacles_xyr }, q) {
  const [ex, ey] = [links[0] * Math.cos(q[0]), links[0] * Math.sin(q[0])];
  const [ux, uy] = [Math.cos(q[0] + q[1]), Math.sin(q[0] + q[1])];
  return obstacles_xyr.every(([x, y, r]) => {
    const first = Math.min(links[0], Math.max(0, (x * ex + y * ey) / links[0])) / links[0];
    const second = Math.min(links[1], Math.max(0, (x - ex) * ux + (y - ey) * uy));
    const least = (r + capsule_radius) ** 2;
    return (
      (x - first * ex) ** 2 + (y - first * ey) ** 2 > least &&
      (x - ex - second * ux) ** 2 + (y - ey - second * uy) ** 2 > least
    );
  });
}

const solvable = PLANAR.map((given, i) => ({ given, i })).filter(({ given }) => given.label === 'solvable');
const unsolvable = PLANAR.map((given, i) => ({ given, i })).filter(({ given }) => given.label !== 'solvable');

describe('two joints among circles', () => {
  test('there are 20 with a way, and 30 without', () => {
    expect([solvable.length, unsolvable.length]).toEqual([20, 30]);
  });
  test.each(solvable)('problem $i: a way that touches nothing, no longer than 1.3 of the grid’s', ({ given }) => {
    const { cell, from, to } = problemOf(given);
    for (let seed = 1; seed <= SEEDS; seed++) {
      const plan = planAtOnce(cell, from, to, { seed, iterations: ITERATIONS });
      if (plan.status !== 'found') throw new Error(`seed ${seed}: ${plan.status}`);
      expect(Array.from(plan.way[0])).toEqual(from);
      expect(Array.from(plan.way[plan.way.length - 1])).toEqual(to);
      expect(plan.length / DEGREE).toBeLessThanOrEqual(1.3 * (given.grid_shortest_deg_1deg_8conn ?? NaN));
      for (let i = 1; i < plan.way.length; i++) {
        const [one, other] = [Array.from(plan.way[i - 1]), Array.from(plan.way[i])];
        const farthest = Math.max(...one.map((value, j) => Math.abs(other[j] - value)));
        for (const q of pointsOn([one, other], Math.ceil(farthest / (0.1 * DEGREE)) || 1)) {
          if (!isClear(given, q))
            throw new Error(`seed ${seed}: touches at ${q.map((value) => value / DEGREE).join(', ')}`);
        }
        for (const value of other) {
          expect(value).toBeGreaterThanOrEqual(given.limits_deg[0] * DEGREE);
          expect(value).toBeLessThanOrEqual(given.limits_deg[1] * DEGREE);
        }
      }
    }
  });
  test.each(process.env.DENAVIT_DEEP ? unsolvable : unsolvable.slice(0, 6))(
    'problem $i: none is found, and no more is said',
    ({ given }) => {
      const { cell, from, to } = problemOf(given);
      const iterations = process.env.DENAVIT_DEEP ? ITERATIONS : 1500;
      expect(planAtOnce(cell, from, to, { iterations })).toEqual({ status: 'not-found', iterations });
    },
  );
});

describe('a search', () => {
  const { cell, from, to } = problemOf(solvable[0].given);

  test('is the same for the same seed', () => {
    expect(planAtOnce(cell, from, to, { seed: 7 })).toEqual(planAtOnce(cell, from, to, { seed: 7 }));
  });
  test('counts its iterations, and ends when they are spent', () => {
    const counted = [...planAround(cell, from, to, { iterations: 5, seed: 3 })];
    expect(counted).toEqual(counted.map((_, i) => i + 1));
    expect(counted.length).toBeLessThanOrEqual(5);
  });
  test('goes straight where nothing is in the way', () => {
    const plan = planAtOnce(createWorkcell(cell.bodies, []), from, to);
    expect(plan).toMatchObject({
      status: 'found',
      iterations: 0,
      way: [Float64Array.from(from), Float64Array.from(to)],
    });
  });
  test('says which end is not clear itself, and of what', () => {
    const blocked = createWorkcell(cell.bodies, [
      { kind: 'sphere', centre: [0.5 * Math.cos(to[0]), 0.5 * Math.sin(to[0]), 0], radius: 0.05 },
    ]);
    expect(planAtOnce(blocked, from, to)).toMatchObject({ status: 'goal', touch: { obstacle: 0 } });
    expect(planAtOnce(blocked, to, from)).toMatchObject({ status: 'start', touch: { obstacle: 0 } });
  });
});
