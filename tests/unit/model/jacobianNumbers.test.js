/**
 * The Jacobian panel's numbers, judged by forward kinematics that shares no code with the kernel, by eigenvalues of J Jᵀ instead
 * of a singular value decomposition, and by the work that forces do.
 */
import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { identity } from '../../../src/kinematics/pose.js';
import { createChain } from '../../../src/kinematics/chain.js';
import { distanceToSingularity } from '../../../src/kinematics/singularity.js';
import { compilePosture, compileRobot } from '../../../src/model/compile.js';
import { copyText } from '../../../src/model/numbers/copyText.js';
import { dexterityNumbers, partOf } from '../../../src/model/numbers/dexterityNumbers.js';
import { ellipsoidAt, ellipsoidScale } from '../../../src/model/numbers/ellipsoid.js';
import { jacobianSheet } from '../../../src/model/numbers/jacobianSheets.js';
import { jacobiansAt, rowsInDocument } from '../../../src/model/numbers/jacobianNumbers.js';
import { FIRST_JACOBIAN } from '../../../src/model/numbers/jacobianView.js';
import { LIBRARY, newDocument } from '../../../src/model/library.js';
import { errorCurves } from '../../../src/model/numbers/quotients.js';
import { nearestSingularity } from '../../../src/model/numbers/singularityNumbers.js';
import { jointLoads } from '../../../src/model/numbers/statics.js';
import { SEED, runs } from '../../helpers/property.js';
import { anyChain, oracleForward, sizeOf } from '../kinematics/oracle.js';

/**
 * @import { ChainDescription } from '../../../src/kinematics/chain.js'
 * @import { JacobianFrame } from '../../../src/model/numbers/jacobianView.js'
 * @import { Matrix } from '../kinematics/oracle.js'
 */

const FRAMES = /** @type {readonly JacobianFrame[]} */ (['world', 'base', 'user', 'tool']);

/** Its axes are the world’s, in another order and one of them turned round. */
const USER = Float64Array.of(0, 1, 0, 0, 0, 0, -1, 0, -1, 0, 0, 0, 0.3, -0.2, 0.1, 1);

const ROBOTS = {
  'Puma 560': LIBRARY.puma560,
  UR5: LIBRARY.ur5,
  'Planar 2R': LIBRARY.planar2r,
  'Cobra 600': LIBRARY.scara_cobra600,
};

/** @param {string} name */
function robotOf(name) {
  const robot = ROBOTS[/** @type {keyof typeof ROBOTS} */ (name)];
  if (!robot) throw new Error(`No ${name} in the library.`);
  return robot;
}

/** @param {Matrix} R @param {readonly number[]} v → Rᵀ v */
const seenFrom = (R, v) => [0, 1, 2].map((i) => [0, 1, 2].reduce((sum, m) => sum + R[m][i] * v[m], 0));

/**
 * Columns by central differences of the oracle's forward kinematics, along the axes of a frame.
 * @param {ChainDescription} description
 * @param {readonly number[]} q
 * @param {JacobianFrame} frame
 */
function byOracle(description, q, frame) {
  const h = 1e-5;
  const T = oracleForward(description, [...q]).tcp;
  const base = description.base;
  /** @type {Matrix} */
  const world = [
    [1, 0, 0],
    [0, 1, 0],
    [0, 0, 1],
  ];
  const baseAxes = base ? [0, 1, 2].map((i) => [0, 1, 2].map((j) => base[4 * j + i])) : world;
  const user = [0, 1, 2].map((i) => [0, 1, 2].map((j) => USER[4 * j + i]));
  const axes = { world, base: baseAxes, user, tool: T }[frame];
  return q.map((_, k) => {
    const at = (/** @type {number} */ by) =>
      oracleForward(
        description,
        q.map((value, i) => (i === k ? value + by : value)),
      ).tcp;
    const [A, B] = [at(-h), at(h)];
    const D = [0, 1, 2].map((i) => [0, 1, 2].map((j) => [0, 1, 2].reduce((sum, m) => sum + B[i][m] * A[j][m], 0)));
    const linear = [0, 1, 2].map((i) => (B[i][3] - A[i][3]) / (2 * h));
    const angular = [D[2][1] - D[1][2], D[0][2] - D[2][0], D[1][0] - D[0][1]].map((value) => value / (4 * h));
    return [...seenFrom(axes, linear), ...seenFrom(axes, angular)];
  });
}

