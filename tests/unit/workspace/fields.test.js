/** Sections of arms with joints to spare: closed forms, another seed, and places that no cell may miss; and what curves make of a plane. */
import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { createChain } from '../../../src/kinematics/chain.js';
import { arranged, endsOf, ringsOf } from '../../../src/workspace/arrangement.js';
import { createSampler } from '../../../src/workspace/sampler.js';
import { sectionAtOnce } from '../../../src/workspace/section.js';
import { atOnce } from '../../../src/workspace/steps.js';
import { runs, SEED } from '../../helpers/property.js';
import { publishedArm } from '../kinematics/publishedArms.js';
import { annulus, armOf, both, farthestOff, planar, right, sliding, turning, wrongCells } from './arms.js';

/** @import { ChainDescription } from '../../../src/kinematics/chain.js' */
/** @import { Section, SectionOptions } from '../../../src/workspace/section.js' */
/** @import { Traced, Vertex } from '../../../src/workspace/traced.js' */
/** @import { Inside } from './arms.js' */

const isDeep = Boolean(process.env.DENAVIT_DEEP);
const QUARTER = Math.PI / 2;

/** @param {ChainDescription} arm @param {SectionOptions} [options] @returns {Section} */
function sectionOf(arm, options) {
  const section = sectionAtOnce(createChain(arm), options);
  if (!section) throw new Error('Expected a section.');
  return section;
}

/**
 * Three links whose first joint turns a quarter either way, the others all the way round: places no farther from the arc that the
 * elbow runs on than the two others are long together. (Nowhere are all places of the arc nearer than their difference.)
 * @type {Inside}
 */
const aroundArc = (x, y) => {
  const [elbow, rest] = [0.5, 0.45];
  const toArc = x >= 0 ? Math.abs(Math.hypot(x, y) - elbow) : Math.hypot(x, Math.abs(y) - elbow);
  return rest - toArc;
};

/** Three links in a half-plane, the first of them beside its axis, over which they reach: what comes out on the other side is nothing new. */
const OVER = armOf(turning([0.05, QUARTER, 0, 0]), ...[0.2, 0.15, 0.1].map((a) => turning([a, 0, 0, 0])));

describe('the section of a planar 3R arm', () => {
  test.each([
    ['without limits', planar([0.5, 0.3, 0.15]), annulus(0.05, 0.95), Math.PI * (0.95 ** 2 - 0.05 ** 2)],
    [
      'with a limited shoulder',
      planar([0.5, 0.3, 0.15], [[-QUARTER, QUARTER]]),
      aroundArc,
      QUARTER * (0.95 ** 2 - 0.05 ** 2) + Math.PI * 0.45 ** 2,
    ],
    ...(isDeep
      ? [
          /** @type {[string, ChainDescription, Inside, number]} */ ([
            'beside an axis that it reaches over',
            OVER,
            both((u, v) => 0.45 - Math.hypot(u - 0.05, v), right),
            QUARTER * 0.45 ** 2 + 0.05 * Math.sqrt(0.45 ** 2 - 0.05 ** 2) + 0.45 ** 2 * Math.asin(0.05 / 0.45),
          ]),
        ]
      : []),
  ])('%s: boundary, area and cells are what its closed form says', (_name, arm, inside, area) => {
    const section = sectionOf(arm, { cell: isDeep ? 4e-3 : 0.02 });
    expect(farthestOff(section, inside)).toBeLessThan(5e-5);
    expect(Math.abs(section.area - area)).toBeLessThan(section.areaError);
    expect(section.areaError).toBeLessThan(1e-3 * area);
    expect(section.gap).toBeLessThan(1e-4);
    expect(wrongCells(section, inside, 5e-5)).toBe(0);
  });

  test('with all its joints limited: as two links reach it from somewhere that the first can be', () => {
    const limits = [[-QUARTER, QUARTER], [0, 2], [-1, 1]]; // prettier-ignore
    const { cells, area, areaError } = sectionOf(planar([0.5, 0.3, 0.15], limits), { cell: 0.01 });
    /** Whether two links reach a place seen from the elbow: the cosine rule, both bends. @param {number} x @param {number} y */
    const isReachedByTwo = (x, y) => {
      const cosine = (x * x + y * y - 0.3 ** 2 - 0.15 ** 2) / (2 * 0.3 * 0.15);
      if (Math.abs(cosine) > 1) return false;
      return [Math.acos(cosine), -Math.acos(cosine)].some((bend) => {
        const turn = Math.atan2(y, x) - Math.atan2(0.15 * Math.sin(bend), 0.3 + 0.15 * Math.cos(bend));
        const q = turn - 2 * Math.PI * Math.round((turn - 1) / (2 * Math.PI));
        return q >= 0 && q <= 2 && Math.abs(bend) <= 1;
      });
    };
    const steps = isDeep ? 4000 : 1000;
    let [count, wrong] = [0, 0];
    for (let k = 0; k < cells.reached.length; k += isDeep ? 1 : 31) {
      const at = (/** @type {number} */ i, /** @type {number} */ j) =>
        cells.reached[k + i + j * cells.columns] === cells.reached[k];
      if (![-1, 0, 1].every((i) => [-1, 0, 1].every((j) => at(i, j)))) continue; // at the boundary
      const u = cells.u + ((k % cells.columns) + 0.5) * cells.size;
      const v = cells.v + (Math.floor(k / cells.columns) + 0.5) * cells.size;
      let isReached = false;
      for (let s = 0; s <= steps && !isReached; s++) {
        const q = -QUARTER + (s / steps) * Math.PI;
        const [x, y] = [u - 0.5 * Math.cos(q), v - 0.5 * Math.sin(q)];
        isReached = isReachedByTwo(Math.cos(q) * x + Math.sin(q) * y, Math.cos(q) * y - Math.sin(q) * x);
      }
      count++;
      if (isReached !== (cells.reached[k] === 1)) wrong++;
    }
    expect(wrong).toBe(0);
    expect(count).toBeGreaterThan(isDeep ? 10_000 : 300);
    expect(areaError).toBeLessThan(1e-3 * area);
  });
});

