/** Joint moves, ways of the tool, and the joints along such a way. */
import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { createChain } from '../../../src/kinematics/chain.js';
import { jointMomentsAt, planJointMove } from '../../../src/motion/jointMove.js';
import { followPath } from '../../../src/motion/followPath.js';
import { quinticLaw } from '../../../src/motion/polynomialLaws.js';
import { momentAt } from '../../../src/motion/timeLaw.js';
import { arcPath, linePath } from '../../../src/motion/toolPath.js';
import { SEED, runs } from '../../helpers/property.js';
import { angleBetween, arm, columnMajor, distanceBetween, oracleForward, rowsOf } from '../kinematics/oracle.js';
import { ARCS, RUCKIG, toolboxCase } from './references.js';

/** @import { LawName } from '../../../src/motion/jointMove.js' */
/** @import { JointsCase, LineCase } from './references.js' */

/** @type {LawName[]} */
const LAWS = ['trapezoid', 'doubleS', 'cubic', 'quintic'];
const DEGREE = Math.PI / 180;

const at = (/** @type {readonly number[]} */ place) =>
  columnMajor([
    [1, 0, 0, place[0]],
    [0, 1, 0, place[1]],
    [0, 0, 1, place[2]],
    [0, 0, 0, 1],
  ]);

describe('joint moves', () => {
  test('six joints take the time that ruckig takes', () => {
    const { q0, q1, vmax, amax, jmax, duration } = RUCKIG[RUCKIG.length - 1];
    const limits = q0.map((_, i) => ({ rate: vmax[i], acceleration: amax[i], jerk: (jmax ?? [])[i] }));
    expect(planJointMove(q0, q1, limits).duration).toBeCloseTo(duration, 12);
  });
  test('the quintic law is the toolbox’s jtraj', () => {
    const { t, q, qd } = /** @type {JointsCase} */ (toolboxCase('jtraj 2dof 2s'));
    const laws = [1, 2].map((to) => quinticLaw(0, to, 2));
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
  test('all joints begin and end together, keep their limits, and one of them is at a limit', () => {
    fc.assert(
      fc.property(
        fc.array(joint, { minLength: 1, maxLength: 6 }),
        fc.constantFrom(...LAWS),
        fc.double({ min: 0.01, max: 1, noNaN: true }),
        (joints, law, speed) => {
          const [from, to] = [joints.map((each) => each.from), joints.map((each) => each.to)];
          const move = planJointMove(from, to, joints, { law, speed, acceleration: 0.5 });
          const [first, last] = [0, move.duration].map((t) => jointMomentsAt(move, t));
          let used = 0;
          for (const [i, { rate, acceleration, jerk }] of joints.entries()) {
            expect(move.laws[i].duration).toBe(move.duration);
            expect(Math.abs(first[i].position - from[i])).toBeLessThan(1e-12);
            expect(Math.abs(last[i].position - to[i])).toBeLessThan(1e-9);
            for (let k = 0; k <= 40; k++) {
              const now = momentAt(move.laws[i], (move.duration * k) / 40);
              const jerks = law === 'trapezoid' || law === 'cubic' ? 0 : Math.abs(now.jerk) / (0.5 * jerk);
              const shares = [Math.abs(now.rate) / (speed * rate), Math.abs(now.acceleration) / (0.5 * acceleration)];
              used = Math.max(used, jerks, ...shares);
            }
          }
          expect(used).toBeLessThan(1.001);
          if (move.duration > 1e-6 && law !== 'cubic') expect(used).toBeGreaterThan(0.99);
          if (move.slowest === null) expect(move.duration).toBe(0);
        },
      ),
      { seed: SEED, numRuns: runs(300) },
    );
  });
  test('a way too short for powers of its time to be numbers is covered within the limits all the same', () => {
    const limits = [{ rate: 0.001, acceleration: 0.1, jerk: 0.1 }];
    for (const way of [8e-21, 1e-30, 5e-324]) {
      for (const law of LAWS) {
        const move = planJointMove([way], [0], limits, { law, acceleration: 0.5 });
        expect(jointMomentsAt(move, move.duration / 2)[0].position).toBeLessThanOrEqual(way);
        expect(Math.abs(jointMomentsAt(move, 0)[0].acceleration)).toBeLessThan(0.05 * 1.0001);
      }
    }
  });
  test('wrong calls are refused', () => {
    const limits = [{ rate: 1, acceleration: 1 }];
    expect(() => planJointMove([0], [1, 2], limits)).toThrow('Expected as many values');
    expect(() => planJointMove([0], [1], limits, { speed: 0 })).toThrow('speed: expected a share above 0');
    expect(() => planJointMove([0], [NaN], limits)).toThrow('to: expected a finite number, got NaN.');
  });
});

describe('ways of the tool', () => {
  test('the straight line with turning is the toolbox’s', () => {
    const { s, T0, T1, T } = /** @type {LineCase} */ (toolboxCase('straight line + slerp, s uniform'));
    const path = linePath(columnMajor(T0), columnMajor(T1));
    s.forEach((share, i) => {
      const pose = rowsOf(path.poseAt(share));
      expect(distanceBetween(pose, T[i])).toBeLessThan(1e-9);
      expect(angleBetween(pose, T[i])).toBeLessThan(1e-9);
    });
    expect(path.poseAt(1)).toEqual(columnMajor(T1));
  });
  test.each(ARCS.map((each) => /** @type {const} */ ([each.name, each])))(
    '%s',
    (_, { via, center, radius, normal, sweep_rad: sweep, arc_length: length, points }) => {
      const path = arcPath(at(via[0]), via[1], at(via[2]));
      expect(path.radius).toBeCloseTo(radius, 10);
      expect(path.sweep).toBeCloseTo(sweep, 10);
      expect(path.length).toBeCloseTo(length, 10);
      center.forEach((x, k) => expect(path.center[k]).toBeCloseTo(x, 10));
      normal.forEach((x, k) => expect(path.normal[k]).toBeCloseTo(x, 10));
      points.forEach((point, i) => {
        const pose = path.poseAt(i / (points.length - 1));
        point.forEach((x, k) => expect(Math.abs(pose[12 + k] - x)).toBeLessThan(1e-9));
      });
    },
  );
  test('an arc passes its point, evenly, whatever three points it is given', () => {
    const place = fc.tuple(...[0, 1, 2].map(() => fc.double({ min: -1, max: 1, noNaN: true })));
    fc.assert(
      fc.property(place, place, place, (a, b, c) => {
        const sides = [
          [a, b],
          [b, c],
          [c, a],
        ].map(([p, q]) => Math.hypot(...p.map((x, k) => x - q[k])));
        const half = (sides[0] + sides[1] + sides[2]) / 2;
        const flat = Math.sqrt(Math.max(0, half * (half - sides[0]) * (half - sides[1]) * (half - sides[2])));
        fc.pre(flat > 1e-3 * Math.max(...sides) ** 2 && Math.min(...sides) > 1e-2);
        const path = arcPath(at(a), b, at(c));
        const places = Array.from({ length: 721 }, (_, i) => path.poseAt(i / 720).slice(12, 15));
        const steps = places.slice(1).map((p, i) => Math.hypot(...p.map((x, k) => x - places[i][k])));
        expect(Math.max(...steps) - Math.min(...steps)).toBeLessThan(1e-9 * path.radius);
        const nearest = Math.min(...places.map((p) => Math.hypot(...p.map((x, k) => x - b[k]))));
        expect(nearest).toBeLessThan(path.length / 720);
        c.forEach((x, k) => expect(places[720][k]).toBe(x));
      }),
      { seed: SEED, numRuns: runs(60) },
    );
  });
  test('three points on a line, or two that are one, have no circle', () => {
    expect(() => arcPath(at([0, 0, 0]), [1, 1, 1], at([2, 2, 2]))).toThrow('not on one line');
    expect(() => arcPath(at([0, 0, 0]), [1, 1, 1], at([0, 0, 0]))).toThrow('apart');
  });
});

describe('the joints along a way', () => {
  const ARM = { puma560: [0.3, 0.6, -2.6, 0.4, 0.9, 0.2], ur5: [0.3, -1.2, 1.6, -0.7, 0.9, 0.4] };
  const names = /** @type {(keyof typeof ARM)[]} */ (Object.keys(ARM));

  test.each(names)('of %s keep to lines and arcs as exactly as promised, between the postures too', (name) => {
    const description = arm(name);
    const chain = createChain(description);
    const pull = fc.tuple(...[0, 1, 2, 3, 4, 5].map(() => fc.double({ min: -0.15, max: 0.15, noNaN: true })));
    fc.assert(
      fc.property(pull, pull, fc.boolean(), (wobble, way, isArc) => {
        const q = ARM[name].map((value, i) => value + wobble[i]);
        const T = columnMajor(oracleForward(description, q).tcp);
        const end = columnMajor(
          oracleForward(
            description,
            q.map((value, i) => value + way[i]),
          ).tcp,
        );
        fc.pre(distanceBetween(rowsOf(T), rowsOf(end)) > 0.01);
        const via = [0, 1, 2].map((k) => (T[12 + k] + end[12 + k]) / 2 + (k === 2 ? 0.05 : 0));
        const path = isArc ? arcPath(T, via, end) : linePath(T, end);
        const found = followPath(chain, path, q);
        if (found.status !== 'done') return;
        expect(found.positionDeviation).toBeLessThanOrEqual(1e-5);
        expect(found.turnDeviation).toBeLessThanOrEqual(0.01 * DEGREE);
        expect([found.shares[0], found.shares.at(-1)]).toEqual([0, 1]);
        for (let i = 1; i < found.shares.length; i++) {
          for (const part of [0.1, 0.3, 0.5, 0.7, 0.9, 1]) {
            const [a, b] = [found.postures[i - 1], found.postures[i]];
            const between = [...a].map((value, k) => value + part * (b[k] - value));
            const share = found.shares[i - 1] + part * (found.shares[i] - found.shares[i - 1]);
            const [is, wanted] = [oracleForward(description, between).tcp, rowsOf(path.poseAt(share))];
            expect(distanceBetween(is, wanted)).toBeLessThan(found.positionDeviation);
            expect(angleBetween(is, wanted)).toBeLessThan(found.turnDeviation);
          }
        }
      }),
      { seed: SEED, numRuns: runs(12) },
    );
  });
  test('a SCARA goes straight down: a slide counts in metres', () => {
    const description = arm('scara_cobra600');
    const chain = createChain(description);
    const q = [0.3, 0.7, 0.05, 0.2];
    const T = columnMajor(oracleForward(description, q).tcp);
    const end = T.slice();
    end[13] += 0.05;
    end[14] += (oracleForward(description, [0.3, 0.7, 0.1, 0.2]).tcp[2][3] - T[14]) / 2;
    const found = followPath(chain, linePath(T, end), q);
    expect(found.status).toBe('done');
  });
  test('a line that leaves the reach, or passes a limit, is refused with where and why', () => {
    const description = arm('puma560');
    const chain = createChain(description);
    const q = ARM.puma560;
    const T = columnMajor(oracleForward(description, q).tcp);
    const far = T.slice();
    far[12] += 2;
    const beyond = followPath(chain, linePath(T, far), q);
    if (beyond.status !== 'refused') throw new Error('It was not refused.');
    expect(['reach', 'limit', 'orientation']).toContain(beyond.reason);
    const there = oracleForward(description, [...beyond.posture]).tcp;
    expect(distanceBetween(there, rowsOf(linePath(T, far).poseAt(beyond.share)))).toBeLessThan(1e-8);
    expect(followPath(chain, linePath(T, far), q)).toEqual(beyond); // the same again

    const limited = createChain({
      ...description,
      joints: description.joints.map((joint, i) => (i === 0 ? { ...joint, upper: 0.35 } : joint)),
    });
    const aside = T.slice();
    aside[12] -= 0.2 * Math.sin(0.3);
    aside[13] += 0.2 * Math.cos(0.3);
    const stopped = followPath(limited, linePath(T, aside), q);
    expect(stopped).toMatchObject({ status: 'refused', reason: 'limit', joint: 0 });
    if (stopped.status === 'refused') expect(stopped.posture[0]).toBeCloseTo(0.35, 4);
  });
  test('a posture that is not where the way begins is refused', () => {
    const description = arm('puma560');
    const T = columnMajor(oracleForward(description, ARM.puma560).tcp);
    const other = ARM.puma560.map((value) => value + 0.1);
    expect(followPath(createChain(description), linePath(T, T), other)).toMatchObject({ reason: 'start', share: 0 });
  });
});
