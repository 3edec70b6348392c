/** Moves that go on into each other. */
import { describe, expect, test } from 'vitest';
import { createChain } from '../../../src/kinematics/chain.js';
import { planMotion } from '../../../src/motion/plan.js';
import { planMoment, planMomentAt } from '../../../src/motion/planMoment.js';
import { momentAt } from '../../../src/motion/timeLaw.js';
import {
  angleBetween,
  arm,
  columnMajor,
  distanceBetween,
  oracleForward,
  rodrigues,
  rowsOf,
  times,
} from '../kinematics/oracle.js';

/** @import { Ending, Move, MotionPlan } from '../../../src/motion/plan.js' */

const ARM = { puma560: [0.3, 0.6, -2.6, 0.4, 0.9, 0.2], ur5: [0.3, -1.2, 1.6, -0.7, 0.9, 0.4] };
const LIMITS = { rates: Float64Array.of(2, 2, 2.5, 4, 4, 6), accelerations: Float64Array.of(8, 8, 10, 20, 20, 30) };
const FINE = /** @type {const} */ ({ kind: 'fine' });

/** @param {keyof typeof ARM} name @param {ArrayLike<number>} q */
const toolAt = (name, q) => oracleForward(arm(name), q).tcp;

/** A pose beside another. @param {number[][]} T @param {readonly number[]} by @param {readonly number[]} turn @returns {Float64Array} */
function beside(T, by, turn) {
  const angle = Math.hypot(...turn);
  const R =
    angle === 0
      ? T
      : times(
          rodrigues([...turn], angle),
          T.slice(0, 3).map((row) => row.slice(0, 3)),
        );
  return columnMajor([...[0, 1, 2].map((i) => [...R[i].slice(0, 3), T[i][3] + by[i]]), [0, 0, 0, 1]]);
}

/** What a plan passes of the limits at most, and how far what it says it is doing is from what it does. @param {MotionPlan} plan @param {number} count */
function audit(plan, count) {
  const [now, before] = [planMoment(6), planMoment(6)];
  const found = { use: 0, gap: 0, jump: 0 };
  const step = plan.duration / count;
  planMomentAt(plan, 0, before);
  for (let k = 1; k <= count; k++) {
    planMomentAt(plan, k * step, now);
    for (let i = 0; i < 6; i++) {
      const use = Math.max(
        Math.abs(now.rates[i]) / LIMITS.rates[i],
        Math.abs(now.accelerations[i]) / LIMITS.accelerations[i],
      );
      found.use = Math.max(found.use, use);
      // by the mean rate it would be here, were its acceleration constant
      const way = now.posture[i] - before.posture[i] - (step * (now.rates[i] + before.rates[i])) / 2;
      found.gap = Math.max(found.gap, Math.max(0, Math.abs(way) - 1e-9) / (step * step * LIMITS.accelerations[i]));
      found.jump = Math.max(found.jump, Math.abs(now.rates[i] - before.rates[i]) / (step * LIMITS.accelerations[i]));
      before.posture[i] = now.posture[i];
      before.rates[i] = now.rates[i];
    }
  }
  return found;
}