test.runIf(isDeep)('where a piece of boundary is overlooked, coarser lines find it', () => {
  const { gap, area, areaError } = sectionOf(publishedArm('kuka_kr6_r900'));
  expect(gap).toBeLessThan(1e-3);
  expect(areaError).toBeLessThan(1e-3 * area);
});

describe('the section of an arm with joints to spare closes, and misses no place that is sampled:', () => {
  test.each(['ur10', 'kuka_youbot', ...(isDeep ? ['ur5', 'kuka_kr6_r900', 'kuka_kr210_l150', 'kinova_jaco'] : [])])(
    '%s',
    (name) => {
      const arm = publishedArm(name);
      const { cells, frame, gap, area, areaError } = sectionOf(arm, { cell: 4e-3, tolerance: 2e-4 });
      expect(gap).toBeLessThan(2e-3);
      expect(areaError).toBeLessThan(0.02 * area);
      const count = isDeep ? 1e6 : 1e5;
      const places = new Float32Array(3 * count);
      createSampler(createChain(arm), { seed: 9 }).fill(0, places);
      let outside = 0;
      for (let k = 0; k < places.length; k += 3) {
        const v = places[k + 2] - frame.origin[2];
        const u = Math.hypot(places[k] - frame.origin[0], places[k + 1] - frame.origin[1]);
        const [i, j] = [Math.floor((u - cells.u) / cells.size), Math.floor((v - cells.v) / cells.size)];
        let isNear = false;
        for (let a = i - 1; a <= i + 1; a++)
          for (let b = j - 1; b <= j + 1; b++)
            if (a >= 0 && b >= 0 && a < cells.columns && cells.reached[b * cells.columns + a] === 1) isNear = true;
        if (!isNear) outside++;
      }
      expect(outside).toBe(0);
    },
  );

  test('whatever the seed, the same area', () => {
    const [one, other] = [1, 2].map((seed) => sectionOf(publishedArm('ur3'), { cell: 8e-3, tolerance: 2e-4, seed }));
    expect(Math.abs(one.area - other.area)).toBeLessThan(one.areaError);
  });
});

/** Two joints that turn about one direction: seen from their edge, both move the tool along one line. */
const inLine = [0, 1].map(() => [0.075, 0, 0, 0]);

