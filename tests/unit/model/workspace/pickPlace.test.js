/** Where a press in the scene puts a point: on what is seen there, or nowhere. */
import fc from 'fast-check';
import { expect, test } from 'vitest';
import { along, dot, minus, unit } from '../../../../src/kinematics/lines.js';
import { NO_MAPS } from '../../../../src/model/workspace/mapped.js';
import { firstCube, pickGrounds, placeUnder } from '../../../../src/model/workspace/pickPlace.js';
import { cubeOf } from '../../../../src/model/workspace/reachValues.js';
import { FIRST_WORKSPACE } from '../../../../src/model/workspace/workspaceView.js';
import { SEED, runs } from '../../../helpers/property.js';

/** @import { Cubes, SectionMap, VolumeMap } from '../../../../src/model/workspace/mapped.js' */

const counts = /** @type {const} */ ([5, 4, 3]);
/** @param {readonly number[]} reached */
const cubesWith = (reached) => {
  const cubes = { size: 0.5, corner: /** @type {const} */ ([-1, 2, -0.3]), counts, reached: new Uint8Array(60) };
  for (const cube of reached) cubes.reached[cube] = 1;
  return /** @type {Cubes} */ (/** @type {unknown} */ (cubes));
};
/** Not on the faces of the cubes, where either neighbour is as good. @param {number} min @param {number} max */
const between = (min, max) => fc.nat(999).map((k) => min + ((max - min) * (k + 0.37)) / 1000);
const anywhere = fc.tuple(between(-6, 6), between(-6, 6), between(-6, 6));
const within = fc.tuple(between(-1, 1.5), between(2, 4), between(-0.3, 1.2));

test('the cube that is picked is the first that small steps along the line of sight come to', () => {
  fc.assert(
    fc.property(fc.uniqueArray(fc.nat(59), { maxLength: 30 }), anywhere, within, (reached, from, to) => {
      fc.pre(Math.hypot(...minus(to, from)) > 0.1);
      const cubes = cubesWith(reached);
      const ray = { from, along: unit(minus(to, from)) };
      const found = firstCube(cubes, ray);
      const steps = Array.from({ length: 6000 }, (_, k) => cubeOf(cubes, ...along(from, k * 0.004, ray.along)));
      const expected = steps.filter((cube) => cube >= 0 && cubes.reached[cube])[0];
      const cube = found ? cubeOf(cubes, found[0], found[1], found[2]) : -1;
      if (expected === undefined || expected === cube) return; // steps go past a corner that the line just meets
      expect(steps.filter((at) => at === cube).length).toBeLessThan(2);
      expect(cubes.reached[cube]).toBe(1);
    }),
    { seed: SEED, numRuns: runs(40) },
  );
});

test('a line of sight along an axis meets the row it is in, and none beside it', () => {
  const cubes = cubesWith([59]);
  expect(firstCube(cubes, { from: [9, 3.8, 1], along: [-1, 0, 0] })).toEqual([1.25, 3.75, 0.95]);
  expect(firstCube(cubes, { from: [9, 3.2, 1], along: [-1, 0, 0] })).toBe(null);
  expect(firstCube(cubes, { from: [9, 3.8, 1], along: [1, 0, 0] })).toBe(null);
});

test('on a plane: in it, and on the line of sight; not behind the eye, nor where it is seen from its edge', () => {
  const frame = { origin: [0.1, 0.2, 0.3], u: [1, 0, 0], v: [0, 0, 1] };
  const section = /** @type {SectionMap} */ (/** @type {unknown} */ ({ section: null, first: { frame } }));
  const maps = { ...NO_MAPS, section };
  const tool = { at: [0, 0, 0], towards: [0, 0, 1] };
  const at = placeUnder({ from: [2, -3, 1], along: unit([-1, 2, 1]) }, 'section', maps, tool);
  expect(dot(minus(at ?? [], frame.origin), [0, 1, 0])).toBeCloseTo(0, 12);
  expect(at).toEqual([0.4, 0.2, 2.6].map((value) => expect.closeTo(value, 12)));
  expect(placeUnder({ from: [2, -3, 1], along: [0, -1, 0] }, 'section', maps, tool)).toBe(null);
  expect(placeUnder({ from: [2, -3, 1], along: [1, 0, 0] }, 'section', maps, tool)).toBe(null);
  expect(placeUnder({ from: [1, 1, 4], along: [0, 0, -1] }, 'tool', NO_MAPS, tool)).toEqual([1, 1, 0]);
});

test('what is shown comes first; with neither, the plane through the tool point', () => {
  const section = /** @type {SectionMap} */ ({ isStale: false, why: null, section: null, first: { kind: 'plane' } });
  const volume = /** @type {VolumeMap} */ ({ isStale: false, cubes: cubesWith([]) });
  const workspace = { ...FIRST_WORKSPACE, open: ['volume', 'points'] };
  expect(pickGrounds({ maps: NO_MAPS, workspace })).toEqual(['tool']);
  expect(pickGrounds({ maps: { volume, section }, workspace })).toEqual(['volume', 'section']);
  expect(pickGrounds({ maps: { volume, section }, workspace: { ...workspace, open: ['volume', 'section'] } })).toEqual([
    'section',
    'volume',
  ]);
  expect(pickGrounds({ maps: { volume, section }, workspace: { ...workspace, hasVolume: false } })).toEqual([
    'section',
  ]);
});
