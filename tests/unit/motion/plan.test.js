/** Programs of moves that stop at each end: where the arm is, when, and how fast. */
import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { createChain } from '../../../src/kinematics/chain.js';
import { planMotion } from '../../../src/motion/plan.js';
import { planMomentAt } from '../../../src/motion/planMoment.js';
import { quinticLaw } from '../../../src/motion/polynomialLaws.js';
import { momentAt } from '../../../src/motion/timeLaw.js';
import { SEED, runs } from '../../helpers/property.js';
import { angleBetween, arm, columnMajor, distanceBetween, oracleForward, rowsOf } from '../kinematics/oracle.js';
import { RUCKIG, toolboxCase } from './references.js';

/** @import { LawName } from '../../../src/motion/restLaw.js' */
/** @import { Move } from '../../../src/motion/plan.js' */
/** @import { JointsCase } from './references.js' */

/** @type {LawName[]} */
const LAWS = ['trapezoid', 'doubleS', 'cubic', 'quintic'];
const FINE = /** @type {const} */ ({ kind: 'fine' });

/** An arm of so many turning joints; what it looks like does not matter. @param {number} dof @param {number} [most] */
const plainArm = (dof, most = Infinity) =>
  createChain({
    convention: 'standard',
    joints: Array.from({ length: dof }, () => ({
      type: 'revolute',
      a: 0.3,
      alpha: 0,
      d: 0,
      theta: 0,
      lower: -most,
      upper: most,
    })),
  });

/** @param {readonly number[]} posture @param {Partial<Extract<Move, { kind: 'joint' }>>} [more] @returns {Move} */
const to = (posture, more) => ({
  kind: 'joint',
  posture: Float64Array.from(posture),
  speed: 1,
  acceleration: 1,
  ending: FINE,
  ...more,
});

/** @param {Float64Array} T_base_tcp @param {Partial<Extract<Move, { kind: 'linear' }>>} [more] @returns {Move} */
const straightTo = (T_base_tcp, more) => ({
  kind: 'linear',
  T_base_tcp,
  speed: 0.25,
  turnSpeed: 1.5,
  acceleration: 1,
  ending: FINE,
  ...more,
});

