/**
 * Four equations in three unknowns x, y, z, each of degree one in every unknown, have a common solution only if Dixon's
 * determinant is zero (Dixon 1908; here of 6 × 6, for eight coefficients to an equation). It comes from
 *
 *   det [ f(x,y,z); f(X,y,z); f(X,Y,z); f(X,Y,Z) ] / ((x − X)(y − Y)(z − Z))
 *     = det [ f_x(y,z); f_y(X,z); f_z(X,Y); f(X,Y,0) ],
 *
 * read as a bilinear form in the monomials X^0…2 Y^0…1 (rows) and z^0…2 y^0…1 (columns): its entries are sums of 4 × 4 minors
 * of the matrix of coefficients. At a solution the first row above vanishes whatever X, Y and Z are, so the vector of
 * z^i y^j is in the null space. Solutions with an unknown at infinity (a half turn) are solutions like any other: their
 * vectors have zeros in front.
 *
 * Coefficient m of an equation belongs to x^(bit 0 of m) y^(bit 1) z^(bit 2).
 */

/** Rows and columns of the matrix, equations, coefficients of each. */
export const SIZE = 6;
export const EQUATIONS = 4;
export const COEFFICIENTS = 8;

/** A pair of columns p < q has the number PAIR[8 p + q]; 28 in all. */
const PAIR = new Uint8Array(64);
for (let p = 0, count = 0; p < 8; p++) for (let q = p + 1; q < 8; q++) PAIR[8 * p + q] = count++;

/**
 * The minors that are needed and where they go, found once: `pairs` holds for each minor the six pairs of its columns and
 * their six complements; `from`, `to`, `signs` say which minor is added to which entry.
 * @type {{ pairs: Uint8Array, from: Uint8Array, to: Uint8Array, signs: Int8Array } | undefined}
 */
let plan;

/** Each factor: [coefficient, power of X, of Y, of z, of y]. */
const FACTORS = [
  [1, 0, 0, 0, 0, 3, 0, 0, 0, 1, 5, 0, 0, 1, 0, 7, 0, 0, 1, 1],
  [2, 0, 0, 0, 0, 3, 1, 0, 0, 0, 6, 0, 0, 1, 0, 7, 1, 0, 1, 0],
  [4, 0, 0, 0, 0, 5, 1, 0, 0, 0, 6, 0, 1, 0, 0, 7, 1, 1, 0, 0],
  [0, 0, 0, 0, 0, 1, 1, 0, 0, 0, 2, 0, 1, 0, 0, 3, 1, 1, 0, 0],
];

/** @param {number[]} columns @returns {number} the sign of the order they are in */
const parity = (columns) =>
  columns.reduce((sign, p, i) => columns.slice(i + 1).reduce((product, q) => (q < p ? -product : product), sign), 1);

/** Which minor goes where: sums of products of one term from each row, equal ones together. */
function sumOfMinors() {
  /** @type {Map<string, { columns: number[], to: number, sign: number }>} */
  const terms = new Map();
  for (let choice = 0; choice < 256; choice++) {
    const parts = FACTORS.map((factor, row) => factor.slice(5 * ((choice >> (2 * row)) & 3)).slice(0, 5));
    const columns = parts.map(([column]) => column);
    if (new Set(columns).size < 4) continue;
    const [X, Y, z, y] = [1, 2, 3, 4].map((k) => parts.reduce((sum, part) => sum + part[k], 0));
    const sorted = columns.toSorted((p, q) => p - q);
    const key = `${sorted.join()};${X},${Y},${z},${y}`;
    const sign = (terms.get(key)?.sign ?? 0) + parity(columns);
    terms.set(key, { columns: sorted, to: SIZE * (X + 3 * Y) + z + 3 * y, sign });
  }
  return [...terms.values()].filter(({ sign }) => sign !== 0);
}

