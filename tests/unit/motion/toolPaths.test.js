/** Ways of the tool, and the joints along such a way. */
import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { createChain } from '../../../src/kinematics/chain.js';
import { blendPath } from '../../../src/motion/blend.js';
import { followPath } from '../../../src/motion/followPath.js';
import { pathMomentAt } from '../../../src/motion/posturePath.js';
import { momentAt } from '../../../src/motion/timeLaw.js';
import { arcPath, linePath } from '../../../src/motion/toolPath.js';
import { trapezoidInTime } from '../../../src/motion/trapezoidInTime.js';
import { SEED, runs } from '../../helpers/property.js';
import { angleBetween, arm, columnMajor, distanceBetween, oracleForward, rowsOf } from '../kinematics/oracle.js';
import { ARCS, toolboxCase } from './references.js';

/** @import { LineCase } from './references.js' */

const DEGREE = Math.PI / 180;

const at = (/** @type {readonly number[]} */ place) =>
  columnMajor([
    [1, 0, 0, place[0]],
    [0, 1, 0, place[1]],
    [0, 0, 1, place[2]],
    [0, 0, 0, 1],
  ]);

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
  test('with the trapezoid it is the toolbox’s ctraj', () => {
    const { T0, T1, T } = /** @type {LineCase} */ (toolboxCase('ctraj 11 steps (trapezoidal s, slerp)'));
    const last = T.length - 1;
    const path = linePath(columnMajor(T0), columnMajor(T1));
    const { law } = trapezoidInTime(0, 1, last, { rate: 1.5 / last });
    T.forEach((wanted, i) => {
      const pose = rowsOf(path.poseAt(momentAt(law, i).position));
      expect(distanceBetween(pose, wanted)).toBeLessThan(1e-9);
      expect(angleBetween(pose, wanted)).toBeLessThan(1e-9);
    });
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
        const passed = path.poseAt(path.viaShare);
        b.forEach((x, k) => expect(Math.abs(passed[12 + k] - x)).toBeLessThan(1e-9 * path.radius));
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
    let done = 0;
    const pull = fc.tuple(...[0, 1, 2, 3, 4, 5].map(() => fc.double({ min: -0.15, max: 0.15, noNaN: true })));
    fc.assert(
      fc.property(pull, pull, fc.constantFrom('line', 'arc', 'zone'), (wobble, way, kind) => {
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
        const corner = columnMajor(
          oracleForward(
            description,
            q.map((value, i) => value + way[(i + 1) % 6]),
          ).tcp,
        );
        const path = {
          line: () => linePath(T, end),
          arc: () => arcPath(T, via, end),
          // from a line into an arc, and only that part of it
          zone: () => blendPath(linePath(corner, T), arcPath(T, via, end), 0.3, 0.4),
        }[kind]();
        const begin = kind === 'zone' ? followPath(chain, linePath(T, path.poseAt(0)), q) : null;
        if (begin && begin.status === 'refused') return;
        const from = begin ? pathMomentAt(begin.path, 1).posture : q;
        const found = followPath(chain, path, from);
        if (found.status !== 'done') return;
        done++;
        expect(found.positionDeviation).toBeLessThanOrEqual(1e-5);
        expect(found.turnDeviation).toBeLessThanOrEqual(0.01 * DEGREE);
        const { knots } = found.path;
        expect([knots[0], knots.at(-1)]).toEqual([0, 1]);
        for (let i = 1; i < knots.length; i++) {
          for (let part = 0.1; part < 1.05; part += 0.1) {
            const share = knots[i - 1] + part * (knots[i] - knots[i - 1]);
            const is = oracleForward(description, pathMomentAt(found.path, share).posture).tcp;
            const wanted = rowsOf(path.poseAt(share));
            expect(distanceBetween(is, wanted)).toBeLessThan(found.positionDeviation);
            expect(angleBetween(is, wanted)).toBeLessThan(found.turnDeviation);
          }
        }
      }),
      { seed: SEED, numRuns: runs(15) },
    );
    expect(done).toBeGreaterThan(5);
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
