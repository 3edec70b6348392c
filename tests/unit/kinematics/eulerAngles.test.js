/** @import { EulerSequence } from '../../../src/kinematics/orientations/eulerAngles.js' */
/** @import { Matrix } from './oracle.js' */
import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import {
  EULER_SEQUENCES,
  eulerAnglesOf,
  poseFromEulerAngles,
} from '../../../src/kinematics/orientations/eulerAngles.js';
import { EULER_NAMES } from '../../../src/kinematics/orientations/eulerNames.js';
import { identity } from '../../../src/kinematics/pose.js';
import { createRandom } from '../../../src/kinematics/random.js';
import { SEED, runs } from '../../helpers/property.js';
import { anyPose, columnMajor, largestDifference, rigid, rodrigues, rotationOf, rowsOf, times } from './oracle.js';

const QUARTER = Math.PI / 2;
const ORIGIN = [0, 0, 0];
const DEGREE = Math.PI / 180;
const anyTurn = fc.double({ min: -Math.PI, max: Math.PI, noNaN: true });
const random = createRandom(SEED);
const between = (/** @type {number} */ min, /** @type {number} */ max) => min + (max - min) * random();

/** @type {Record<string, number[]>} */
const UNIT = { x: [1, 0, 0], y: [0, 1, 0], z: [0, 0, 1] };
/** A quarter turn about each axis, in whole numbers. @type {Record<string, Matrix>} */
const QUARTER_TURN = {
  x: [
    [1, 0, 0],
    [0, 0, -1],
    [0, 1, 0],
  ],
  y: [
    [0, 0, 1],
    [0, 1, 0],
    [-1, 0, 0],
  ],
  z: [
    [0, -1, 0],
    [1, 0, 0],
    [0, 0, 1],
  ],
};

/** @param {string} axis @param {number} count @returns {Matrix} */
const quarterTurns = (axis, count) =>
  [QUARTER_TURN[axis], QUARTER_TURN[axis], QUARTER_TURN[axis]]
    .slice(0, (count + 8) % 4)
    .reduce(times, rotationOf(rowsOf(identity())));

/** @param {EulerSequence} sequence */
const isIntrinsic = (sequence) => sequence === sequence.toUpperCase();
/** @param {EulerSequence} sequence */
const isProper = (sequence) => sequence[0] === sequence[2];

/**
 * The three elementary rotations as they stand in the product: in the order of the sequence if each is about the axes the
 * one before has turned, against it if all are about the same fixed ones.
 * @template V
 * @param {EulerSequence} sequence
 * @param {readonly V[]} values  in the order of the sequence
 * @param {(axis: string, value: V, place: number) => Matrix} elementary
 */
function product(sequence, values, elementary) {
  const factors = Array.from(sequence.toLowerCase(), (axis, i) => elementary(axis, values[i], i));
  return (isIntrinsic(sequence) ? factors : factors.reverse()).reduce(times);
}

/** @param {EulerSequence} sequence @param {readonly number[]} angles */
const oracle = (sequence, angles) => product(sequence, angles, (axis, angle) => rodrigues(UNIT[axis], angle));

/** @param {Matrix} R */
const poseOf = (R) => columnMajor(rigid(R, ORIGIN));
/** @param {ArrayLike<number>} T @param {Matrix} R */
const offBy = (T, R) => largestDifference(rotationOf(rowsOf(T)), R);

/** @param {EulerSequence} sequence @param {Float64Array} angles */
function expectInRange(sequence, [first, middle, last]) {
  const [least, most] = isProper(sequence) ? [0, Math.PI] : [-QUARTER, QUARTER];
  expect([first, last].every((outer) => outer > -Math.PI && outer <= Math.PI)).toBe(true);
  expect(middle >= least && middle <= most).toBe(true);
}

test('there are 24 sequences: twelve about moving axes and the same about fixed axes', () => {
  expect(new Set(EULER_SEQUENCES).size).toBe(24);
  expect(Object.isFrozen(EULER_SEQUENCES)).toBe(true);
  const moving = EULER_SEQUENCES.filter(isIntrinsic);
  expect(moving.length).toBe(12);
  expect(EULER_SEQUENCES.filter((name) => !isIntrinsic(name))).toEqual(moving.map((name) => name.toLowerCase()));
  for (const name of moving) expect(name).toMatch(/^(?!.*(.)\1)[XYZ]{3}$/);
});

