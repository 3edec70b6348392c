/** Time laws: what books and other programs say they are, and that they keep their limits and hang together. */
import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { doubleS } from '../../../src/motion/doubleS.js';
import { cubicLaw, leastDuration, quinticLaw } from '../../../src/motion/polynomialLaws.js';
import { momentAt, stretched } from '../../../src/motion/timeLaw.js';
import { trapezoidInTime } from '../../../src/motion/trapezoidInTime.js';
import { cubicSpline, parabolicBlends } from '../../../src/motion/viaPoints.js';
import { SEED, runs } from '../../helpers/property.js';
import { RUCKIG, toolboxCase } from './references.js';

/** @import { TimeLaw } from '../../../src/motion/timeLaw.js' */
/** @import { LawCase } from './references.js' */

const ends = (/** @type {TimeLaw} */ law) => [momentAt(law, 0), momentAt(law, law.duration)];

/**
 * Position, rate and, where it should, acceleration go on from piece to piece without a leap.
 * @param {TimeLaw} law @param {{ size: number, rate: number, acceleration: number | null }} of
 */
function expectContinuous({ pieces }, { size, rate, acceleration }) {
  for (const [i, piece] of pieces.entries()) {
    if (i === 0) continue;
    const before = pieces[i - 1];
    // by Horner here and by differences in the law: the value of a polynomial at its end
    const at = (/** @type {readonly number[]} */ c, /** @type {number} */ x) =>
      c.reduceRight((sum, k) => sum * x + k, 0);
    const derived = (/** @type {readonly number[]} */ c) => c.slice(1).map((k, power) => k * (power + 1));
    const [c, d] = [before.coefficients, piece.coefficients];
    expect(Math.abs(at(c, before.duration) - at(d, 0))).toBeLessThan(1e-9 * size);
    expect(Math.abs(at(derived(c), before.duration) - at(derived(d), 0))).toBeLessThan(1e-9 * rate);
    if (acceleration === null) continue;
    const [a, b] = [at(derived(derived(c)), before.duration), at(derived(derived(d)), 0)];
    expect(Math.abs(a - b)).toBeLessThan(1e-7 * acceleration);
  }
}

