/** Files of a mapped workspace, read back by hand. */
import { describe, expect, test } from 'vitest';
import {
  cubesCsvParts,
  placesCsvParts,
  plyParts,
  stlParts,
  writeSectionCsv,
  writeSectionSvg,
} from '../../../src/io/workspaceFiles.js';

/** A tetrahedron, 1 m along each axis, seen from outside. */
const TETRAHEDRON = {
  corners: Float32Array.of(0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1),
  triangles: Uint32Array.of(0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3),
};

/** A square of 2 m with a hole of 1 m. */
const FRAME = [
  { places: [-1, -1, 1, -1, 1, 1, -1, 1], area: 4 },
  { places: [-0.5, -0.5, -0.5, 0.5, 0.5, 0.5, 0.5, -0.5], area: -1 },
];

describe('a workspace as a file', () => {
  test('CSV of places and of a section says its unit, and which outlines are holes', () => {
    expect([...placesCsvParts([Float32Array.of(0.1, -0.2, 0.3)], 100, 'cm')].join('')).toBe(
      'x [cm],y [cm],z [cm]\r\n10,-20,30\r\n',
    );
    const lines = writeSectionCsv(FRAME, 1, 'm').split('\r\n');
    expect(lines).toHaveLength(1 + 8 + 1);
    expect(lines[0]).toBe('outline,hole,u [m],v [m]');
    expect(lines[1]).toBe('1,no,-1,-1');
    expect(lines[5]).toBe('2,yes,-0.5,-0.5');
  });

  test('of a long list every place is written once, whatever the parts', () => {
    const lists = [25_000, 3].map((count, list) => Float32Array.from({ length: 3 * count }, (_, k) => list + k));
    const lines = [...placesCsvParts(lists, 1, 'm')].join('').split('\r\n');
    expect(lines).toHaveLength(1 + 25_003 + 1);
    expect(lines[25_000]).toBe('74997,74998,74999');
    expect(lines[25_001]).toBe('1,2,3');
    const ply = [...plyParts(lists, 1)].join('');
    expect(ply).toContain('element vertex 25003\n');
    expect(ply.split('end_header\n')[1].split('\n')).toHaveLength(25_003 + 1);
  });

  test('cubes are written by their middles, with what is known of each; only those that are reached', () => {
    const values = Float32Array.of(0.5, 0.25, 0);
    const cubes = {
      ...{ size: 0.1, corner: [0, -0.1, 1], counts: [3, 1, 1], reached: Uint8Array.of(1, 0, 1) },
      ...{ manipulability: values, margin: values, directions: values, postures: Uint8Array.of(4, 0, 2) },
    };
    expect([...cubesCsvParts(cubes, 100, 'cm')].join('')).toBe(
      'x [cm],y [cm],z [cm],manipulability,margin,directions,postures\r\n5,-5,105,0.5,0.5,0.5,4\r\n25,-5,105,0,0,0,2\r\n',
    );
    expect([...cubesCsvParts({ ...cubes, postures: null }, 1, 'm')].join('')).not.toContain('postures');
  });

  test('PLY has the counts it says, with faces or without', () => {
    const solid = [...plyParts([TETRAHEDRON.corners], 10, TETRAHEDRON.triangles)].join('').split('\n');
    const end = solid.indexOf('end_header');
    expect(solid.slice(0, 3)).toEqual(['ply', 'format ascii 1.0', 'element vertex 4']);
    expect(solid).toContain('element face 4');
    expect(solid.slice(end + 1)).toEqual(['0 0 0', '10 0 0', '0 10 0', '0 0 10', '3 0 2 1', '3 0 1 3', '3 0 3 2', '3 1 2 3', '']); // prettier-ignore
    expect([...plyParts([TETRAHEDRON.corners], 1)].join('')).not.toContain('face');
  });

  test('STL encloses the volume that it should, by its own numbers, its normals outwards', () => {
    const bytes = Uint8Array.from([...stlParts(TETRAHEDRON, 10)].flatMap((part) => [...part]));
    const view = new DataView(bytes.buffer);
    expect(bytes).toHaveLength(84 + 4 * 50);
    expect(view.getUint32(80, true)).toBe(4);
    let sum = 0;
    for (let i = 0; i < 4; i++) {
      const [n, a, b, c] = [0, 1, 2, 3].map((k) => [0, 1, 2].map((axis) => view.getFloat32(84 + 50 * i + 12 * k + 4 * axis, true))); // prettier-ignore
      sum +=
        a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
      const middle = [0, 1, 2].map((axis) => (a[axis] + b[axis] + c[axis]) / 3 - 2.5);
      expect(n.reduce((total, value, axis) => total + value * middle[axis], 0)).toBeGreaterThan(0);
      expect(Math.hypot(...n)).toBeCloseTo(1, 6);
    }
    expect(sum / 6).toBeCloseTo(1000 / 6, 3);
  });

  test('SVG is as large as the region, with a margin, v upwards and the hole in the same path', () => {
    const svg = writeSectionSvg(FRAME, { u: [-1, 1], v: [-1, 1.5] }, 100, 'cm');
    expect(svg).toContain('width="210cm" height="260cm" viewBox="-105 -155 210 260"');
    expect(svg.match(/<path/g)).toHaveLength(1);
    expect(svg).toContain('M-100,100L100,100L100,-100L-100,-100ZM-50,50');
    expect(svg).toContain('fill-rule="evenodd"');
  });
});
