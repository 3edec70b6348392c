import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { createChain } from '../../../src/kinematics/chain.js';
import { inverseKinematics } from '../../../src/kinematics/inverse.js';
import { SEED, runs } from '../../helpers/property.js';
import { expectHonest } from './honest.js';
import {
  ARMS,
  anyChain,
  arm,
  columnMajor,
  forwardCases,
  fromLine,
  inverseCases,
  oracleForward,
  rigid,
  rotationOf,
  times,
} from './oracle.js';

/** @import { ChainDescription } from '../../../src/kinematics/chain.js' */
/** @import { InverseOptions } from '../../../src/kinematics/descent/inverseOptions.js' */
/** @import { Matrix } from './oracle.js' */

const HALF_TURN = Math.PI;

/**
 * Solve, and hold the answer to what it says.
 * @param {ChainDescription} description
 * @param {Matrix} goal
 * @param {InverseOptions} [options]
 */
const solve = (description, goal, options) =>
  expectHonest(description, goal, inverseKinematics(createChain(description), columnMajor(goal), options), options);

/** @param {ChainDescription} description @param {ArrayLike<number>} q */
const goalOf = (description, q) => oracleForward(description, q).tcp;

/** Postures uniformly inside the limits of an arm. @param {ReturnType<typeof arm>} description */
const anyPosture = ({ joints }) =>
  fc
    .array(fc.double({ min: 0, max: 1, noNaN: true }), { minLength: joints.length, maxLength: joints.length })
    .map((parts) => joints.map(({ lower, upper }, i) => Math.min(upper, lower + (upper - lower) * parts[i])));

describe.each(ARMS)('%s', (name) => {
  const description = arm(name);
  const { reachable, nearSingular = [] } = inverseCases[name];
  test('all 200 reachable poses converge from the default seed', () => {
    expect(reachable.length).toBe(200);
    for (const line of reachable) expect(solve(description, fromLine(line)).status).toBe('converged');
  });
  test('poses next to a singularity converge', () => {
    for (const line of nearSingular) expect(solve(description, fromLine(line)).status).toBe('converged');
  });
  test('from within 0.05 rad of a posture the answer comes at once, and is near', () => {
    let far = 0;
    for (const q of forwardCases[name].q) {
      const seed = q.map(
        (value, i) => value + (i % 2 ? 0.05 : -0.05) * (description.joints[i].type === 'prismatic' ? 0.1 : 1),
      );
      const result = solve(description, goalOf(description, q), { seed });
      expect(result.status).toBe('converged');
      if (result.restarts > 0 || q.some((value, i) => Math.abs(value - result.q[i]) > 0.3)) far++;
    }
    expect(far).toBeLessThanOrEqual(1); // a posture next to a singularity has neighbours on its other side
  });
  test('a goal at which every joint stands at one of its limits converges', () => {
    const { joints } = description;
    for (let corner = 0; corner < 2 ** joints.length; corner++) {
      const q = joints.map(({ lower, upper }, i) => ((corner >> i) & 1 ? upper : lower));
      expect(solve(description, goalOf(description, q)).status).toBe('converged');
    }
  });
  test('scaling the arm, and the tolerance with it, scales the slides and changes nothing else', () => {
    for (const scale of [1e-3, 25.4, 1e3]) {
      for (const line of reachable.slice(0, 20)) {
        const goal = fromLine(line);
        const one = solve(description, goal);
        const scaled = goal.map((row, i) => row.map((value, j) => (j === 3 && i < 3 ? value * scale : value)));
        const other = solve(arm(name, scale), scaled, { positionTolerance: 1e-9 * scale });
        expect(other.status).toBe(one.status);
        one.q.forEach((value, i) => {
          const unit = description.joints[i].type === 'prismatic' ? scale : 1;
          expect(Math.abs(other.q[i] / unit - value)).toBeLessThan(1e-6);
        });
      }
    }
  });
});

