import fc from 'fast-check';
import { expect, test } from 'vitest';
import { inside, overlap, roomFor, withinPicture } from '../../../src/render/labelRoom.js';
import { SEED, runs } from '../../helpers/property.js';

const within = (/** @type {number} */ least, /** @type {number} */ most) =>
  fc.double({ min: least, max: most, noNaN: true });
const anyLabel = fc
  .record({
    ...{ x: within(0, 600), y: within(0, 600), width: within(8, 60), height: within(8, 24) },
    ...{ angle: within(0, 6.3), gap: within(0, 10), yields: fc.boolean() },
  })
  .map(({ angle, ...label }) => ({ ...label, east: Math.cos(angle), south: Math.sin(angle) }));

/** @param {readonly { left: number, top: number, width: number, height: number }[]} boxes */
const covered = (boxes) =>
  boxes.reduce((sum, a, i) => sum + boxes.slice(i + 1).reduce((part, b) => part + overlap(a, b), 0), 0);

test('labels that may give way never cover more than where they wanted to stand, and the others do not move', () =>
  fc.assert(
    fc.property(fc.array(anyLabel, { maxLength: 20 }), (labels) => {
      const firm = roomFor(labels.map((label) => ({ ...label, yields: false })));
      const boxes = roomFor(labels);
      labels.forEach(({ yields }, i) => {
        if (!yields) expect(boxes[i]).toEqual(firm[i]);
        expect(Math.hypot(boxes[i].left - firm[i].left, boxes[i].top - firm[i].top)).toBeLessThan(130);
      });
      expect(covered(boxes)).toBeLessThanOrEqual(covered(firm) + 1e-9);
    }),
    { seed: SEED, numRuns: runs(100) },
  ));

test('three names at one tip are three names that can be read', () => {
  const tip = { x: 100, y: 100, east: 1, south: 0, gap: 4, width: 14, height: 16, yields: true };
  const boxes = roomFor([tip, tip, tip]);
  expect(covered(boxes)).toBe(0);
  expect(boxes[0]).toEqual({ left: 104, top: 92, width: 14, height: 16 });
});

test('words about a point without a direction are in its middle, and are kept inside the picture', () => {
  const [box] = roomFor([{ x: 2, y: 300, east: 0, south: 0, gap: 9, width: 80, height: 20, yields: false }]);
  expect(box).toEqual({ left: -38, top: 290, width: 80, height: 20 });
  expect(inside(box, 400, 300)).toEqual({ left: 6, top: 274, width: 80, height: 20 });
});

test('a line that leaves the picture ends at its edge, still on the line', () => {
  expect(withinPicture(100, 100, 300, 150, 400, 300)).toEqual([300, 150]);
  expect(withinPicture(100, 100, 700, 160, 400, 300)).toEqual([400, 130]);
  expect(withinPicture(100, 100, -100, 100, 400, 300)).toEqual([0, 100]);
  fc.assert(
    fc.property(within(1, 399), within(1, 299), within(-900, 900), within(-900, 900), (x0, y0, x, y) => {
      const [px, py] = withinPicture(x0, y0, x, y, 400, 300);
      expect(Math.abs((px - x0) * (y - y0) - (py - y0) * (x - x0))).toBeLessThan(1e-6);
      for (const [value, most] of [[px, 400], [py, 300]]) expect(value >= -1e-9 && value <= most + 1e-9).toBe(true); // prettier-ignore
    }),
    { seed: SEED, numRuns: runs(100) },
  );
});
