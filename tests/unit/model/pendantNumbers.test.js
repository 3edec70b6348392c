/** The pendant's numbers and the way back, judged by the formula as a person would write it down for each arm. */
import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { LIBRARY } from '../../../src/model/library.js';
import {
  coupledWith,
  onPendant,
  postureFromPendant,
  withPendantValue,
  zeroOnPendant,
} from '../../../src/model/controller/pendantNumbers.js';
import { hasPendant } from '../../../src/model/controller/controllerData.js';
import { runs, SEED } from '../../helpers/property.js';

/** @import { ControllerDoc, JointDoc, RobotDoc, Units } from '../../../src/model/document.js' */

const PLAIN = { sign: /** @type {const} */ (1), offset: 0, coupling: 0 };

/**
 * @param {Partial<ControllerDoc>[]} controllers
 * @param {{ units?: Units, joint?: Partial<JointDoc> }} [options]
 * @returns {RobotDoc}
 */
function arm(controllers, { units = { length: 'mm', angle: 'deg' }, joint = {} } = {}) {
  const [first] = LIBRARY.puma560.joints;
  return {
    ...LIBRARY.puma560,
    units,
    joints: controllers.map((controller, i) => ({
      ...first,
      id: `j${i + 1}`,
      ...{ lower: -170, upper: 170, home: 0 },
      ...joint,
      controller: { ...PLAIN, ...controller },
    })),
  };
}

const J3_TO_J2 = { coupledTo: 'j2', coupling: -1 };
const FANUC = arm([{}, {}, J3_TO_J2, {}, {}, {}]);

/** Degrees as a person types them. */
const anyDegrees = fc.integer({ min: -17000, max: 17000 }).map((hundredths) => hundredths / 100);
const anyPosture = fc.array(anyDegrees, { minLength: 6, maxLength: 6 });
const anyController = fc.record({ sign: fc.constantFrom(1, -1), offset: fc.integer({ min: -180, max: 180 }) });

test('a typed number stands there, the others stay to the last digits, and joints that it does not move keep theirs', () => {
  const anyArm = fc
    .array(anyController, { minLength: 6, maxLength: 6 })
    .map((controllers) => arm(controllers.map((each, i) => (i === 2 ? { ...each, ...J3_TO_J2 } : each))));
  fc.assert(
    fc.property(anyArm, anyPosture, fc.nat(5), anyDegrees, (robot, posture, index, value) => {
      const before = onPendant(robot, posture).values;
      const next = withPendantValue(robot, posture, index, value);
      const after = onPendant(robot, next).values;
      after.forEach((number, i) => expect(number).toBeCloseTo(i === index ? value : before[i], 9));
      next.forEach((q, i) => {
        if (i !== index && !(index === 1 && i === 2)) expect(q).toBe(posture[i]);
      });
      // J = sign · q + offset − J2, so q = sign · (J − offset + J2)
      const { sign, offset } = robot.joints[2].controller;
      expect(next[2]).toBeCloseTo(sign * (after[2] - offset + after[1]), 9);
    }),
    { seed: SEED, numRuns: runs(200) },
  );
});

test('there and back in any units', () => {
  for (const angle of /** @type {const} */ (['deg', 'rad'])) {
    const robot = arm([{ sign: -1, offset: angle === 'deg' ? 90 : Math.PI / 2 }, {}, J3_TO_J2, { sign: -1 }, {}, {}], {
      units: { length: 'm', angle },
    });
    fc.assert(
      fc.property(anyPosture, (degrees) => {
        const posture = angle === 'deg' ? degrees : degrees.map((value) => (value * Math.PI) / 180);
        const { values } = onPendant(robot, posture);
        expect(values[0]).toBeCloseTo(90 - degrees[0], 9);
        expect(values[2]).toBeCloseTo(degrees[2] - degrees[1], 9);
        postureFromPendant(robot, values).forEach((q, i) => expect(q).toBeCloseTo(posture[i], 11));
      }),
      { seed: SEED, numRuns: runs(50) },
    );
  }
});