/** By Laplace: the minors of the upper two rows times those of the lower two. */
function makePlan() {
  const terms = sumOfMinors();
  const minors = [...new Set(terms.map(({ columns }) => columns.join()))];
  return {
    pairs: Uint8Array.from(
      minors.flatMap((minor) => {
        const [p, q, r, s] = minor.split(',').map(Number);
        // signs + − + + − +
        return [p, q, r, s, p, r, q, s, p, s, q, r, q, r, p, s, q, s, p, r, r, s, p, q];
      }),
    ).reduce(
      (pairs, column, k, columns) => {
        if (k % 2) pairs[k >> 1] = PAIR[8 * columns[k - 1] + column];
        return pairs;
      },
      new Uint8Array(12 * minors.length),
    ),
    from: Uint8Array.from(terms, ({ columns }) => minors.indexOf(columns.join())),
    to: Uint8Array.from(terms, ({ to }) => to),
    signs: Int8Array.from(terms, ({ sign }) => sign),
  };
}

const upper = new Float64Array(28);
const lower = new Float64Array(28);
const minors = new Float64Array(70);

/** @param {Float64Array} M @param {number} row @param {Float64Array} out 28 */
function writePairMinors(M, row, out) {
  const next = row + COEFFICIENTS;
  for (let p = 0, k = 0; p < 8; p++) {
    const a = M[row + p];
    const b = M[next + p];
    for (let q = p + 1; q < 8; q++) out[k++] = a * M[next + q] - b * M[row + q];
  }
}

/**
 * @param {Float64Array} M  4 × 8, row by row: the coefficients of each equation
 * @param {Float64Array} D  6 × 6, row by row, filled
 */
export function writeDixonMatrix(M, D) {
  plan ??= makePlan();
  const { pairs, from, to, signs } = plan;
  writePairMinors(M, 0, upper);
  writePairMinors(M, 2 * COEFFICIENTS, lower);
  for (let k = 0, m = 0; k < pairs.length; k += 12, m++) {
    minors[m] =
      upper[pairs[k]] * lower[pairs[k + 1]] -
      upper[pairs[k + 2]] * lower[pairs[k + 3]] +
      upper[pairs[k + 4]] * lower[pairs[k + 5]] +
      upper[pairs[k + 6]] * lower[pairs[k + 7]] -
      upper[pairs[k + 8]] * lower[pairs[k + 9]] +
      upper[pairs[k + 10]] * lower[pairs[k + 11]];
  }
  D.fill(0);
  for (let k = 0; k < from.length; k++) D[to[k]] += signs[k] * minors[from[k]];
}

/**
 * The determinant of such a matrix, by elimination with partial pivoting, and what it would be if the smallest pivot were
 * as large as the largest entry: rounding in the entries moves it by some 1e-16 of that.
 * @param {Float64Array} A  6 × 6, overwritten
 * @param {Float64Array} out  2 numbers
 */
export function writeDeterminant(A, out) {
  let product = 1;
  let smallest = Infinity;
  let largest = 0;
  for (let i = 0; i < SIZE * SIZE; i++) if (Math.abs(A[i]) > largest) largest = Math.abs(A[i]);
  for (let k = 0; k < SIZE; k++) {
    let row = k;
    for (let i = k + 1; i < SIZE; i++) if (Math.abs(A[SIZE * i + k]) > Math.abs(A[SIZE * row + k])) row = i;
    const pivot = A[SIZE * row + k];
    product *= pivot;
    if (pivot === 0) break;
    smallest = Math.min(smallest, Math.abs(pivot));
    if (row !== k) {
      for (let j = k; j < SIZE; j++) {
        const other = A[SIZE * row + j];
        A[SIZE * row + j] = A[SIZE * k + j];
        A[SIZE * k + j] = other;
      }
      product = -product;
    }
    for (let i = k + 1; i < SIZE; i++) {
      const factor = A[SIZE * i + k] / pivot;
      for (let j = k + 1; j < SIZE; j++) A[SIZE * i + j] -= factor * A[SIZE * k + j];
    }
  }
  out[0] = product;
  out[1] = (Math.abs(product) / smallest) * largest;
}
