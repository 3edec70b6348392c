import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { bar, beam, cone, drum, solidOf, stub } from '../../../src/render/arm/solid.js';
import { SEED, runs } from '../../helpers/property.js';

/** @import { Shape, Solid } from '../../../src/render/arm/solid.js' */

const size = fc.double({ min: 0.01, max: 2, noNaN: true });
const place = fc.double({ min: -2, max: 2, noNaN: true });

/** @type {fc.Arbitrary<Shape>} */
const anyShape = fc.oneof(
  fc.tuple(size, place, size).map(([r, from, height]) => drum(r, from, from + height)),
  fc.tuple(size, place, size).map(([r, from, height]) => drum(r, from, from - height)),
  fc.tuple(size, size, place, size).map(([r, end, from, height]) => cone(r, end, from, from + height)),
  fc.tuple(size, size, place, size).map(([r, end, from, height]) => cone(r, end, from, from - height)),
  fc.tuple(place, size, size, size).map(([length, r, end, thickness]) => beam(length, r, end, thickness)),
  fc.tuple(place, size, size, size).map(([length, r, end, thickness]) => stub(length, r, Math.min(r, end), thickness)),
  fc.tuple(size, size, place, size).map(([x, y, from, height]) => bar(x, y, from, from + height)),
);

/** @param {Solid} solid @param {number} i */
const corner = ({ positions }, i) => positions.slice(3 * i, 3 * i + 3);

/** By the divergence theorem: positive if the triangles look outwards. @param {Solid} solid */
function volumeOf(solid) {
  let volume = 0;
  for (let i = 0; i < solid.indices.length; i += 3) {
    const [[ax, ay, az], [bx, by, bz], [cx, cy, cz]] = [0, 1, 2].map((k) => corner(solid, solid.indices[i + k]));
    volume += (ax * (by * cz - bz * cy) - ay * (bx * cz - bz * cx) + az * (bx * cy - by * cx)) / 6;
  }
  return volume;
}

describe('every solid', () => {
  test('is closed: each side of a triangle is the side of one other, the other way round', () =>
    fc.assert(
      fc.property(anyShape, (shape) => {
        const solid = solidOf(shape);
        /** @type {Map<string, number>} */
        const sides = new Map();
        const name = (/** @type {number} */ i) =>
          corner(solid, i)
            .map((x) => (Math.round(x * 1e9) + 0).toString())
            .join();
        for (let i = 0; i < solid.indices.length; i += 3) {
          const names = [0, 1, 2].map((k) => name(solid.indices[i + k]));
          if (new Set(names).size < 3) continue; // nothing of it is left at a tip
          names.forEach((from, k) => {
            const to = names[(k + 1) % 3];
            sides.set(`${from} ${to}`, (sides.get(`${from} ${to}`) ?? 0) + 1);
          });
        }
        const open = [...sides].filter(([side, count]) => sides.get(side.split(' ').reverse().join(' ')) !== count);
        expect(open).toEqual([]);
      }),
      { seed: SEED, numRuns: runs(60) },
    ));

  test('has finite corners, and unit normals on the side that its triangles look to', () =>
    fc.assert(
      fc.property(anyShape, (shape) => {
        const solid = solidOf(shape);
        expect([...solid.positions, ...solid.normals, ...solid.edges].every(Number.isFinite)).toBe(true);
        let [leastCosine, worstLength] = [Infinity, 0];
        for (let i = 0; i < solid.indices.length; i += 3) {
          const [a, b, c] = [0, 1, 2].map((k) => corner(solid, solid.indices[i + k]));
          const [u, v] = [b, c].map((p) => p.map((x, k) => x - a[k]));
          const face = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
          if (Math.hypot(...face) < 1e-9) continue;
          for (const k of [0, 1, 2]) {
            const normal = solid.normals.slice(3 * solid.indices[i + k], 3 * solid.indices[i + k] + 3);
            worstLength = Math.max(worstLength, Math.abs(Math.hypot(...normal) - 1));
            leastCosine = Math.min(leastCosine, normal[0] * face[0] + normal[1] * face[1] + normal[2] * face[2]);
          }
        }
        expect(worstLength).toBeLessThan(1e-12);
        expect(leastCosine).toBeGreaterThan(0);
      }),
      { seed: SEED, numRuns: runs(60) },
    ));

  test('has its edges on its surface', () =>
    fc.assert(
      fc.property(anyShape, (shape) => {
        const { positions, edges } = solidOf(shape);
        const corners = new Set(
          Array.from({ length: positions.length / 3 }, (_, i) => positions.slice(3 * i, 3 * i + 3).join()),
        );
        const ends = Array.from({ length: edges.length / 3 }, (_, i) => edges.slice(3 * i, 3 * i + 3).join());
        expect(ends.filter((end) => !corners.has(end))).toEqual([]);
      }),
      { seed: SEED, numRuns: runs(30) },
    ));
});

test('a drum, a cone, a bar and a beam have the volumes of their formulas, chamfers and sides aside', () => {
  expect(volumeOf(solidOf(drum(1, -1, 1, 0.001)))).toBeCloseTo(2 * Math.PI, 1);
  expect(volumeOf(solidOf(cone(1, 0, 0, 3)))).toBeCloseTo(Math.PI, 1);
  expect(volumeOf(solidOf(bar(1, 2, 0, 3)))).toBeCloseTo(24, 0);
  // two half discs and the rectangle between them
  expect(volumeOf(solidOf(beam(3, 0.5, 0.5, 1)))).toBeCloseTo(3 + Math.PI / 4, 1);
});

test('a beam of negative length is the mirror image of one of positive length', () => {
  expect(volumeOf(solidOf(beam(-3, 1, 0.5, 1)))).toBeCloseTo(volumeOf(solidOf(beam(3, 1, 0.5, 1))), 9);
});

test('the rims of a drum are drawn as edges, and so are the four uprights of a bar', () => {
  const upright = (/** @type {number[]} */ edges) => {
    let count = 0;
    for (let i = 0; i < edges.length; i += 6) {
      if (edges[i] === edges[i + 3] && edges[i + 1] === edges[i + 4]) count++;
    }
    return count;
  };
  expect(upright(solidOf(drum(1, 0, 1)).edges)).toBe(0);
  expect(solidOf(drum(1, 0, 1)).edges.length / 6).toBe(4 * 48); // two at each end, on both sides of the chamfer
  expect(upright(solidOf(bar(1, 1, 0, 1)).edges)).toBe(4);
});
