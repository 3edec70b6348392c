import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { createChain } from '../../../src/kinematics/chain.js';
import { dexterity } from '../../../src/kinematics/dexterity.js';
import { geometricJacobian } from '../../../src/kinematics/jacobian.js';
import { writeMotionDerivative } from '../../../src/kinematics/measures/motionDerivative.js';
import { distanceToSingularity, lostMotion } from '../../../src/kinematics/singularity.js';
import { singularityKinds } from '../../../src/kinematics/measures/singularityKinds.js';
import { SEED, runs } from '../../helpers/property.js';
import { anyChain, columnMajor, rigid, rodrigues, sizeOf } from './oracle.js';
import { publishedArm, publishedForward } from './publishedArms.js';

/** @import { JointRow } from '../../../src/kinematics/joint.js' */

const { PI, atan2, acos, asin, sin, cos, abs, hypot } = Math;
/** @param {Partial<JointRow>} row @returns {JointRow} */
const revolute = (row) => ({ type: 'revolute', a: 0, alpha: 0, d: 0, theta: 0, ...row });
/** @param {number[]} lengths */
const planar = (...lengths) => createChain({ convention: 'standard', joints: lengths.map((a) => revolute({ a })) });
/** @param {string} name */
const chainOf = (name) => createChain(publishedArm(name));
/** @param {ArrayLike<number>} a @param {ArrayLike<number>} b */
const dot = (a, b) => Array.from(a).reduce((sum, value, i) => sum + value * b[i], 0);

/** The lengths of the tables that the closed forms below are in. */
const PUMA = { a2: 0.4318, a3: 0.0203, d4: 0.4318 };
const UR5 = { a2: -0.425, a3: -0.39225, d5: 0.09465 };
/** Of the Puma: where the forearm, bent by its offset, is in line with the upper arm. */
const PUMA_STRAIGHT = -atan2(PUMA.d4, PUMA.a3);

/** How far the wrist centre is before axis 1, in the plane that the arm moves in; m. */
const pumaReach = (/** @type {number} */ q2, /** @type {number} */ q3) =>
  PUMA.a2 * cos(q2) + PUMA.a3 * cos(q2 + q3) - PUMA.d4 * sin(q2 + q3);
const pumaAbove = (/** @type {number} */ q23) => acos((PUMA.d4 * sin(q23) - PUMA.a3 * cos(q23)) / PUMA.a2);
const ur5Above = (/** @type {number} */ q2, /** @type {number} */ q23) =>
  asin(-(UR5.a2 * cos(q2) + UR5.a3 * cos(q23)) / UR5.d5);

/** The way to the nearest multiple of half a turn from `from`. @param {number} value @param {number} [from] */
const toHalfTurn = (value, from = 0) => abs(value - from - PI * Math.round((value - from) / PI));
/** The way round to an angle. @param {number} value @param {number} goal */
const wayTo = (value, goal) => value - goal - 2 * PI * Math.round((value - goal) / (2 * PI));

