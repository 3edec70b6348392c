/** Joint moves through their targets by a cubic spline, and past them by linear segments with parabolic blends. */
import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { createChain } from '../../../src/kinematics/chain.js';
import { planMotion } from '../../../src/motion/plan.js';
import { planMomentAt } from '../../../src/motion/planMoment.js';
import { SEED, runs } from '../../helpers/property.js';

/** @import { JointLimits, Move, ViaLaw } from '../../../src/motion/moves.js' */
/** @import { MotionPlan } from '../../../src/motion/plan.js' */

/** @type {ViaLaw[]} */
const LAWS = ['cubicSpline', 'parabolicBlends'];
const ON = /** @type {const} */ ({ kind: 'share', share: 0.5 });

/** @param {number} dof @param {number} [most] */
const plainArm = (dof, most = Infinity) =>
  createChain({
    convention: 'standard',
    joints: Array.from({ length: dof }, () => ({
      ...{ type: /** @type {const} */ ('revolute'), a: 0.3, alpha: 0, d: 0, theta: 0 },
      ...{ lower: -most, upper: most },
    })),
  });

/** @param {readonly number[]} posture @param {ViaLaw} law @param {object} [more] @returns {Move} */
const to = (posture, law, more) =>
  /** @type {Move} */ ({
    ...{ kind: 'joint', posture: Float64Array.from(posture), speed: 1, acceleration: 1, ending: ON, law },
    ...more,
  });

/** @param {number} dof @param {number} rate @param {number} acceleration @returns {JointLimits} */
const limit = (dof, rate, acceleration) => ({
  rates: new Float64Array(dof).fill(rate),
  accelerations: new Float64Array(dof).fill(acceleration),
});

/** Values, rates and accelerations of a joint by the plan, at a moment. @param {MotionPlan} plan @param {number} t @param {number} [joint] */
function at(plan, t, joint = 0) {
  const { posture, rates, accelerations } = planMomentAt(plan, t);
  return [posture[joint], rates[joint], accelerations[joint]];
}

describe('of one joint', () => {
  test('the spline through 0, 1, 0 evenly is that of the books: 24 up, 24 down, at rest on top', () => {
    // by symmetry each half is a cubic from rest to rest; its acceleration is 6/h² at the ends
    const moves = [to([1], 'cubicSpline'), to([0], 'cubicSpline')];
    const plan = planMotion(plainArm(1), Float64Array.of(0), moves, limit(1, 100, 24));
    expect(plan.duration).toBeCloseTo(1, 9);
    [
      [0, 0, 0, 24],
      [0.25, 0.5, 3, 0],
      [0.5, 1, 0, -24],
      [1, 0, 0, 24],
    ].forEach(([t, ...wanted]) => at(plan, t).forEach((value, k) => expect(value).toBeCloseTo(wanted[k], 8)));
    // by the rate: 3/2 of the mean
    expect(planMotion(plainArm(1), Float64Array.of(0), moves, limit(1, 1.5, 1e6)).duration).toBeCloseTo(2, 9);
  });
  test('blends past 0, 1, 0 have the acceleration asked for and cut the point by an eighth of their time and turn', () => {
    const moves = [to([1], 'parabolicBlends'), to([0], 'parabolicBlends')];
    const plan = planMotion(plainArm(1), Float64Array.of(0), moves, limit(1, 1, 4));
    // from rest to a rate of 1 in 1/4 s, which costs half of it: each segment takes 1 + 1/8, and the blend about the point 1/2
    expect(plan.duration).toBeCloseTo(2.25, 9);
    [
      [0.125, 1 / 32, 0.5, 4],
      [0.5, 0.375, 1, 0],
      [1.125, 1 - (2 * 0.5) / 8, 0, -4],
      [2.2, 0.005, -0.2, 4],
    ].forEach(([t, ...wanted]) => at(plan, t).forEach((value, k) => expect(value).toBeCloseTo(wanted[k], 8)));
  });
  test.each(
    /** @type {const} */ ([
      ['cubicSpline', 'cubic'],
      ['parabolicBlends', 'trapezoid'],
    ]),
  )('alone, %s is the %s', (law, plain) => {
    const [own, other] = [law, plain].map((name) =>
      planMotion(plainArm(1), Float64Array.of(0.2), [to([-1], /** @type {ViaLaw} */ (name))], limit(1, 2, 3)),
    );
    expect(own.duration).toBeCloseTo(other.duration, 9);
    for (let k = 0; k <= 20; k++) {
      const [a, b] = [own, other].map((plan) => at(plan, (plan.duration * k) / 20));
      a.slice(0, 2).forEach((value, i) => expect(value).toBeCloseTo(b[i], 7));
    }
  });
});

