/** How near an arm comes to what stands around it, and to itself; and that a way called clear is. */
import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { createChain } from '../../../src/kinematics/chain.js';
import { createRandom } from '../../../src/kinematics/random.js';
import { ENDS, armBodies, writeEnds, writeLevers } from '../../../src/motion/clearance/armBodies.js';
import { touchOnPath, touchOnWay } from '../../../src/motion/clearance/clearWay.js';
import { pointDistance } from '../../../src/motion/clearance/obstacles.js';
import { segmentFrom, segmentsApart } from '../../../src/motion/clearance/segmentDistance.js';
import { clearance, createWorkcell } from '../../../src/motion/clearance/workcell.js';
import { SEED, runs } from '../../helpers/property.js';
import { anyChain, anyPose } from '../kinematics/oracle.js';
import { publishedArm } from '../kinematics/publishedArms.js';
import { apart, oracleStretches, outside, pointsOn } from './workcells.js';

/** @import { Obstacle } from '../../../src/motion/clearance/obstacles.js' */

const number = (/** @type {number} */ min, /** @type {number} */ max) => fc.double({ min, max, noNaN: true });
const place = fc.array(number(-1, 1), { minLength: 3, maxLength: 3 });
const size = number(0.01, 0.6);

/** @type {fc.Arbitrary<Obstacle>} */
const anyObstacle = fc.oneof(
  fc.record({ kind: fc.constant(/** @type {const} */ ('sphere')), centre: place, radius: size }),
  fc.record({ kind: fc.constant(/** @type {const} */ ('box')), T_base_box: anyPose, size: fc.tuple(size, size, size) }),
  fc.record({
    kind: fc.constant(/** @type {const} */ ('cylinder')),
    T_base_cylinder: anyPose,
    radius: size,
    height: size,
  }),
  fc
    .tuple(
      place.filter((normal) => Math.hypot(...normal) > 0.1),
      number(-1, 1),
    )
    .map(([normal, offset]) => ({
      kind: /** @type {const} */ ('plane'),
      normal: normal.map((value) => value / Math.hypot(...normal)),
      offset,
    })),
);

describe('segments', () => {
  test('the distance from an obstacle is the least of many points on the segment', () => {
    fc.assert(
      fc.property(anyObstacle, place, place, (obstacle, from, to) => {
        const found = segmentFrom(Float64Array.of(...from, ...to), 0, pointDistance(obstacle));
        const sampled = Math.min(...pointsOn([from, to], 400).map((p) => outside(obstacle, p)));
        const spacing = apart(from, to) / 400;
        expect(found).toBeLessThanOrEqual(sampled + 1e-6 * apart(from, to) + 1e-12);
        expect(found).toBeGreaterThanOrEqual(sampled - spacing - 1e-12);
      }),
      { seed: SEED, numRuns: runs(150) },
    );
  });
  test('the nearest point lies on the obstacle, as far off as said', () => {
    fc.assert(
      fc.property(anyObstacle, place, place, (obstacle, from, to) => {
        const at = new Float64Array(4);
        const found = segmentFrom(Float64Array.of(...from, ...to), 0, pointDistance(obstacle), at);
        const own = from.map((value, i) => value + at[0] * (to[i] - value));
        const nearest = Array.from(at.subarray(1));
        expect(outside(obstacle, nearest)).toBeLessThan(1e-9);
        expect(Math.abs(apart(own, nearest) - found)).toBeLessThan(1e-9);
      }),
      { seed: SEED, numRuns: runs(100) },
    );
  });
  test('the distance of two segments, parallel ones and points among them, is the least of many pairs', () => {
    const segment = fc.oneof(
      fc.tuple(place, place),
      place.map((p) => /** @type {[number[], number[]]} */ ([p, [p[0] + 0.5, p[1], p[2]]])),
      place.map((p) => /** @type {[number[], number[]]} */ ([p, p])),
    );
    fc.assert(
      fc.property(segment, segment, (one, other) => {
        const found = segmentsApart(Float64Array.of(...one.flat(), ...other.flat()), 0, ENDS);
        const sampled = Math.min(...pointsOn(one, 40).flatMap((p) => pointsOn(other, 40).map((q) => apart(p, q))));
        const spacing = (apart(...one) + apart(...other)) / 40;
        expect(found).toBeLessThanOrEqual(sampled + 1e-12);
        expect(found).toBeGreaterThanOrEqual(sampled - spacing - 1e-12);
      }),
      { seed: SEED, numRuns: runs(60) },
    );
  });
  test.each([
    [{ kind: 'sphere', centre: [0, 0, 0], radius: 0 }],
    [{ kind: 'sphere', centre: [0, 0, 0], radius: NaN }],
    [{ kind: 'plane', normal: [0, 0, 2], offset: 0 }],
  ])('%j is no obstacle', (obstacle) => {
    expect(() => pointDistance(/** @type {Obstacle} */ (obstacle))).toThrow(/^Expected/);
  });
});