/** Eigenvalues of a symmetric matrix by Jacobi's turns, falling. @param {number[][]} S */
function eigenvalues(S) {
  const A = S.map((row) => [...row]);
  const n = A.length;
  for (let sweep = 0; sweep < 60; sweep++) {
    for (let p = 0; p < n; p++) {
      for (let r = p + 1; r < n; r++) {
        if (A[p][r] === 0) continue;
        const angle = 0.5 * Math.atan2(2 * A[p][r], A[r][r] - A[p][p]);
        const [c, s] = [Math.cos(angle), Math.sin(angle)];
        for (let i = 0; i < n; i++) [A[i][p], A[i][r]] = [c * A[i][p] - s * A[i][r], s * A[i][p] + c * A[i][r]];
        for (let i = 0; i < n; i++) [A[p][i], A[r][i]] = [c * A[p][i] - s * A[r][i], s * A[p][i] + c * A[r][i]];
      }
    }
  }
  return A.map((row, i) => row[i]).sort((a, b) => b - a);
}

test('in every frame, both Jacobians are what the oracle’s forward kinematics does when a joint moves', () => {
  fc.assert(
    fc.property(
      anyChain,
      fc.constantFrom(...FRAMES),
      fc.constantFrom('poses', 'kernel'),
      ({ description, q }, frame, quotient) => {
        const chain = createChain(description);
        const view = { ...FIRST_JACOBIAN, frame, quotient: /** @type {'poses' | 'kernel'} */ (quotient) };
        const { geometric, numeric } = jacobiansAt(chain, q, { ...view, method: 'central' }, USER);
        const size = sizeOf(description);
        // A slide's step is a part of the arm's length: next to nothing for an arm of a nanometre, and then rounding counts,
        // of the farthest place on the way to the tool, which slides may have come back from.
        const { base, tool, joints } = description;
        const ways = [
          ...[base, tool].map((T) => (T ? Math.hypot(T[12], T[13], T[14]) : 0)),
          ...joints.map(({ a, d, type }, k) => Math.hypot(a, d) + (type === 'prismatic' ? Math.abs(q[k]) : 0)),
        ];
        const far = ways.reduce((sum, way) => sum + way);
        const rounding = (1e-15 * far) / (1e-5 * chain.characteristicLength);
        byOracle(description, [...q], frame)
          .flat()
          .forEach((value, i) => {
            expect(Math.abs(geometric[i] - value)).toBeLessThan(1e-8 * size);
            expect(Math.abs(numeric[i] - value)).toBeLessThan(1e-8 * size + rounding);
          });
      },
    ),
    { seed: SEED, numRuns: runs(40) },
  );
});

test('a planar 2R arm has the Jacobian of the books, in its own millimetres per radian', () => {
  const robot = robotOf('Planar 2R');
  const [a1, a2] = robot.joints.map(({ a }) => a);
  const chain = compileRobot(robot);
  const [q1, q2] = [0.4, 0.9];
  const rows = rowsInDocument(robot, jacobiansAt(chain, [q1, q2], { ...FIRST_JACOBIAN, frame: 'world' }).geometric);
  const wanted = [
    [-a1 * Math.sin(q1) - a2 * Math.sin(q1 + q2), -a2 * Math.sin(q1 + q2)],
    [a1 * Math.cos(q1) + a2 * Math.cos(q1 + q2), a2 * Math.cos(q1 + q2)],
    [0, 0],
    [0, 0],
    [0, 0],
    [1, 1],
  ];
  expect(robot.units.length).toBe('mm');
  rows.forEach((row, i) => row.forEach((value, k) => expect(value).toBeCloseTo(wanted[i][k], 9)));
});

test('the error is the same whatever the unit of length, slides included', () => {
  const robot = robotOf('Cobra 600');
  const { base, tool, convention, joints } = compileRobot(robot);
  const larger = (/** @type {Float64Array} */ T) => T.map((value, i) => (i >= 12 && i < 15 ? 1024 * value : value));
  const scaled = createChain({
    ...{ convention, base: larger(base), tool: larger(tool) },
    joints: joints.map((joint) => {
      const by = joint.type === 'prismatic' ? 1024 : 1;
      const { lower, upper } = joint;
      return { ...joint, a: 1024 * joint.a, d: 1024 * joint.d, lower: by * lower, upper: by * upper };
    }),
  });
  const q = [0.3, 0.6, 0.1, 1];
  const one = errorCurves(compileRobot(robot), q, 'poses');
  const other = errorCurves(scaled, q.with(2, 1024 * q[2]), 'poses');
  other.forward.forEach((error, i) => expect(Math.abs(error / one.forward[i] - 1)).toBeLessThan(1e-3));
});

test('each block has its own unit: millimetres per radian, radians, and no unit where a slide moves the tool', () => {
  for (const name of /** @type {const} */ (['Puma 560', 'Cobra 600'])) {
    const robot = robotOf(name);
    const chain = compileRobot(robot);
    const q = robot.joints.map((joint, i) => (joint.type === 'prismatic' ? 0.05 : 0.3 + 0.2 * i));
    const rows = rowsInDocument(robot, jacobiansAt(chain, q, FIRST_JACOBIAN).geometric);
    byOracle(chain, q, 'base').forEach((column, k) =>
      column.forEach((value, i) => {
        const isLength = i < 3 && robot.joints[k].type !== 'prismatic';
        expect(rows[i][k]).toBeCloseTo(isLength ? value * 1000 : value, 4);
      }),
    );
  }
});