describe('known singular postures are recognised', () => {
  const q23 = -0.9;
  const shoulder2 = pumaAbove(q23);
  const lift = ur5Above(-1.5, -1.8);
  /** @type {[string, number[], string[]][]} */
  const cases = [
    ['puma560', [0.1, 0.5, -0.3, 0.4, 0, 0.2], ['wrist']],
    ['puma560', [0.1, 0.5, -0.3, 0.4, PI, 0.2], ['wrist']],
    ['puma560', [0.1, 0.5, PUMA_STRAIGHT, 0.4, 0.7, 0.2], ['elbow']],
    ['puma560', [0.1, 0.5, PUMA_STRAIGHT + PI, 0.4, 0.7, 0.2], ['elbow']],
    ['puma560', [0.1, shoulder2, q23 - shoulder2, 0.4, 0.7, 0.2], ['shoulder']],
    ['puma560', [0.1, shoulder2, q23 - shoulder2, 0.4, 0, 0.2], ['wrist', 'shoulder']],
    ['ur5', [0.3, -1.2, 1.1, -0.7, 0, 0.4], ['wrist']],
    ['ur5', [0.3, -1.2, 1.1, -0.7, -PI, 0.4], ['wrist']],
    ['ur5', [0.3, -1.2, 0, -0.7, 0.9, 0.4], ['elbow']],
    ['ur5', [0.3, -1.5, -0.3, lift + 1.8, 0.9, 0.4], ['shoulder']],
    ['ur5', [0, 0, 0, 0, 0, 0], ['wrist', 'elbow']],
    ['stanford', [0.3, -0.8, 0.5, 0.4, 0, -0.2], ['wrist']],
    ['stanford', [0.3, 0, 0.5, 0.4, 0.6, -0.2], ['shoulder']],
    ['kuka_kr6_r900', [0.3, -0.8, 0.5, 0.4, 0, -0.2], ['wrist']],
    ['scara_cobra600', [0.3, 0, 0.1, -0.5], ['elbow']],
    ['scara_cobra600', [0.3, PI, 0.1, -0.5], ['elbow']],
    ['planar2r', [0.3, 0], ['elbow']],
    ['planar2r', [0.3, PI], ['elbow']],
    ['planar3r', [0.3, 0, 0.5], ['elbow']],
    ['polar_rrp', [0.3, 0, 0.5], ['shoulder']],
  ];
  test.each(cases)('%s at %j: %j', (name, q, kinds) => {
    const chain = chainOf(name);
    const { singularValues, freedoms, rank, conditionNumber, isotropy, manipulability } = dexterity(chain, q);
    expect(singularValues[freedoms - 1]).toBeLessThan(1e-12);
    expect(rank).toBe(freedoms - 1);
    expect(conditionNumber).toBe(Infinity);
    expect(isotropy).toBe(0);
    expect(manipulability).toBeLessThan(1e-12);
    expect(singularityKinds(chain, q)).toEqual(kinds);
    const found = distanceToSingularity(chain, q);
    expect(found.isFound).toBe(true);
    expect(found.distance).toBe(0);
    expect(found.joint).toBe(null);
    expect(Array.from(found.q ?? [])).toEqual(q);
    expect(found.kinds).toEqual(kinds);
    expect(found.kind).toBe(kinds[0]);
  });
});

test('a wrist without an arm has no elbow: it is singular where its first axis and its last are parallel, wherever the tool is', () => {
  for (const last of [{ d: 0.2 }, { d: 0.2, a: 0.1 }]) {
    const joints = [revolute({ alpha: -PI / 2 }), revolute({ alpha: PI / 2 }), revolute(last)];
    const chain = createChain({ convention: 'standard', joints });
    for (const q of [
      [0.3, 0, 0.5],
      [0.3, PI, 0.5],
    ]) {
      expect(dexterity(chain, q).rank).toBe(2);
      expect(singularityKinds(chain, q)).toEqual(['wrist']);
    }
    expect(singularityKinds(chain, [0.3, 0.7, 0.5])).toEqual(['other']);
  }
});

test('what is not singular has no name', () => {
  expect(singularityKinds(planar(1, 1), [0.3, 0.5])).toEqual(['other']);
  expect(singularityKinds(chainOf('puma560'), [0.1, 0.5, -0.3, 0.4, 0.6, 0.2])).toEqual(['other']);
  expect(singularityKinds(chainOf('ur5'), [0.3, -1.2, 1.1, -0.7, 0.9, 0.4])).toEqual(['other']);
});

