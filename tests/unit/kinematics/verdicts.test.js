import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { createChain } from '../../../src/kinematics/chain.js';
import { inverseKinematics } from '../../../src/kinematics/inverse.js';
import { SEED, runs } from '../../helpers/property.js';
import { expectHonest } from './honest.js';
import {
  arm,
  columnMajor,
  fromLine,
  inverseCases,
  oracleForward,
  rigid,
  rodrigues,
  rotationOf,
  times,
} from './oracle.js';

/** @import { ChainDescription } from '../../../src/kinematics/chain.js' */
/** @import { InverseOptions } from '../../../src/kinematics/descent/inverseOptions.js' */
/** @import { Matrix } from './oracle.js' */

const QUARTER = Math.PI / 2;
/** @param {ChainDescription} description @param {Matrix} goal @param {InverseOptions} [options] */
const solve = (description, goal, options) =>
  expectHonest(description, goal, inverseKinematics(createChain(description), columnMajor(goal), options), options);
/** @param {ChainDescription} description @param {ArrayLike<number>} q */
const goalOf = (description, q) => oracleForward(description, q).tcp;
/** The same place, the orientation turned about an axis of the tool. @param {Matrix} goal @param {number[]} axis @param {number} angle */
const turned = (goal, axis, angle) =>
  rigid(
    times(rotationOf(goal), rodrigues(axis, angle)),
    [0, 1, 2].map((i) => goal[i][3]),
  );
/** @param {Matrix} goal @param {number[]} by */
const moved = (goal, by) =>
  rigid(
    rotationOf(goal),
    [0, 1, 2].map((i) => goal[i][3] + by[i]),
  );
/** @param {number} min @param {number} max */
const between = (min, max) => fc.double({ min, max, noNaN: true });

describe('out of reach', () => {
  const planar = arm('planar2r');
  test('a goal beyond a planar arm says by how much, and the arm points at it', () => {
    for (const [x, y] of [
      [3, 0],
      [0, -2.5],
      [1.5, 1.5],
    ]) {
      const result = solve(planar, rigid(rodrigues([0, 0, 1], Math.atan2(y, x)), [x, y, 0]));
      expect(result.status).toBe('unreachable');
      expect(result.beyondReach).toBeCloseTo(Math.hypot(x, y) - 2, 12);
      expect(result.positionError).toBeCloseTo(Math.hypot(x, y) - 2, 6);
      expect(result.q[1]).toBeCloseTo(0, 3);
    }
  });
  test('a goal at the very end of the arm is not', () => {
    expect(solve(planar, goalOf(planar, [0.7, 0])).status).toBe('converged');
    const hair = solve(planar, rigid(rodrigues([0, 0, 1], 0), [2 + 1e-7, 0, 0]));
    expect(hair.status).toBe('unreachable');
    expect(hair.beyondReach).toBeCloseTo(1e-7, 12);
  });
  test('is never said of a pose that forward kinematics made, at full stretch included', () => {
    for (const name of /** @type {const} */ (['puma560', 'ur5', 'planar2r'])) {
      const description = arm(name);
      fc.assert(
        fc.property(between(-1, 1), between(-1, 1), (one, two) => {
          // elbows straight: as far out as the arm goes
          const q = description.joints.map((_, i) => [one, two, name === 'puma560' ? -QUARTER : 0, 0, 0.3, 0][i]);
          const result = solve(description, goalOf(description, q), { restarts: 5 });
          expect(result.status).not.toBe('unreachable');
        }),
        { seed: SEED, numRuns: runs(30) },
      );
    }
  });
  test('is not said because of rounding, however small the tolerance and however far away the base', () => {
    const base = columnMajor(rigid(rodrigues([1, 2, 3], 1), [1e4, -1e4, 1e4]));
    for (const description of [planar, { ...planar, base }]) {
      for (let k = 0; k < 40; k++) {
        const goal = columnMajor(goalOf(description, [k / 7, 0]));
        const result = inverseKinematics(createChain(description), goal, { positionTolerance: 1e-300, restarts: 0 });
        expect(result.status).not.toBe('unreachable');
      }
    }
  });
  test('the far poses of the data are out of reach by what geometry says at least', () => {
    for (const name of /** @type {const} */ (['puma560', 'ur5'])) {
      const chain = createChain(arm(name));
      for (const [why, ...line] of inverseCases[name].unreachable ?? []) {
        if (why !== 'distance') continue;
        const goal = fromLine(line);
        const result = solve(arm(name), goal);
        const away = Math.hypot(...chain.shoulder.map((value, k) => goal[k][3] - value));
        expect(result.status).toBe('unreachable');
        expect(result.beyondReach).toBeCloseTo(away - chain.reach, 12);
        expect(result.positionError).toBeGreaterThanOrEqual(/** @type {number} */ (result.beyondReach) - 1e-12);
      }
    }
  });
});

