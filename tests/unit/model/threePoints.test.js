import fc from 'fast-check';
import { expect, test } from 'vitest';
import { compilePose } from '../../../src/model/compile.js';
import { frameFromPoints } from '../../../src/model/frames/threePoints.js';
import { SEED, runs } from '../../helpers/property.js';

/** @param {ArrayLike<number>} a @param {ArrayLike<number>} b */
const farthest = (a, b) => Math.max(...Array.from(a, (value, i) => Math.abs(value - b[i])));

test('three points make the frame that they were taken from', () => {
  fc.assert(
    fc.property(
      fc.tuple(...Array.from({ length: 6 }, () => fc.integer({ min: -170, max: 170 }))),
      fc.integer({ min: 1, max: 500 }),
      fc.integer({ min: -300, max: 300 }),
      fc.integer({ min: 20, max: 400 }),
      ([x, y, z, w, p, r], length, along, aside) => {
        fc.pre(aside > Math.abs(along) / 20);
        const T = compilePose({ xyz: [x, y, z], rpy: [w, p, r] }, { length: 'mm', angle: 'deg' });
        const point = (/** @type {number} */ u, /** @type {number} */ v) =>
          [0, 1, 2].map((k) => T[12 + k] + (T[k] * u + T[4 + k] * v) / 1000);
        const found = frameFromPoints([point(0, 0), point(length, 0), point(along, aside)]);
        expect('T_world_frame' in found && farthest(found.T_world_frame, T)).toBeLessThan(1e-9);
      },
    ),
    { seed: SEED, numRuns: runs(100) },
  );
  const at = (/** @type {number} */ x, /** @type {number} */ y) => [x, y, 0];
  expect(frameFromPoints([at(0, 0), at(0, 0), at(1, 1)])).toEqual({ fault: 'together' });
  expect(frameFromPoints([at(0, 0), at(1, 0), at(0, 0)])).toEqual({ fault: 'together' });
  expect(frameFromPoints([at(0, 0), at(1, 0), at(-2, 0)])).toEqual({ fault: 'inLine' });
  expect(frameFromPoints([at(0, 0), at(1, 0), at(2, 0.01)])).toEqual({ fault: 'inLine' });
});