describe('zones', () => {
  const start = Float64Array.from(ARM.puma560);
  const chain = createChain(arm('puma560'));
  const T = toolAt('puma560', start);
  const lines = (/** @type {Ending} */ ending) =>
    [
      [0, 0.12, 0],
      [0, 0.12, -0.15],
      [0.1, 0, -0.1],
    ].map(
      (by) =>
        /** @type {Move} */ ({
          kind: 'linear',
          T_base_tcp: beside(T, by, [0.1 * by[0], by[1], 0]),
          speed: 0.3,
          turnSpeed: 1.5,
          acceleration: 2,
          ending,
        }),
    );
  const corners = lines(FINE).map((each) => rowsOf(/** @type {{ T_base_tcp: Float64Array }} */ (each).T_base_tcp));

  test('a zone by distance keeps within it, and to the lines outside it', () => {
    const plan = planMotion(chain, start, lines({ kind: 'distance', distance: 0.02 }), LIMITS);
    expect(plan.refused).toBeNull();
    expect(plan.parts.map(({ notBlended }) => notBlended)).toEqual([null, null, 'last']);
    const way = [T, ...corners];
    let nearest = [Infinity, Infinity];
    for (let k = 0; k <= 600; k++) {
      const is = toolAt('puma560', planMomentAt(plan, (plan.duration * k) / 600).posture);
      const off = [0, 1, 2].map((leg) => {
        const [p, a, b] = [is, way[leg], way[leg + 1]].map((pose) => [0, 1, 2].map((i) => pose[i][3]));
        const d = b.map((x, i) => x - a[i]);
        const along = d.reduce((sum, x, i) => sum + x * (p[i] - a[i]), 0) / d.reduce((sum, x) => sum + x * x, 0);
        const share = Math.min(1, Math.max(0, along));
        return Math.hypot(...p.map((x, i) => x - a[i] - share * d[i]));
      });
      const toCorner = [corners[0], corners[1]].map((corner) => distanceBetween(is, corner));
      if (Math.min(...toCorner) > 0.0201) expect(Math.min(...off)).toBeLessThan(1e-5);
      nearest = nearest.map((value, i) => Math.min(value, toCorner[i]));
    }
    for (const value of nearest) {
      expect(value).toBeGreaterThan(0.001);
      expect(value).toBeLessThan(0.02);
    }
    expect(distanceBetween(toolAt('puma560', planMomentAt(plan, plan.duration).posture), corners[2])).toBeLessThan(
      1e-9,
    );
  });
  test.each(
    /** @type {Ending[]} */ ([
      { kind: 'distance', distance: 0.02 },
      { kind: 'share', share: 0.7 },
    ]),
  )('rates go on from piece to piece and from move to move: %j', (ending) => {
    const joint = /** @type {Move} */ ({
      kind: 'joint',
      posture: Float64Array.from(start, (value, i) => value + [0.3, -0.2, 0.2, 0.5, -0.3, 0.6][i]),
      speed: 1,
      acceleration: 1,
      ending,
    });
    const [first, second, third] = lines(ending);
    // lines into each other, out of a joint move, and into one
    for (const moves of [
      [first, second, third],
      [joint, first, second],
      [first, second, joint],
    ]) {
      const plan = planMotion(chain, start, moves, LIMITS);
      expect(plan.refused).toBeNull();
      for (const { path } of plan.parts) {
        const { knots, coefficients, dof } = path;
        /** The slope of a joint at either end of a piece. @param {number} piece @param {number} i @param {0 | 1} x */
        const slope = (piece, i, x) => {
          const c = coefficients.subarray(6 * (dof * piece + i), 6 * (dof * piece + i) + 6);
          const sum = x === 0 ? c[1] : c.reduce((total, value, k) => total + k * value, 0);
          return sum / (knots[piece + 1] - knots[piece]);
        };
        for (let k = 1; k < knots.length - 1; k++) {
          for (let i = 0; i < dof; i++) expect(Math.abs(slope(k, i, 0) - slope(k - 1, i, 1))).toBeLessThan(1e-6);
        }
      }
      for (const { begin } of plan.parts.slice(1)) {
        const [before, after] = [begin - 1e-9, begin + 1e-9].map((t) => planMomentAt(plan, t).rates.slice());
        before.forEach((rate, i) => expect(Math.abs(after[i] - rate)).toBeLessThan(1e-6));
      }
    }
  });
  test('a larger zone takes less time, and none stops', () => {
    const durations = [0, 0.3, 0.6, 1].map(
      (share) => planMotion(chain, start, lines({ kind: 'share', share }), LIMITS).duration,
    );
    expect(durations[0]).toBe(planMotion(chain, start, lines(FINE), LIMITS).duration);
    for (let k = 1; k < 4; k++) expect(durations[k]).toBeLessThan(durations[k - 1]);
    const plan = planMotion(chain, start, lines({ kind: 'share', share: 0.5 }), LIMITS);
    for (const { end } of plan.parts.slice(0, 2)) {
      expect(Math.hypot(...planMomentAt(plan, end).rates)).toBeGreaterThan(0.05);
    }
  });
  test('the S-curve goes on through them, with the jerk that it has from rest to rest', () => {
    const plan = planMotion(chain, start, lines({ kind: 'distance', distance: 0.04 }), LIMITS);
    expect(plan.parts.map(({ timing }) => timing)).toEqual(['doubleS', 'doubleS', 'doubleS']);
    const [acceleration, step] = [2 / 0.3, 1e-3]; // of the way, whose unit is what it takes at full speed
    let most = 0;
    let gone = 0;
    /** @type {number[]} */
    const ways = [];
    for (const { begin, end, law } of plan.parts) {
      for (let t = ways.length * step; t < end; t += step)
        ways.push(gone + momentAt(law, t - begin).position - law.from);
      gone += law.to - law.from;
    }
    for (let k = 3; k < ways.length; k++) {
      const third = ways[k] - 3 * ways[k - 1] + 3 * ways[k - 2] - ways[k - 3];
      most = Math.max(most, Math.abs(third) / step ** 3);
    }
    expect(most / (2 * acceleration ** 2)).toBeGreaterThan(0.9);
    expect(most / (2 * acceleration ** 2)).toBeLessThan(1.001);
  });
  test('a law that is not kept because the move does not stop is told; one that is, is not', () => {
    const [first, second, third] = lines({ kind: 'distance', distance: 0.02 });
    const by = (/** @type {Move} */ move, /** @type {string} */ law) => /** @type {Move} */ ({ ...move, law });
    const told = (/** @type {Move[]} */ ...moves) =>
      planMotion(chain, start, moves, LIMITS).parts.map(({ timing, instead }) => [timing, instead]);
    expect(told(first, by(second, 'trapezoid'), by(third, 'quintic'))).toEqual([
      ['doubleS', null],
      ['doubleS', 'trapezoid'],
      ['doubleS', 'quintic'],
    ]);
    expect(told(by(first, 'trapezoid'), by(second, 'trapezoid'), by(third, 'quintic'))).toEqual([
      ['trapezoid', null],
      ['trapezoid', null],
      ['trapezoid', 'quintic'],
    ]);
    expect(
      told(by(first, 'timeOptimal'), by(/** @type {Move} */ ({ ...second, ending: FINE }), 'cubic'), third),
    ).toEqual([
      ['timeOptimal', null],
      ['trapezoid', 'cubic'],
      ['doubleS', null],
    ]);
  });
  test('what is not blended says why', () => {
    const share = /** @type {Ending} */ ({ kind: 'share', share: 0.5 });
    const [first, second] = lines(share);
    const why = (/** @type {Move[]} */ ...moves) =>
      planMotion(chain, start, moves, LIMITS).parts.map(({ notBlended }) => notBlended);
    expect(why(first, { kind: 'wait', seconds: 1 }, second)).toEqual(['wait', null, 'last']);
    expect(why(first, first, second)).toEqual(['still', 'still', 'last']);
    expect(why(lines({ kind: 'distance', distance: 0 })[0], second)).toEqual(['short', 'last']);
    expect(() => why(...lines({ kind: 'share', share: 2 }))).toThrow(
      'ending.share: expected a share from 0 to 1, got 2.',
    );
    expect(() => why(...lines({ kind: 'distance', distance: -1 }))).toThrow('ending.distance: expected 0 or more');
  });
  test('a move that leads into one that is refused stops at its end', () => {
    const [first] = lines({ kind: 'distance', distance: 0.02 });
    const far = /** @type {Move} */ ({ ...first, T_base_tcp: beside(T, [3, 0.12, 0], [0, 0, 0]) });
    const plan = planMotion(chain, start, [first, far], LIMITS);
    expect(plan.refused).toMatchObject({ move: 1 });
    expect(plan.parts).toHaveLength(1);
    expect(distanceBetween(toolAt('puma560', planMomentAt(plan, Infinity).posture), corners[0])).toBeLessThan(1e-9);
  });
  test('a circle that asks for more acceleration across than it may have is gone along more slowly, and it says so', () => {
    const move = /** @type {Move} */ ({
      ...lines(FINE)[0],
      kind: 'circular',
      via: beside(T, [0, 0.03, 0.03], [0, 0, 0]),
      T_base_tcp: beside(T, [0, 0.06, 0], [0, 0, 0]),
      law: 'trapezoid',
    });
    const plan = planMotion(chain, start, [move], LIMITS);
    expect(plan.parts[0].slowed).toEqual([{ from: 0, to: 1, joint: null }]);
    const speed = Math.sqrt(2 * 0.03);
    expect(plan.duration).toBeCloseTo((0.03 * Math.PI) / speed + speed / 2, 6);
  });
});

