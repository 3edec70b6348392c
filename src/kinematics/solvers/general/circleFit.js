/**
 * The trigonometric polynomial of degree 8 whose products with given weights come nearest to given values on the circle, by
 * least squares. Only the values change from pose to pose, so everything else is done once.
 *
 * @typedef {object} CircleFit
 * @property {Float64Array} design   32 · 17: the values that coefficients lead to
 * @property {Float64Array} inverse  17 · 32: the coefficients that values lead to
 * @property {number} spread  how much an error of 1 in the values can mean at any angle (root mean square)
 */
import { COUNT, DEGREE } from './circleRoots.js';

/** More values than coefficients: what is over tells the noise. */
export const SAMPLES = 32;

/** Columns that depend on one another by less than this are no basis. */
const INDEPENDENT = 1e-9;

/** Off the multiples of 45°, where special things happen. @param {number} k */
export const sampleAngle = (k) => ((k + 0.37) * 2 * Math.PI) / SAMPLES;

/** @param {number} angle @param {Float64Array} row  17, filled */
function writeHarmonics(angle, row) {
  row[0] = 1;
  for (let k = 1; k <= DEGREE; k++) row.set([Math.cos(k * angle), Math.sin(k * angle)], 2 * k - 1);
}

/**
 * @param {Float64Array} weights  at the 32 angles
 * @returns {CircleFit | null} null where the weights leave too little
 */
export function fitCircle(weights) {
  const design = new Float64Array(SAMPLES * COUNT);
  const row = new Float64Array(COUNT);
  for (let k = 0; k < SAMPLES; k++) {
    writeHarmonics(sampleAngle(k), row);
    for (let j = 0; j < COUNT; j++) design[COUNT * k + j] = weights[k] * row[j];
  }
  const inverse = pseudoInverse(design);
  if (!inverse) return null;
  let spread = 0;
  for (let k = 0; k < 2 * SAMPLES; k++) {
    writeHarmonics((Math.PI * k) / SAMPLES, row);
    let square = 0;
    for (let i = 0; i < SAMPLES; i++) {
      let sum = 0;
      for (let j = 0; j < COUNT; j++) sum += row[j] * inverse[SAMPLES * j + i];
      square += sum * sum;
    }
    spread = Math.max(spread, Math.sqrt(square));
  }
  return { design, inverse, spread };
}

/**
 * R⁻¹ Qᵀ, by Gram and Schmidt, each column made orthogonal twice.
 * @param {Float64Array} A  32 × 17, row by row
 * @returns {Float64Array | null} 17 × 32
 */
function pseudoInverse(A) {
  const Q = new Float64Array(COUNT * SAMPLES); // column by column
  const R = new Float64Array(COUNT * COUNT); // row by row
  for (let j = 0; j < COUNT; j++) {
    const v = Q.subarray(SAMPLES * j, SAMPLES * (j + 1));
    for (let k = 0; k < SAMPLES; k++) v[k] = A[COUNT * k + j];
    const whole = dot(v, v);
    for (let twice = 0; twice < 2; twice++) {
      for (let i = 0; i < j; i++) {
        const q = Q.subarray(SAMPLES * i, SAMPLES * (i + 1));
        const share = dot(q, v);
        R[COUNT * i + j] += share;
        for (let k = 0; k < SAMPLES; k++) v[k] -= share * q[k];
      }
    }
    const left = dot(v, v);
    if (!(left > INDEPENDENT * INDEPENDENT * whole)) return null;
    R[COUNT * j + j] = Math.sqrt(left);
    for (let k = 0; k < SAMPLES; k++) v[k] /= R[COUNT * j + j];
  }
  const inverse = Q.slice();
  for (let i = COUNT - 1; i >= 0; i--) {
    for (let k = 0; k < SAMPLES; k++) {
      let sum = Q[SAMPLES * i + k];
      for (let j = i + 1; j < COUNT; j++) sum -= R[COUNT * i + j] * inverse[SAMPLES * j + k];
      inverse[SAMPLES * i + k] = sum / R[COUNT * i + i];
    }
  }
  return inverse;
}

/** @param {Float64Array} a @param {Float64Array} b @returns {number} */
function dot(a, b) {
  let sum = 0;
  for (let k = 0; k < SAMPLES; k++) sum += a[k] * b[k];
  return sum;
}