test.each(LAWS)('%s: to go on takes no much longer than to stop where a short way follows a long one', (law) => {
  for (const way of [1, 0.1, 0.03]) {
    const moves = [to([1], law), to([1 + way], law), to([2], law)];
    const [on, stopping] = [ON, { kind: 'fine' }].map((ending) =>
      planMotion(
        plainArm(1),
        Float64Array.of(0),
        moves.map((move) => /** @type {Move} */ ({ ...move, ending })),
        limit(1, 2, 8),
      ),
    );
    expect(on.duration).toBeLessThan(2 * stopping.duration);
  }
});

test('what is passed and what is not: a stop, a wait, another law, a move to where it stands', () => {
  const [spline, blends] = LAWS.map(
    (law) =>
      (/** @type {number} */ x, /** @type {object} */ more = {}) =>
        to([x], law, more),
  );
  const why = (/** @type {Move[]} */ ...moves) => {
    const plan = planMotion(plainArm(1), Float64Array.of(0), moves, limit(1, 2, 3));
    // whether it stands where it comes to, and what it says of it
    return plan.parts.map(({ end, notBlended }) => (Math.abs(at(plan, end - 1e-7)[1]) < 1e-5 ? notBlended : 'on'));
  };
  expect(why(spline(1), spline(2), spline(3))).toEqual(['on', 'on', 'last']);
  expect(why(blends(1), blends(2), blends(3))).toEqual(['on', 'on', 'last']);
  expect(why(spline(1, { ending: { kind: 'fine' } }), spline(2, { ending: { kind: 'fine' } }))).toEqual([null, null]);
  expect(why(spline(1), { kind: 'wait', seconds: 1 }, spline(2))).toEqual(['wait', null, 'last']);
  expect(why(spline(1), blends(2))).toEqual(['law', 'last']);
  expect(why(to([1], /** @type {ViaLaw} */ (/** @type {unknown} */ ('trapezoid'))), spline(2))).toEqual([
    'law',
    'last',
  ]);
  expect(why(spline(1), to([2], /** @type {ViaLaw} */ (/** @type {unknown} */ ('cubic'))))).toEqual(['law', 'last']);
  expect(why(spline(1), spline(1), spline(2))).toEqual(['still', 'still', 'last']);
});

test('a spline that swings past a limit is refused there, and so is a target past one; what comes before is planned', () => {
  const chain = plainArm(1, 1);
  const moves = [0.5, 0.999, -1].map((x) => to([x], 'cubicSpline'));
  const plan = planMotion(chain, Float64Array.of(-1), moves, limit(1, 1, 10));
  expect(plan.refused).toMatchObject({ move: 2, reason: 'limit', joint: 0 });
  expect(plan.refused?.posture[0]).toBeCloseTo(1, 9);
  expect(plan.parts.map(({ move }) => move)).toEqual([0, 1]);
  expect(at(plan, plan.duration)).toEqual([expect.closeTo(0.999, 9), expect.closeTo(0, 9), expect.anything()]);
  const far = planMotion(chain, Float64Array.of(0), [moves[0], to([1.5], 'cubicSpline')], limit(1, 1, 10));
  expect(far.refused).toEqual({ move: 1, reason: 'limit', joint: 0, share: 0.5, posture: Float64Array.of(1) });
  expect(far.parts).toHaveLength(1);
});