describe('an arm whose J3 counts against J2', () => {
  const robot = {
    ...FANUC,
    joints: FANUC.joints.map((joint, i) => ({
      ...joint,
      ...[{}, { lower: -60, upper: 76 }, { lower: -50, upper: 230 }][i],
    })),
  };

  test('moves both when J2 is changed, and shows the published numbers of an R-2000iB', () => {
    expect(withPendantValue(robot, [0, 10, 20, 0, 0, 0], 1, 30)).toEqual([0, 30, 40, 0, 0, 0]);
    const { values } = onPendant(robot, [7.962, -5.284, -41.534, 77.661, -51.975, -79.273]);
    expect(values[2]).toBeCloseTo(-36.25, 12);
    expect(coupledWith(robot, 2)).toBe(1);
  });
  test('has limits of J3 that move with J2, and of J2 no farther than the third joint lets it', () => {
    const { robot: shown, limits } = onPendant(robot, [0, 20, 0, 0, 0, 0]);
    expect([shown.joints[2].lower, shown.joints[2].upper]).toEqual([-70, 210]);
    // J3 = −20: q3 = J3 + J2 from −50 on, so J2 from −30 on
    expect([shown.joints[1].lower, shown.joints[1].upper]).toEqual([-30, 76]);
    expect(limits[1].stoppedBy).toEqual([2]);
    expect(limits[2].stoppedBy).toEqual([]);
  });
  test('never leaves a limit of a joint by a number that is inside those of the pendant', () => {
    const inside = fc
      .tuple(fc.nat(100), fc.nat(100))
      .map(([a, b]) => [0, -60 + (136 * a) / 100, -50 + (280 * b) / 100, 0, 0, 0]);
    fc.assert(
      fc.property(inside, fc.constantFrom(1, 2), fc.nat(100), (posture, index, share) => {
        const { lower = NaN, upper = NaN } = onPendant(robot, posture).robot.joints[index];
        const q = withPendantValue(robot, posture, index, lower + ((upper - lower) * share) / 100);
        robot.joints.forEach((joint, i) => {
          expect(q[i]).toBeGreaterThanOrEqual((joint.lower ?? -Infinity) - 1e-9);
          expect(q[i]).toBeLessThanOrEqual((joint.upper ?? Infinity) + 1e-9);
        });
      }),
      { seed: SEED, numRuns: runs(200) },
    );
  });
  test('lets J2 free where the third joint is past its limits already', () => {
    const { robot: shown } = onPendant(robot, [0, 20, -90, 0, 0, 0]);
    expect([shown.joints[1].lower, shown.joints[1].upper]).toEqual([-60, 76]);
  });
});

test('a turned sign turns the limits round, and a limit is met to the last digit', () => {
  const robot = arm([{ sign: -1, offset: 0.1 }, {}, {}, {}, {}, {}], { joint: { lower: -10.3, upper: 200.7 } });
  const { robot: shown } = onPendant(robot, [0, 0, 0, 0, 0, 0]);
  const { lower = NaN, upper = NaN } = shown.joints[0];
  expect([lower, upper]).toEqual([expect.closeTo(-200.6, 12), expect.closeTo(10.4, 12)]);
  expect(withPendantValue(robot, [0, 0, 0, 0, 0, 0], 0, lower)[0]).toBe(200.7);
  expect(withPendantValue(robot, [0, 0, 0, 0, 0, 0], 0, upper)[0]).toBe(-10.3);
});

test('all numbers at zero, or at the limit where zero is none', () => {
  const robot = arm([{ offset: 200 }, {}, J3_TO_J2, {}, {}, {}]);
  expect(zeroOnPendant(robot, false)).toEqual({ posture: [-200, 0, 0, 0, 0, 0], stopped: [] });
  expect(zeroOnPendant(robot, true)).toEqual({ posture: [-170, 0, 0, 0, 0, 0], stopped: [0] });
});

test('it is offered where a controller has numbers or a configuration for the arm', () => {
  expect(['puma560', 'ur5', 'scara_cobra600', 'planar2r'].map((id) => hasPendant(LIBRARY[id]))).toEqual([
    true,
    true,
    false,
    false,
  ]);
});

test('a joint without limits takes the number that it is given', () => {
  const robot = {
    ...LIBRARY.puma560,
    joints: LIBRARY.puma560.joints.map((joint) => ({ ...joint, lower: undefined, upper: undefined })),
  };
  expect(postureFromPendant(robot, [1, 2, 3, 4, 5, 6])).toEqual([1, 2, 3, 4, 5, 6]);
});
