/** Voxels against closed forms, their surface, and what is told of them. */
import { describe, expect, test } from 'vitest';
import { createChain } from '../../../src/kinematics/chain.js';
import { facingOf, shareOfFacings } from '../../../src/workspace/facings.js';
import { atOnce } from '../../../src/workspace/steps.js';
import { summarising } from '../../../src/workspace/summary.js';
import { mapVolume } from '../../../src/workspace/volume.js';
import { cubeAt, emptyVoxels, measuring, middleOf } from '../../../src/workspace/voxels.js';
import { surfacing } from '../../../src/workspace/voxelSurface.js';
import { publishedArm } from '../kinematics/publishedArms.js';
import { anthropomorphic, armOf, cartesian, planar, scara, sliding, turning } from './arms.js';

/** @import { ChainDescription } from '../../../src/kinematics/chain.js' */
/** @import { VolumeOptions } from '../../../src/workspace/volume.js' */
/** @import { VoxelSurface } from '../../../src/workspace/voxelSurface.js' */

/** @param {ChainDescription} arm @param {VolumeOptions} options */
function volumeOf(arm, options) {
  const work = mapVolume(createChain(arm), options);
  const first = work.next();
  let step = first;
  while (!step.done) step = work.next();
  return { voxels: step.value, first: first.done ? null : first.value };
}

/** Twice the signed volume that the triangles enclose, sixfold, by the divergence theorem. @param {VoxelSurface} surface */
function enclosedBy({ corners, triangles }) {
  let sum = 0;
  for (let i = 0; i < triangles.length; i += 3) {
    const [a, b, c] = [0, 1, 2].map((k) =>
      Array.from(corners.subarray(3 * triangles[i + k], 3 * triangles[i + k] + 3)),
    );
    sum += a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
  }
  return sum / 6;
}

describe('the volume of', () => {
  test('a shell: the middles of its cubes are inside, its surface is closed, and its four postures are counted', () => {
    const { voxels, first } = volumeOf(anthropomorphic(0.4, 0.3), { cell: 0.07 });
    expect(first?.voxels?.reached.some((value) => value === 1)).toBe(true);
    expect(voxels.isMiddle).toBe(true);
    for (let k = 0; k < voxels.reached.length; k++) {
      const r = Math.hypot(...middleOf(voxels, k));
      if (Math.abs(r - 0.7) > 1e-9 && Math.abs(r - 0.1) > 1e-9)
        expect(voxels.reached[k]).toBe(Number(r < 0.7 && r > 0.1));
      if (voxels.reached[k] && Math.abs(middleOf(voxels, k)[0]) > 1e-9) expect(voxels.postures?.[k]).toBe(4);
    }
    expect(Math.abs(voxels.volume - 1.4325662500369452)).toBeLessThan(voxels.volumeError);
    expect(enclosedBy(atOnce(surfacing(voxels)))).toBeCloseTo(voxels.volume, 5);
  });

  test('a box and a SCARA arm', () => {
    const box = volumeOf(cartesian([-0.2, 0.5], [0.1, 0.7], [0, 0.4]), { cell: 0.05 }).voxels;
    expect(Math.abs(box.volume - 0.7 * 0.6 * 0.4)).toBeLessThan(box.volumeError);
    const { voxels } = volumeOf(scara(0.4, 0.3, 0.2), { cell: 0.05 });
    expect(Math.abs(voxels.volume - 0.3015928947446201)).toBeLessThan(voxels.volumeError);
    expect(Math.max(...voxels.manipulability)).toBeLessThanOrEqual(0.4 * 0.3 + 1e-9); // l₁ l₂ |sin q₂|
    expect(Math.max(...voxels.manipulability)).toBeGreaterThan(0.9 * 0.4 * 0.3);
  });

  test('an arm for one orientation is inside of that for any, and a cone lies between', () => {
    const T = [1, 0, 0, 0, 0, -1, 0, 0, 0, 0, -1, 0, 0, 0, 0, 1];
    const arm = publishedArm('kuka_kr6_r900');
    const count = (/** @type {VolumeOptions['wanted']} */ wanted) =>
      volumeOf(arm, { cell: 0.4, wanted }).voxels.reached.reduce((sum, value) => sum + value, 0);
    const [any, cone, fixed] = [
      count({ kind: 'any' }),
      count({ kind: 'cone', T, halfAngle: 0.6 }),
      count({ kind: 'fixed', T }),
    ];
    expect(fixed).toBeGreaterThan(0);
    expect(cone).toBeGreaterThanOrEqual(fixed);
    expect(any).toBeGreaterThan(cone);
  });

  test('is the same for the same seed', () => {
    const ask = () => volumeOf(publishedArm('ur5'), { cell: 0.4, seed: 5 }).voxels;
    expect(ask()).toEqual(ask());
  });
});