test('with the wrist centre next to the line of the first axis, where the way down is a narrow bend, it is found', () => {
  // KUKA KR 6 R900 after ros-industrial/kuka_experimental, kr6r900sixx_macro.xacro; metres, degrees
  const table = [
    [0.025, -90, 0.4, 0, -170, 170],
    [0.455, 0, 0, 0, -190, 45],
    [0.035, 90, 0, -90, -120, 156],
    [0, -90, -0.42, 0, -185, 185],
    [0, 90, 0, 0, -120, 120],
    [0, 180, -0.08, 0, -350, 350],
  ];
  const joints = table.map(([a, alpha, d, theta, lower, upper]) => {
    const [twist, angle, low, high] = [alpha, theta, lower, upper].map((degrees) => (degrees * Math.PI) / 180);
    return { type: /** @type {const} */ ('revolute'), a, alpha: twist, d, theta: angle, lower: low, upper: high };
  });
  for (const q of [
    [
      0.12481093357273254, -1.458107156145418, -0.21126532090970507, -1.584057402298287, 1.5173094041588908,
      -3.0438360922862384,
    ],
    [
      1.8325828826416366, -1.8295239432961017, 0.5605027825546993, -2.230619181651272, 1.0281860357655659,
      -1.2129690402132978,
    ],
    [
      0.7448162102067521, -2.681575216870582, 2.3319739758392735, -1.1252504736470854, -0.000610773519975627,
      -5.220050183608631,
    ],
  ]) {
    /** @type {ChainDescription} */
    const description = { convention: 'standard', joints };
    expect(solve(description, goalOf(description, q), { restarts: 10 }).status).toBe('converged');
  }
});

test('a gantry with unlimited slides and a small wrist goes metres away in one descent', () => {
  const slide = { type: /** @type {const} */ ('prismatic'), a: 0, d: 0, theta: 0 };
  const turn = { type: /** @type {const} */ ('revolute'), a: 0, d: 0, theta: 0 };
  /** @type {ChainDescription} */
  const gantry = {
    convention: 'standard',
    joints: [
      { ...slide, alpha: HALF_TURN / 2 },
      { ...slide, alpha: HALF_TURN / 2, theta: HALF_TURN / 2 },
      { ...slide, alpha: 0 },
      { ...turn, alpha: HALF_TURN / 2 },
      { ...turn, alpha: -HALF_TURN / 2 },
      { ...turn, alpha: 0, d: 1e-3 },
    ],
  };
  for (const q of [
    [3, -2, 5, 0.4, 0.8, -1],
    [300, 200, -500, 0.4, 0.8, -1],
    [0.01, 0, 0, 1, 1, 1],
  ]) {
    const { status, restarts } = solve(gantry, goalOf(gantry, q));
    expect([status, restarts]).toEqual(['converged', 0]);
  }
});

/** Postures with room to turn the tool over without moving it. */
const ROOMY = {
  puma560: [
    [0.3, 0.8, -0.4, 0.5, 0.9, -0.2],
    [0, 0.5, 0.5, 0, 1, 0],
    [1, 1, -1, 0, 0.7, 0.7],
  ],
  ur5: [
    [0.3, -1.2, 1.1, -0.7, 0.9, 0.4],
    [0, -1.5, 1.5, 0, 1.5, 0],
    [1, -1, 1.5, 0.5, 1.2, 0],
  ],
};

test.each(ARMS)('scaling by a power of two, which rounds nothing, changes not one bit of the search: %s', (name) => {
  const description = arm(name);
  const goals = [...inverseCases[name].reachable.slice(0, 10), ...(inverseCases[name].nearSingular ?? []).slice(0, 5)];
  for (const scale of [2 ** -10, 2 ** 10]) {
    for (const goal of goals.map(fromLine)) {
      const one = solve(description, goal);
      const scaled = goal.map((row, i) => row.map((value, j) => (j === 3 && i < 3 ? value * scale : value)));
      const other = solve(arm(name, scale), scaled, { positionTolerance: 1e-9 * scale });
      const wanted = one.q.map((value, i) => (description.joints[i].type === 'prismatic' ? value * scale : value));
      expect([other.iterations, ...other.q]).toEqual([one.iterations, ...wanted]);
    }
  }
});