describe('the nearest singular posture, against closed forms of all there are', () => {
  const anyAngles = fc.array(fc.double({ min: -PI, max: PI, noNaN: true }), { minLength: 6, maxLength: 6 });
  const STEPS = 2000;

  test('of a Puma 560: wrist, elbow, or the curve on which its wrist is above the shoulder', () => {
    const chain = chainOf('puma560');
    fc.assert(
      fc.property(anyAngles, (q) => {
        const found = distanceToSingularity(chain, q, { withinLimits: false });
        const wrist = toHalfTurn(q[4]);
        const elbow = toHalfTurn(q[2], PUMA_STRAIGHT);
        let shoulder = Infinity;
        for (let i = 0; i < STEPS; i++) {
          const q23 = (2 * PI * i) / STEPS;
          const q2 = pumaAbove(q23);
          if (Number.isNaN(q2)) continue;
          for (const side of [q2, -q2]) {
            // no nearer by whole turns of both joints than of each
            shoulder = Math.min(shoulder, hypot(wayTo(q[1], side), wayTo(q[2], q23 - side)));
          }
        }
        const nearest = Math.min(wrist, elbow, shoulder);
        expect(found.distance).toBeLessThan(nearest + 1e-9);
        expect(found.distance).toBeGreaterThan(nearest - 1e-4); // the curve is taken in steps
        const [, s2, s3, , s5] = /** @type {Float64Array} */ (found.q);
        const factors = { wrist: sin(s5), elbow: sin(s3 - PUMA_STRAIGHT), shoulder: pumaReach(s2, s3) };
        expect(found.kinds.length).toBeGreaterThan(0);
        for (const kind of found.kinds) {
          expect(abs(factors[/** @type {'wrist' | 'elbow' | 'shoulder'} */ (kind)])).toBeLessThan(1e-9);
        }
        expect(hypot(...q.map((value, i) => value - (found.q ?? [])[i]))).toBeCloseTo(found.distance, 12);
      }),
      { seed: SEED, numRuns: runs(25) },
    );
  });

  test('of a UR5: wrist, elbow, or the surface on which axes 5 and 6 meet above the shoulder', () => {
    const chain = chainOf('ur5');
    const steps = 120;
    fc.assert(
      fc.property(anyAngles, (q) => {
        const found = distanceToSingularity(chain, q, { withinLimits: false });
        let nearest = Math.min(toHalfTurn(q[4]), toHalfTurn(q[2]));
        for (let i = 0; i < steps; i++) {
          for (let j = 0; j < steps; j++) {
            const q2 = (2 * PI * i) / steps;
            const q23 = (2 * PI * j) / steps;
            const turned = ur5Above(q2, q23);
            if (Number.isNaN(turned)) continue;
            for (const q234 of [turned, PI - turned]) {
              const ways = [wayTo(q[1], q2), wayTo(q[2], q23 - q2), wayTo(q[3], q234 - q23)];
              nearest = Math.min(nearest, hypot(...ways));
            }
          }
        }
        expect(found.distance).toBeLessThan(nearest + 1e-9);
        const [, s2, s3, s4, s5] = /** @type {Float64Array} */ (found.q);
        const above = UR5.a2 * cos(s2) + UR5.a3 * cos(s2 + s3) + UR5.d5 * sin(s2 + s3 + s4);
        expect(abs(sin(s5) * sin(s3) * above)).toBeLessThan(1e-9);
        expect(found.kind).not.toBe('other');
      }),
      { seed: SEED, numRuns: runs(12) },
    );
  });

  test('of planar and SCARA arms: the way to stretch or fold joint 2', () => {
    fc.assert(
      fc.property(anyAngles, (six) => {
        for (const chain of [planar(1, 0.6), planar(1, 0.6, 0.3)]) {
          const found = distanceToSingularity(chain, six.slice(0, chain.dof));
          expect(abs(found.distance - toHalfTurn(six[1]))).toBeLessThan(1e-9);
          expect(found.kind).toBe('elbow');
          expect(found.joint).toBe(found.distance > 0 ? 1 : null);
        }
      }),
      { seed: SEED, numRuns: runs(15) },
    );
  });

  test('of a polar arm with its axis through the TCP: the way to the vertical', () => {
    const chain = chainOf('polar_rrp');
    const q = [0.3, 0.4, 0.5];
    const found = distanceToSingularity(chain, q, { withinLimits: false });
    expect(found.kind).toBe('shoulder');
    expect(found.joint).toBe(1);
    expect(dexterity(chain, /** @type {Float64Array} */ (found.q)).rank).toBe(2);
  });

  test('within limits: not past a joint that is stopped before', () => {
    const limited = publishedArm('scara_cobra600');
    const rows = limited.joints.map((row, i) => (i === 1 ? { ...row, lower: 0.2, upper: 1.2 } : row));
    const chain = createChain({ ...limited, joints: rows });
    const q = [0.1, 0.7, 0.1, 0];
    const found = distanceToSingularity(chain, q);
    expect(found.isFound).toBe(false);
    expect(found.distance).toBe(Infinity);
    expect([found.q, found.joint, found.kind, found.kinds]).toEqual([null, null, null, []]);
    expect(distanceToSingularity(chain, q, { withinLimits: false }).distance).toBeCloseTo(0.7, 9);
    for (const q2 of [0.25, 0.4, 0.55, 1.1])
      expect(distanceToSingularity(chain, [0.1, q2, 0.1, 0]).isFound).toBe(false);
    // past the limit already: the way is counted from there
    expect(distanceToSingularity(chain, [0.1, -0.3, 0.1, 0]).distance).toBeCloseTo(0.3, 9);
  });

  test('the turns of single joints alone find wrist and elbow, wherever they are', () => {
    const chain = chainOf('puma560');
    for (const q of publishedForward('puma560').q.slice(0, 10)) {
      const found = distanceToSingularity(chain, q, { withinLimits: false, searches: 0 });
      expect(found.distance).toBeLessThan(Math.min(toHalfTurn(q[4]), toHalfTurn(q[2], PUMA_STRAIGHT)) + 1e-9);
    }
  });

  test('a posture that is singular but for its last digits is singular', () => {
    const q = [0.1, 0.5, -0.3, 0.4, 5e-13, 0.2];
    expect(distanceToSingularity(chainOf('puma560'), q).distance).toBe(0);
    expect(distanceToSingularity(chainOf('puma560'), [0.1, 0.5, -0.3, 0.4, 1e-9, 0.2]).distance).toBeCloseTo(1e-9, 15);
  });

  test('within limits: on to where a limit cuts the singular postures', () => {
    const puma = publishedArm('puma560');
    const limits = /** @type {Record<number, [number, number]>} */ ({ 1: [0, 0.5], 2: [-1, 1], 4: [0.5, 1.2] });
    const rows = puma.joints.map((row, i) => ({ ...row, lower: limits[i]?.[0] ?? -3, upper: limits[i]?.[1] ?? 3 }));
    const chain = createChain({ ...puma, joints: rows });
    const q = [0.1, 0.3, 0, 0.4, 0.8, 0.2];
    const found = distanceToSingularity(chain, q);
    const [, s2, s3] = /** @type {Float64Array} */ (found.q);
    expect(found.kind).toBe('shoulder');
    expect(s2).toBe(0.5);
    expect(abs(pumaReach(s2, s3))).toBeLessThan(1e-12);
    expect(abs(found.distance - hypot(0.2, s3))).toBeLessThan(1e-12);
    expect(distanceToSingularity(chain, q, { withinLimits: false }).q?.[1]).toBeGreaterThan(0.6);
  });

  test('of a planar 4R arm, which has a joint to spare: the way to where its four axes are in one plane', () => {
    fc.assert(
      fc.property(anyAngles, ([q1, q2, q3, q4]) => {
        const found = distanceToSingularity(planar(1, 0.8, 0.6, 0.4), [q1, q2, q3, q4], { searches: 8 });
        expect(abs(found.distance - hypot(toHalfTurn(q2), toHalfTurn(q3)))).toBeLessThan(1e-6);
        expect(found.kind).toBe('elbow');
      }),
      { seed: SEED, numRuns: runs(8) },
    );
  });

  test('of a 5R arm: where its last axis falls in line with its first, which takes two conditions', () => {
    const chain = chainOf('kuka_youbot');
    const found = distanceToSingularity(chain, publishedForward('kuka_youbot').q[9]);
    expect(found.distance).toBeLessThan(0.343);
    const J = geometricJacobian(chain, /** @type {Float64Array} */ (found.q));
    const sign = J[5] * J[29] < 0 ? -1 : 1;
    for (let i = 0; i < 6; i++) expect(abs(J[i] - sign * J[24 + i])).toBeLessThan(1e-12);
  });

  test('of a 7R arm with a shoulder, an elbow and a wrist of crossing axes, where singular postures are thin: still the nearest', () => {
    // the dimensions of a KUKA LBR iiwa 7 R800
    const twists = [-PI / 2, PI / 2, PI / 2, -PI / 2, -PI / 2, PI / 2, 0];
    const offsets = [0.34, 0, 0.4, 0, 0.4, 0, 0.126];
    const joints = twists.map((alpha, i) => revolute({ alpha, d: offsets[i] }));
    const chain = createChain({ convention: 'standard', joints });
    // q4 = 0: stretched. q6 = 0 with q4 a right angle, or with q5 a right angle; q2 = 0 with q3 a right angle: known ones
    for (const [q, nearest] of /** @type {[number[], number][]} */ ([
      [[0.1, 0.9, 0.3, 0.4, 0.2, 0.9, 0.1], 0.4],
      [[0.1, 1.2, 0.3, 1.2, PI / 2 - 0.3, 0.4, 0.1], 0.5],
      [[0.1, 0.3, PI / 2 + 0.4, 1.3, 0.4, 1.2, 0.1], 0.5],
    ])) {
      const found = distanceToSingularity(chain, q);
      expect(found.distance).toBeLessThan(nearest + 1e-9);
      expect(dexterity(chain, /** @type {Float64Array} */ (found.q)).rank).toBe(5);
    }
  });

  test('at the limit of a slide: the limit to its last digit', () => {
    const { joints } = publishedArm('cyl_rpp');
    const rows = joints.map((row, i) => (i === 2 ? { ...row, d: -0.1 + 1e-14, lower: 0.1, upper: 0.7 } : row));
    const chain = createChain({ convention: 'standard', joints: rows });
    const found = distanceToSingularity(chain, [0.1, 0.2, 0.3]);
    expect(found.q?.[2]).toBe(0.1);
    expect(found.joint).toBe(2);
    expect(found.distance).toBeCloseTo(0.2 / chain.characteristicLength, 12);
  });

  test('a gantry has none', () => {
    const found = distanceToSingularity(chainOf('cart_ppp'), [0.1, 0.1, 0.1]);
    expect(found.isFound).toBe(false);
    expect(found.smallest).toBeCloseTo(1, 12);
  });

  test('the answer is inside the limits, singular, the same every time, and no better for looking longer', () => {
    for (const name of ['puma560', 'stanford', 'kinova_mico']) {
      const chain = chainOf(name);
      for (const q of publishedForward(name).q.slice(0, 2)) {
        const found = distanceToSingularity(chain, q);
        const singular = /** @type {Float64Array} */ (found.q);
        const { rank, freedoms, singularValues } = dexterity(chain, singular);
        expect(rank).toBeLessThan(freedoms);
        expect(singularValues[freedoms - 1]).toBeLessThan(2e-12);
        chain.joints.forEach(({ lower, upper }, i) => expect(singular[i] >= lower && singular[i] <= upper).toBe(true));
        expect(distanceToSingularity(chain, q)).toEqual(found);
      }
      const [q] = publishedForward(name).q;
      const longer = distanceToSingularity(chain, q, { searches: 50, samples: 36, randomSeed: 7 });
      expect(distanceToSingularity(chain, q).distance).toBeLessThan(longer.distance + 1e-9);
    }
  });

  test('does not depend on the unit of length', () => {
    for (const name of ['puma560', 'stanford', 'scara_cobra600', 'planar2r', 'kuka_youbot']) {
      const slides = publishedArm(name).joints.map(({ type }) => type === 'prismatic');
      const [q] = publishedForward(name).q;
      const wanted = distanceToSingularity(chainOf(name), q);
      for (const scale of [1e-3, 25.4, 1e3]) {
        const scaled = q.map((value, i) => (slides[i] ? value * scale : value));
        const found = distanceToSingularity(createChain(publishedArm(name, scale)), scaled);
        expect(abs(found.distance - wanted.distance)).toBeLessThan(1e-9);
        expect(abs(found.smallest - wanted.smallest)).toBeLessThan(1e-12);
        expect([found.joint, found.kinds]).toEqual([wanted.joint, wanted.kinds]);
      }
    }
  });
});

