/** What a map is asked for, how far it is, and what is drawn of it. */
import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { compileRobot } from '../../../src/model/compile.js';
import { newDocument } from '../../../src/model/newDocument.js';
import { reduce, startState } from '../../../src/model/session.js';
import {
  isInside,
  moveWindow,
  ticksWithin,
  windowAround,
  zoomWindow,
} from '../../../src/model/workspace/drawingWindow.js';
import {
  cellSize,
  cubeSize,
  leastCell,
  sectionQuestion,
  volumeQuestion,
} from '../../../src/model/workspace/mapQuestions.js';
import { createProgress } from '../../../src/model/workspace/progress.js';
import { cubeOf, reachValues } from '../../../src/model/workspace/reachValues.js';
import { holesOf, stripesOf, thinned, withHoles } from '../../../src/model/workspace/sectionShape.js';
import { FIRST_WORKSPACE } from '../../../src/model/workspace/workspaceView.js';
import { firstRobot } from '../../../src/model/shelf.js';
import { atOnce } from '../../../src/workspace/steps.js';
import { summarising } from '../../../src/workspace/summary.js';
import { SEED, runs } from '../../helpers/property.js';

const asking = (/** @type {object} */ change = {}, tab = 'workspace') =>
  reduce(startState(newDocument(firstRobot)), {
    type: 'show',
    change: {
      tab: /** @type {'workspace'} */ (tab),
      workspace: { ...FIRST_WORKSPACE, open: ['volume', 'section'], ...change },
    },
  });
const chainOf = (/** @type {ReturnType<typeof asking>} */ { doc }) => compileRobot(doc.robot);

describe('what is asked', () => {
  test('nothing before somebody asks, nor of a fold that is closed, nor where nobody sees it', () => {
    const fresh = startState(newDocument(firstRobot));
    expect(volumeQuestion(fresh, chainOf(fresh))).toBeNull();
    for (const [change, tab] of /** @type {const} */ ([
      [{ open: [] }, 'workspace'],
      [{ hasVolume: false, hasSection: false }, 'robot'],
    ])) {
      // prettier-ignore
      const state = asking(change, tab);
      expect(volumeQuestion(state, chainOf(state))).toBeNull();
      expect(sectionQuestion(state, chainOf(state))).toBeNull();
    }
    const behind = asking({}, 'robot');
    expect(volumeQuestion(behind, chainOf(behind))).not.toBeNull(); // it is in the scene
  });

  test('how a map looks is no other question; the table, limits, cubes, the seed and the tool are', () => {
    const keyOf = (/** @type {ReturnType<typeof asking>} */ state) => volumeQuestion(state, chainOf(state))?.volume.key;
    const key = keyOf(asking());
    for (const same of [
      { colour: 'margin' },
      { opacity: 0.2 },
      { style: 'points' },
      { cell: 0.001 },
      { hasVolume: false },
    ])
      expect(keyOf(asking(same))).toBe(key);
    const others = [
      { withLimits: false },
      { detail: 'fine' },
      { seed: 2 },
      { tool: 'fixed' },
      { tool: 'cone' },
      { colour: 'directions' },
    ]; // which take more postures
    const keys = others.map((change) => keyOf(asking(change)));
    expect(new Set([key, ...keys]).size).toBe(1 + others.length);
    const longer = reduce(asking(), { type: 'set-joint-field', joint: 1, field: 'a', value: 500 });
    expect(keyOf(longer)).not.toBe(key);
    const named = reduce(asking(), { type: 'rename-robot', name: 'Other' });
    expect(keyOf(named)).toBe(key);
    const moved = reduce(asking(), { type: 'set-joint-value', joint: 0, value: 30 });
    expect(keyOf(moved)).toBe(key);
  });

  test('a plane is spanned by unit vectors that look along its normal', () => {
    const axis = fc.double({ min: -3, max: 3, noNaN: true });
    fc.assert(
      fc.property(
        fc.tuple(axis, axis, axis).filter((n) => Math.hypot(...n) > 0.01),
        axis,
        (normal, offset) => {
          const state = asking({ cut: 'plane', normal, offset });
          const { cut } = /** @type {{ cut: { origin: number[], u: number[], v: number[] } }} */ ((sectionQuestion(state, chainOf(state)) ?? { options: {} }).options); // prettier-ignore
          const { origin, u, v } = cut;
          const size = Math.hypot(...normal);
          const dot = (/** @type {number[]} */ a, /** @type {number[]} */ b) =>
            a.reduce((sum, value, i) => sum + value * b[i], 0);
          expect(Math.hypot(...u)).toBeCloseTo(1, 9);
          expect(Math.hypot(...v)).toBeCloseTo(1, 9);
          expect(dot(u, v)).toBeCloseTo(0, 9);
          expect((u[0] * v[1] - u[1] * v[0]) * size).toBeCloseTo(normal[2], 9);
          expect(dot(u, normal)).toBeCloseTo(0, 9);
          expect(dot(origin, normal) / size).toBeCloseTo(offset, 9);
        },
      ),
      { seed: SEED, numRuns: runs(50) },
    );
  });

  test('cubes and cells have round edges that fit the arm', () => {
    const chain = compileRobot(firstRobot);
    expect([cubeSize(chain, 'coarse'), cubeSize(chain, 'usual'), cubeSize(chain, 'fine')]).toEqual([0.05, 0.02, 0.01]);
    expect(cellSize(chain, { cell: null })).toBe(0.005);
    expect(cellSize(chain, { cell: 1e-5 })).toBe(leastCell(chain));
    expect(leastCell(chain)).toBeLessThanOrEqual(0.0005);
  });
});