describe('a half turn', () => {
  for (const name of /** @type {const} */ (['puma560', 'ur5'])) {
    test(`of the tool from the seed's own orientation, exactly, about x, y, z or between, converges: ${name}`, () => {
      const { convention, joints } = arm(name);
      const description = {
        convention,
        joints: joints.map((row) => ({ ...row, lower: -2 * HALF_TURN, upper: 2 * HALF_TURN })),
      };
      for (const seed of ROOMY[name]) {
        const start = goalOf(description, seed);
        for (const axis of [
          [1, 0, 0],
          [0, 1, 0],
          [0, 0, 1],
          [1, 1, 0],
        ]) {
          const goal = rigid(
            times(exactHalfTurn(axis), rotationOf(start)),
            [0, 1, 2].map((i) => start[i][3]),
          );
          expect(solve(description, goal, { seed }).status).toBe('converged');
        }
      }
    });
  }
  test('that a SCARA can make about its vertical, it makes', () => {
    const description = arm('scara_cobra600');
    const start = goalOf(description, [0.2, 0.4, 0.1, 1]);
    const goal = rigid(
      times(exactHalfTurn([0, 0, 1]), rotationOf(start)),
      [0, 1, 2].map((i) => start[i][3]),
    );
    expect(solve(description, goal, { seed: [0.2, 0.4, 0.1, 1] }).status).toBe('converged');
  });
});

/** 2uuᵀ − 1. @param {number[]} axis */
function exactHalfTurn(axis) {
  const square = axis.reduce((sum, value) => sum + value * value, 0);
  return axis.map((x, i) => axis.map((y, j) => (2 * x * y) / square - (i === j ? 1 : 0)));
}

describe('whatever is asked', () => {
  test('a goal made by forward kinematics inside the limits is never called impossible', () => {
    for (const name of ARMS) {
      const description = arm(name);
      fc.assert(
        fc.property(anyPosture(description), (q) => {
          expect(solve(description, goalOf(description, q)).status).toBe('converged');
        }),
        { seed: SEED, numRuns: runs(100) },
      );
    }
  });
  test('the answer is inside the limits and its errors are true: any goal, any arm of the library', () => {
    for (const name of ARMS) {
      const description = arm(name);
      const anyGoal = fc
        .tuple(anyPosture(arm('puma560')), fc.double({ min: 0, max: 2, noNaN: true }))
        .map(([q, far]) =>
          goalOf(arm('puma560'), q).map((row, i) => row.map((v, j) => (j === 3 && i < 3 ? v * far : v))),
        );
      fc.assert(
        fc.property(anyGoal, (goal) => void solve(description, goal, { restarts: 10 })),
        { seed: SEED, numRuns: runs(25) },
      );
    }
  });
  test('the answer is inside the limits and its errors are true: any chain of 1 to 7 joints with base and tool', () => {
    fc.assert(
      fc.property(
        anyChain,
        fc.infiniteStream(fc.double({ min: 0, max: 2, noNaN: true })),
        ({ description, q }, widths) => {
          const joints = description.joints.map((row, i) => {
            const width = widths.next().value;
            return width > 1.5 ? row : { ...row, lower: q[i] - width, upper: q[i] + width / 2 };
          });
          const limited = { ...description, joints };
          const result = solve(limited, goalOf(limited, q), {
            restarts: 20,
            positionTolerance: 1e-8,
            orientationTolerance: 1e-8,
          });
          expect(['unreachable', 'outside-limits']).not.toContain(result.status);
        },
      ),
      { seed: SEED, numRuns: runs(60) },
    );
  });
  test('the same question has the same answer, and another random seed may have another', () => {
    const description = arm('puma560');
    for (const line of inverseCases.puma560.reachable.slice(0, 20)) {
      const first = solve(description, fromLine(line));
      solve(description, fromLine(inverseCases.puma560.reachable[50])); // another search in between leaves no trace
      expect(solve(description, fromLine(line))).toEqual(first);
    }
    const answers = inverseCases.puma560.reachable.slice(0, 20).map((line) => {
      const [one, two] = [1, 2].map((randomSeed) => solve(description, fromLine(line), { randomSeed }).q);
      return one.every((value, i) => value === two[i]);
    });
    expect(answers).toContain(false);
  });
  test('what is returned belongs to the caller', () => {
    const description = arm('puma560');
    const [one, two] = inverseCases.puma560.reachable.map(fromLine);
    const first = solve(description, one);
    const kept = first.q.slice();
    solve(description, two);
    expect(first.q).toEqual(kept);
  });
});