describe.each(EULER_SEQUENCES)('%s', (sequence) => {
  test('is the product of its elementary rotations, and comes back', () => {
    fc.assert(
      fc.property(anyTurn, anyTurn, anyTurn, (...angles) => {
        const T = poseFromEulerAngles([1, 2, 3], angles, sequence);
        expect(offBy(T, oracle(sequence, angles))).toBeLessThan(3e-15); // 4 ulp of π count as π
        expect(Array.from(T).filter((_, i) => i % 4 === 3 || i > 11)).toEqual([0, 0, 0, 1, 2, 3, 1]);
        const found = eulerAnglesOf(T, sequence);
        expectInRange(sequence, found.angles);
        const again = poseFromEulerAngles([1, 2, 3], found.angles, sequence);
        expect(largestDifference(rowsOf(again), rowsOf(T))).toBeLessThan(3e-15);
      }),
      { seed: SEED, numRuns: runs(25) },
    );
  });
  test('in its range gives the same angles again, as well as the distance from gimbal lock allows', () => {
    for (let n = 0; n < 60; n++) {
      const middle = isProper(sequence) ? between(0, Math.PI) : between(-QUARTER, QUARTER);
      const angles = [between(-3.14, 3.14), middle, between(-3.14, 3.14)];
      const T = poseFromEulerAngles(ORIGIN, angles, sequence);
      const found = eulerAnglesOf(T, sequence);
      const away = isProper(sequence) ? Math.min(middle, Math.PI - middle) : QUARTER - Math.abs(middle);
      expect(found.lockDistance).toBeCloseTo(away, 14);
      angles.forEach((angle, i) => expect(Math.abs(found.angles[i] - angle)).toBeLessThan(2e-15 / away));
      const again = poseFromEulerAngles(ORIGIN, found.angles, sequence);
      expect(largestDifference(rowsOf(again), rowsOf(T))).toBeLessThan(1e-15);
    }
  });
  test('comes back from any orientation, and gives it again', () => {
    fc.assert(
      fc.property(anyPose, (T) => {
        const { angles } = eulerAnglesOf(T, sequence);
        expectInRange(sequence, angles);
        const again = poseFromEulerAngles(T.subarray(12, 15), angles, sequence);
        expect(largestDifference(rowsOf(again), rowsOf(T))).toBeLessThan(3e-15);
      }),
      { seed: SEED, numRuns: runs(25) },
    );
  });
  test('is exact at all multiples of right angles, there and back, without a minus zero', () => {
    for (let n = 0; n < 64; n++) {
      // each angle 0 to 3 right angles, some of them a full turn more or less
      const counts = [n % 4, (n >> 2) % 4, n >> 4].map((count, i) => count + 4 * (((n + i) % 3) - 1));
      const R = product(sequence, counts, quarterTurns);
      const T = poseFromEulerAngles(
        ORIGIN,
        counts.map((count) => count * QUARTER),
        sequence,
      );
      const exact = poseOf(R).map((value) => value + 0);
      expect(T).toEqual(exact);
      const { angles } = eulerAnglesOf(T, sequence);
      expect(angles.every((angle) => [-QUARTER, 0, QUARTER, Math.PI].some((x) => Object.is(x, angle)))).toBe(true);
      expect(poseFromEulerAngles(ORIGIN, angles, sequence)).toEqual(exact);
    }
  });
  test('at and near gimbal lock gives the orientation again, and says where it is locked', () => {
    const leftmost = isIntrinsic(sequence) ? 0 : 2;
    for (const away of [0, 1e-16, 3e-16, 1e-15, 2e-15, 1e-14, 1e-13, 1e-12, 1e-10, 1e-9, 1e-8, 1e-7, 1e-5, 1e-3]) {
      for (let n = 0; n < 8; n++) {
        const [first, last] = n < 2 ? [0, 0] : [between(-3, 3), between(-3, 3)];
        const quarters = (isProper(sequence) ? 0 : 1) + 2 * (n % 2);
        // the lock itself in whole numbers, so that 1e-16 away from it is 1e-16 away
        const R = product(sequence, [first, n % 4 < 2 ? away : -away, last], (axis, angle, place) => {
          const turn = rodrigues(UNIT[axis], angle);
          return place === 1 ? times(quarterTurns(axis, quarters), turn) : turn;
        });
        const { angles, isGimbalLock, lockDistance } = eulerAnglesOf(poseOf(R), sequence);
        expectInRange(sequence, angles);
        expect(Math.abs(lockDistance - away)).toBeLessThan(6e-16);
        expect(isGimbalLock).toBe(away < 1.5e-15 || (away < 3e-15 && isGimbalLock));
        if (isGimbalLock) expect(Object.is(angles[leftmost], 0)).toBe(true);
        // within 8 ulp of 1 the lock wins, within 4 ulp of π the right angle
        const tolerance = away > 5e-16 && away < 3e-15 ? 2.5e-15 : 1.2e-15;
        expect(offBy(poseFromEulerAngles(ORIGIN, angles, sequence), R)).toBeLessThan(tolerance);
      }
    }
  });
});