describe('outside the limits', () => {
  test('a pose that only a joint past its limit can take says which and by how much', () => {
    // Elbow and shoulder both free to choose, so only the base turn decides: the mirrored arm is out by more.
    const description = arm('planar2r');
    const [shoulder, elbow] = description.joints;
    const joints = [
      { ...shoulder, lower: -1, upper: 1 },
      { ...elbow, lower: 0, upper: 2 },
    ];
    const limited = { ...description, joints };
    for (const past of [0.01, 0.1, 0.5]) {
      const above = solve(limited, goalOf(description, [1 + past, 1]));
      expect(above.status).toBe('outside-limits');
      expect(above.limit).toEqual({ joint: 0, by: expect.closeTo(past, 7), bound: 'upper' });
      const below = solve(limited, goalOf(description, [-1 - past, 1]));
      expect(below.limit).toEqual({ joint: 0, by: expect.closeTo(past, 7), bound: 'lower' });
    }
  });
  test('a slide is short by millimetres', () => {
    const description = arm('scara_cobra600');
    const below = solve(description, goalOf(description, [0.1, 0.5, 0.21 + 0.03, 0.2]));
    expect(below.status).toBe('outside-limits');
    expect(below.limit).toEqual({ joint: 2, by: expect.closeTo(0.03, 8), bound: 'upper' });
    expect(below.positionError).toBeLessThan(0.031);
  });
  test('a slide that is short by metres is, too, and no turn makes up for a slide', () => {
    /** @type {ChainDescription} */
    const telescope = {
      convention: 'standard',
      joints: [
        { type: 'revolute', a: 0, alpha: QUARTER, d: 0, theta: 0 },
        { type: 'revolute', a: 0, alpha: -QUARTER, d: 0, theta: 0 },
        { type: 'prismatic', a: 0, alpha: 0, d: 0, theta: 0, lower: 0.5, upper: 1 },
      ],
    };
    expect(solve(telescope, goalOf(telescope, [0.3, 0.4, 1.1]))).toMatchObject({
      status: 'outside-limits',
      limit: { joint: 2, by: expect.closeTo(0.1, 8), bound: 'upper' },
    });
    expect(solve(telescope, goalOf(telescope, [0.3, 0.4, 3]))).toMatchObject({
      status: 'outside-limits',
      limit: { joint: 2, by: expect.closeTo(2, 8), bound: 'upper' },
    });
    const scara = arm('scara_cobra600');
    expect(solve(scara, moved(goalOf(scara, [0.1, 0.5, 0.1, 0.2]), [1, 0, 0]))).toMatchObject({
      status: 'unreachable',
      reason: 'distance',
    });
  });
  test('nothing is outside by nothing: a solution found while ignoring the limits, but inside them, is an answer', () => {
    for (const name of /** @type {const} */ (['puma560', 'scara_cobra600'])) {
      for (const line of inverseCases[name].reachable) {
        const { status, limit } = solve(arm(name), fromLine(line), { restarts: 0 });
        if (status === 'outside-limits') expect(limit?.by).toBeGreaterThan(1e-6);
      }
    }
  });
  test('the poses of the data that only ignoring the limits allows are called so', () => {
    const cases = (inverseCases.puma560.unreachable ?? []).filter(([why]) => why === 'limits');
    expect(cases.length).toBeGreaterThan(10);
    for (const [, ...line] of cases) {
      const { status, limit } = solve(arm('puma560'), fromLine(line));
      expect(status).toBe('outside-limits');
      expect(limit && limit.by > 0 && limit.joint >= 0 && limit.joint < 6).toBe(true);
    }
  });
  test('widened by as much as is said, and a little, the limits let the pose in', () => {
    const { convention, joints } = arm('puma560');
    for (const [why, ...line] of inverseCases.puma560.unreachable ?? []) {
      if (why !== 'limits') continue;
      const { limit } = solve(arm('puma560'), fromLine(line));
      const by = /** @type {number} */ (limit?.by) + 1e-6;
      const wider = joints.map((row) => ({
        ...row,
        lower: row.lower - by,
        upper: row.upper + by,
      }));
      expect(solve({ convention, joints: wider }, fromLine(line)).status).toBe('converged');
    }
  });
  test('an arm whose joints all turn a full turn has no such verdict', () => {
    for (const [, ...line] of inverseCases.ur5.unreachable ?? []) {
      expect(['unreachable', 'stalled', 'budget']).toContain(solve(arm('ur5'), fromLine(line)).status);
    }
  });
});

