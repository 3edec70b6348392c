/**
 * Gaussian elimination with complete pivoting (Golub & Van Loan, section 3.4.8), which tells the rank as it goes: solves
 * square systems of six, and finds the vectors that a singular matrix takes to zero.
 */
const N = 6;

const rowOf = new Uint8Array(N);
const columnOf = new Uint8Array(N);
const work = new Float64Array(N);

/**
 * A = P L U Q in place; the permutations are kept until the next call.
 * @param {Float64Array} A  6 × 6, row by row
 * @returns {number} the last pivot over the first, in absolute value: 0 for a singular matrix
 */
export function factorise(A) {
  for (let k = 0; k < N; k++) rowOf[k] = columnOf[k] = k;
  let first = 0;
  let pivot = 0;
  for (let k = 0; k < N; k++) {
    let largest = -1;
    let row = k;
    let column = k;
    for (let i = k; i < N; i++) {
      for (let j = k; j < N; j++) {
        const size = Math.abs(A[N * i + j]);
        if (size > largest) {
          largest = size;
          row = i;
          column = j;
        }
      }
    }
    if (row !== k) {
      for (let j = 0; j < N; j++) {
        const held = A[N * k + j];
        A[N * k + j] = A[N * row + j];
        A[N * row + j] = held;
      }
      const held = rowOf[k];
      rowOf[k] = rowOf[row];
      rowOf[row] = held;
    }
    if (column !== k) {
      for (let i = 0; i < N; i++) {
        const held = A[N * i + k];
        A[N * i + k] = A[N * i + column];
        A[N * i + column] = held;
      }
      const held = columnOf[k];
      columnOf[k] = columnOf[column];
      columnOf[column] = held;
    }
    pivot = largest;
    if (k === 0) first = largest;
    if (!(largest > 0)) {
      for (let i = k; i < N; i++) A[N * i + i] = 0;
      return 0;
    }
    const inverse = 1 / A[N * k + k];
    for (let i = k + 1; i < N; i++) {
      const factor = A[N * i + k] * inverse;
      A[N * i + k] = factor;
      if (factor !== 0) for (let j = k + 1; j < N; j++) A[N * i + j] -= factor * A[N * k + j];
    }
  }
  return pivot / first;
}

/**
 * How many pivots of the matrix factorised last are more than this share of the first.
 * @param {Float64Array} LU
 * @param {number} share
 */
export function rankOf(LU, share) {
  let rank = 0;
  while (rank < N && Math.abs(LU[(N + 1) * rank]) > share * Math.abs(LU[0])) rank++;
  return rank;
}

/**
 * x with A x = b, for the matrix factorised last, and of full rank.
 * @param {Float64Array} LU
 * @param {Float64Array} b
 * @param {Float64Array} x
 */
export function solveFactorised(LU, b, x) {
  for (let i = 0; i < N; i++) {
    let sum = b[rowOf[i]];
    for (let j = 0; j < i; j++) sum -= LU[N * i + j] * work[j];
    work[i] = sum;
  }
  for (let i = N - 1; i >= 0; i--) {
    let sum = work[i];
    for (let j = i + 1; j < N; j++) sum -= LU[N * i + j] * work[j];
    work[i] = sum / LU[N * i + i];
    x[columnOf[i]] = work[i];
  }
}

/**
 * A vector that the matrix factorised last takes to zero if its rank is `rank`: unit in column number `free` of those that no
 * pivot is in (as complete pivoting orders them), zero in the others.
 * @param {Float64Array} LU
 * @param {number} rank  at most 5
 * @param {number} free  from `rank` to 5
 * @param {Float64Array} v
 */
export function nullVector(LU, rank, free, v) {
  for (let i = rank; i < N; i++) v[columnOf[i]] = work[i] = i === free ? 1 : 0;
  for (let i = rank - 1; i >= 0; i--) {
    let sum = 0;
    for (let j = i + 1; j < N; j++) sum -= LU[N * i + j] * work[j];
    v[columnOf[i]] = work[i] = sum / LU[N * i + i];
  }
}
