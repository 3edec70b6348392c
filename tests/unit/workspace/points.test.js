/** Single points, lines between them, and questions as a worker is asked them. */
import { describe, expect, test } from 'vitest';
import { createChain } from '../../../src/kinematics/chain.js';
import { transferable, workspaceJob } from '../../../src/workspace/jobs.js';
import { createPointFinder } from '../../../src/workspace/points.js';
import { createSampler } from '../../../src/workspace/sampler.js';
import { oracleForward } from '../kinematics/oracle.js';
import { publishedArm } from '../kinematics/publishedArms.js';
import { anthropomorphic, armOf, planar } from './arms.js';

/** @import { ChainDescription } from '../../../src/kinematics/chain.js' */
/** @import { WorkspaceJob } from '../../../src/workspace/jobs.js' */

/** How far a posture is from a place. @param {ChainDescription} arm @param {Float64Array} q @param {number[]} place */
const off = (arm, q, place) => {
  const { tcp } = oracleForward(arm, Array.from(q));
  return Math.hypot(...place.map((value, axis) => value - tcp[axis][3]));
};

describe('a point', () => {
  test('out of reach: no place is nearer than the nearest, which stands on the boundary and in the half-plane of the point', () => {
    const chain = createChain(publishedArm('puma560'));
    const { ask } = createPointFinder(chain);
    const places = new Float32Array(3 * 10_000);
    createSampler(chain, { seed: 7 }).fill(0, places);
    for (const place of [
      [1.2, 0, 0.5],
      [1.5, 0, 0],
      [0.05, 0, 0.6],
      [1, 0, -0.9],
    ]) {
      // prettier-ignore
      const { distance, nearest } = ask(place);
      const away = (/** @type {number} */ k) => Math.hypot(...place.map((value, i) => value - places[k + i]));
      let least = Infinity;
      for (let k = 0; k < places.length; k += 3) least = Math.min(least, away(k));
      expect(least).toBeGreaterThan(distance - 1e-6); // places are sampled in single precision
      expect(Math.abs(nearest[1])).toBeLessThan(1e-6);
      const beside = (/** @type {number} */ metres) =>
        nearest.map((value, i) => value + ((place[i] - value) / distance) * metres);
      expect([ask(beside(-1e-5)).isReached, ask(beside(1e-5)).isReached]).toEqual([true, false]);
    }
  });

  test('inside has all its postures; outside, the nearest place', () => {
    const arm = anthropomorphic(0.4, 0.3);
    const { ask } = createPointFinder(createChain(arm));
    const inside = ask([0.3, 0.2, 0.1]);
    expect(inside).toMatchObject({ isReached: true, isProven: true, areAll: true, distance: 0 });
    expect(inside.postures).toHaveLength(4);
    for (const { q } of inside.postures) expect(off(arm, q, [0.3, 0.2, 0.1])).toBeLessThan(1e-9);
    const beyond = ask([0, 0.6, 0.8]);
    expect(beyond).toMatchObject({ isReached: false, isProven: true, postures: [] });
    expect(beyond.distance).toBeCloseTo(0.3, 8);
    const hole = ask([0.03, 0, -0.04]);
    expect(hole.isReached).toBe(false);
    expect(hole.distance).toBeCloseTo(0.05, 8);
    expect(Math.hypot(...hole.nearest)).toBeCloseTo(0.1, 8);
  });

  test('of a planar arm is nowhere off its plane, and the nearest place is below it', () => {
    const { ask } = createPointFinder(createChain(planar([0.5, 0.3])));
    const above = ask([0.4, 0.3, 0.1]);
    expect(above.isReached).toBe(false);
    expect(above.distance).toBeCloseTo(0.1, 9);
    expect(Array.from(above.nearest).map((value) => Math.round(value * 1e6) / 1e6)).toEqual([0.4, 0.3, 0]);
  });

  test('counts limits: a posture that is outside is none', () => {
    const arm = planar(
      [0.5, 0.3],
      [
        [-1, 1],
        [0, 2],
      ],
    );
    const free = createPointFinder(createChain(arm), { withLimits: false });
    const bound = createPointFinder(createChain(arm));
    expect(free.ask([0.6, 0.1, 0]).postures).toHaveLength(2);
    const { postures } = bound.ask([0.6, 0.1, 0]);
    expect(postures).toHaveLength(1);
    expect(postures[0].limitMargin?.share).toBeGreaterThan(0);
    expect(bound.ask([-0.6, 0.1, 0]).isReached).toBe(false);
  });

  test('of an arm with joints to spare has some postures, and none is said to be all', () => {
    const arm = publishedArm('ur5');
    const answer = createPointFinder(createChain(arm)).ask([0.3, 0.2, 0.3]);
    expect(answer).toMatchObject({ isReached: true, areAll: false });
    expect(answer.postures.length).toBeGreaterThan(1);
    for (const { q } of answer.postures) expect(off(arm, q, [0.3, 0.2, 0.3])).toBeLessThan(1e-8);
  });
});