describe('no posture at all', () => {
  test('six joints that cannot make the pose say so without blaming reach or limits, and give the nearest', () => {
    for (const [why, ...line] of inverseCases.ur5.unreachable ?? []) {
      if (why !== 'geometry') continue;
      const result = solve(arm('ur5'), fromLine(line));
      expect(['unreachable', 'stalled', 'budget']).toContain(result.status);
      if (result.status !== 'unreachable') expect(result.restarts).toBe(200);
      expect(result.positionError + result.orientationError).toBeGreaterThan(1e-6);
    }
  });
  test('what is called nearest is where no joint inside its limits can better it', () => {
    const description = arm('ur5');
    const length = createChain(description).characteristicLength;
    const cases = (inverseCases.ur5.unreachable ?? []).filter(([why]) => why === 'geometry').slice(0, 8);
    for (const [, ...line] of cases) {
      const goal = fromLine(line);
      const { q, positionError, orientationError } = solve(description, goal);
      const cost = (positionError / length) ** 2 + orientationError ** 2;
      for (let joint = 0; joint < 6; joint++) {
        for (const step of [1e-4, -1e-4]) {
          const other = goalOf(
            description,
            q.map((value, i) => (i === joint ? value + step : value)),
          );
          const position = Math.hypot(...[0, 1, 2].map((i) => other[i][3] - goal[i][3]));
          const chord = Math.hypot(...rotationOf(other).flatMap((row, i) => row.map((value, j) => value - goal[i][j])));
          const angle = 2 * Math.asin(Math.min(1, chord / Math.sqrt(8)));
          expect((position / length) ** 2 + angle ** 2).toBeGreaterThan(cost * (1 - 1e-6) - 1e-9);
        }
      }
    }
  });
  test('the nearest of many starts is kept, not the last', () => {
    const description = arm('ur5');
    const length = createChain(description).characteristicLength;
    for (const [why, ...line] of inverseCases.ur5.unreachable ?? []) {
      if (why !== 'geometry') continue;
      const costs = [0, 3, 10, 30].map((restarts) => {
        const { positionError, orientationError } = solve(description, fromLine(line), { restarts });
        return (positionError / length) ** 2 + orientationError ** 2;
      });
      for (let i = 1; i < costs.length; i++) expect(costs[i]).toBeLessThan(costs[i - 1] * 1.05);
    }
  });
  test('a budget of nothing is said to be spent', () => {
    const goal = fromLine(inverseCases.puma560.reachable[0]);
    const none = solve(arm('puma560'), goal, { restarts: 0, maxIterations: 0, descentsOnly: true });
    expect([none.status, none.iterations, none.restarts]).toEqual(['budget', 0, 0]);
  });
});