describe('the body of an arm', () => {
  const RADIUS = 1e-3;

  test('its stretches run from joint to joint, whatever the convention', () => {
    fc.assert(
      fc.property(anyChain, ({ description, q }) => {
        const bodies = armBodies(
          createChain(description),
          q.map(() => RADIUS),
        );
        const ends = writeEnds(bodies, q, new Float64Array(ENDS * bodies.stretches.length));
        const stretches = oracleStretches(description, q);
        bodies.stretches.forEach(({ link, kind }, i) => {
          const expected = stretches.find((each) => each.link === link && each.kind === kind);
          const [one, other] = [
            Array.from(ends.subarray(ENDS * i, ENDS * i + 3)),
            Array.from(ends.subarray(ENDS * i + 3, ENDS * i + 6)),
          ];
          const [from, to] = expected?.ends ?? [[NaN], [NaN]];
          // from either end
          const off = Math.min(apart(one, from) + apart(other, to), apart(one, to) + apart(other, from));
          expect(off).toBeLessThan(1e-11);
        });
        const kept = bodies.stretches.map(({ link, kind }) => `${link} ${kind}`);
        for (const {
          link,
          kind,
          ends: [from, to],
        } of stretches) {
          if (apart(from, to) > 1e-6) expect(kept).toContain(`${link} ${kind}`);
        }
      }),
      { seed: SEED, numRuns: runs(150) },
    );
  });
  test('nothing goes farther than the levers say', () => {
    fc.assert(
      fc.property(
        anyChain,
        fc.array(number(-0.5, 0.5), { minLength: 7, maxLength: 7 }),
        number(0, 1),
        ({ description, q }, steps, share) => {
          const bodies = armBodies(
            createChain(description),
            q.map(() => RADIUS),
          );
          const to = q.map((value, j) => value + steps[j]);
          const levers = writeLevers(bodies, q, to, new Float64Array(q.length * bodies.stretches.length));
          const between = q.map((value, j) => value + share * steps[j]);
          const [before, after] = [q, between].map((posture) => oracleStretches(description, posture));
          bodies.stretches.forEach(({ link, kind }, i) => {
            const [one, other] = [before, after].map((all) =>
              all.find((each) => each.link === link && each.kind === kind),
            );
            const most = steps
              .slice(0, q.length)
              .reduce((sum, step, j) => sum + share * Math.abs(step) * levers[q.length * i + j], 0);
            for (const end of [0, 1]) {
              expect(apart(one?.ends[end] ?? [NaN], other?.ends[end] ?? [NaN])).toBeLessThanOrEqual(most + 1e-12);
            }
          });
        },
      ),
      { seed: SEED, numRuns: runs(150) },
    );
  });
  test('a link whose radius is none, or too few of them, are refused', () => {
    const chain = createChain(publishedArm('planar2r'));
    expect(() => armBodies(chain, [0.1])).toThrow('Expected a radius for each of 2 links, got 1.');
    expect(() => armBodies(chain, [0.1, 0])).toThrow('Expected the radius of link 2 to be above 0, got 0.');
  });
});