test('an intrinsic sequence has the angles of the extrinsic one that is read the other way round, at gimbal lock too', () => {
  for (const sequence of EULER_SEQUENCES.filter(isIntrinsic)) {
    const mirrored = /** @type {EulerSequence} */ ([...sequence.toLowerCase()].reverse().join(''));
    for (const middle of [0.4, 0, QUARTER, Math.PI]) {
      const T = poseFromEulerAngles(ORIGIN, [0.5, middle, -1.2], sequence);
      expect(poseFromEulerAngles(ORIGIN, [-1.2, middle, 0.5], mirrored)).toEqual(T);
      expect(eulerAnglesOf(T, mirrored).angles.reverse()).toEqual(eulerAnglesOf(T, sequence).angles);
    }
  }
});

test('what is written into out is what is returned', () => {
  const T = new Float64Array(16).fill(7);
  expect(poseFromEulerAngles([1, 2, 3], [0.1, 0.2, 0.3], 'ZXZ', T)).toBe(T);
  expect(T).toEqual(poseFromEulerAngles([1, 2, 3], [0.1, 0.2, 0.3], 'ZXZ'));
  const out = { angles: new Float64Array(3), isGimbalLock: true, lockDistance: 0 };
  expect(eulerAnglesOf(T, 'ZXZ', out)).toBe(out);
  expect(out).toEqual(eulerAnglesOf(T, 'ZXZ'));
});

test('axes with six decimals are read, to six decimals', () => {
  const T = poseFromEulerAngles(ORIGIN, [0.7, 0.3, -2], 'zyx').map((value) => Number(value.toFixed(6)));
  const { angles } = eulerAnglesOf(T, 'zyx');
  [0.7, 0.3, -2].forEach((angle, i) => expect(Math.abs(angles[i] - angle)).toBeLessThan(2e-6));
});

describe('published numbers', () => {
  const { PI } = Math;
  test.each(
    /** @type {[string, EulerSequence, number[], Matrix, number][]} */ ([
      [
        'Corke, Robotics, Vision and Control, section 2.3.1: rpy2r(0.1, 0.2, 0.3)',
        'xyz',
        [0.1, 0.2, 0.3],
        [
          [0.9363, -0.2751, 0.2184],
          [0.2896, 0.9564, -0.037],
          [-0.1987, 0.0978, 0.9752],
        ],
        6e-5,
      ],
      [
        'Corke, section 2.3.1: eul2r(0.1, 0.2, 0.3)',
        'ZYZ',
        [0.1, 0.2, 0.3],
        [
          [0.9021, -0.3836, 0.1977],
          [0.3875, 0.9216, 0.0198],
          [-0.1898, 0.0587, 0.9801],
        ],
        6e-5,
      ],
      [
        'MathWorks, eul2rotm([0 pi/2 0])',
        'ZYX',
        [0, PI / 2, 0],
        [
          [0, 0, 1],
          [0, 1, 0],
          [-1, 0, 0],
        ],
        0,
      ],
      [
        "MathWorks, eul2rotm([0 pi/2 pi/2], 'ZYZ')",
        'ZYZ',
        [0, PI / 2, PI / 2],
        [
          [0, 0, 1],
          [1, 0, 0],
          [0, 1, 0],
        ],
        0,
      ],
      [
        'MathWorks, so3([pi/4 pi/3 pi/8], "eul")',
        'ZYX',
        [PI / 4, PI / 3, PI / 8],
        [
          [0.3536, -0.4189, 0.8364],
          [0.3536, 0.8876, 0.2952],
          [-0.866, 0.1913, 0.4619],
        ],
        6e-5,
      ],
      [
        'Rz(90°) Rx(90°), which is not Rx(90°) Rz(90°) (Craig, section 2.8)',
        'ZXZ',
        [PI / 2, PI / 2, 0],
        [
          [0, 0, 1],
          [1, 0, 0],
          [0, 1, 0],
        ],
        0,
      ],
      [
        'Rx(90°) Rz(90°)',
        'zxz',
        [PI / 2, PI / 2, 0],
        [
          [0, -1, 0],
          [0, 0, -1],
          [1, 0, 0],
        ],
        0,
      ],
    ]),
  )('%s', (_, sequence, angles, printed, tolerance) => {
    const T = poseFromEulerAngles(ORIGIN, angles, sequence);
    expect(offBy(T, printed)).toBeLessThanOrEqual(tolerance);
    if (sequence !== 'ZXZ')
      angles.forEach((angle, i) => expect(eulerAnglesOf(T, sequence).angles[i]).toBeCloseTo(angle, 14));
  });
  test('Craig, equations 2.64 and 2.66: fixed angles of 10°, 20°, 30° come back', () => {
    const angles = [10, 20, 30].map((degrees) => degrees * DEGREE);
    const found = eulerAnglesOf(poseFromEulerAngles(ORIGIN, angles, 'xyz'), 'xyz').angles;
    angles.forEach((angle, i) => expect(found[i]).toBeCloseTo(angle, 14));
  });
  test('roll 30°, pitch 90°, yaw 70° is roll 0°, pitch 90°, yaw 40°', () => {
    const one = poseFromEulerAngles(ORIGIN, [30 * DEGREE, QUARTER, 70 * DEGREE], 'xyz');
    const other = poseFromEulerAngles(ORIGIN, [0, QUARTER, 40 * DEGREE], 'xyz');
    expect(largestDifference(rowsOf(one), rowsOf(other))).toBeLessThan(3e-16);
    const { angles, isGimbalLock } = eulerAnglesOf(one, 'xyz');
    expect([isGimbalLock, angles[1], angles[2]]).toEqual([true, QUARTER, 0]);
    expect(angles[0]).toBeCloseTo(-40 * DEGREE, 15);
  });
});

