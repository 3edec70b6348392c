import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { allInverseKinematics } from '../../../src/kinematics/allInverse.js';
import { createChain } from '../../../src/kinematics/chain.js';
import { createRandom } from '../../../src/kinematics/random.js';
import { onlyOnce } from '../../../src/kinematics/sameSolution.js';
import { isThere } from '../../../src/kinematics/everyPosture.js';
import { SEED, runs } from '../../helpers/property.js';
import { columnMajor, oracleForward } from './oracle.js';
import { publishedArm } from './publishedArms.js';

/** @import { ChainDescription } from '../../../src/kinematics/chain.js' */

const TOLERANCES = { positionTolerance: 1e-9, orientationTolerance: 1e-9 };

/** All axes of a bent wrist's arm are in one plane here, folded: three motions are lost at once. */
const FLAT = [0, 0, 0, 0, Math.PI, 0];

/** @param {string} name @param {readonly number[]} q */
function poseAt(name, q) {
  const description = publishedArm(name);
  return { chain: createChain(description), goal: columnMajor(oracleForward(description, [...q]).tcp) };
}

describe('postures in one valley', () => {
  test.each(['kinova_mico', 'kinova_jaco'])(
    'of %s, next to three singularities, are at most eight solutions',
    (name) => {
      // Three quadratic equations, as the lost motions are to second order, have eight solutions.
      fc.assert(
        fc.property(
          fc.array(fc.double({ min: -1e-4, max: 1e-4, noNaN: true }), { minLength: 6, maxLength: 6 }),
          fc.integer({ min: 1, max: 1e6 }),
          (off, seed) => {
            const { chain, goal } = poseAt(
              name,
              FLAT.map((value, i) => value + off[i]),
            );
            const random = createRandom(seed);
            const near = Array.from({ length: 60 }, () =>
              Float64Array.from(FLAT, (value) => value + 6e-3 * (random() - 0.5)),
            ).filter((q) => isThere(chain, goal, q, TOLERANCES));
            expect(onlyOnce(chain, goal, near, TOLERANCES, false).length).toBeLessThanOrEqual(8);
          },
        ),
        { seed: SEED, numRuns: runs(5) },
      );
    },
  );
  test.each(
    /** @type {[string, number, number[]][]} */ ([
      ['kinova_mico', 4, [0, -0.00003937695371714067, 0, 0, -3.1415315544683824, 0]],
      ['kinova_jaco', 2, [-1.570796325481517, -0.000040847342213566414, 3.1415926620704755, 0, 0, Math.PI]],
      ['kinova_jaco', 8, [-Math.PI, Math.PI, 3.141625425792495, 0, 0, 0]],
    ]),
  )('of %s are not listed one by one, but as at most %i; and a valley is no family: %j', (name, most, q) => {
    const { chain, goal } = poseAt(name, q);
    const { solutions, families } = allInverseKinematics(chain, goal);
    expect(solutions.length).toBeGreaterThan(0);
    expect(solutions.length).toBeLessThanOrEqual(most);
    expect(families).toEqual([]);
  });
});

describe('postures that are near each other', () => {
  test('are two solutions if each meets the pose and what is between them does not', () => {
    const description = publishedArm('planar3r');
    const chain = createChain(description);
    const { a: upper } = description.joints[0];
    const { a: fore } = description.joints[1];
    fc.assert(
      fc.property(
        fc.tuple(...[0, 2].map(() => fc.double({ min: -3, max: 3, noNaN: true }))),
        fc.double({ min: -5.5, max: -2, noNaN: true }),
        fc.boolean(),
        ([first, last], exponent, areProven) => {
          const bend = 10 ** exponent;
          const turn = 2 * Math.atan2(fore * Math.sin(bend), upper + fore * Math.cos(bend)); // the elbow on the other side
          const q = Float64Array.of(first, bend, last);
          const other = Float64Array.of(first + turn, -bend, last + 2 * bend - turn);
          const goal = columnMajor(oracleForward(description, [...q]).tcp);
          for (const posture of [q, other]) expect(isThere(chain, goal, posture, TOLERANCES)).toBe(true);
          expect(onlyOnce(chain, goal, [q, other], TOLERANCES, areProven)).toEqual([q, other]);
        },
      ),
      { seed: SEED, numRuns: runs(30) },
    );
  });
  test('are one where what is straight between them is off by more than rounding, and what is at the bottom is not', () => {
    // A UR3 with its elbow straight: the solver has it bent by ±3.5e-7, and half-way between these the pose is off by 7e-15 m.
    const { chain, goal } = poseAt(
      'ur3',
      [1.5613900224817088, -1.398775476407431, 0, 2.5502254999234353, 1.2256905440739179, -1.625637153764037],
    );
    const { solutions, complete } = allInverseKinematics(chain, goal);
    expect(complete).toBe(true);
    expect(solutions.filter(({ q }) => Math.abs(q[2]) < 1e-3)).toHaveLength(1);
  });
  test('are one if they are what rounding makes of an elbow that is straight', () => {
    const chain = createChain(publishedArm('planar3r'));
    const goal = columnMajor(oracleForward(publishedArm('planar3r'), [0.3, 0, 0.4]).tcp);
    const near = [1e-8, -1e-8, 2e-8].map((bend) => Float64Array.of(0.3 - bend / 2, bend, 0.4 - bend / 2));
    for (const areProven of [true, false]) {
      expect(onlyOnce(chain, goal, near, TOLERANCES, areProven).length).toBe(1);
    }
  });
});

test('an arm with a joint to spare has a family of postures, and none of them is listed as if it stood alone', () => {
  const link = { type: /** @type {const} */ ('revolute'), theta: 0 };
  /** @type {ChainDescription} */
  const arm = {
    convention: 'standard',
    joints: [
      { ...link, a: 0.1, alpha: 1.1, d: 0.3 },
      { ...link, a: 0.4, alpha: 0.4, d: 0.1 },
      { ...link, a: 0.05, alpha: 1.3, d: 0.3 },
      { ...link, a: 0.1, alpha: -1.2, d: 0.2 },
      { ...link, a: 0.08, alpha: 0.9, d: 0.1 },
      { ...link, a: 0.03, alpha: 0.3, d: 0.1 },
      { ...link, a: 0.07, alpha: -0.7, d: 0.1 },
    ],
  };
  const goal = columnMajor(oracleForward(arm, [0.2, 0.5, 0.1, -0.7, 1, 0.4, 0.3]).tcp);
  const { solutions, families, complete } = allInverseKinematics(createChain(arm), goal);
  expect(solutions).toEqual([]);
  expect(families.map(({ kind, joints }) => [kind, joints.length])).toEqual([['other', 7]]);
  expect(complete).toBe(false);
});