describe('how far it is', () => {
  test('it never goes back, ends at all of it, and learns what takes long', () => {
    const progress = createProgress({ a: 1, b: 1 });
    progress.begin(10);
    expect(progress.at('a', 0.5, 10.1)).toEqual({ share: 0.25, secondsLeft: null }); // too early to tell
    const { share, secondsLeft } = progress.at('a', 1, 11);
    expect(share).toBe(0.5);
    expect(secondsLeft).toBeCloseTo(1, 9);
    expect(progress.at('b', 0.5, 14).share).toBe(0.75);
    expect(progress.at('b', 0.1, 15).share).toBe(0.75);
    expect(progress.at('who knows', 1, 16).share).toBe(0.75);
    progress.end(20);
    progress.begin(0);
    expect(progress.at('a', 1, 1).share).toBeCloseTo(0.1, 9); // one second of ten
  });
});

/** Four cubes in a row, the second not reached. */
const CUBES = {
  ...{ size: 0.5, corner: /** @type {[number, number, number]} */ ([0, 0, 1]), counts: /** @type {[number, number, number]} */ ([4, 1, 1]) },
  ...{ reached: Uint8Array.of(1, 0, 1, 1), manipulability: Float32Array.of(0.1, 9, 0.2, 0.4) },
  ...{ margin: Float32Array.of(0, 1, 0.5, 1), directions: Float32Array.of(0, 1, 0.5, 1), postures: Uint8Array.of(2, 9, 4, 4) },
  ...{ joints: 3, freedoms: 3, isMiddle: true, volume: 0, volumeError: 0 },
}; // prettier-ignore

describe('the volume in numbers', () => {
  const summaryOf = (/** @type {typeof CUBES | (Omit<typeof CUBES, 'postures'> & { postures: null })} */ cubes) =>
    atOnce(summarising(cubes));
  const summary = summaryOf(CUBES);
  if (!summary) throw new Error('Three cubes are reached.');

  test('only what is reached counts, on a scale that says what it is of', () => {
    const { scales, ...rest } = summary;
    expect(rest).toMatchObject({ count: 3, low: [0, 0, 1], high: [2, 0.5, 1.5] });
    expect(scales.postures).toEqual({ least: 2, most: 4, isCount: true, shares: [1 / 3, 0, 2 / 3] });
    expect(scales.manipulability).toMatchObject({ least: 0, most: Math.fround(0.4) });
    expect(scales.margin).toEqual({ least: 0, most: 1, isCount: false, shares: [1 / 3, 0, 1 / 3, 1 / 3] });
    expect(scales.height).toEqual({ least: 1.25, most: 1.25, isCount: false, shares: [1] });
    expect(summaryOf({ ...CUBES, postures: null })?.scales.postures).toBeNull();
    expect(summaryOf({ ...CUBES, reached: new Uint8Array(4) })).toBeNull();
  });

  test('a cube has its value, and a place its cube', () => {
    expect(reachValues(CUBES, summary, 'postures')?.of(2)).toBe(4);
    expect(reachValues(CUBES, summary, 'height')?.of(3)).toBe(1.25);
    const without = { ...summary, scales: { ...summary.scales, postures: null } };
    expect(reachValues({ ...CUBES, postures: null }, without, 'postures')).toBeNull();
    expect([cubeOf(CUBES, 1.1, 0.2, 1.3), cubeOf(CUBES, 2.1, 0.2, 1.3), cubeOf(CUBES, NaN, 0, 1)]).toEqual([2, -1, -1]);
  });

  test('a layer of cubes has an area, its edge the error', () => {
    const side = 6;
    const isIn = (/** @type {number} */ k) => k % side > 0 && k % side < 5 && k >= side && k < 5 * side;
    const reached = Uint8Array.from({ length: side * side }, (_, k) => Number(isIn(k)));
    const values = new Float32Array(side * side);
    const layer = {
      ...{ ...CUBES, counts: /** @type {[number, number, number]} */ ([side, side, 1]), reached, size: 1 },
      ...{ manipulability: values, margin: values, directions: values, postures: null },
    };
    expect(summaryOf(layer)?.layer).toEqual({ across: 2, area: 16, areaError: 6 }); // 12 of 16 are at the edge
    expect(summaryOf({ ...layer, isMiddle: false })?.layer?.area).toBe(10);
  });
});