describe('the double S', () => {
  test.each(RUCKIG.filter(({ q0 }) => q0.length === 1).map((each) => /** @type {const} */ ([each.name, each])))(
    'is as quick as ruckig, and at its places: %s',
    (_, { q0, q1, v0, v1, vmax, amax, jmax, duration, samples }) => {
      const limits = { rate: vmax[0], acceleration: amax[0], ...(jmax && { jerk: jmax[0] }) };
      const law = doubleS(q0[0], q1[0], limits, { rateBefore: v0[0], rateAfter: v1[0] });
      expect(Math.abs(law.duration - duration)).toBeLessThan(1e-12);
      for (const { t, q, qd } of samples) {
        const { position, rate } = momentAt(law, t);
        expect(Math.abs(position - q[0])).toBeLessThan(1e-10);
        if (t < duration) expect(Math.abs(rate - qd[0])).toBeLessThan(1e-10);
      }
    },
  );
  test('has the durations of Biagiotti and Melchiorri’s examples 3.9 and 3.10', () => {
    const [a, b] = [5, 10].map((rate) => doubleS(0, 10, { rate, acceleration: 10, jerk: 30 }, { rateBefore: 1 }));
    const taken = a.pieces.map(({ duration }) => duration);
    expect(a.duration).toBeCloseTo(2.71, 10);
    expect(taken[0]).toBeCloseTo(0.3333, 4);
    expect(taken[0] + taken[1] + taken[2]).toBeCloseTo(0.7333, 4);
    expect(taken[3]).toBeCloseTo(1.1433, 4);
    expect(taken[4] + taken[5] + taken[6]).toBeCloseTo(0.8333, 4);
    expect(b.duration).toBeCloseTo(2.2494, 4);
  });

  const number = (/** @type {number} */ min, /** @type {number} */ max) => fc.double({ min, max, noNaN: true });
  const decade = number(-2, 2).map((power) => 10 ** power);
  test('ends where it should, hangs together and keeps its limits', () => {
    fc.assert(
      fc.property(
        fc.record({
          from: number(-3, 3),
          to: number(-3, 3),
          rate: decade,
          acceleration: decade,
          jerk: fc.option(decade, { nil: undefined }),
          before: number(-1, 1),
          after: number(-1, 1),
        }),
        ({ from, to, before, after, ...limits }) => {
          const rates = { rateBefore: before * limits.rate, rateAfter: after * limits.rate };
          const law = doubleS(from, to, limits, rates);
          const [first, last] = ends(law);
          const size = 1 + Math.abs(from) + Math.abs(to) + limits.rate * law.duration;
          expect(Math.abs(first.position - from)).toBeLessThan(1e-9 * size);
          expect(Math.abs(last.position - to)).toBeLessThan(1e-9 * size);
          if (law.duration > 0) {
            expect(Math.abs(first.rate - rates.rateBefore)).toBeLessThan(1e-9 * limits.rate);
            expect(Math.abs(last.rate - rates.rateAfter)).toBeLessThan(1e-9 * limits.rate);
          }
          const jerky = limits.jerk === undefined ? null : limits.acceleration;
          expectContinuous(law, { size, rate: limits.rate, acceleration: jerky });
          for (let k = 0; k <= 50; k++) {
            const at = momentAt(law, (law.duration * k) / 50);
            expect(Math.abs(at.rate)).toBeLessThan(limits.rate * (1 + 1e-9));
            expect(Math.abs(at.acceleration)).toBeLessThan(limits.acceleration * (1 + 1e-9));
            expect(Math.abs(at.jerk)).toBeLessThanOrEqual((limits.jerk ?? 0) * (1 + 1e-9));
          }
        },
      ),
      { seed: SEED, numRuns: runs(500) },
    );
  });
  test('between rests it takes the time of the closed form', () => {
    fc.assert(
      fc.property(decade, decade, decade, decade, (d, v, a, j) => {
        const { duration } = doubleS(0, -d, { rate: v, acceleration: a, jerk: j });
        const rise = v * j < a * a ? 2 * Math.sqrt(v / j) : a / j + v / a;
        const short =
          2 * a ** 3 > d * j ** 2 ? 4 * Math.cbrt(d / (2 * j)) : a / j + Math.sqrt((a / j) ** 2 + (4 * d) / a);
        const wanted = d / v >= rise ? d / v + rise : short;
        expect(Math.abs(duration - wanted)).toBeLessThan(1e-9 * wanted);
      }),
      { seed: SEED, numRuns: runs(500) },
    );
  });
  test('wrong limits and ends are refused by name', () => {
    expect(() => doubleS(0, 1, { rate: 0, acceleration: 1 })).toThrow('limits.rate: expected a number above 0, got 0.');
    expect(() => doubleS(0, 1, { rate: 1, acceleration: Infinity })).toThrow('limits.acceleration');
    expect(() => doubleS(0, NaN, { rate: 1, acceleration: 1 })).toThrow('to: expected a finite number, got NaN.');
    expect(() => doubleS(0, 1, { rate: 1, acceleration: 1 }, { rateAfter: 2 })).toThrow('rateAfter');
  });
});