describe('a way among obstacles', () => {
  /** @type {(names: string[]) => fc.Arbitrary<{ name: string, obstacles: Obstacle[], from: number[], to: number[] }>} */
  const anyWay = (names) =>
    fc.constantFrom(...names).chain((name) => {
      const { joints } = publishedArm(name);
      const posture = fc.tuple(
        ...joints.map(({ lower, upper }) => number(Math.max(-3, lower ?? -3), Math.min(3, upper ?? 3))),
      );
      return fc.record({
        name: fc.constant(name),
        obstacles: fc.array(anyObstacle, { maxLength: 4 }),
        from: posture,
        to: posture,
      });
    });

  /** The least distance of the arm's surface in a posture, of points on it. @param {string} name @param {Obstacle[]} obstacles @param {number} radius @param {ArrayLike<number>} q */
  function oracleClearance(name, obstacles, radius, q) {
    const moving = oracleStretches(publishedArm(name), q).filter(
      ({ link, kind, ends }) =>
        apart(...ends) > 0 && !(link === 0 && kind === 'offset' && publishedArm(name).joints[0].type === 'revolute'),
    );
    return Math.min(
      Infinity,
      ...moving.flatMap(({ ends }) =>
        pointsOn(ends, 30).flatMap((p) => obstacles.map((obstacle) => outside(obstacle, p) - radius)),
      ),
    );
  }

  test('that is called clear is clear at every look; one that is not has a touch to show', () => {
    const seen = { clear: 0, touched: 0 };
    fc.assert(
      fc.property(
        anyWay(['planar2r', 'scara_cobra600', 'puma560', 'ur5', 'stanford']),
        ({ name, obstacles, from, to }) => {
          const radius = 0.03;
          const chain = createChain(publishedArm(name));
          const cell = createWorkcell(
            armBodies(
              chain,
              from.map(() => radius),
            ),
            obstacles,
            { looksAtItself: false },
          );
          const touch = touchOnWay(cell, from, to);
          if (touch === null) {
            seen.clear++;
            for (let i = 0; i <= 40; i++) {
              const q = from.map((value, j) => value + (i / 40) * (to[j] - value));
              expect(oracleClearance(name, obstacles, radius, q)).toBeGreaterThan(0);
            }
          } else {
            seen.touched++;
            const spacing = 0.05; // of the oracle's points
            expect(oracleClearance(name, obstacles, radius, touch.posture)).toBeLessThan(1e-3 + spacing);
            touch.posture.forEach((value, j) =>
              expect(value).toBeCloseTo(from[j] + touch.share * (to[j] - from[j]), 12),
            );
          }
        },
      ),
      { seed: SEED, numRuns: runs(60) },
    );
    expect(Math.min(seen.clear, seen.touched)).toBeGreaterThan(10);
  });
  test('along curved ways the same holds', () => {
    const seen = { clear: 0, touched: 0 };
    const curve = fc.array(fc.tuple(...[1, 1, 1, 1, 1].map(() => number(-0.6, 0.6))), { minLength: 6, maxLength: 6 });
    fc.assert(
      fc.property(anyWay(['puma560', 'stanford', 'ur5']), curve, ({ name, obstacles, from }, terms) => {
        const radius = 0.03;
        const cell = createWorkcell(
          armBodies(
            createChain(publishedArm(name)),
            from.map(() => radius),
          ),
          obstacles,
          { looksAtItself: false },
        );
        const coefficients = Float64Array.from(from.flatMap((value, j) => [value, ...terms[j]]));
        const touch = touchOnPath(cell, { dof: 6, knots: Float64Array.of(0, 2), coefficients });
        /** @param {number} x */
        const postureAt = (x) =>
          from.map((value, j) => terms[j].reduce((sum, term, k) => sum + term * x ** (k + 1), value));
        if (touch === null) {
          seen.clear++;
          for (let i = 0; i <= 40; i++)
            expect(oracleClearance(name, obstacles, radius, postureAt(i / 40))).toBeGreaterThan(0);
        } else {
          seen.touched++;
          expect(oracleClearance(name, obstacles, radius, touch.posture)).toBeLessThan(1e-3 + 0.05);
          postureAt(touch.share).forEach((value, j) => expect(touch.posture[j]).toBeCloseTo(value, 9));
        }
      }),
      { seed: SEED, numRuns: runs(60) },
    );
    expect(Math.min(seen.clear, seen.touched)).toBeGreaterThan(8);
  });
  test('a way that turns back in its middle is looked at to its ends', () => {
    const chain = createChain(publishedArm('planar2r'));
    const tip = chain.reach - 0.05;
    const obstacle = {
      kind: /** @type {const} */ ('sphere'),
      centre: [tip * Math.cos(1), tip * Math.sin(1), 0],
      radius: 0.1,
    };
    const cell = createWorkcell(armBodies(chain, [0.02, 0.02]), [obstacle]);
    const coefficients = Float64Array.of(1, -4, 4, 0, 0, 0, 0, 0, 0, 0, 0, 0); // 1 − 4 λ (1 − λ): 1 at both ends
    const touch = touchOnPath(cell, { dof: 2, knots: Float64Array.of(0, 1), coefficients });
    expect(touch).toMatchObject({ stretch: 1, obstacle: 0 });
  });
  test('a thin plate between two postures that are both clear is found', () => {
    const chain = createChain(publishedArm('planar2r'));
    const plate = {
      kind: /** @type {const} */ ('box'),
      T_base_box: Float64Array.of(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0.9, 0, 1),
      size: [1e-4, 1, 1],
    };
    const cell = createWorkcell(armBodies(chain, [0.02, 0.02]), [plate]);
    const [from, to] = [
      [Math.PI / 2 - 0.4, 0],
      [Math.PI / 2 + 0.4, 0],
    ];
    for (const end of [from, to]) expect(clearance(cell, end)?.distance).toBeGreaterThan(0.05);
    const touch = touchOnWay(cell, from, to);
    expect(touch?.distance).toBeLessThan(1e-3);
    expect(touch).toMatchObject({ obstacle: 0, other: null });
  });
  test('a margin is kept as well', () => {
    const chain = createChain(publishedArm('planar2r'));
    const cell = createWorkcell(armBodies(chain, [0.02, 0.02]), [{ kind: 'plane', normal: [0, 1, 0], offset: -0.1 }]);
    expect(touchOnWay(cell, [0, 0], [0, 1], { margin: 0.07 })).toBeNull();
    expect(touchOnWay(cell, [0, 0], [0, 1], { margin: 0.09 })).not.toBeNull();
  });
  test('an arm that folds onto itself is told of, and which links are nearest', () => {
    const seen = { apart: 0, folded: 0 };
    fc.assert(
      fc.property(anyWay(['puma560', 'ur5', 'kuka_kr6_r900']), ({ name, from }) => {
        const radius = 0.06;
        const bodies = armBodies(
          createChain(publishedArm(name)),
          from.map(() => radius),
        );
        const nearest = clearance(createWorkcell(bodies, []), from);
        const stretches = oracleStretches(publishedArm(name), from);
        /** @param {number} i */
        const pointsOf = (i) => {
          const { link, kind } = bodies.stretches[i];
          const found = stretches.find((each) => each.link === link && each.kind === kind);
          return pointsOn(found?.ends ?? [[NaN], [NaN]], 30);
        };
        const sampled = bodies.pairs.map(([i, j]) =>
          Math.min(...pointsOf(i).flatMap((p) => pointsOf(j).map((q) => apart(p, q)))),
        );
        const least = Math.min(...sampled) - 2 * radius;
        const found = nearest?.distance ?? NaN;
        expect(found).toBeLessThanOrEqual(least + 1e-12);
        expect(found).toBeGreaterThanOrEqual(least - 0.04);
        expect(nearest?.obstacle).toBeNull();
        seen[found < 0 ? 'folded' : 'apart']++;
      }),
      { seed: SEED, numRuns: runs(60) },
    );
    expect(Math.min(seen.apart, seen.folded)).toBeGreaterThan(3);
  });
  test('links that always touch at their joint are no pair, those that a long link keeps apart are', () => {
    const { stretches, pairs } = armBodies(createChain(publishedArm('ur5')), new Array(6).fill(0.06));
    const links = pairs.map(([i, j]) => [stretches[i].link, stretches[j].link]);
    expect(links).toContainEqual([0, 2]);
    expect(links).not.toContainEqual([2, 3]);
  });
  test.each(['puma560', 'ur5', 'kuka_kr6_r900', 'stanford', 'scara_cobra600', 'planar3r'])(
    'of %s, what one joint alone moves against each other is no pair, and nothing else is left out but what is near',
    (name) => {
      const description = publishedArm(name);
      const chain = createChain(description);
      const { stretches, pairs } = armBodies(
        chain,
        chain.joints.map(() => 1e-6), // so thin that nothing is near
      );
      const random = createRandom(7);
      const postures = [1, 2].map(() => chain.joints.map(() => random() + 0.2));
      /** @param {ArrayLike<number>} q @param {number} i @param {number} j  the places of four points, one seen from the other */
      const shape = (q, i, j) => {
        const [one, other] = [i, j].map((k) => {
          const { link, kind } = stretches[k];
          return oracleStretches(description, q).find((each) => each.link === link && each.kind === kind)?.ends ?? [];
        });
        return one.flatMap((p) => other.map((r) => apart(p, r)));
      };
      stretches.forEach((one, i) => {
        for (let j = i + 1; j < stretches.length; j++) {
          const movers = chain.joints.filter((_, k) => {
            const own = stretches[j].kind === 'offset' && k === stretches[j].link; // that only turns or lengthens it
            const other = postures[0].map((value, m) => (m === k ? postures[1][m] : value));
            const [before, after] = [shape(postures[0], i, j), shape(other, i, j)];
            return !own && k > one.link && before.some((value, m) => Math.abs(value - after[m]) > 1e-9);
          });
          const isPair = pairs.some(([a, b]) => a === i && b === j);
          if (isPair) expect(movers.length, `${i}, ${j}`).toBeGreaterThan(1);
          else expect(stretches[j].link - one.link < 2 || movers.length <= 1, `${i}, ${j}`).toBe(true);
        }
      });
    },
  );
  test('with nothing around and no links that could meet, there is nothing to be near to', () => {
    const cell = createWorkcell(armBodies(createChain(publishedArm('planar2r')), [0.1, 0.1]), []);
    expect(clearance(cell, [1, 2])).toBeNull();
    expect(touchOnWay(cell, [0, 0], [3, -3])).toBeNull();
  });
});
