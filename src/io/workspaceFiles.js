/**
 * A mapped workspace as files: points as CSV and PLY, a section as CSV and SVG, a solid as STL and PLY. Lengths are metres times
 * `scale`, which the caller chooses and says: none of these formats has a unit of its own. What may be large is made in parts of
 * some milliseconds each, which follow each other in the file.
 *
 * @typedef {{ places: ArrayLike<number>, area: number }} OutlineToWrite      u, v; closed
 * @typedef {{ u: ArrayLike<number>, v: ArrayLike<number> }} ExtentToWrite    lowest and highest
 *
 * @typedef {object} CubesToWrite
 * @property {number} size
 * @property {readonly number[]} corner
 * @property {readonly number[]} counts
 * @property {Uint8Array} reached
 * @property {Float32Array} manipulability
 * @property {Float32Array} margin
 * @property {Float32Array} directions
 * @property {Uint8Array | null} postures
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

/** Numbers in one part. */
const PART = 30_000;

/** @template {Float32Array | Uint32Array} List @param {List} values @param {number} width @returns {Generator<List>} */
function* partsOf(values, width) {
  const most = width * Math.floor(PART / width);
  for (let k = 0; k < values.length; k += most) yield /** @type {List} */ (values.subarray(k, k + most));
}

/**
 * @param {readonly Float32Array[]} lists  x, y and z of each place
 * @param {number} scale
 * @param {string} unit
 */
export function* placesCsvParts(lists, scale, unit) {
  yield writeCsv([['x', 'y', 'z'].map((name) => `${name} [${unit}]`)]);
  for (const places of lists) for (const part of partsOf(places, 3)) yield writeCsv(rowsOf(part, 3, scale));
}

/**
 * The middles of cubes that are reached, with what is known of each.
 * @param {CubesToWrite} cubes
 * @param {number} scale
 * @param {string} unit
 */
export function* cubesCsvParts({ size, corner, counts, reached, postures, ...values }, scale, unit) {
  const names = /** @type {const} */ (['manipulability', 'margin', 'directions']);
  const head = ['x', 'y', 'z'].map((name) => `${name} [${unit}]`);
  yield writeCsv([[...head, ...names, ...(postures ? ['postures'] : [])]]);
  /** @type {number[][]} */
  let rows = [];
  for (let cube = 0; cube < reached.length; cube++) {
    if (!reached[cube]) continue;
    const at = [cube % counts[0], Math.floor(cube / counts[0]) % counts[1], Math.floor(cube / (counts[0] * counts[1]))];
    const place = at.map((k, axis) => Number(short((corner[axis] + (k + 0.5) * size) * scale)));
    const known = names.map((name) => Number(short(values[name][cube])));
    rows.push([...place, ...known, ...(postures ? [postures[cube]] : [])]);
    if (rows.length < PART / 10) continue;
    yield writeCsv(rows);
    rows = [];
  }
  yield writeCsv(rows);
}

/** @param {readonly OutlineToWrite[]} outlines @param {number} scale @param {string} unit */
export const writeSectionCsv = (outlines, scale, unit) =>
  writeCsv([
    ['outline', 'hole', `u [${unit}]`, `v [${unit}]`],
    ...outlines.flatMap(({ places, area }, i) =>
      rowsOf(places, 2, scale).map((row) => [i + 1, area < 0 ? 'yes' : 'no', ...row]),
    ),
  ]);

/**
 * @param {readonly Float32Array[]} lists  corners, x, y and z each
 * @param {number} scale
 * @param {Uint32Array} [triangles]
 */
export function* plyParts(lists, scale, triangles = new Uint32Array(0)) {
  const count = triangles.length / 3;
  const faces = count > 0 ? [`element face ${count}`, 'property list uchar int vertex_indices'] : [];
  const corners = lists.reduce((sum, { length }) => sum + Math.floor(length / 3), 0);
  const head = [
    'ply',
    'format ascii 1.0',
    `element vertex ${corners}`,
    ...['x', 'y', 'z'].map((name) => `property float ${name}`),
    ...faces,
    'end_header',
  ];
  yield `${head.join('\n')}\n`;
  for (const list of lists) {
    for (const part of partsOf(list, 3))
      yield rowsOf(part, 3, scale)
        .map((row) => `${row.join(' ')}\n`)
        .join('');
  }
  for (const part of partsOf(triangles, 3))
    yield rowsOf(part, 3, 1)
      .map((row) => `3 ${row.join(' ')}\n`)
      .join('');
}

/**
 * Binary, as every program reads it.
 * @param {{ corners: Float32Array, triangles: Uint32Array }} surface
 * @param {number} scale
 * @returns {Generator<Uint8Array<ArrayBuffer>>}
 */
export function* stlParts({ corners, triangles }, scale) {
  const head = new DataView(new ArrayBuffer(STL_HEAD));
  head.setUint32(STL_HEAD - 4, triangles.length / 3, true);
  yield new Uint8Array(head.buffer);
  for (const part of partsOf(triangles, 3)) {
    const view = new DataView(new ArrayBuffer((STL_TRIANGLE * part.length) / 3));
    for (let i = 0; i < part.length / 3; i++)
      writeTriangle(view, STL_TRIANGLE * i, corners, part.subarray(3 * i), scale);
    yield new Uint8Array(view.buffer);
  }
}

/** @param {DataView} view @param {number} at @param {Float32Array} corners @param {Uint32Array} three @param {number} scale */
function writeTriangle(view, at, corners, three, scale) {
  const [a, b, c] = [0, 1, 2].map((k) => [0, 1, 2].map((axis) => corners[3 * three[k] + axis] * scale));
  const [p, q] = [b.map((value, axis) => value - a[axis]), c.map((value, axis) => value - a[axis])];
  const normal = [p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]];
  const size = Math.hypot(...normal) || 1;
  [...normal.map((value) => value / size), ...a, ...b, ...c].forEach((value, k) =>
    view.setFloat32(at + 4 * k, value, true),
  );
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
