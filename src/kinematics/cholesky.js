/**
 * Solve H x = g for a symmetric positive definite H by Cholesky's factorisation (Golub & Van Loan, section 4.2).
 * @param {Float64Array} H  n · n, row by row; only the lower triangle is read; overwritten
 * @param {Float64Array} g  n
 * @param {Float64Array} x  n, filled
 * @returns {boolean} false if H is not positive definite
 */
export function solveCholesky(H, g, x) {
  const n = g.length;
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
