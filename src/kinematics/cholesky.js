/**
 * Solve H x = g for a symmetric positive definite H by Cholesky's factorisation (Golub & Van Loan, section 4.2).
 * @param {Float64Array} H  n · n, row by row; only the lower triangle is read; overwritten
 * @param {Float64Array} g  n
 * @param {Float64Array} x  n, filled
 * @returns {boolean} false if H is not positive definite
 */
export function solveCholesky(H, g, x) {
  const n = g.length;
  if (n === 6) return solveSix(H, g, x);
  for (let j = 0; j < n; j++) {
    let sum = H[j * n + j];
    for (let k = 0; k < j; k++) sum -= H[j * n + k] * H[j * n + k];
    if (!(sum > 0)) return false;
    const inverse = 1 / Math.sqrt(sum);
    H[j * n + j] = inverse; // the diagonal keeps 1 / L_jj: nothing is divided again
    for (let i = j + 1; i < n; i++) {
      let below = H[i * n + j];
      for (let k = 0; k < j; k++) below -= H[i * n + k] * H[j * n + k];
      H[i * n + j] = below * inverse;
    }
  }
  for (let i = 0; i < n; i++) {
    let sum = g[i];
    for (let k = 0; k < i; k++) sum -= H[i * n + k] * x[k];
    x[i] = sum * H[i * n + i];
  }
  for (let i = n - 1; i >= 0; i--) {
    let sum = x[i];
    for (let k = i + 1; k < n; k++) sum -= H[k * n + i] * x[k];
    x[i] = sum * H[i * n + i];
  }
  return true;
}

/**
 * The same for six unknowns, written out: most arms have six joints, and this is half of the time that a step takes.
 * @param {Float64Array} H
 * @param {Float64Array} g
 * @param {Float64Array} x
 * @returns {boolean}
 */
function solveSix(H, g, x) {
  const s0 = H[0];
  if (!(s0 > 0)) return false;
  const d0 = 1 / Math.sqrt(s0);
  const l10 = H[6] * d0;
  const l20 = H[12] * d0;
  const l30 = H[18] * d0;
  const l40 = H[24] * d0;
  const l50 = H[30] * d0;
  const s1 = H[7] - l10 * l10;
  if (!(s1 > 0)) return false;
  const d1 = 1 / Math.sqrt(s1);
  const l21 = (H[13] - l20 * l10) * d1;
  const l31 = (H[19] - l30 * l10) * d1;
  const l41 = (H[25] - l40 * l10) * d1;
  const l51 = (H[31] - l50 * l10) * d1;
  const s2 = H[14] - l20 * l20 - l21 * l21;
  if (!(s2 > 0)) return false;
  const d2 = 1 / Math.sqrt(s2);
  const l32 = (H[20] - l30 * l20 - l31 * l21) * d2;
  const l42 = (H[26] - l40 * l20 - l41 * l21) * d2;
  const l52 = (H[32] - l50 * l20 - l51 * l21) * d2;
  const s3 = H[21] - l30 * l30 - l31 * l31 - l32 * l32;
  if (!(s3 > 0)) return false;
  const d3 = 1 / Math.sqrt(s3);
  const l43 = (H[27] - l40 * l30 - l41 * l31 - l42 * l32) * d3;
  const l53 = (H[33] - l50 * l30 - l51 * l31 - l52 * l32) * d3;
  const s4 = H[28] - l40 * l40 - l41 * l41 - l42 * l42 - l43 * l43;
  if (!(s4 > 0)) return false;
  const d4 = 1 / Math.sqrt(s4);
  const l54 = (H[34] - l50 * l40 - l51 * l41 - l52 * l42 - l53 * l43) * d4;
  const s5 = H[35] - l50 * l50 - l51 * l51 - l52 * l52 - l53 * l53 - l54 * l54;
  if (!(s5 > 0)) return false;
  const d5 = 1 / Math.sqrt(s5);
  const y0 = g[0] * d0;
  const y1 = (g[1] - l10 * y0) * d1;
  const y2 = (g[2] - l20 * y0 - l21 * y1) * d2;
  const y3 = (g[3] - l30 * y0 - l31 * y1 - l32 * y2) * d3;
  const y4 = (g[4] - l40 * y0 - l41 * y1 - l42 * y2 - l43 * y3) * d4;
  const y5 = (g[5] - l50 * y0 - l51 * y1 - l52 * y2 - l53 * y3 - l54 * y4) * d5;
  const x5 = y5 * d5;
  const x4 = (y4 - l54 * x5) * d4;
  const x3 = (y3 - l43 * x4 - l53 * x5) * d3;
  const x2 = (y2 - l32 * x3 - l42 * x4 - l52 * x5) * d2;
  const x1 = (y1 - l21 * x2 - l31 * x3 - l41 * x4 - l51 * x5) * d1;
  const x0 = (y0 - l10 * x1 - l20 * x2 - l30 * x3 - l40 * x4 - l50 * x5) * d0;
  x[0] = x0;
  x[1] = x1;
  x[2] = x2;
  x[3] = x3;
  x[4] = x4;
  x[5] = x5;
  return true;
}