describe('the motion that is lost', () => {
  test('of six joints at a singularity: no joint rate makes any of it, and the rates given move nothing', () => {
    /** @type {[string, number[]][]} */
    const cases = [
      ['puma560', [0.1, 0.5, -0.3, 0.4, 0, 0.2]],
      ['puma560', [0.1, 0.5, PUMA_STRAIGHT, 0.4, 0.7, 0.2]],
      ['ur5', [0.3, -1.2, 0, -0.7, 0.9, 0.4]],
      ['stanford', [0.3, 0, 0.5, 0.4, 0.6, -0.2]],
    ];
    for (const [name, q] of cases) {
      const chain = chainOf(name);
      const L = chain.characteristicLength;
      const { linear, angular, gain, singularValue, lostFreedoms, rates } = lostMotion(chain, q);
      expect(gain).toBe(Infinity);
      expect(singularValue).toBeLessThan(1e-12);
      expect(lostFreedoms).toBe(1);
      expect(hypot(...linear.map((value) => value / L), ...angular)).toBeCloseTo(1, 13);
      const J = geometricJacobian(chain, q);
      const moved = new Float64Array(6);
      for (let k = 0; k < 6; k++) {
        const column = J.subarray(6 * k, 6 * k + 6);
        expect(abs(dot(linear, column) / (L * L) + dot(angular, column.subarray(3)))).toBeLessThan(1e-12 * (1 + 1 / L));
        for (let i = 0; i < 6; i++) moved[i] += column[i] * rates[k];
      }
      expect(hypot(...moved)).toBeLessThan(1e-12);
    }
  });
  test('the Puma with its wrist in line: joints 4 and 6 turn against each other and nothing moves', () => {
    const { rates } = lostMotion(chainOf('puma560'), [0.1, 0.5, -0.3, 0.4, 0, 0.2]);
    expect(abs(rates[3] + rates[5])).toBeLessThan(1e-12);
    expect(abs(rates[3])).toBeCloseTo(Math.SQRT1_2, 12);
  });
  test('of a planar and of a SCARA arm stretched out: the radial one, not one of those that they never make', () => {
    const two = lostMotion(planar(1, 1), [PI / 3, 0]);
    expect(two.part).toBe('linear');
    expect(abs(two.linear[0] * sin(PI / 3) - two.linear[1] * cos(PI / 3))).toBeLessThan(1e-12);
    expect(hypot(...two.linear)).toBeCloseTo(two.lengthScale, 12);
    expect(two.angular).toEqual([0, 0, 0]);
    const chain = chainOf('scara_cobra600');
    for (const q of [
      [PI / 3, 0, 0.1, 0.4],
      [PI / 3, 1e-10, 0.1, 0.4],
      [PI / 3, 1e-6, 0.1, 0.4],
    ]) {
      const four = lostMotion(chain, q);
      expect(abs(four.linear[0] * sin(PI / 3) - four.linear[1] * cos(PI / 3))).toBeLessThan(1e-6);
      expect(hypot(...four.linear)).toBeCloseTo(four.lengthScale, 9);
      expect(hypot(four.linear[2], ...four.angular)).toBeLessThan(1e-6);
    }
  });
  test('however the arm is put up, and wherever it points', () => {
    const base = columnMajor(rigid(rodrigues([1, 2, 3], 1), [0.4, 0.5, -0.6]));
    const chain = createChain({ ...publishedArm('scara_cobra600'), base });
    for (const q1 of [-0.7, -0.2, 0, 0.4, 0.8]) {
      for (const q2 of [0, PI]) {
        const { linear, angular } = lostMotion(chain, [q1, q2, 0.1, 0.4]);
        const radial = rodrigues([1, 2, 3], 1).map((row) => row[0] * cos(q1) + row[1] * sin(q1));
        expect(abs(dot(linear, radial))).toBeCloseTo(hypot(...linear), 12);
        expect(hypot(...angular)).toBeLessThan(1e-12);
      }
    }
  });
  test('anywhere else: the twist that costs most, at the price stated', () => {
    fc.assert(
      fc.property(anyChain, ({ description, q }) => {
        const chain = createChain(description);
        const { full } = /** @type {{ full: number }} */ ({ full: dexterity(chain, q, { part: 'full' }).freedoms });
        const found = lostMotion(chain, q, { part: 'full' });
        const L = found.lengthScale;
        expect([...found.linear, ...found.angular, ...found.rates].every(Number.isFinite)).toBe(true);
        expect(full).toBeGreaterThan(0);
        if (found.gain === Infinity) return;
        expect(found.gain * found.singularValue).toBeCloseTo(1, 12);
        const J = geometricJacobian(chain, q);
        const made = [0, 1, 2, 3, 4, 5].map((i) => q.reduce((sum, _, k) => sum + J[6 * k + i] * found.rates[k], 0));
        const wanted = [...found.linear, ...found.angular].map((value) => value * found.singularValue);
        made.forEach((value, i) => expect(abs(value - wanted[i]) / (i < 3 ? L : 1)).toBeLessThan(1e-7));
      }),
      { seed: SEED, numRuns: runs(150) },
    );
  });
});