describe('fewer than six joints', () => {
  const scara = arm('scara_cobra600');
  const planar = arm('planar2r');
  test('a tilt that a SCARA cannot make leaves position and turn, with the smallest rotation missing that there is', () => {
    fc.assert(
      fc.property(
        between(-0.8, 0.8),
        between(-1.4, 1.4),
        between(0.02, 0.2),
        between(-2, 2),
        between(0.05, 0.5),
        (a, b, c, d, tilt) => {
          const goal = turned(goalOf(scara, [a, b, c, d]), [1, 0, 0], tilt);
          const result = solve(scara, goal);
          expect(result.status).toBe('subspace');
          expect(result.task).toEqual({
            name: 'position-and-turn',
            met: ['position', 'turn-about-upright'],
            free: ['tilt'],
          });
          expect(Math.abs(result.orientationError - tilt)).toBeLessThan(1e-9);
        },
      ),
      { seed: SEED, numRuns: runs(30) },
    );
  });
  test('a turn that its limit forbids leaves position and tilt', () => {
    const joints = scara.joints.map((row, i) => (i === 3 ? { ...row, lower: -0.5, upper: 0.5 } : row));
    const fixed = scara.joints.map((row, i) => (i === 3 ? { ...row, lower: 0.5, upper: 0.5 } : row));
    // With no solution ignoring the limits either: a wrist that is welded to a tilted tool.
    const goal = goalOf(scara, [0.2, 0.3, 0.1, 2]);
    const result = solve({ ...scara, joints }, goal);
    expect(result.status).toBe('outside-limits');
    expect(result.limit?.joint).toBe(3);
    expect(solve({ ...scara, joints: fixed.slice(0, 3) }, goal)).toMatchObject({
      status: 'subspace',
      task: { name: 'position-and-tilt', met: ['position', 'tilt'], free: ['turn-about-upright'] },
    });
  });
  test('a planar arm meets any point of its ring; in the plane the tilt is met too', () => {
    fc.assert(
      fc.property(between(0.1, 1.95), between(-3, 3), between(-3, 3), (radius, direction, heading) => {
        const goal = rigid(rodrigues([0, 0, 1], heading), [
          radius * Math.cos(direction),
          radius * Math.sin(direction),
          0,
        ]);
        const result = solve(planar, goal);
        expect(result.status).toBe('subspace');
        expect(result.task?.name).toBe('position-and-tilt');
      }),
      { seed: SEED, numRuns: runs(50) },
    );
  });
  test('a planar arm with a tool axis asked for that it cannot have meets the position', () => {
    const result = solve(planar, rigid(rodrigues([1, 0, 0], 0.4), [1, 0.5, 0]));
    expect(result.task?.name).toBe('position');
  });
  test('a goal out of the plane is met in no task, and the nearest posture is found', () => {
    const result = solve(planar, moved(goalOf(planar, [0.3, 0.8]), [0, 0, 0.1]));
    expect(result).toMatchObject({ status: 'unreachable', reason: 'distance', shortBy: expect.closeTo(0.1, 9) });
    expect(result.positionError).toBeCloseTo(0.1, 6);
  });
  test('an exactly opposite tool axis is a tilt of a half turn, not of none', () => {
    const result = solve(
      planar,
      rigid(
        [
          [1, 0, 0],
          [0, -1, 0],
          [0, 0, -1],
        ],
        [1, 0.5, 0],
      ),
    );
    expect(result.task?.name).toBe('position');
    expect(result.orientationError).toBeCloseTo(Math.PI, 6);
  });
  test('a position that only a joint past its limit can reach is outside the limits, task named', () => {
    const joints = planar.joints.map((row) => ({ ...row, lower: -0.5, upper: 0.5 }));
    const goal = turned(goalOf(planar, [0.7, 0.3]), [1, 0, 0], 0.3);
    const result = solve({ ...planar, joints }, goal);
    expect(result.status).toBe('outside-limits');
    expect(result.task?.name).toBe('position');
    expect(result.limit?.joint).toBe(0);
    expect(result.limit?.by).toBeCloseTo(0.2, 6);
  });
  test('six joints are never let off with a part', () => {
    for (const [, ...line] of inverseCases.puma560.unreachable ?? []) {
      expect(solve(arm('puma560'), fromLine(line)).status).not.toBe('subspace');
    }
  });
});