test('the names of the sequences name sequences that there are, three angles each, and cannot be written to', () => {
  expect(Object.isFrozen(EULER_NAMES)).toBe(true);
  expect(new Set(EULER_NAMES.map(({ name }) => name)).size).toBe(EULER_NAMES.length);
  for (const entry of EULER_NAMES) {
    expect(EULER_SEQUENCES).toContain(entry.sequence);
    expect(new Set(entry.angles).size).toBe(3);
    expect([entry, entry.angles].every(Object.isFrozen)).toBe(true);
  }
});

test('W P R of a FANUC, read backwards, is A B C of a KUKA; a Mitsubishi writes A B C forwards', () => {
  const sequenceOf = (/** @type {string} */ name) =>
    EULER_NAMES.find((entry) => entry.name === name)?.sequence ?? 'XYX';
  const T = poseFromEulerAngles(ORIGIN, [0.1, 0.2, 0.3], sequenceOf('FANUC'));
  expect(eulerAnglesOf(T, sequenceOf('KUKA')).angles.reverse()).toEqual(eulerAnglesOf(T, 'xyz').angles);
  expect(poseFromEulerAngles(ORIGIN, [0.1, 0.2, 0.3], sequenceOf('Mitsubishi'))).toEqual(T);
});

describe('wrong calls are refused', () => {
  const T = poseFromEulerAngles(ORIGIN, ORIGIN, 'XYZ');
  test.each(['ZZX', 'xyY', 'zyX', 'xy', 'abc', '', null, 3])('the sequence %j', (wrong) => {
    const sequence = /** @type {EulerSequence} */ (/** @type {unknown} */ (wrong));
    expect(() => poseFromEulerAngles(ORIGIN, ORIGIN, sequence)).toThrow('Expected a sequence such as');
    expect(() => eulerAnglesOf(T, sequence)).toThrow(typeof wrong === 'string' ? `got '${wrong}'` : `got ${wrong}`);
  });
  test.each([
    [[0, 0], [0, 0, 0], 'Expected a position to be 3 numbers, got 2.'],
    [[0, 0, 0], [0, 0, 0, 0], 'Expected Euler angles to be 3 numbers, got 4.'],
    [[0, 0, -Infinity], [0, 0, 0], 'Expected a position to be finite, got -Infinity at index 2.'],
    [[0, 0, 0], [0, NaN, 0], 'Expected Euler angles to be finite, got NaN at index 1.'],
  ])('%j with %j', (xyz, angles, words) => {
    expect(() => poseFromEulerAngles(xyz, angles, 'XYZ')).toThrow(words);
  });
  test('no pose, or no room', () => {
    expect(() => eulerAnglesOf(T.with(5, NaN), 'XYZ')).toThrow('got NaN at index 5');
    expect(() => eulerAnglesOf(T.with(0, -1), 'XYZ')).toThrow('left-handed axes');
    expect(() => eulerAnglesOf([1, 2, 3], 'XYZ')).toThrow('got 3 numbers');
    expect(() => poseFromEulerAngles(ORIGIN, ORIGIN, 'XYZ', new Float64Array(9))).toThrow(
      'Expected room for 16 numbers',
    );
  });
});
