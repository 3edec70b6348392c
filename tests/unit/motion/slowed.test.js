/** Where a move is slower than it was asked for: whether it is, by how much, and that it is said of the right part of its way. */
import { describe, expect, test } from 'vitest';
import { createChain } from '../../../src/kinematics/chain.js';
import { planMotion } from '../../../src/motion/plan.js';
import { planMomentAt } from '../../../src/motion/planMoment.js';
import { momentAt } from '../../../src/motion/timeLaw.js';
import { angleBetween, arm, columnMajor, oracleForward, rodrigues, times } from '../kinematics/oracle.js';

/** @import { MotionPart, MotionPlan, Move } from '../../../src/motion/plan.js' */

const description = arm('puma560');
const chain = createChain(description);
const start = Float64Array.of(0, 0.6, -2.6, 0.2, 0.35, 0);
const T = oracleForward(description, start).tcp;
const FREE = { rates: new Float64Array(6).fill(1e3), accelerations: new Float64Array(6).fill(1e6) };
const WRIST = 3; // the joint that turns fast beside the singularity of the wrist

/** A turn on the spot that passes near the singularity of the wrist; or that and a line. @param {number} turn  rad @param {readonly number[]} by @param {Partial<Extract<Move, { kind: 'linear' }>>} [more] @returns {Move} */
function past(turn, by, more) {
  const R = times(
    rodrigues([0, 1, 0], turn),
    T.slice(0, 3).map((row) => row.slice(0, 3)),
  );
  return {
    kind: 'linear',
    T_base_tcp: columnMajor([...[0, 1, 2].map((i) => [...R[i], T[i][3] + by[i]]), [0, 0, 0, 1]]),
    speed: 0.05,
    turnSpeed: 0.2,
    acceleration: 0.05,
    law: 'trapezoid',
    ending: { kind: 'fine' },
    ...more,
  };
}

/** Rates and accelerations of a joint at most, by differences of its postures. @param {MotionPlan} plan @param {number} joint */
function mostOf(plan, joint) {
  const count = 6000;
  const step = plan.duration / count;
  const q = Array.from({ length: count + 1 }, (_, k) => planMomentAt(plan, k * step).posture[joint]);
  const rates = q.slice(1).map((value, k) => (value - q[k]) / step);
  const accelerations = rates.slice(1).map((value, k) => (value - rates[k]) / step);
  const most = (/** @type {number[]} */ values) =>
    values.reduce((largest, value) => Math.max(largest, Math.abs(value)), 0);
  return { rate: most(rates), acceleration: most(accelerations) };
}

describe('a law that asks a little more of one joint than its limit', () => {
  test.each(/** @type {const} */ (['trapezoid', 'doubleS', 'cubic', 'quintic']))(
    'is slowed, and one that asks a little less is not: %s',
    (law) => {
      const moves = [past(0.6, [0, 0, 0], { law })];
      const free = planMotion(chain, start, moves, FREE);
      expect(free.parts[0].slowed).toEqual([]);
      const asked = mostOf(free, WRIST);
      for (const [kind, most] of /** @type {const} */ ([
        ['rates', asked.rate],
        ['accelerations', asked.acceleration],
      ])) {
        const within = (/** @type {number} */ limit) => ({ ...FREE, [kind]: FREE[kind].with(WRIST, limit) });
        expect(planMotion(chain, start, moves, within(1.003 * most)).parts[0]).toEqual(free.parts[0]);
        const slow = planMotion(chain, start, moves, within(most / 1.03));
        expect([...new Set(slow.parts[0].slowed.map(({ joint }) => joint))]).toEqual([WRIST]);
        expect(slow.duration).toBeGreaterThan(free.duration);
        const { rate, acceleration } = mostOf(slow, WRIST);
        expect(kind === 'rates' ? rate : acceleration).toBeLessThan((most / 1.03) * 1.001);
      }
    },
  );
});

