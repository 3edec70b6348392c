/**
 * A region as square cells: a cell is in it if its middle is. Row by row: where the outlines cross the middle of the row, the
 * region begins or ends.
 *
 * @import { Outline } from './outline.js'
 *
 * @typedef {object} Cells
 * @property {number} size     m, of a cell
 * @property {number} columns
 * @property {number} rows
 * @property {number} u        of the corner of the first cell; row by row upwards
 * @property {number} v
 * @property {Uint8Array} reached  columns · rows: 1 or 0
 *
 * @typedef {{ u: [number, number], v: [number, number] }} Extent
 */

/** @param {readonly Outline[]} outlines @returns {Extent | null} null if there are none */
export function extentOf(outlines) {
  if (outlines.length === 0) return null;
  /** @type {Extent} */
  const extent = { u: [Infinity, -Infinity], v: [Infinity, -Infinity] };
  for (const { vertices } of outlines) {
    for (const { u, v } of vertices) {
      extent.u = [Math.min(extent.u[0], u), Math.max(extent.u[1], u)];
      extent.v = [Math.min(extent.v[0], v), Math.max(extent.v[1], v)];
    }
  }
  return extent;
}

/**
 * @param {readonly Outline[]} outlines
 * @param {number} size
 * @returns {Cells}
 */
export function cellsOf(outlines, size) {
  const extent = extentOf(outlines) ?? { u: [0, 0], v: [0, 0] };
  const first = (/** @type {number} */ value) => Math.floor(value / size);
  const [left, low] = [first(extent.u[0]), first(extent.v[0])];
  const columns = first(extent.u[1]) - left + 1;
  const rows = first(extent.v[1]) - low + 1;
  const [u, v] = [left * size, low * size];
  const reached = new Uint8Array(columns * rows);
  /** Where each row is crossed: the place, and whether the region begins there (1) or ends (−1). @type {[number, number][][]} */
  const crossings = Array.from({ length: rows }, () => []);
  const rowAt = (/** @type {number} */ height) => Math.ceil((height - v) / size - 0.5); // the first whose middle is not below
  for (const { vertices } of outlines) {
    vertices.forEach((a, i) => {
      const b = vertices[(i + 1) % vertices.length];
      const begins = b.v < a.v ? 1 : -1; // the region is on the left
      const from = Math.max(0, rowAt(Math.min(a.v, b.v)));
      const to = Math.min(rows, rowAt(Math.max(a.v, b.v)));
      for (let row = from; row < to; row++) {
        const share = (v + (row + 0.5) * size - a.v) / (b.v - a.v);
        crossings[row].push([a.u + share * (b.u - a.u), begins]);
      }
    });
  }
  crossings.forEach((crossed, row) => {
    crossed.sort((a, b) => a[0] - b[0]);
    let depth = 0;
    crossed.forEach(([at, begins], i) => {
      depth += begins;
      if (depth <= 0 || i + 1 === crossed.length) return;
      const from = Math.max(0, Math.ceil((at - u) / size - 0.5));
      const to = Math.min(columns, Math.ceil((crossed[i + 1][0] - u) / size - 0.5));
      reached.fill(1, row * columns + from, row * columns + Math.max(from, to));
    });
  });
  return { size, columns, rows, u, v, reached };
}