test('many cubes are counted, drawn and summed up in steps, so that work can be stopped', () => {
  const voxels = emptyVoxels({ low: [0, 0, 0], high: [1, 1, 0.3] }, 0.01, { joints: 3, freedoms: 3 });
  expect(voxels.reached.length).toBeGreaterThan(3e5);
  for (const work of [measuring(voxels), surfacing(voxels), summarising(voxels)]) {
    voxels.reached[0] = 1;
    expect(work.next().done).toBe(false);
  }
});

test('what lies in one plane is in the middle of its cubes', () => {
  const { voxels } = volumeOf(planar([0.5, 0.3]), { cell: 0.1 });
  expect(voxels.counts[2]).toBe(1);
  expect(middleOf(voxels, 0)[2]).toBe(0);
});

test('a curve is where it is, and its area may be none: of an arm without a link, with a joint held, of slides in line', () => {
  const slide = sliding([0, 0, 0, 0], [0, 0.2]);
  for (const arm of [planar([0, 0.3]), planar([0.5, 0.3], [[], [0.3, 0.3]]), armOf(slide, slide)]) {
    const summary = atOnce(summarising(volumeOf(arm, { cell: 0.1 }).voxels));
    expect(summary?.count).toBeGreaterThan(0);
    expect(summary?.layer?.area).toBeLessThanOrEqual(summary?.layer?.areaError ?? 0);
  }
});

test('what the tool point draws in general: a volume, a surface or a curve, whatever the cubes make of it', () => {
  const freedoms = (/** @type {ChainDescription} */ arm) => volumeOf(arm, { cell: 0.4 }).voxels.freedoms;
  const wrist = armOf(turning([0, -Math.PI / 2, 0, 0]), turning([0, Math.PI / 2, 0, 0]), turning([0, 0, 0.5, 0]));
  expect([planar([0.5]), planar([0.5, 0.3]), wrist, anthropomorphic(0.5, 0.3)].map(freedoms)).toEqual([1, 2, 2, 3]);
});

test('a cube is found again by its middle', () => {
  const { voxels } = volumeOf(cartesian([0, 1], [0, 1], [0, 0.4]), { cell: 0.2 });
  for (let k = 0; k < voxels.reached.length; k++) expect(cubeAt(voxels, ...middleOf(voxels, k))).toBe(k);
  expect(cubeAt(voxels, 9, 0, 0)).toBe(-1);
});

test('directions: opposite ones differ, all 54 squares are met, and a full set is everything', () => {
  const set = new Uint32Array(2);
  const seen = new Set();
  for (let k = 0; k < 4000; k++) {
    const z = 1 - (2 * (k + 0.5)) / 4000;
    const r = Math.sqrt(1 - z * z);
    const axis = [r * Math.cos(2.4 * k), r * Math.sin(2.4 * k), z];
    const facing = facingOf(axis);
    expect(facingOf(axis.map((value) => -value))).not.toBe(facing);
    seen.add(facing);
    set[facing >> 5] |= 1 << (facing & 31);
  }
  expect(seen.size).toBe(54);
  expect(shareOfFacings(set, 0)).toBe(1);
});
