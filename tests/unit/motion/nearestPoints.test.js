/** Where bodies are nearest: on their surfaces, as far apart as is said. */
import fc from 'fast-check';
import { expect, test } from 'vitest';
import { createChain } from '../../../src/kinematics/chain.js';
import { linkFrames } from '../../../src/kinematics/forward.js';
import { armBodies } from '../../../src/motion/clearance/armBodies.js';
import { nearestPoints } from '../../../src/motion/clearance/nearestPoints.js';
import { clearance, createWorkcell, touches } from '../../../src/motion/clearance/workcell.js';
import { SEED, runs } from '../../helpers/property.js';

const THICK = 0.05;
const joint = { type: /** @type {const} */ ('revolute'), theta: 0, d: 0, a: 0.5, alpha: 0 };
const unlimited = { lower: -Infinity, upper: Infinity };
/** Three links of half a metre in the plane z = 0. */
const chain = createChain({
  convention: 'standard',
  joints: [joint, joint, joint].map((one) => ({ ...one, ...unlimited })),
});
const bodies = armBodies(chain, [THICK, THICK, THICK]);
const place = fc.double({ min: -1.4, max: 1.4, noNaN: true });
const angle = fc.double({ min: -3, max: 3, noNaN: true });

test('of a sphere: on the line from its middle to the arm, and as far apart as the clearance says', () => {
  fc.assert(
    fc.property(fc.tuple(angle, angle, angle), fc.tuple(place, place, place), (q, centre) => {
      const cell = createWorkcell(bodies, [{ kind: 'sphere', centre, radius: 0.1 }], { looksAtItself: false });
      const near = clearance(cell, q);
      if (!near) throw new Error('A sphere is always somewhere.');
      const [ofArm, ofBall] = nearestPoints(cell, q, near);
      const gap = Math.hypot(...ofArm.map((value, k) => value - ofBall[k]));
      if (near.distance <= 0) {
        expect(gap).toBeLessThan(1e-9); // one point in both
        return;
      }
      expect(gap).toBeCloseTo(near.distance, 6);
      expect(Math.hypot(...ofBall.map((value, k) => value - centre[k]))).toBeCloseTo(0.1, 6);
      const frames = linkFrames(chain, q);
      const axis = (/** @type {number} */ k) => [...frames.subarray(16 * k + 12, 16 * k + 15)];
      // the surface is as thick as the link, from the nearest place of its axis
      const [a, b] = [axis(near.stretch), axis(near.stretch + 1)];
      const along = Array.from({ length: 2001 }, (_, i) => a.map((value, k) => value + (i / 2000) * (b[k] - value)));
      const least = Math.min(...along.map((at) => Math.hypot(...at.map((value, k) => value - ofArm[k]))));
      expect(least).toBeCloseTo(THICK, 4);
    }),
    { seed: SEED, numRuns: runs(60) },
  );
});

test('of two links: on both surfaces; where they overlap, one place; and all that touches is told', () => {
  const cell = createWorkcell(bodies, []);
  const bent = [0, Math.PI / 2, Math.PI / 2]; // the third comes back over the first, half a metre above it
  const near = clearance(cell, bent);
  if (!near) throw new Error('The first and the third link could touch.');
  const [one, other] = nearestPoints(cell, bent, near);
  expect([one[1], other[1]].map((value) => Number(value.toFixed(9)))).toEqual([THICK, 0.5 - THICK]);
  expect(touches(cell, bent)).toEqual([]);
  const folded = [0, 3, 3]; // and here right across it
  const over = clearance(cell, folded);
  if (!over) throw new Error('As above.');
  expect(over.distance).toBeLessThan(0);
  const [a, b] = nearestPoints(cell, folded, over);
  expect(a).toEqual(b);
  expect(touches(cell, folded).map(({ stretch, other: with_ }) => [stretch, with_])).toEqual([[0, 2]]);
  const places = [
    [0.2, 0, 0],
    [0.3, 0, 0.1],
    [3, 0, 0],
  ]; // the second less deep than the first
  const balls = places.map((centre) => ({ kind: /** @type {const} */ ('sphere'), centre, radius: 0.1 }));
  expect(touches(createWorkcell(bodies, balls), [0, 0, 0]).map(({ obstacle }) => obstacle)).toEqual([0, 1]);
});