describe('a gantry whose tool stands beside its wrist', () => {
  const quarter = [0, QUARTER, 0, QUARTER];
  const tool = 0.15;
  const gantry = (/** @type {number} */ travel, /** @type {number[][]} */ ...wrist) =>
    armOf(
      ...[sliding(quarter, [0, travel]), sliding(quarter, [0, 1]), sliding([0, QUARTER, 0, 0], [0, 0.6])],
      ...wrist.map((row) => turning(row)),
    );
  const options = { tolerance: 2e-4, cell: 5e-3 };
  const [oneTurn, twoTurns] = [[[tool, 0, 0, 0]], [[0, QUARTER, 0, 0], [tool, 0, 0, 0]]]; // prettier-ignore

  test.each(
    /** @type {[string, number[][], number][]} */ ([
      ['one joint that turns, seen from its edge', oneTurn, 0.6 + 2 * tool],
      ...(isDeep ? [['two that turn along one line', inLine, 0.6 + 2 * tool]] : []),
      [
        'two: a rectangle rolled along by a disc',
        twoTurns,
        (1 + 2 * tool) * (0.6 + 2 * tool) - (4 - Math.PI) * tool ** 2,
      ],
    ]),
  )('%s', (_, wrist, area) => {
    const section = sectionOf(gantry(0.8, ...wrist), options);
    expect(section.kind).toBe('plane');
    expect(Math.abs(section.area - area)).toBeLessThan(section.areaError);
    expect(section.areaError).toBeLessThan(0.003);
    expect(section.gap).toBeLessThan(1e-3);
    expect(section.outlines).toHaveLength(1);
  });
});

/**
 * Where the slide that crosses the plane is too short for some postures: a low box of wrists with a tool around each, and a pillar with an arm,
 * cut aslant so that what is reached ends where the slide does.
 */
describe('a slide too short for some postures:', () => {
  const [high, deep, wide, tool] = [0.1, 1.2, 0.6, 0.15];
  const up = [0, QUARTER, 0, QUARTER];
  const gantry = (/** @type {number[][]} */ ...wrist) =>
    armOf(
      ...[sliding(up, [0, high]), sliding(up, [0, deep]), sliding([0, QUARTER, 0, 0], [0, wide])],
      ...wrist.map((row) => turning(row)),
    );
  /** As it is seen from above, places are nearer to each other by this share. */
  const seen = 1 / Math.hypot(1, 0.5);
  /** @param {number[]} from @param {boolean} [isLevel] @returns {SectionOptions} */
  const across = (from, isLevel = false) => ({
    cut: {
      kind: 'plane',
      origin: [from[0], from[1], from[2]],
      u: [0, 1, 0],
      v: isLevel ? [-1, 0, 0] : [seen, 0, 0.5 * seen],
    },
    tolerance: 4e-4,
    cell: 0.02,
  });
  /** Seen along the plane's slope a rectangle, rolled along by the tool. @type {Inside} */
  const rolled = (u, v) => {
    const z = 0.5 * seen * v;
    return tool - Math.hypot(Math.max(0, -u, u - wide), Math.max(0, -z, z - high));
  };
  const slanting = (wide * high + 2 * tool * (wide + high) + Math.PI * tool ** 2) / (0.5 * seen);
  const beyond = 0.1;
  const rest = Math.sqrt(tool ** 2 - beyond ** 2);
  /** @type {Inside} */
  const levelled = (u, v) => rest - Math.hypot(Math.max(0, -u, u - wide), Math.max(0, v, -deep - v));
  /** Three links of together 0.6 m that turn about the slide, which lets them follow the plane so far out. */
  const out = 0.3;
  const strip = 2 * (out * Math.sqrt(0.36 - out ** 2) + 0.36 * Math.asin(out / 0.6)) - Math.PI * 0.1 ** 2;
  const pillar = armOf(sliding([0, 0, 0, 0], [0, out]), ...[0.35, 0.15, 0.1].map((a) => turning([a, 0, 0, 0])));

  test.each(
    /** @type {[string, ChainDescription, SectionOptions, number, Inside][]} */ ([
      [
        'a pillar with three links',
        pillar,
        across([0, 0, out / 2]),
        strip / seen,
        (u, v) => Math.min(annulus(0.1, 0.6)(u, seen * v), out - Math.abs(seen * v)),
      ],
      ...(isDeep
        ? [
            ['one joint that turns', gantry([tool, 0, 0, 0]), across([0.4, 0, 0]), slanting, rolled],
            ['two that turn along one line', gantry(...inLine), across([0.4, 0, 0]), slanting, rolled],
            [
              'two that turn to all sides, beyond the end of the slide',
              gantry([0, QUARTER, 0, 0], [tool, 0, 0, 0]),
              across([0, 0, high + beyond], true),
              (deep + 2 * rest) * (wide + 2 * rest) - (4 - Math.PI) * rest ** 2,
              levelled,
            ],
          ]
        : []),
    ]),
  )('%s', (_name, arm, options, area, inside) => {
    const section = sectionOf(arm, options);
    expect(Math.abs(section.area - area)).toBeLessThan(section.areaError);
    expect(section.areaError).toBeLessThan(0.01 * area);
    expect(farthestOff(section, inside)).toBeLessThan(1e-3);
  });
});

