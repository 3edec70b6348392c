/**
 * Symmetric positive definite systems by Cholesky's factorisation without its square roots, L D Lᵀ (Golub & Van Loan, section
 * 4.1). The factors of the last system are kept, for another right side.
 */

/**
 * Factors of each size: below the diagonal L, on it 1 / D, above it L D turned over. Nothing here calls back.
 * @type {Float64Array[]}
 */
const factors = [];

/** Those of size 6: L row by row, then 1 / D. */
const six = new Float64Array(21);

/**
 * Solve (H + damping) x = g.
 * @param {Float64Array} H  n · n, row by row; only the lower triangle is read
 * @param {Float64Array} g  n
 * @param {Float64Array} x  n, filled; may be g
 * @param {number} [damping]  added to the diagonal
 * @returns {boolean} false if the sum is not positive definite
 */
export function solveCholesky(H, g, x, damping = 0) {
  const n = g.length;
  const isDefinite = n === 6 ? factoriseSix(H, damping) : factorise(H, n, damping);
  if (isDefinite) solveAgain(g, x);
  return isDefinite;
}

/**
 * Another right side for the system of this size that was solved last.
 * @param {Float64Array} g  n
 * @param {Float64Array} x  n, filled; may be g
 */
export function solveAgain(g, x) {
  const n = g.length;
  if (n === 6) {
    substituteSix(g, x);
    return;
  }
  const L = factors[n];
  for (let i = 0; i < n; i++) {
    let sum = g[i];
    for (let k = 0; k < i; k++) sum -= L[i * n + k] * x[k];
    x[i] = sum;
  }
  for (let i = n - 1; i >= 0; i--) {
    let sum = x[i] * L[i * n + i];
    for (let k = i + 1; k < n; k++) sum -= L[k * n + i] * x[k];
    x[i] = sum;
  }
}

/**
 * @param {Float64Array} H
 * @param {number} n
 * @param {number} damping
 * @returns {boolean}
 */
function factorise(H, n, damping) {
  const L = (factors[n] ??= new Float64Array(n * n));
  for (let j = 0; j < n; j++) {
    let pivot = H[j * n + j] + damping;
    for (let k = 0; k < j; k++) pivot -= L[j * n + k] * L[k * n + j];
    if (!(pivot > 0)) return false;
    const inverse = 1 / pivot;
    L[j * n + j] = inverse;
    for (let i = j + 1; i < n; i++) {
      let below = H[i * n + j];
      for (let k = 0; k < j; k++) below -= L[k * n + i] * L[j * n + k];
      L[j * n + i] = below;
      L[i * n + j] = below * inverse;
    }
  }
  return true;
}

/**
 * The same for six unknowns, written out: most arms have six joints, and loops take three times as long. d is D, e its
 * inverse, c the column below before it is divided.
 * @param {Float64Array} H
 * @param {number} damping
 * @returns {boolean}
 */
function factoriseSix(H, damping) {
  const d0 = H[0] + damping;
  if (!(d0 > 0)) return false;
  const e0 = 1 / d0;
  const c10 = H[6];
  const l10 = c10 * e0;
  const c20 = H[12];
  const l20 = c20 * e0;
  const c30 = H[18];
  const l30 = c30 * e0;
  const c40 = H[24];
  const l40 = c40 * e0;
  const c50 = H[30];
  const l50 = c50 * e0;
  const d1 = H[7] + damping - c10 * l10;
  if (!(d1 > 0)) return false;
  const e1 = 1 / d1;
  const c21 = H[13] - c20 * l10;
  const l21 = c21 * e1;
  const c31 = H[19] - c30 * l10;
  const l31 = c31 * e1;
  const c41 = H[25] - c40 * l10;
  const l41 = c41 * e1;
  const c51 = H[31] - c50 * l10;
  const l51 = c51 * e1;
  const d2 = H[14] + damping - c20 * l20 - c21 * l21;
  if (!(d2 > 0)) return false;
  const e2 = 1 / d2;
  const c32 = H[20] - c30 * l20 - c31 * l21;
  const l32 = c32 * e2;
  const c42 = H[26] - c40 * l20 - c41 * l21;
  const l42 = c42 * e2;
  const c52 = H[32] - c50 * l20 - c51 * l21;
  const l52 = c52 * e2;
  const d3 = H[21] + damping - c30 * l30 - c31 * l31 - c32 * l32;
  if (!(d3 > 0)) return false;
  const e3 = 1 / d3;
  const c43 = H[27] - c40 * l30 - c41 * l31 - c42 * l32;
  const l43 = c43 * e3;
  const c53 = H[33] - c50 * l30 - c51 * l31 - c52 * l32;
  const l53 = c53 * e3;
  const d4 = H[28] + damping - c40 * l40 - c41 * l41 - c42 * l42 - c43 * l43;
  if (!(d4 > 0)) return false;
  const e4 = 1 / d4;
  const c54 = H[34] - c50 * l40 - c51 * l41 - c52 * l42 - c53 * l43;
  const l54 = c54 * e4;
  const d5 = H[35] + damping - c50 * l50 - c51 * l51 - c52 * l52 - c53 * l53 - c54 * l54;
  if (!(d5 > 0)) return false;
  const e5 = 1 / d5;
  six[0] = l10;
  six[1] = l20;
  six[2] = l21;
  six[3] = l30;
  six[4] = l31;
  six[5] = l32;
  six[6] = l40;
  six[7] = l41;
  six[8] = l42;
  six[9] = l43;
  six[10] = l50;
  six[11] = l51;
  six[12] = l52;
  six[13] = l53;
  six[14] = l54;
  six[15] = e0;
  six[16] = e1;
  six[17] = e2;
  six[18] = e3;
  six[19] = e4;
  six[20] = e5;
  return true;
}

/**
 * @param {Float64Array} g
 * @param {Float64Array} x
 */
function substituteSix(g, x) {
  const l10 = six[0];
  const l20 = six[1];
  const l21 = six[2];
  const l30 = six[3];
  const l31 = six[4];
  const l32 = six[5];
  const l40 = six[6];
  const l41 = six[7];
  const l42 = six[8];
  const l43 = six[9];
  const l50 = six[10];
  const l51 = six[11];
  const l52 = six[12];
  const l53 = six[13];
  const l54 = six[14];
  const e0 = six[15];
  const e1 = six[16];
  const e2 = six[17];
  const e3 = six[18];
  const e4 = six[19];
  const e5 = six[20];
  const y0 = g[0];
  const y1 = g[1] - l10 * y0;
  const y2 = g[2] - l20 * y0 - l21 * y1;
  const y3 = g[3] - l30 * y0 - l31 * y1 - l32 * y2;
  const y4 = g[4] - l40 * y0 - l41 * y1 - l42 * y2 - l43 * y3;
  const y5 = g[5] - l50 * y0 - l51 * y1 - l52 * y2 - l53 * y3 - l54 * y4;
  const x5 = y5 * e5;
  const x4 = y4 * e4 - l54 * x5;
  const x3 = y3 * e3 - l43 * x4 - l53 * x5;
  const x2 = y2 * e2 - l32 * x3 - l42 * x4 - l52 * x5;
  const x1 = y1 * e1 - l21 * x2 - l31 * x3 - l41 * x4 - l51 * x5;
  const x0 = y0 * e0 - l10 * x1 - l20 * x2 - l30 * x3 - l40 * x4 - l50 * x5;
  x[0] = x0;
  x[1] = x1;
  x[2] = x2;
  x[3] = x3;
  x[4] = x4;
  x[5] = x5;
}