describe('polynomials', () => {
  test('Craig 7.1: from 15 to 75 in 3 s; Spong: from 10 to −20 in 1 s', () => {
    const [a, b] = [cubicLaw(15, 75, 3), cubicLaw(10, -20, 1)].map(({ pieces }) => pieces[0].coefficients);
    [15, 0, 20, -4.44].forEach((value, k) => expect(a[k]).toBeCloseTo(value, 2));
    expect(b).toEqual([10, 0, -90, 60]);
  });
  test('Siciliano: π in 1 s has peaks of 3π/2 and 6π', () => {
    const law = cubicLaw(0, Math.PI, 1);
    expect(momentAt(law, 0.5).rate).toBeCloseTo((3 * Math.PI) / 2, 12);
    expect(momentAt(law, 0).acceleration).toBeCloseTo(6 * Math.PI, 12);
  });
  test.each(['quintic 0->1 T=1', 'quintic 0->1 T=1 qd0=0.5'])('%s, of the Robotics Toolbox', (name) => {
    const { t, q, qd, qdd } = /** @type {LawCase} */ (toolboxCase(name));
    const law = quinticLaw(0, 1, 1, { rateBefore: qd[0] });
    t.forEach((time, i) => {
      const at = momentAt(law, time);
      expect(at.position).toBeCloseTo(q[i], 10);
      expect(at.rate).toBeCloseTo(qd[i], 10);
      expect(at.acceleration).toBeCloseTo(qdd[i], 9);
    });
  });
  test.each(/** @type {const} */ (['cubic', 'quintic']))('the least duration of a %s just meets one limit', (kind) => {
    for (const limits of [
      { rate: 1, acceleration: 100 },
      { rate: 100, acceleration: 1 },
      { rate: 100, acceleration: 100, jerk: 1 },
    ]) {
      const duration = leastDuration(kind, -0.7, limits);
      const law = (kind === 'cubic' ? cubicLaw : quinticLaw)(0, -0.7, duration);
      let most = 0;
      for (let k = 0; k <= 4000; k++) {
        const at = momentAt(law, (duration * k) / 4000);
        most = Math.max(
          most,
          Math.abs(at.rate) / limits.rate,
          Math.abs(at.acceleration) / limits.acceleration,
          Math.abs(at.jerk) / (limits.jerk ?? Infinity),
        );
      }
      expect(most).toBeGreaterThan(1 - 1e-6);
      expect(most).toBeLessThan(1 + 1e-9);
    }
  });
  test('no time is enough for no way only', () => {
    expect(cubicLaw(1, 1, 0).duration).toBe(0);
    expect(momentAt(cubicLaw(1, 1, 0), 0).position).toBe(1);
    expect(() => quinticLaw(0, 1, 0)).toThrow('duration: expected a number of seconds above 0, got 0.');
  });
});

describe('linear segments with parabolic blends', () => {
  test.each([
    ['trapezoidal 0->1 T=1 default V=1.5', 1, 1.5],
    ['trapezoidal Spong LSPB 0->40 V=60 T=1', 40, 60],
  ])('%s', (name, to, rate) => {
    const { t, q, qd } = /** @type {LawCase} */ (toolboxCase(name));
    const { law } = trapezoidInTime(0, to, 1, { rate });
    t.forEach((time, i) => {
      const at = momentAt(law, time);
      expect(at.position).toBeCloseTo(q[i], 10);
      expect(at.rate).toBeCloseTo(qd[i], 10);
    });
  });
  test('Spong: blends of 1/3 s and 180 s⁻²; Siciliano: tc = 0.2113', () => {
    const { blend, acceleration } = trapezoidInTime(0, 40, 1, { rate: 60 });
    expect([blend, acceleration]).toEqual([expect.closeTo(1 / 3, 12), expect.closeTo(180, 10)]);
    expect(trapezoidInTime(0, Math.PI, 1, { acceleration: 6 * Math.PI }).blend).toBeCloseTo(0.2113, 4);
  });
  test('a rate or an acceleration that cannot be is refused with what can', () => {
    expect(() => trapezoidInTime(0, 40, 1, { rate: 90 })).toThrow('expected more than 40 and at most 80');
    expect(() => trapezoidInTime(0, 40, 1, { acceleration: 159 })).toThrow('expected at least 160');
    expect(trapezoidInTime(0, 40, 1, { acceleration: 160 }).blend).toBe(0.5);
    expect(trapezoidInTime(5, 5, 1, { rate: 3 }).law.duration).toBe(1);
  });
  test('Craig 7.3: past 10, 35, 25, 10 in 2, 1, 3 s with 50 s⁻²', () => {
    const { law, blends, rates } = parabolicBlends([10, 35, 25, 10], [2, 1, 3], 50);
    [0.27, 0.47, 0.098, 0.102].forEach((value, i) => expect(Math.abs(blends[i] - value)).toBeLessThan(0.003));
    expect(rates[1]).toBe(-10);
    expect(rates[0]).toBeCloseTo(13.3975, 4); // 13.50 in the book, which rounds the blend first
    expect(rates[2]).toBeCloseTo(-5.09, 2);
    const straight = [1, 3, 5].map((i) => law.pieces[i].duration);
    [1.5, 0.716, 2.849].forEach((value, i) => expect(Math.abs(straight[i] - value)).toBeLessThan(0.003));
    expect(law.duration).toBeCloseTo(6, 12);
    const [first, last] = ends(law);
    expect([first.position, last.position]).toEqual([10, expect.closeTo(10, 12)]);
    expect(last.rate).toBeCloseTo(0, 12);
    expectContinuous(law, { size: 35, rate: 13, acceleration: null });
    expect(() => parabolicBlends([10, 35, 25, 10], [2, 1, 3], 12)).toThrow('expected at least 12.5');
    expect(() => parabolicBlends([0, 10, 0, 10], [2, 1, 2], 14)).toThrow('too small for the blends about segment 2');
  });
  test('two points are one trapezoid', () => {
    const { law } = parabolicBlends([0, 40], [1], 180);
    const other = trapezoidInTime(0, 40, 1, { rate: 60 }).law;
    for (const t of [0, 0.1, 1 / 3, 0.5, 0.8, 1]) {
      expect(momentAt(law, t).position).toBeCloseTo(momentAt(other, t).position, 10);
    }
  });
});