test('few iterations make it no less true: what is within tolerance is called converged, and nothing else is', () => {
  for (const maxIterations of [0, 1, 3, 6]) {
    for (const line of inverseCases.ur5.reachable.slice(0, 40))
      solve(arm('ur5'), fromLine(line), { restarts: 0, maxIterations });
  }
});

describe('the seed', () => {
  test('is the middle of the limits, or zero where there are none', () => {
    /** @type {ChainDescription} */
    const description = {
      convention: 'standard',
      joints: [
        { type: 'revolute', a: 1, alpha: 0, d: 0, theta: 0, lower: 0.5, upper: 1.5 },
        { type: 'revolute', a: 1, alpha: 0, d: 0, theta: 0 },
      ],
    };
    const result = solve(description, goalOf(description, [1, 0]));
    expect([result.iterations, ...result.q]).toEqual([0, 1, 0]);
  });
  test('that solves already is the answer, with all its full turns', () => {
    const description = arm('ur5');
    const seed = [6, -6, 3, 4, -5, 6.2];
    const result = solve(description, goalOf(description, seed), { seed });
    expect(Array.from(result.q)).toEqual(seed);
  });
  test('decides between full turns: each joint is the nearest inside the limits', () => {
    const description = arm('ur5');
    const q = [0.5, -1, 1.2, -0.4, 0.9, -0.3];
    const away = q.map((value, i) => value + (i % 2 ? 2 : -2) * HALF_TURN);
    const result = solve(description, goalOf(description, q), { seed: away.map((value) => value + 0.01) });
    result.q.forEach((value, i) => expect(value).toBeCloseTo(away[i], 8));
  });
  test('outside the limits is brought inside first', () => {
    const description = arm('puma560');
    const q = [0.3, 0.8, -0.4, 0.5, 0.9, -0.2];
    const result = solve(description, goalOf(description, q), { seed: q.map((value) => value + 4 * HALF_TURN) });
    expect(result.restarts).toBe(0);
    q.forEach((value, i) => expect(result.q[i]).toBeCloseTo(value, 8));
  });
});

describe('wrong calls', () => {
  const chain = createChain(arm('planar2r'));
  const goal = columnMajor(goalOf(arm('planar2r'), [0.1, 0.2]));
  test.each([
    [{ seed: [0] }, 'Expected 2 joint values, got 1.'],
    [{ seed: [0, NaN] }, 'Expected joint value 2 to be a finite number, got NaN.'],
    [{ positionTolerance: 0 }, 'Expected positionTolerance to be positive, got 0.'],
    [{ orientationTolerance: NaN }, 'Expected orientationTolerance to be positive, got NaN.'],
    [{ restarts: -1 }, 'Expected restarts to be a whole number, got -1.'],
    [{ restarts: Infinity }, 'Expected restarts to be a whole number, got Infinity.'],
    [{ maxIterations: 2.5 }, 'Expected maxIterations to be a whole number, got 2.5.'],
    [{ randomSeed: NaN }, 'Expected randomSeed to be a whole number, got NaN.'],
  ])('%j is refused', (options, words) => {
    expect(() => inverseKinematics(chain, goal, options)).toThrow(RangeError);
    expect(() => inverseKinematics(chain, goal, options)).toThrow(words);
  });
  test('a goal that is no pose is refused', () => {
    expect(() => inverseKinematics(chain, new Float64Array(16))).toThrow('Expected the goal to be a pose');
    expect(() => inverseKinematics(chain, goal.slice(0, 12))).toThrow('got 12 numbers');
  });
});
