/**
 * A mapped workspace as files: points as CSV and PLY, a section as CSV and SVG, a solid as STL and PLY. Lengths are metres times
 * `scale`, which the caller chooses and says: none of these formats has a unit of its own.
 *
 * @typedef {{ places: ArrayLike<number>, area: number }} OutlineToWrite      u, v; closed
 * @typedef {{ u: ArrayLike<number>, v: ArrayLike<number> }} ExtentToWrite    lowest and highest
 * @typedef {{ corners: ArrayLike<number>, triangles: ArrayLike<number> }} SurfaceToWrite
 */
import { writeCsv } from './csv.js';

/** What precedes the triangles of an STL file, and the size of one. */
const STL_HEAD = 84;
const STL_TRIANGLE = 50;

/** Around the drawing of a section, as a share of it. */
const MARGIN = 0.02;

/** Single precision has seven digits. @param {number} value */
const short = (value) => String(Number(value.toPrecision(7)));

/** @param {ArrayLike<number>} values @param {number} width @param {number} scale @returns {number[][]} */
const rowsOf = (values, width, scale) =>
  Array.from({ length: Math.floor(values.length / width) }, (_, row) =>
    Array.from({ length: width }, (_cell, k) => Number(short(values[width * row + k] * scale))),
  );

/** @param {ArrayLike<number>} places  x, y and z each @param {number} scale @param {string} unit */
export const writePlacesCsv = (places, scale, unit) =>
  writeCsv([['x', 'y', 'z'].map((name) => `${name} [${unit}]`), ...rowsOf(places, 3, scale)]);

/** @param {readonly OutlineToWrite[]} outlines @param {number} scale @param {string} unit */
export const writeSectionCsv = (outlines, scale, unit) =>
  writeCsv([
    ['outline', 'hole', `u [${unit}]`, `v [${unit}]`],
    ...outlines.flatMap(({ places, area }, i) =>
      rowsOf(places, 2, scale).map((row) => [i + 1, area < 0 ? 'yes' : 'no', ...row]),
    ),
  ]);

/**
 * @param {ArrayLike<number>} corners
 * @param {number} scale
 * @param {ArrayLike<number>} [triangles]
 */
export function writePly(corners, scale, triangles = []) {
  const count = triangles.length / 3;
  const faces = count > 0 ? [`element face ${count}`, 'property list uchar int vertex_indices'] : [];
  const head = [
    'ply',
    'format ascii 1.0',
    `element vertex ${Math.floor(corners.length / 3)}`,
    ...['x', 'y', 'z'].map((name) => `property float ${name}`),
    ...faces,
    'end_header',
  ];
  const lines = rowsOf(corners, 3, scale).map((row) => row.join(' '));
  const sides = rowsOf(triangles, 3, 1).map((row) => `3 ${row.join(' ')}`);
  return `${[...head, ...lines, ...sides].join('\n')}\n`;
}

/** Binary, as every program reads it. @param {SurfaceToWrite} surface @param {number} scale @returns {Uint8Array} */
export function writeStl({ corners, triangles }, scale) {
  const count = triangles.length / 3;
  const bytes = new Uint8Array(STL_HEAD + STL_TRIANGLE * count);
  const view = new DataView(bytes.buffer);
  view.setUint32(STL_HEAD - 4, count, true);
  for (let i = 0; i < count; i++) {
    const [a, b, c] = [0, 1, 2].map((k) => [0, 1, 2].map((axis) => corners[3 * triangles[3 * i + k] + axis] * scale));
    const [p, q] = [b.map((value, axis) => value - a[axis]), c.map((value, axis) => value - a[axis])];
    const normal = [p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]];
    const size = Math.hypot(...normal) || 1;
    [...normal.map((value) => value / size), ...a, ...b, ...c].forEach((value, k) =>
      view.setFloat32(STL_HEAD + STL_TRIANGLE * i + 4 * k, value, true),
    );
  }
  return bytes;
}

/**
 * The region filled, holes left open, v upwards; one unit of the drawing is one of `unit`.
 * @param {readonly OutlineToWrite[]} outlines
 * @param {ExtentToWrite} extent
 * @param {number} scale
 * @param {'mm' | 'cm' | 'in'} unit
 */
export function writeSectionSvg(outlines, extent, scale, unit) {
  const margin = MARGIN * Math.max(extent.u[1] - extent.u[0], extent.v[1] - extent.v[0]);
  const [left, top] = [extent.u[0] - margin, -extent.v[1] - margin];
  const [width, height] = [extent.u[1] - extent.u[0] + 2 * margin, extent.v[1] - extent.v[0] + 2 * margin];
  const [x, y, w, h] = [left, top, width, height].map((value) => short(value * scale));
  const d = outlines
    .map(({ places }) => {
      const points = rowsOf(places, 2, scale).map(([u, v]) => `${u},${-v || 0}`);
      return `M${points.join('L')}Z`;
    })
    .join('');
  return [
    `<svg xmlns="http://www.w3.org/2000/svg" width="${w}${unit}" height="${h}${unit}" viewBox="${x} ${y} ${w} ${h}">`,
    `<path d="${d}" fill="#9bb4d8" fill-rule="evenodd" stroke="#1f3f77" vector-effect="non-scaling-stroke"/>`,
    '</svg>\n',
  ].join('\n');
}