test('a cubic spline goes through its points with a continuous acceleration and the rates asked for', () => {
  const point = fc.double({ min: -3, max: 3, noNaN: true });
  fc.assert(
    fc.property(
      fc.array(fc.tuple(point, fc.double({ min: 0.1, max: 3, noNaN: true })), { minLength: 2, maxLength: 8 }),
      point,
      point,
      (vias, rateBefore, rateAfter) => {
        const points = vias.map(([value]) => value);
        const durations = vias.slice(1).map(([, duration]) => duration);
        const law = cubicSpline(points, durations, { rateBefore, rateAfter });
        let t = 0;
        for (const [i, value] of points.entries()) {
          expect(Math.abs(momentAt(law, t).position - value)).toBeLessThan(1e-9);
          t += durations[i] ?? 0;
        }
        const [first, last] = ends(law);
        expect(Math.abs(first.rate - rateBefore)).toBeLessThan(1e-9);
        expect(Math.abs(last.rate - rateAfter)).toBeLessThan(1e-8);
        expectContinuous(law, { size: 10, rate: 100, acceleration: 1000 });
      },
    ),
    { seed: SEED, numRuns: runs(100) },
  );
  expect(() => cubicSpline([0, 1], [])).toThrow('Expected 2 or more points and one duration less, got 2 and 0.');
  expect(() => cubicSpline([0, 1], [0])).toThrow('got 0.');
});

test('stretched, a law covers the same way with rates, accelerations and jerks divided by powers of the factor', () => {
  const law = doubleS(1, 3, { rate: 1, acceleration: 2, jerk: 10 });
  const slow = stretched(law, 2.5);
  for (let k = 0; k <= 20; k++) {
    const [a, b] = [momentAt(law, (law.duration * k) / 20), momentAt(slow, (slow.duration * k) / 20)];
    expect(b.position).toBeCloseTo(a.position, 10);
    if (k === 0 || k === 20) continue;
    expect(b.rate).toBeCloseTo(a.rate / 2.5, 10);
    expect(b.acceleration).toBeCloseTo(a.acceleration / 6.25, 8);
  }
  expect([momentAt(law, -1), momentAt(law, 99)]).toEqual([
    { position: 1, rate: 0, acceleration: 0, jerk: 0 },
    { position: 3, rate: 0, acceleration: 0, jerk: 0 },
  ]);
});
