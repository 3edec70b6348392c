/**
 * Singular values of small matrices, A = U Σ Vᵀ, by one-sided Jacobi rotations (Hestenes 1958): the columns of A are turned
 * in pairs until all are orthogonal. Among the ways there are it is the one that keeps the digits of small singular values
 * (Demmel & Veselić 1992: an error of a few roundings relative to the columns, however short some are), and for matrices of
 * six rows it is fast as well. All of U and V are filled in, what belongs to no singular value included.
 *
 * @typedef {object} Svd   room for one decomposition and its results, used again and again
 * @property {number} rows
 * @property {number} columns
 * @property {Float64Array} values  min(rows, columns) singular values, falling, never negative
 * @property {Float64Array} U  rows · rows, orthogonal, column-major: column j is what a unit step along column j of V makes,
 *   divided by singular value j
 * @property {Float64Array} V  columns · columns, orthogonal, column-major
 * @property {Float64Array} work
 * @property {Float64Array} free
 */

/** Columns are orthogonal when the cosine between them is no more than the rounding of their product. */
const ORTHOGONAL = 4 * Number.EPSILON;

/** Sweeps until then: six or seven in practice. */
const SWEEPS = 40;

/** A column shorter than this next to the largest entry is nothing: the squares of what is in it would lose their digits. */
const NOTHING = 1e-140;

/** @param {number} rows @param {number} columns @returns {Svd} */
export function createSvd(rows, columns) {
  const tall = Math.max(rows, columns);
  const thin = Math.min(rows, columns);
  return {
    rows,
    columns,
    values: new Float64Array(thin),
    U: new Float64Array(rows * rows),
    V: new Float64Array(columns * columns),
    work: new Float64Array(tall * thin),
    free: new Float64Array(tall),
  };
}

/**
 * Turns columns p and q of M by the angle whose cosine and sine are c and s.
 * @param {Float64Array} M  column-major
 * @param {number} length  of a column
 * @param {number} p
 * @param {number} q
 * @param {number} c
 * @param {number} s
 */
function turn(M, length, p, q, c, s) {
  for (let i = 0, a = p * length, b = q * length; i < length; i++, a++, b++) {
    const x = M[a];
    const y = M[b];
    M[a] = c * x - s * y;
    M[b] = s * x + c * y;
  }
}

/**
 * One round of all pairs.
 * @param {Float64Array} W  tall · thin
 * @param {Float64Array} Q  thin · thin, turned along
 * @param {number} tall
 * @param {number} thin
 * @returns {boolean} whether anything had to be turned
 */
function sweep(W, Q, tall, thin) {
  let hasTurned = false;
  for (let p = 0; p < thin - 1; p++) {
    for (let q = p + 1; q < thin; q++) {
      let pp = 0;
      let qq = 0;
      let pq = 0;
      for (let i = 0, a = p * tall, b = q * tall; i < tall; i++, a++, b++) {
        pp += W[a] * W[a];
        qq += W[b] * W[b];
        pq += W[a] * W[b];
      }
      if (pp < qq) {
        // the longer column first: this sorts, and convergence is faster (de Rijk 1989)
        turn(W, tall, p, q, 0, -1);
        turn(Q, thin, p, q, 0, -1);
        [pp, qq, pq] = [qq, pp, -pq];
        hasTurned = true;
      }
      if (!(Math.abs(pq) > ORTHOGONAL * Math.sqrt(pp) * Math.sqrt(qq))) continue;
      const zeta = (qq - pp) / (2 * pq);
      const t = (zeta < 0 ? -1 : 1) / (Math.abs(zeta) + Math.sqrt(1 + zeta * zeta));
      const c = 1 / Math.sqrt(1 + t * t);
      turn(W, tall, p, q, c, c * t);
      turn(Q, thin, p, q, c, c * t);
      hasTurned = true;
    }
  }
  return hasTurned;
}

/**
 * Gives column j of B a direction at right angles to the columns before it: the unit vector that is farthest from them,
 * what it has in common with them taken off, twice for the digits.
 * @param {Float64Array} B  size · size
 * @param {number} size
 * @param {number} j
 * @param {Float64Array} free  room
 */
function complete(B, size, j, free) {
  free.fill(1);
  for (let k = 0; k < j; k++) for (let i = 0; i < size; i++) free[i] -= B[k * size + i] ** 2;
  let best = 0;
  for (let i = 1; i < size; i++) if (free[i] > free[best]) best = i;
  const to = j * size;
  for (let i = 0; i < size; i++) B[to + i] = i === best ? 1 : 0;
  for (let round = 0; round < 2; round++) {
    for (let k = 0; k < j; k++) {
      let along = 0;
      for (let i = 0; i < size; i++) along += B[k * size + i] * B[to + i];
      for (let i = 0; i < size; i++) B[to + i] -= along * B[k * size + i];
    }
    let square = 0;
    for (let i = 0; i < size; i++) square += B[to + i] ** 2;
    const inverse = 1 / Math.sqrt(square);
    for (let i = 0; i < size; i++) B[to + i] *= inverse;
  }
}

/**
 * Fills `svd` with the decomposition of A. Allocates nothing.
 * @param {ArrayLike<number>} A  rows · columns, column-major, finite
 * @param {Svd} svd
 * @returns {Svd}
 */
export function decompose(A, svd) {
  const { rows, columns, values, work: W, free } = svd;
  const isWide = rows < columns; // then the transpose is decomposed, and U and V change places
  const tall = isWide ? columns : rows;
  const thin = isWide ? rows : columns;
  const B = isWide ? svd.V : svd.U;
  const Q = isWide ? svd.U : svd.V;
  let largest = 0;
  for (let i = 0; i < W.length; i++) largest = Math.max(largest, Math.abs(A[i]));
  // a power of two rounds nothing, and squares can then neither overflow nor vanish
  const unit = largest > 0 ? 2 ** Math.floor(Math.log2(largest)) : 1;
  for (let j = 0; j < thin; j++) {
    for (let i = 0; i < tall; i++) W[j * tall + i] = (isWide ? A[i * rows + j] : A[j * rows + i]) / unit;
  }
  Q.fill(0);
  for (let j = 0; j < thin; j++) Q[j * thin + j] = 1;
  for (let round = 0; round < SWEEPS && sweep(W, Q, tall, thin); round++);
  for (let j = 0; j < tall; j++) {
    let square = 0;
    if (j < thin) for (let i = 0; i < tall; i++) square += W[j * tall + i] ** 2;
    const value = Math.sqrt(square);
    if (j < thin) values[j] = value * unit;
    if (value < NOTHING) complete(B, tall, j, free);
    else for (let i = 0; i < tall; i++) B[j * tall + i] = W[j * tall + i] / value;
  }
  return svd;
}