describe('near a singularity', () => {
  test('a line slows down where a joint is at its limit, and says which and where', () => {
    const chain = createChain(arm('puma560'));
    const start = Float64Array.of(0, 0.6, -2.6, 0.2, 0.35, 0);
    const T = toolAt('puma560', start);
    const move = /** @type {Move} */ ({
      kind: 'linear',
      T_base_tcp: beside(T, [0, 0, 0], [0, 0.6, 0]),
      speed: 1,
      turnSpeed: 2,
      acceleration: 10,
      law: 'trapezoid',
      ending: FINE,
    });
    const plan = planMotion(chain, start, [move], LIMITS);
    expect(plan.refused).toBeNull();
    const [part] = plan.parts;
    expect(part.slowed.length).toBeGreaterThan(0);
    const gone = (/** @type {number} */ t) => angleBetween(toolAt('puma560', planMomentAt(plan, t).posture), T) / 0.6;
    for (const { from, to, joint } of part.slowed) {
      let most = 0;
      for (let k = 0; k <= 400; k++) {
        const t = (plan.duration * k) / 400;
        if (gone(t) < from - 0.01 || gone(t) > to + 0.01) continue;
        const { rates, accelerations } = planMomentAt(plan, t);
        const j = /** @type {number} */ (joint);
        most = Math.max(
          most,
          Math.abs(rates[j]) / LIMITS.rates[j],
          Math.abs(accelerations[j]) / LIMITS.accelerations[j],
        );
      }
      expect(most).toBeGreaterThan(0.95);
    }
    expect(audit(plan, 2000).use).toBeLessThan(1.001);
    const unbound = { rates: new Float64Array(6).fill(1e3), accelerations: new Float64Array(6).fill(1e6) };
    const free = planMotion(chain, start, [move], unbound);
    expect(free.parts[0].slowed).toEqual([]);
    expect(free.duration).toBeLessThan(plan.duration);
  });
});