const square = (/** @type {number} */ middle, /** @type {number} */ half, /** @type {number} */ turn = 1) => {
  const points = [[-half, -half], [half, -half], [half, half], [-half, half]].map(([u, v]) => [middle + u, v]); // prettier-ignore
  const ring = turn > 0 ? points : points.reverse();
  return { places: Float64Array.from(ring.flat()), points: ring.flat(), area: turn * (2 * half) ** 2 };
};

describe('the section as a drawing', () => {
  test('stripes cover what is reached, and nothing else', () => {
    const cells = { size: 0.5, columns: 4, rows: 2, u: -1, v: 3, reached: Uint8Array.of(1, 0, 1, 1, 0, 0, 0, 1) };
    expect(stripesOf(cells)).toEqual([-1, -0.5, 3, 3.5, 0, 1, 3, 3.5, 0.5, 1, 3.5, 4]);
    expect(stripesOf(cells, 1)).toEqual([0.5, 1, 3, 4]); // one row stands for two
  });

  test('holes belong to what is around them, islands in holes are regions by themselves', () => {
    const [outer, hole, island, other] = [square(0, 4), square(0, 3, -1), square(0, 1), square(10, 1)];
    const pit = square(0, 0.5, -1);
    const regions = withHoles([hole, outer, pit, island, other]);
    const holesIn = (/** @type {number[]} */ points) => regions.find((region) => region.outer === points)?.holes;
    expect(holesIn(outer.points)).toEqual([hole.points]);
    expect(holesIn(island.points)).toEqual([pit.points]);
    expect(holesIn(other.points)).toEqual([]);
    const section = { cells: { size: 1, columns: 0, rows: 0, u: 0, v: 0, reached: new Uint8Array(0) }, outlines: [outer, hole, island] }; // prettier-ignore
    const at = (/** @type {number} */ u) => isInside({ kind: 'flat', isAnyAngle: false, frame: { origin: [], u: [], v: [] }, ...section }, u, 0.1); // prettier-ignore
    expect([0, 2, 3.5, 5].map(at)).toEqual([true, false, true, false]);
    expect(holesOf(section)).toEqual([{ area: 36, u: [-3, 3], v: [-3, 3] }]);
  });

  test('what is left out of an outline cannot be seen', () => {
    const circle = Float64Array.from({ length: 2000 }, (_, k) =>
      [Math.cos, Math.sin][k % 2]((Math.PI * (k >> 1)) / 500),
    );
    const few = thinned(circle, 0.05);
    expect(few.length).toBeLessThan(400);
    for (let k = 0; k < circle.length; k += 2) {
      const nearest = Math.min(...Array.from({ length: few.length / 2 }, (_, i) => Math.hypot(few[2 * i] - circle[k], few[2 * i + 1] - circle[k + 1]))); // prettier-ignore
      expect(nearest).toBeLessThan(0.05 * Math.SQRT2);
    }
  });

  test('zooming keeps what is under the pointer there, and moving takes it along', () => {
    const size = { width: 300, height: 200 };
    const pixel = (/** @type {{ u: number, v: number, scale: number }} */ { u, scale }, /** @type {number} */ at) =>
      (at - u) * scale;
    const place = fc.double({ min: -5, max: 5, noNaN: true });
    fc.assert(
      fc.property(place, place, fc.double({ min: 0.2, max: 5, noNaN: true }), (u, v, factor) => {
        const window = windowAround({ u: [-1, 2], v: [0, 1] }, size);
        expect(Math.abs(pixel(window, 2))).toBeLessThanOrEqual(size.width / 2);
        const zoomed = zoomWindow(window, factor, { u, v });
        expect(pixel(zoomed, u)).toBeCloseTo(pixel(window, u), 6);
        const moved = moveWindow(window, { u, v }, { u: u + 1, v });
        expect(pixel(moved, u + 1)).toBeCloseTo(pixel(window, u) + 2 * window.scale, 6);
      }),
      { seed: SEED, numRuns: runs(50) },
    );
    expect(ticksWithin(0, 10, 2)).toEqual([-4, -2, 0, 2, 4]);
    expect(ticksWithin(0.1, 0.1, 1)).toEqual([]);
  });
});
