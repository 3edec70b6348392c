import fc from 'fast-check';
import { PerspectiveCamera, Vector3 } from 'three';
import { describe, expect, test } from 'vitest';
import { fitCamera } from '../../../src/render/fit.js';
import { gridSteps } from '../../../src/render/floor.js';
import { SEED, runs } from '../../helpers/property.js';

describe('the step of the grid', () => {
  test('is 1, 2 or 5 times a power of ten, and neither crowded nor empty, from a toy of 20 mm to a crane of 20 m', () => {
    const sizes = Array.from({ length: 400 }, (_, i) => 0.02 * 1000 ** (i / 399));
    for (const size of sizes) {
      const { minor, major } = gridSteps(size);
      expect(['1', '2', '5']).toContain(minor.toExponential().split('e')[0]);
      expect(size / minor).toBeGreaterThan(10);
      expect(size / minor).toBeLessThan(28);
      expect(Math.round(major / minor)).toBeGreaterThanOrEqual(4);
      expect(Math.abs(major / minor - Math.round(major / minor))).toBeLessThan(1e-9);
    }
  });
  test('is 100 mm for a Puma 560', () => expect(gridSteps(1.69)).toEqual({ minor: 0.1, major: 0.5 }));
});

test('a fitted camera sees all points within the part of the picture that they may fill, and touches its edge', () => {
  const coordinate = fc.double({ min: -5, max: 5, noNaN: true });
  fc.assert(
    fc.property(
      fc.array(fc.tuple(coordinate, coordinate, coordinate), { minLength: 1, maxLength: 20 }),
      fc.double({ min: -3, max: 3, noNaN: true }),
      fc.double({ min: -1.4, max: 1.4, noNaN: true }),
      fc.double({ min: 0.3, max: 3, noNaN: true }),
      (coordinates, azimuth, elevation, aspect) => {
        // corners of boxes, as those of parts are
        const points = coordinates.flatMap((xyz) =>
          Array.from({ length: 8 }, (_, i) => new Vector3(...xyz.map((x, k) => (i & (1 << k) ? x : x + 0.1)))),
        );
        const back = new Vector3(
          Math.cos(elevation) * Math.cos(azimuth),
          Math.cos(elevation) * Math.sin(azimuth),
          Math.sin(elevation),
        );
        const right = new Vector3(0, 0, 1).cross(back).normalize();
        const up = back.clone().cross(right);
        const half = Math.tan((12 * Math.PI) / 180);
        const { x, y, z } = fitCamera(points, { right, up, back }, { tanX: 0.8 * half * aspect, tanY: 0.65 * half });
        const camera = new PerspectiveCamera(24, aspect, 0.001, 1000);
        camera.up.set(0, 0, 1);
        camera.position.addScaledVector(right, x).addScaledVector(up, y).addScaledVector(back, z);
        camera.lookAt(camera.position.clone().sub(back));
        camera.updateMatrixWorld();
        const seen = points.map((point) => point.clone().project(camera));
        const [wide, high] = [seen.map((p) => Math.abs(p.x) / 0.8), seen.map((p) => Math.abs(p.y) / 0.65)];
        expect(Math.max(...wide, ...high)).toBeCloseTo(1, 6);
      },
    ),
    { seed: SEED, numRuns: runs(100) },
  );
});
