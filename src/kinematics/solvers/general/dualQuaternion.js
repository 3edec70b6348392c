/**
 * Rigid motions as unit dual quaternions, eight numbers: (w, x, y, z) of the rotation, then (w, x, y, z) of the dual part, half
 * the translation times the rotation. A line with unit direction a and moment p × a is (0, a, 0, p × a), and the turn by θ
 * about it is cos(θ/2) + sin(θ/2) · line. A slide along a direction v is 1 + (way/2) · (0, 0, 0, v), the same form with a line
 * at infinity (Study 1903; Husty & Schröcker 2012). Flat arrays with offsets: a thing stands at `a[i] … a[i + 7]`.
 *
 * @import { Screws } from '../../screws.js'
 */
import { compose, invert } from '../../pose.js';

/** The numbers of one dual quaternion. */
export const DQ = 8;

/**
 * out[k …] = a[i …] · b[j …]. `out` must not be one of the factors.
 * @param {Float64Array} a
 * @param {number} i
 * @param {Float64Array} b
 * @param {number} j
 * @param {Float64Array} out
 * @param {number} k
 */
export function multiply(a, i, b, j, out, k) {
  const p = a[i];
  const q = a[i + 1];
  const r = a[i + 2];
  const s = a[i + 3];
  const P = a[i + 4];
  const Q = a[i + 5];
  const R = a[i + 6];
  const S = a[i + 7];
  const t = b[j];
  const u = b[j + 1];
  const v = b[j + 2];
  const w = b[j + 3];
  const T = b[j + 4];
  const U = b[j + 5];
  const V = b[j + 6];
  const W = b[j + 7];
  out[k] = p * t - q * u - r * v - s * w;
  out[k + 1] = p * u + q * t + r * w - s * v;
  out[k + 2] = p * v - q * w + r * t + s * u;
  out[k + 3] = p * w + q * v - r * u + s * t;
  out[k + 4] = p * T - q * U - r * V - s * W + P * t - Q * u - R * v - S * w;
  out[k + 5] = p * U + q * T + r * W - s * V + P * u + Q * t + R * w - S * v;
  out[k + 6] = p * V - q * W + r * T + s * U + P * v - Q * w + R * t + S * u;
  out[k + 7] = p * W + q * V - r * U + s * T + P * w + Q * v - R * u + S * t;
}

/**
 * out[k …] = the inverse motion of the unit a[i …].
 * @param {Float64Array} a
 * @param {number} i
 * @param {Float64Array} out
 * @param {number} k
 */
export function conjugate(a, i, out, k) {
  for (let m = 0; m < DQ; m++) out[k + m] = m === 0 || m === 4 ? a[i + m] : -a[i + m];
}

/**
 * out[k …] = c + s · line[i …], the motion of one joint with half-angle cosine and sine (c, s); for a slide (1, way/2).
 * @param {Float64Array} line
 * @param {number} i
 * @param {number} c
 * @param {number} s
 * @param {Float64Array} out
 * @param {number} k
 */
export function turn(line, i, c, s, out, k) {
  for (let m = 0; m < DQ; m++) out[k + m] = s * line[i + m];
  out[k] += c;
}

/**
 * The lines of an arm, one after another, lengths in units of its characteristic length.
 * @param {Screws} screws
 * @returns {Float64Array} 8 · n
 */
export function linesOf({ dof, slides, axes, points, length }) {
  const lines = new Float64Array(DQ * dof);
  for (let i = 0; i < dof; i++) {
    const [x, y, z] = axes.subarray(3 * i, 3 * i + 3);
    const [u, v, w] = points.subarray(3 * i, 3 * i + 3).map((value) => value / length);
    const moment = [v * z - w * y, w * x - u * z, u * y - v * x];
    lines.set(slides[i] ? [0, 0, 0, 0, 0, x, y, z] : [0, x, y, z, 0, ...moment], DQ * i);
  }
  return lines;
}

const motion = new Float64Array(16);
const before = new Float64Array(DQ);
const single = new Float64Array(DQ);
const toHome = new Float64Array(16);

/**
 * The motion that takes the tool from its home to a goal, T_start_goal · home⁻¹, with its orientation made exactly rigid.
 * Shepperd's choice of the largest component (1978), as in pose.js.
 * @param {Screws} screws
 * @param {ArrayLike<number>} T_start_goal
 * @param {Float64Array} out 8 numbers
 */
export function writeGoalMotion({ home, length }, T_start_goal, out) {
  const T = compose(T_start_goal, invert(home, toHome), motion);
  const squares = [1 + T[0] + T[5] + T[10], 1 + T[0] - T[5] - T[10], 1 - T[0] + T[5] - T[10], 1 - T[0] - T[5] + T[10]];
  const largest = squares.indexOf(Math.max(...squares));
  const [x, y, z] = [T[6] - T[9], T[8] - T[2], T[1] - T[4]];
  const [xy, yz, zx] = [T[1] + T[4], T[6] + T[9], T[2] + T[8]];
  const row = [
    [squares[0], x, y, z],
    [x, squares[1], xy, zx],
    [y, xy, squares[2], yz],
    [z, zx, yz, squares[3]],
  ][largest];
  const size = Math.hypot(...row);
  const [w, i, j, k] = row.map((value) => value / size);
  const [u, v, t] = [T[12], T[13], T[14]].map((value) => value / (2 * length));
  out.set([w, i, j, k, -u * i - v * j - t * k, u * w + v * k - t * j, -u * k + v * w + t * i, u * j - v * i + t * w]);
}

/**
 * What the joints do together: E_1(q_1) · E_2(q_2) · … .
 * @param {{ lines: Float64Array, slides: readonly boolean[] }} arm
 * @param {ArrayLike<number>} q  radians and arm lengths
 * @param {Float64Array} out 8 numbers
 */
export function loopProduct({ lines, slides }, q, out) {
  out.set([1, 0, 0, 0, 0, 0, 0, 0]);
  slides.forEach((slide, i) => {
    before.set(out);
    turn(lines, DQ * i, slide ? 1 : Math.cos(q[i] / 2), slide ? q[i] / 2 : Math.sin(q[i] / 2), single, 0);
    multiply(before, 0, single, 0, out, 0);
  });
}