describe('of several joints', () => {
  // no ways so short that the 1e-9 of tolerances is not little
  const value = fc.integer({ min: -3000, max: 3000 }).map((milli) => milli / 1000);
  const most = fc.double({ min: 0.1, max: 10, noNaN: true });
  const share = fc.double({ min: 0.05, max: 1, noNaN: true });
  const program = fc.integer({ min: 1, max: 4 }).chain((dof) => {
    const list = (/** @type {fc.Arbitrary<number>} */ one) => fc.array(one, { minLength: dof, maxLength: dof });
    return fc.record({
      start: list(value),
      vias: fc.array(fc.record({ posture: list(value), speed: share, acceleration: share }), {
        minLength: 2,
        maxLength: 6,
      }),
      rates: list(most),
      accelerations: list(most),
    });
  });

  test.each(LAWS)(
    '%s: rates go on, all limits are kept and one is used, from rest to rest, all joints in the same time',
    (law) => {
      fc.assert(
        fc.property(program, ({ start, vias, ...limits }) => {
          const moves = vias.map(({ posture, ...more }) => to(posture, law, more));
          const own = {
            rates: Float64Array.from(limits.rates),
            accelerations: Float64Array.from(limits.accelerations),
          };
          const plan = planMotion(plainArm(start.length), Float64Array.from(start), moves, own);
          expect(plan.refused).toBeNull();
          expect(plan.parts).toHaveLength(vias.length);
          let [used, leap] = [0, 0];
          // a move to where the arm is takes next to no time, and stands: what comes after it begins anew
          const stands = plan.parts.filter(({ begin, end }) => end - begin < 1e-9);
          const isRest = (/** @type {number} */ t) =>
            stands.some(({ begin, end }) => t > begin - 1e-9 && t < end + 1e-9);
          for (const [k, { begin, end, path, timing, notBlended }] of plan.parts.entries()) {
            expect(timing).toBe(law);
            if (isRest(begin) && isRest(end)) {
              expect(notBlended).toBe(k === vias.length - 1 ? 'last' : 'still');
              for (const t of [begin, end])
                planMomentAt(plan, t).rates.forEach((rate) => expect(Math.abs(rate)).toBeLessThan(1e-8));
              continue;
            }
            const there = planMomentAt(plan, end).posture;
            // a spline meets its targets; blends meet the last
            const meets = law === 'cubicSpline' || k === vias.length - 1;
            if (meets) vias[k].posture.forEach((wanted, i) => expect(Math.abs(there[i] - wanted)).toBeLessThan(1e-9));
            for (const s of path.knots) {
              const t = begin + s - path.knots[0];
              const [before, after] = [-1e-9, 1e-9].map((by) =>
                planMomentAt(plan, Math.min(plan.duration, Math.max(0, t + by))),
              );
              before.rates.forEach((rate, i) => {
                leap = Math.max(leap, Math.abs(after.rates[i] - rate) - 4e-9 * limits.accelerations[i]);
                if (law === 'cubicSpline' && t > 0 && t < plan.duration && !isRest(t)) {
                  const jump = Math.abs(after.accelerations[i] - before.accelerations[i]);
                  expect(jump).toBeLessThan(
                    1e-5 * limits.accelerations[i] + 4e-9 * Math.abs(after.jerks[i]) + 4e-9 * Math.abs(before.jerks[i]),
                  );
                }
              });
            }
            for (let j = 0; j <= 60; j++) {
              const now = planMomentAt(plan, begin + (end - begin) * Math.min(1 - 1e-9, Math.max(1e-9, j / 60)));
              now.rates.forEach((rate, i) => {
                used = Math.max(used, Math.abs(rate) / (vias[k].speed * limits.rates[i]));
                used = Math.max(
                  used,
                  Math.abs(now.accelerations[i]) / (vias[k].acceleration * limits.accelerations[i]),
                );
              });
            }
          }
          expect(used).toBeLessThan(1 + 1e-6);
          expect(leap).toBeLessThan(1e-6);
          const [first, last] = [0, plan.duration].map((t) => planMomentAt(plan, t).rates);
          for (const rates of [first, last]) {
            rates.forEach((rate, i) =>
              expect(Math.abs(rate)).toBeLessThan(1e-9 + 1e-11 * plan.duration * limits.accelerations[i]),
            );
          }
        }),
        { seed: SEED, numRuns: runs(60) },
      );
    },
  );
});