/** @param {number} u @param {number} v @returns {Vertex} */
const vertex = (u, v) => ({ x: new Float64Array(0), u, v });

/** @type {Traced} */
const curve = { kind: 'singular', fixed: [], vertices: [], roughness: 0, between: () => null };

/** @param {number[][]} lines  u, v, u, v each */
const drawn = (lines) =>
  atOnce(
    arranged(
      lines.map(([a, b, c, d]) => ({ from: vertex(a, b), to: vertex(c, d), curve: { ...curve } })),
      [],
      1e-3,
    ),
  );

/** Twice what a ring runs around, signed. @param {ReturnType<typeof drawn>} arrangement @param {number[]} ring */
const twice = (arrangement, ring) =>
  ring.reduce((sum, half) => {
    const [a, b] = endsOf(arrangement, half);
    return sum + a.u * b.v - b.u * a.v;
  }, 0);

describe('lines part the plane', () => {
  test('two squares that overlap make three fields, and what ends in the open none', () => {
    const square = (/** @type {number} */ at) => [
      [at, at, at + 2, at],
      [at + 2, at, at + 2, at + 2],
      [at + 2, at + 2, at, at + 2],
      [at, at + 2, at, at],
    ];
    const arrangement = drawn([...square(0), ...square(1), [0.5, 0.5, 0.5, -3]]);
    const areas = ringsOf(arrangement).rings.map((ring) => Math.round(twice(arrangement, ring)) / 2);
    expect(areas.sort((a, b) => a - b)).toEqual([-7, 1, 3, 3]);
  });

  test('an end that stops short of a line is joined to it, and the gap is known', () => {
    const arrangement = drawn([[0, 0, 3, 0], [3, 0, 3, 3], [3, 3, 0, 3], [0, 3, 0, 0.004]]); // prettier-ignore
    expect(ringsOf(arrangement).rings).toHaveLength(2);
    expect(Math.max(...arrangement.edges.map(({ gap }) => gap))).toBeCloseTo(0.004, 6);
  });

  test('into as many fields as Euler says, whose areas cancel', () => {
    const place = fc.integer({ min: 0, max: 40 }).map((value) => value / 10);
    const line = fc.tuple(place, place, place, place).filter(([a, b, c, d]) => a !== c || b !== d);
    const told = fc.property(fc.array(line, { minLength: 3, maxLength: 14 }), (lines) => {
      const arrangement = drawn(lines);
      const { rings } = ringsOf(arrangement);
      const nodes = new Set(arrangement.edges.flatMap(({ a, b }) => [a, b]));
      const part = new Map([...nodes].map((node) => [node, node]));
      const rootOf = (/** @type {number} */ node) => {
        let at = node;
        while (part.get(at) !== at) at = /** @type {number} */ (part.get(at));
        return at;
      };
      for (const { a, b } of arrangement.edges) part.set(rootOf(a), rootOf(b));
      const parts = [...nodes].filter((node) => part.get(node) === node).length;
      // of each part by itself V − E + F = 2, and each of its fields has one ring
      expect(nodes.size - arrangement.edges.length + rings.length).toBe(2 * parts);
      expect(rings.reduce((sum, ring) => sum + twice(arrangement, ring), 0)).toBeCloseTo(0, 9);
      expect(rings.filter((ring) => twice(arrangement, ring) < -1e-9)).toHaveLength(parts);
    });
    fc.assert(told, { seed: SEED, numRuns: runs(200) });
  });
});