/** The slope of a log-log curve between two steps, by least squares. @param {number[]} steps @param {number[]} errors @param {number} from @param {number} to */
function slope(steps, errors, from, to) {
  const points = steps.flatMap((step, i) =>
    step > from && step < to ? [[Math.log10(step), Math.log10(errors[i])]] : [],
  );
  const mean = [0, 1].map((k) => points.reduce((sum, point) => sum + point[k], 0) / points.length);
  const up = points.reduce((sum, [x, y]) => sum + (x - mean[0]) * (y - mean[1]), 0);
  return up / points.reduce((sum, [x]) => sum + (x - mean[0]) ** 2, 0);
}

describe.each(['Puma 560', 'UR5', 'Planar 2R'])('%s: the error against the step', (name) => {
  const robot = robotOf(name);
  const chain = compileRobot(robot);
  const q = robot.joints.map((_, i) => 0.3 + 0.25 * i);

  test('truncation has slope 1 forward and 2 central, and rounding slope −1', () => {
    const { steps, forward, central } = errorCurves(chain, q, 'poses');
    expect(slope(steps, forward, 1e-6, 1e-2)).toBeCloseTo(1, 1);
    expect(slope(steps, central, 1e-3, 1e-1)).toBeCloseTo(2, 1);
    expect(Math.abs(slope(steps, forward, 1e-14, 1e-9) + 1)).toBeLessThan(0.15);
    expect(Math.abs(slope(steps, central, 1e-14, 1e-7) + 1)).toBeLessThan(0.15);
  });
  test('the kernel’s quotient does not know of rounding', () => {
    const { steps, forward } = errorCurves(chain, q, 'kernel');
    expect(slope(steps, forward, 1e-11, 1e-2)).toBeCloseTo(1, 1);
    expect(forward[0]).toBeLessThan(1e-13);
  });
});

test('static torques do the work that the force does, in any frame', () => {
  fc.assert(
    fc.property(
      anyChain,
      fc.constantFrom(...FRAMES),
      fc.array(fc.integer({ min: -50, max: 50 }), { minLength: 6, maxLength: 6 }),
      ({ description, q }, frame, wrench) => {
        const loads = jointLoads(createChain(description), q, wrench, frame, USER);
        byOracle(description, [...q], frame).forEach((column, k) => {
          const work = column.reduce((sum, value, i) => sum + value * wrench[i], 0);
          expect(Math.abs(loads[k] - work)).toBeLessThan(1e-5 * sizeOf(description));
        });
      },
    ),
    { seed: SEED, numRuns: runs(40) },
  );
  const robot = robotOf('Planar 2R');
  const [a1, a2] = robot.joints.map(({ a }) => a / 1000);
  const [first, second] = jointLoads(compileRobot(robot), [0, 0], [0, 10, 0, 0, 0, 0], 'world');
  expect([first, second]).toEqual([expect.closeTo(10 * (a1 + a2), 12), expect.closeTo(10 * a2, 12)]);
});

describe.each(['Puma 560', 'UR5', 'Cobra 600'])('%s', (name) => {
  const robot = robotOf(name);
  const chain = compileRobot(robot);
  const posture = robot.joints.map((joint, i) => (joint.type === 'prismatic' ? 50 : 20 + 17 * i));
  const q = compilePosture(robot, posture);

  test('its singular values are the roots of the eigenvalues of J Jᵀ, rows over L', () => {
    const L = chain.characteristicLength;
    const columns = byOracle(chain, [...q], 'world').map((column, k) =>
      column.map((value, i) => value * (i < 3 ? 1 / L : 1) * (chain.joints[k].type === 'prismatic' ? L : 1)),
    );
    const JJt = [0, 1, 2, 3, 4, 5].map((i) =>
      [0, 1, 2, 3, 4, 5].map((j) => columns.reduce((sum, c) => sum + c[i] * c[j], 0)),
    );
    const { values, manipulability, freedoms, conditionNumber, lengthScale } = dexterityNumbers(
      robot,
      chain,
      q,
      'full',
      'base',
    );
    const roots = eigenvalues(JJt).map((value) => Math.sqrt(Math.max(0, value)));
    values.slice(0, freedoms).forEach((value, i) => expect(value).toBeCloseTo(roots[i], 6));
    expect(manipulability).toBeCloseTo(
      roots.slice(0, freedoms).reduce((a, b) => a * b, 1),
      5,
    );
    expect(conditionNumber).toBeCloseTo(roots[0] / roots[freedoms - 1], 4);
    expect(lengthScale).toBeCloseTo(L * 1000, 9);
  });
  test('joint rates of norm 1 reach the velocity ellipsoid and nothing beyond it', () => {
    const { halves, axes, drawn, scale } = ellipsoidAt(chain, q, 'velocity');
    const J = byOracle(chain, [...q], 'world');
    const rateOf = (/** @type {number} */ k) => (chain.joints[k].type === 'prismatic' ? chain.characteristicLength : 1);
    let farthest = 0;
    for (let turn = 0; turn < 400; turn++) {
      const rates = J.map((_, k) => Math.sin(1 + turn * (1.7 + k)));
      const norm = Math.hypot(...rates);
      const v = [0, 1, 2].map((i) => J.reduce((sum, column, k) => sum + (column[i] * rates[k] * rateOf(k)) / norm, 0));
      const along = halves.map(
        (half, m) => (v[0] * axes[3 * m] + v[1] * axes[3 * m + 1] + v[2] * axes[3 * m + 2]) / half,
      );
      farthest = Math.max(farthest, Math.hypot(...along));
    }
    expect(farthest).toBeLessThan(1 + 1e-6);
    expect(farthest).toBeGreaterThan(0.9);
    drawn.forEach((length, m) => expect(length).toBeCloseTo(halves[m] * scale, 12));
  });
});