test('the nearest place is as near as any of all postures, limits counted', () => {
  const arm = planar([0.5, 0.3], [
    [-1, 1],
    [0, 2],
  ]); // prettier-ignore
  const { ask } = createPointFinder(createChain(arm));
  const some = Array.from({ length: 201 * 201 }, (_, k) => {
    const [a, b] = [-1 + Math.floor(k / 201) / 100, (k % 201) / 100];
    return [0.5 * Math.cos(a) + 0.3 * Math.cos(a + b), 0.5 * Math.sin(a) + 0.3 * Math.sin(a + b)];
  });
  for (let k = 0; k < 24; k++) {
    const [x, y] = [Math.cos(0.27 * k) * (0.1 + 0.04 * k), Math.sin(0.27 * k) * (0.1 + 0.04 * k)];
    const least = Math.min(...some.map(([u, v]) => Math.hypot(u - x, v - y)));
    const { distance, isReached } = ask([x, y, 0]);
    expect(distance).toBeLessThanOrEqual(least + 1e-9);
    expect(distance).toBeGreaterThan(isReached ? -1 : least - 0.01);
  }
});

describe('a straight line', () => {
  const { askLine } = createPointFinder(createChain(planar([0.5, 0.3])));

  test('is travelled where it stays inside', () => {
    expect(askLine([0.4, 0.3, 0], [-0.4, 0.3, 0])).toMatchObject({ isTravelled: true, share: 1 });
  });

  test('stops at the hole, there', () => {
    const { isTravelled, share, stop } = askLine([0.4, 0.1, 0], [-0.4, 0.1, 0]);
    expect(isTravelled).toBe(false);
    expect(stop).toMatchObject({ isReachedBeyond: false, held: [] });
    expect(stop?.place[0]).toBeCloseTo(Math.sqrt(0.2 ** 2 - 0.1 ** 2), 4);
    expect(0.4 - 0.8 * share).toBeCloseTo(Math.sqrt(0.2 ** 2 - 0.1 ** 2), 4);
  });

  test('from a place that is not reached goes nowhere', () => {
    expect(askLine([0.9, 0, 0], [0.5, 0, 0])).toMatchObject({
      isTravelled: false,
      share: 0,
      start: null,
      end: null,
      stop: null,
    });
  });

  test('is not travelled by a jump to the other elbow, where no one posture can go all the way', () => {
    const arm = planar(
      [0.5, 0.3],
      [
        [-3, 3],
        [-2, 2],
      ],
    );
    const finder = createPointFinder(createChain(arm));
    const at = (/** @type {number} */ angle) => [0.6 * Math.cos(angle), 0.6 * Math.sin(angle), 0];
    for (const angle of [2.65, 3.65]) expect(finder.ask(at(angle)).isReached).toBe(true);
    const line = finder.askLine(at(2.65), at(3.65));
    expect(line.isTravelled).toBe(false);
    expect(line.share).toBeGreaterThan(0.5);
    expect(line.stop).toMatchObject({ isReachedBeyond: true, held: [{ joint: 0, bound: 'upper' }] });
  });

  test('past the base axis by a hair is none, as the first joint would have to turn half round at once', () => {
    // the shoulder cannot go over the top: straight above the base at 0.5 m it stands at its limit
    const { joints } = anthropomorphic(0.4, 0.3);
    const shoulder = { ...joints[1], lower: 0, upper: Math.acos(0.6) - 1e-6 };
    const arm = armOf(joints[0], shoulder, { ...joints[2], lower: 0, upper: 2.5 });
    const { askLine: ask } = createPointFinder(createChain(arm));
    const past = (/** @type {number} */ y) => ask([0.2, y, 0.5], [-0.2, y, 0.5]);
    expect(past(1e-2).isTravelled).toBe(true);
    const { isTravelled, share } = past(2e-6);
    expect(isTravelled).toBe(false);
    expect(share).toBeCloseTo(0.5, 4);
  });

  test('an elbow at its limit cannot pass, though both ends are reached', () => {
    const arm = planar(
      [0.5, 0.3],
      [
        [-3, 3],
        [0.5, 2],
      ],
    );
    // the line leaves the ring between the radii of the two limits and comes back
    const finder = createPointFinder(createChain(arm));
    const r = Math.sqrt(0.5 ** 2 + 0.3 ** 2 + 0.3 * Math.cos(2)) + 1e-3;
    const { isTravelled, stop } = finder.askLine([r, 0, 0], [-r * 0.8, r * 0.6, 0]);
    expect(isTravelled).toBe(false);
    expect(stop).toMatchObject({ isReachedBeyond: false, held: [{ joint: 1, bound: 'upper' }] });
  });
});