describe('where it is slower', () => {
  const TIGHT = { ...FREE, rates: FREE.rates.with(WRIST, 0.3) };

  test('alone: from share to share of the way, outside of which it is as fast as its law', () => {
    const moves = [past(0.6, [0, 0, 0])];
    const [slow, free] = [TIGHT, FREE].map((limits) => planMotion(chain, start, moves, limits));
    expect(free.duration).toBeGreaterThan(3); // so that seconds are no shares
    const [stretch, ...others] = slow.parts[0].slowed;
    expect(others).toEqual([]);
    /** By how much of the way is gone: what share of the way a second takes. @param {MotionPlan} plan */
    const ratesOf = (plan) => {
      const step = plan.duration / 1000;
      const gone = Array.from(
        { length: 1001 },
        (_, k) => angleBetween(oracleForward(description, planMomentAt(plan, k * step).posture).tcp, T) / 0.6,
      );
      return (/** @type {number} */ share) => {
        const k = gone.findIndex((value) => value >= share);
        return (gone[k + 1] - gone[k - 1]) / (2 * step);
      };
    };
    const [rate, wanted] = [slow, free].map(ratesOf);
    let [inside, outside] = [0, 0];
    for (let share = 0.02; share < 0.98; share += 0.01) {
      const ratio = rate(share) / wanted(share);
      if (share > stretch.from + 0.01 && share < stretch.to - 0.01) {
        inside++;
        expect(ratio).toBeLessThan(0.999);
      } else if (share < stretch.from - 0.01 || share > stretch.to + 0.01) {
        outside++;
        expect(ratio).toBeGreaterThan(0.98);
      }
    }
    expect(inside).toBeGreaterThan(5);
    expect(outside).toBeGreaterThan(5);
  });

  test.each(/** @type {const} */ (['doubleS', 'quintic']))(
    'before and behind that it is the law itself, as smooth: %s',
    (law) => {
      const moves = [past(0.6, [0, 0, 0], { law, acceleration: 0.5 })];
      const [slow, free] = [TIGHT, FREE].map((limits) => planMotion(chain, start, moves, limits));
      const [{ from, to }] = slow.parts[0].slowed;
      let outside = 0;
      for (let k = 0; k <= 20; k++) {
        for (const isBefore of [true, false]) {
          const since = (/** @type {MotionPlan} */ { duration }) => (isBefore ? 0.05 * k : duration - 0.05 * k);
          const [own, wanted] = [slow, free].map((plan) => planMomentAt(plan, since(plan)));
          const gone = angleBetween(oracleForward(description, wanted.posture).tcp, T) / 0.6;
          if (isBefore ? gone > from - 0.02 : gone < to + 0.02) continue;
          outside++;
          own.rates.forEach((rate, i) => expect(Math.abs(rate - wanted.rates[i])).toBeLessThan(1e-7));
          own.accelerations.forEach((value, i) => expect(Math.abs(value - wanted.accelerations[i])).toBeLessThan(1e-6));
        }
      }
      expect(outside).toBeGreaterThan(15);
    },
  );

  test('of moves that lead into each other: shares of each move’s own part', () => {
    const ending = /** @type {const} */ ({ kind: 'share', share: 0.4 });
    const moves = [past(0, [0, 0, -0.1], { ending }), past(0.6, [0, 0, -0.1], { ending }), past(0.6, [0, 0, 0])];
    const [slow, free] = [TIGHT, FREE].map((limits) => planMotion(chain, start, moves, limits));
    expect(slow.refused).toBeNull();
    expect(slow.parts[1].slowed.length).toBeGreaterThan(0);
    for (const [i, part] of slow.parts.entries()) {
      const [rate, wanted] = [part, free.parts[i]].map(rateOf);
      for (let share = 0.02; share < 0.98; share += 0.01) {
        const isSlow = part.slowed.some(({ from, to }) => share > from + 0.01 && share < to - 0.01);
        const isFast = part.slowed.every(({ from, to }) => share < from - 0.01 || share > to + 0.01);
        if (isSlow) expect(rate(share)).toBeLessThan(0.999 * wanted(share));
        if (isFast) expect(rate(share)).toBeGreaterThan(0.98 * wanted(share));
      }
    }
  });
});

/** The rate of the way at a share of it. @param {MotionPart} part */
function rateOf({ law }) {
  return (/** @type {number} */ share) => {
    let [low, high] = [0, law.duration];
    for (let k = 0; k < 50; k++) {
      const middle = (low + high) / 2;
      if (momentAt(law, middle).position - law.from < share * (law.to - law.from)) low = middle;
      else high = middle;
    }
    return momentAt(law, low).rate;
  };
}