test('velocity and force ellipsoids are each other’s reciprocals, and what is held without limit is cut and said so', () => {
  const robot = robotOf('Planar 2R');
  const chain = compileRobot(robot);
  const [velocity, force] = [ellipsoidAt(chain, [0.3, 1], 'velocity'), ellipsoidAt(chain, [0.3, 1], 'force')];
  [0, 1].forEach((k) => expect(velocity.halves[k] * force.halves[k]).toBeCloseTo(1, 9));
  expect(force.halves[2]).toBe(Infinity);
  expect(force.isCut).toBe(true);
  expect(velocity.isCut).toBe(false);
  expect(Math.max(...force.drawn)).toBeLessThanOrEqual(1.5 * chain.characteristicLength);
  for (const kind of /** @type {const} */ (['velocity', 'force']))
    expect(String(ellipsoidScale(chain, kind))).toMatch(/^[0.]*[125]0*$/);
});

test('a straight wrist has lost a turn, and joints 4 and 6 move nothing against each other', () => {
  const robot = robotOf('Puma 560');
  const chain = compileRobot(robot);
  const q = compilePosture(robot, [10, 40, -100, 30, 0, 20]);
  const { worst, conditionNumber, manipulability, rank } = dexterityNumbers(robot, chain, q, 'full', 'tool');
  expect([conditionNumber, manipulability, rank]).toEqual([Infinity, 0, 5]);
  expect(worst?.isLost).toBe(true);
  expect(worst?.joints.map(({ joint }) => joint).sort()).toEqual([3, 5]);
  expect(worst?.joints[0].share).toBeCloseTo(-(worst?.joints[1].share ?? 0), 9);
  const found = distanceToSingularity(chain, compilePosture(robot, [10, 40, -100, 30, 12, 20]));
  const near = nearestSingularity(robot, [10, 40, -100, 30, 12, 20], found);
  expect(near).toMatchObject({ isFound: true, isHere: false, joint: 4, kinds: ['wrist'] });
  expect(near.distance).toBeCloseTo(12, 6);
  expect(near.by).toBeCloseTo(-12, 6);
  expect(near.nearness).toBeCloseTo(1 - 12 / 90, 6);
});

test('what is copied is read again as the same numbers', () => {
  const robot = robotOf('UR5');
  const chain = compileRobot(robot);
  const doc = newDocument(robot);
  const q = compilePosture(robot, doc.posture);
  const view = { ...FIRST_JACOBIAN, wrench: [1, 2, 3, 4, 5, 6] };
  const read = (/** @type {'geometric' | 'numeric' | 'measures' | 'statics'} */ what) =>
    JSON.parse(copyText(jacobianSheet(what, doc, chain, q, view, identity()), 'json'));
  expect(read('geometric').J).toEqual(
    rowsInDocument(robot, jacobiansAt(chain, q, view).geometric).map((row) => row.map((value) => value + 0)),
  );
  expect(read('numeric').J).not.toEqual(read('geometric').J);
  expect(read('statics').tau.values).toEqual(jointLoads(chain, q, view.wrench, 'base').map((value) => value + 0));
  expect(read('measures').sigma.values).toHaveLength(6);
  expect(partOf(chain, null)).toBe('full');
  const inUser = { ...view, frame: /** @type {const} */ ('user') };
  const text = copyText(jacobianSheet('geometric', { ...doc, activeUser: 'table' }, chain, q, inUser, USER), 'text');
  expect(text).toContain('along the axes of the user frame table');
});