/** @param {ChainDescription} arm @param {WorkspaceJob} job */
function answered(arm, job) {
  const work = workspaceJob(arm, job);
  const words = [];
  let step = work.next();
  for (; !step.done; step = work.next()) words.push(structuredClone(step.value));
  return { words, found: structuredClone(step.value) };
}

describe('a question', () => {
  test('of a section shows places first, and its answer can be posted', () => {
    const { words, found } = answered(planar([0.5, 0.3]), {
      kind: 'section',
      options: { cell: 0.01, tolerance: 1e-4 },
    });
    expect(words[0].first?.cells.reached.some((value) => value === 1)).toBe(true);
    expect(words.length).toBeGreaterThan(2);
    expect(found.kind).toBe('section');
  });

  test('of a cloud is answered in parts, the same each time', () => {
    const ask = () => answered(publishedArm('puma560'), { kind: 'cloud', options: { count: 70_000, seed: 3 } });
    const { words } = ask();
    expect(words.map(({ places }) => places?.length)).toEqual([150_000, 60_000]);
    expect(ask().words).toEqual(words);
  });

  test('of points and of a line', () => {
    const arm = planar([0.5, 0.3]);
    const { found } = answered(arm, { kind: 'points', places: [[0.4, 0, 0], [1, 0, 0]] }); // prettier-ignore
    expect(found.kind === 'points' && found.answers.map(({ isReached }) => isReached)).toEqual([true, false]);
    const line = answered(arm, { kind: 'line', from: [0.4, 0.3, 0], to: [-0.4, 0.3, 0] });
    expect(line.found).toMatchObject({ kind: 'line', answer: { isTravelled: true } });
  });

  test('of an arm that has no map is answered with why', () => {
    const joints = [{ type: /** @type {const} */ ('prismatic'), a: 0, alpha: 0, d: 0, theta: 0 }];
    const { found } = answered({ convention: 'standard', joints }, { kind: 'cloud' });
    expect(found).toEqual({ kind: 'not-mapped', why: { code: 'unlimited-slide', joint: 0 } });
  });

  test('memory is handed over once, and only where a message owns all of it', () => {
    const own = new Float64Array(4);
    const found = transferable({ a: own, b: [{ c: own }], d: new Float64Array(8).subarray(0, 2), e: null, f: 1 });
    expect([...found]).toEqual([own.buffer]);
  });
});
