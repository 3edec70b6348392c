/**
 * How the Jacobian changes with the posture, which follows from the Jacobian itself. Moving joint k carries every later axis
 * along and moves the TCP away from the earlier ones, so that with column i of J as (v_i, ω_i)
 *
 *   ∂v_i/∂q_k = ω_k × v_i and ∂ω_i/∂q_k = ω_k × ω_i  for k ≤ i,     ∂v_i/∂q_k = ω_i × v_k and ∂ω_i/∂q_k = 0  for k > i
 *
 * (the kinematic Hessian; Hourtash 2005, Haviland & Corke 2020). For slides ω is 0 and nothing else changes; in homogeneous
 * scale (homogeneous.js) it holds as it stands.
 */

/**
 * The gradient of uᵀ J(q) v over the joint values, u and v held: for a pair of singular vectors, that of the singular value.
 * @param {Float64Array} J  6 · n
 * @param {Float64Array} u  6
 * @param {Float64Array} V  the vector v is n of its numbers
 * @param {number} at       from here on
 * @param {Float64Array} out  n, filled
 */
export function writeMotionDerivative(J, u, V, at, out) {
  const n = out.length;
  // Σ v_i v_i and Σ v_i ω_i over i ≥ k, and Σ v_i ω_i over i < k
  let ax = 0;
  let ay = 0;
  let az = 0;
  let bx = 0;
  let by = 0;
  let bz = 0;
  for (let i = 0, from = 0; i < n; i++, from += 6) {
    const weight = V[at + i];
    ax += weight * J[from];
    ay += weight * J[from + 1];
    az += weight * J[from + 2];
    bx += weight * J[from + 3];
    by += weight * J[from + 4];
    bz += weight * J[from + 5];
  }
  let cx = 0;
  let cy = 0;
  let cz = 0;
  const [ux, uy, uz, mx, my, mz] = u;
  for (let k = 0, from = 0; k < n; k++, from += 6) {
    const weight = V[at + k];
    const vx = J[from];
    const vy = J[from + 1];
    const vz = J[from + 2];
    const wx = J[from + 3];
    const wy = J[from + 4];
    const wz = J[from + 5];
    out[k] =
      ux * (wy * az - wz * ay + cy * vz - cz * vy) +
      uy * (wz * ax - wx * az + cz * vx - cx * vz) +
      uz * (wx * ay - wy * ax + cx * vy - cy * vx) +
      mx * (wy * bz - wz * by) +
      my * (wz * bx - wx * bz) +
      mz * (wx * by - wy * bx);
    ax -= weight * vx;
    ay -= weight * vy;
    az -= weight * vz;
    bx -= weight * wx;
    by -= weight * wy;
    bz -= weight * wz;
    cx += weight * wx;
    cy += weight * wy;
    cz += weight * wz;
  }
}