describe('joint moves', () => {
  const six = RUCKIG.filter(({ q0 }) => q0.length === 6);
  test.each(six.map((each) => /** @type {const} */ ([each.name, each])))(
    'six joints take the time that ruckig takes: %s',
    (_, each) => {
      const { q0, q1, vmax, amax, jmax, duration } = each;
      const limits = {
        rates: Float64Array.from(vmax),
        accelerations: Float64Array.from(amax),
        jerks: Float64Array.from(jmax ?? []),
      };
      expect(planMotion(plainArm(6), Float64Array.from(q0), [to(q1)], limits).duration).toBeCloseTo(duration, 12);
    },
  );
  test('the quintic law of six joints is the toolbox’s jtraj, step by step', () => {
    const { q } = /** @type {JointsCase} */ (toolboxCase('jtraj qz->qn puma 51 steps'));
    const last = q.length - 1;
    const laws = q[0].map((from, k) => quinticLaw(from, q[last][k], last));
    q.forEach((row, i) =>
      laws.forEach((law, k) => expect(Math.abs(momentAt(law, i).position - row[k])).toBeLessThan(1e-9)),
    );
  });
  test('the quintic law is the toolbox’s jtraj', () => {
    const { t, q, qd } = /** @type {JointsCase} */ (toolboxCase('jtraj 2dof 2s'));
    const laws = [1, 2].map((end) => quinticLaw(0, end, 2));
    t.forEach((time, i) => {
      const now = laws.map((law) => momentAt(law, time));
      now.forEach(({ position, rate }, k) => {
        expect(Math.abs(position - q[i][k])).toBeLessThan(1e-9);
        expect(Math.abs(rate - qd[i][k])).toBeLessThan(1e-9);
      });
    });
  });

  const value = fc.double({ min: -3, max: 3, noNaN: true });
  const limit = fc.double({ min: 0.1, max: 10, noNaN: true });
  const joint = fc.record({
    from: value,
    to: fc.oneof(value, fc.constant(0)),
    rate: limit,
    acceleration: limit,
    jerk: limit,
  });
  test('all joints begin and end together, in proportion, keep their limits, and one of them is at a limit', () => {
    fc.assert(
      fc.property(
        fc.array(joint, { minLength: 1, maxLength: 6 }),
        fc.constantFrom(...LAWS),
        fc.double({ min: 0.01, max: 1, noNaN: true }),
        (joints, law, speed) => {
          const limits = {
            rates: Float64Array.from(joints, ({ rate }) => rate),
            accelerations: Float64Array.from(joints, ({ acceleration }) => acceleration),
            jerks: Float64Array.from(joints, ({ jerk }) => jerk),
          };
          const [from, end] = [Float64Array.from(joints, (each) => each.from), joints.map((each) => each.to)];
          const move = to(end, { law, speed, acceleration: 0.5 });
          const plan = planMotion(plainArm(joints.length), from, [move], limits);
          planMomentAt(plan, 0).posture.forEach((value, i) => expect(value + 0).toBe(from[i] + 0));
          const ways = end.map((each, i) => Math.abs(each - from[i]));
          const longest = ways.indexOf(Math.max(...ways));
          let [used, astray] = [0, 0];
          for (let k = 0; k <= 40; k++) {
            const now = planMomentAt(plan, (plan.duration * k) / 40);
            const share = (now.posture[longest] - from[longest]) / (end[longest] - from[longest] || 1);
            for (const [i, { rate, acceleration, jerk }] of joints.entries()) {
              astray = Math.max(astray, Math.abs(now.posture[i] - from[i] - share * (end[i] - from[i])));
              const jerks = law === 'trapezoid' || law === 'cubic' ? 0 : Math.abs(now.jerks[i]) / (0.5 * jerk);
              const rates = Math.abs(now.rates[i]) / (speed * rate);
              used = Math.max(used, jerks, rates, Math.abs(now.accelerations[i]) / (0.5 * acceleration));
            }
            if (k === 40) end.forEach((wanted, i) => expect(Math.abs(now.posture[i] - wanted)).toBeLessThan(1e-9));
          }
          expect(used).toBeLessThan(1.001);
          expect(astray).toBeLessThan(1e-12);
          if (plan.duration > 1e-6 && law !== 'cubic') expect(used).toBeGreaterThan(0.99);
        },
      ),
      { seed: SEED, numRuns: runs(100) },
    );
  });
  test('a way too short for powers of its time to be numbers is covered within the limits all the same', () => {
    const limits = { rates: Float64Array.of(0.001), accelerations: Float64Array.of(0.1), jerks: Float64Array.of(0.1) };
    for (const way of [8e-21, 1e-30, 1e-200, 5e-324]) {
      for (const law of LAWS) {
        const plan = planMotion(plainArm(1), Float64Array.of(way), [to([0], { law, acceleration: 0.5 })], limits);
        expect(planMomentAt(plan, plan.duration / 2).posture[0]).toBeLessThanOrEqual(way);
        expect(Math.abs(planMomentAt(plan, 0).accelerations[0])).toBeLessThan(0.05 * 1.0001);
      }
    }
  });
  test('past a limit it is refused, with where it can be gone to', () => {
    const limits = { rates: Float64Array.of(1, 1), accelerations: Float64Array.of(1, 1) };
    const moves = [to([1, 1]), to([1.5, 3]), to([0, 0])];
    const plan = planMotion(plainArm(2, 2), Float64Array.of(0, 0), moves, limits);
    expect(plan.refused).toEqual({ move: 1, reason: 'limit', joint: 1, share: 0.5, posture: Float64Array.of(1.25, 2) });
    expect(plan.parts).toHaveLength(1);
    expect(planMomentAt(plan, Infinity).posture).toEqual(Float64Array.of(1, 1));
  });
  test('wrong calls are refused', () => {
    const limits = { rates: Float64Array.of(1), accelerations: Float64Array.of(1) };
    const plan = (/** @type {Move} */ move) => () => planMotion(plainArm(1), Float64Array.of(0), [move], limits);
    expect(plan(to([1, 2]))).toThrow('Expected 1 joint values, got 2.');
    expect(plan(to([1], { speed: 0 }))).toThrow('speed: expected a share above 0');
    expect(plan(to([NaN]))).toThrow('Expected joint value 1 to be a finite number, got NaN.');
    expect(plan({ kind: 'wait', seconds: -1 })).toThrow('seconds');
  });
});

describe('linear and circular moves, and waits', () => {
  const description = arm('puma560');
  const chain = createChain(description);
  const start = Float64Array.of(0.3, 0.6, -2.6, 0.4, 0.9, 0.2);
  const T = columnMajor(oracleForward(description, start).tcp);
  const end = T.slice();
  end[13] += 0.12;
  end[14] -= 0.16;
  const limits = { rates: new Float64Array(6).fill(20), accelerations: new Float64Array(6).fill(400) };

  test('a line takes the time of its law, and the tool goes at that rate', () => {
    const plan = planMotion(
      chain,
      start,
      [straightTo(end, { law: 'trapezoid' }), { kind: 'wait', seconds: 0.5 }],
      limits,
    );
    expect(plan.duration).toBeCloseTo(0.2 / 0.25 + 0.25 + 0.5, 9);
    expect(plan.parts.map(({ move }) => move)).toEqual([0, 1]);
    for (const [t, way] of [
      [0.125, 0.0078125],
      [0.525, 0.1],
      [1.05, 0.2],
      [1.5, 0.2],
    ]) {
      const now = oracleForward(description, [...planMomentAt(plan, t).posture]).tcp;
      expect(Math.abs(distanceBetween(now, rowsOf(T)) - way)).toBeLessThan(1.1e-5);
      expect(angleBetween(now, rowsOf(T))).toBeLessThan(1.8e-4);
    }
  });
  test('three points without a circle are refused', () => {
    const via = T.slice();
    via[13] += 0.06;
    via[14] -= 0.08;
    const move = /** @type {Move} */ ({ ...straightTo(end), kind: 'circular', via });
    expect(planMotion(chain, start, [move], limits).refused).toMatchObject({ move: 0, reason: 'arc', share: 0 });
    via[12] += 0.05;
    expect(planMotion(chain, start, [move], limits).refused).toBeNull();
  });
});