test('the derivative of the Jacobian is that of its differences', () => {
  const numbers = (/** @type {number} */ n) =>
    fc.array(fc.double({ min: -1, max: 1, noNaN: true }), { minLength: n, maxLength: n });
  fc.assert(
    fc.property(anyChain, numbers(6), numbers(7), ({ description, q }, u, v) => {
      const chain = createChain(description);
      const out = new Float64Array(chain.dof);
      const V = Float64Array.from([9, ...v.slice(0, chain.dof)]);
      writeMotionDerivative(geometricJacobian(chain, q), Float64Array.from(u), V, 1, out);
      const h = 1e-5;
      const value = (/** @type {number[]} */ at) => {
        const J = geometricJacobian(chain, at);
        return J.reduce((sum, entry, i) => sum + entry * u[i % 6] * v[Math.floor(i / 6)], 0);
      };
      q.forEach((_, k) => {
        const at = (/** @type {number} */ t) => value(q.map((old, i) => (i === k ? old + t : old)));
        expect(abs((at(h) - at(-h)) / (2 * h) - out[k])).toBeLessThan(1e-8 * sizeOf(description));
      });
    }),
    { seed: SEED, numRuns: runs(100) },
  );
});

test('wrong calls are refused', () => {
  const chain = planar(1, 1);
  expect(() => distanceToSingularity(chain, [1])).toThrow('Expected 2 joint values, got 1.');
  expect(() => distanceToSingularity(chain, [1, NaN])).toThrow('Expected joint value 2');
  expect(() => distanceToSingularity(chain, [1, 1], { searches: -1 })).toThrow(
    'Expected a number of searches, got -1.',
  );
  expect(() => distanceToSingularity(chain, [1, 1], { samples: 1.5 })).toThrow(
    'Expected a number of samples, got 1.5.',
  );
  expect(() => distanceToSingularity(chain, [1, 1], { lengthScale: 0 })).toThrow('length scale in metres, got 0');
  expect(() => lostMotion(chain, [1, 1, 1])).toThrow('Expected 2 joint values, got 3.');
  expect(() => lostMotion(chainOf('cart_ppp'), [0, 0, 0], { part: 'angular' })).toThrow(
    'that can move in the angular part',
  );
});
