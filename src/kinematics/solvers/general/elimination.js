/**
 * From six joints to one, by dual quaternions. In the closed loop, two joints a and b and a hidden one h are set against the
 * other three, d, e and f, in one of the orders (the goal is one more factor, wherever the loop is cut)
 *
 *   a h b · d e f = 1     a b · h d e f = 1     a b · d e f h = 1
 *
 * All that can stand in front of the dot, inverted, fills for a given angle of h only four of the eight dimensions of dual
 * quaternions: those of C, B C, C A and B C A, with A and B the lines of a and b, and C what is between them, inverted. So four
 * linear forms vanish on it (the spaces of Husty, Pfurner & Schröcker 2007). What stands behind has degree one in the
 * tangents x, y, z of half the angles of d, e and f; slides are no different. Dixon's determinant eliminates these
 * (dixon.js). The forms, once scaled by the volume that the four vectors span, have minors of degree 2 in the cosine and
 * sine of the angle θ of h, and so has Dixon's matrix D in each of the orders: five values say everything about it. And
 *
 *   det D(θ) = m(θ)⁴ r(θ),   m the mutual moment of the lines a and b, a constant if h is not between them,
 *
 * with r of degree 8, for at most sixteen solutions (Primrose 1986). That the power of m is the fourth was found by
 * experiment, and shows in every pose: r comes from 32 values of the determinant by least squares with the weights m⁴, and
 * what does not fit measures the noise. Compared with the 24 × 24 eigenvalue problem of Raghavan & Roth (1990, 1993)
 * nothing has to be inverted, no half turn is at infinity, and it takes microseconds.
 *
 * Of no use where a and b are in one plane (whatever h does between them), or where D is singular throughout, as for other
 * special arms; then another choice of joints may do.
 *
 * @import { CircleFit } from './circleFit.js'
 * @import { Order } from './restOfLoop.js'
 *
 * @typedef {object} Elimination
 * @property {Order} order
 * @property {Int8Array} joints   a, h, b, d, e, f, from 0
 * @property {number} hidden      h
 * @property {boolean} isCut      the goal is between a and b: the forms change with it
 * @property {Float64Array} forms   4 · 8, or 5 · 4 · 8 at five angles of h if it is between
 * @property {CircleFit} fit
 */
import { fitCircle, sampleAngle, SAMPLES } from './circleFit.js';
import { COUNT } from './circleRoots.js';
import { COEFFICIENTS, EQUATIONS, SIZE, writeDeterminant, writeDixonMatrix } from './dixon.js';
import { DQ, turn } from './dualQuaternion.js';
import { products, setGoal, withFactor, writeFactor, writeProducts } from './restOfLoop.js';
import { mutualMoment, writeForms } from './skewPair.js';

const ENTRIES = SIZE * SIZE;
const FORMS = EQUATIONS * DQ;

/** Values that a matrix of degree 2 is known by. */
const KNOTS = 5;

/**
 * What the noise in the values is surely below: so many times the mean misfit, and this share of what rounding could do at most,
 * which counts where D is singular throughout and all values are noise, even if it fits. With constant weights the highest
 * harmonics, which make the misfit, have less than their share of noise: at 12,000 solutions of 16 arms the polynomial was
 * off from zero by up to 180 times the misfit or 6e-15, and, with weights, by up to 1.2 times or 4e-14.
 */
const DOUBT = { even: { misfit: 1000, pivot: 2e-14 }, weighted: { misfit: 300, pivot: 1e-14 } };

/** Minors smaller than this, beside what they could be, are rounding. */
const CANCELLED = 1e-12;

/** Of the largest coefficient: rounding in what comes after. */
const ROUNDING = 2e-15;

/** Moments less than this (arm lengths) are none. */
const COPLANAR = 1e-9;

/** Off the right angles, as in circleFit.js. @param {number} k */
const knotAngle = (k) => 0.2917 + (k * 2 * Math.PI) / KNOTS;

/** @param {Float64Array} lines @param {number} h @param {number} angle @returns {Float64Array} the turn of h back by an angle */
function turnedBack(lines, h, angle) {
  const C = new Float64Array(DQ);
  turn(lines, DQ * h, Math.cos(angle / 2), -Math.sin(angle / 2), C, 0);
  return C;
}

/**
 * @param {Float64Array} lines  8 · 6
 * @param {readonly boolean[]} slides
 * @param {Order} order
 * @param {number} first  joint a, from 0; at most 3 if h is between
 * @param {CircleFit} evenFit  with all weights 1
 * @returns {Elimination | null} null if this choice is of no use
 */
export function prepareElimination(lines, slides, order, first, evenFit) {
  const places = { between: [0, 1, 2, 3, 4, 5], before: [0, 2, 1, 3, 4, 5], after: [0, 5, 1, 2, 3, 4] }[order];
  const joints = Int8Array.from(places, (place) => (first + place) % 6);
  const [, hidden] = joints;
  if (slides[hidden]) return null;
  const unit = Float64Array.of(1, 0, 0, 0, 0, 0, 0, 0);
  const isCut = order !== 'between' && first === 5;
  if (order !== 'between') {
    const forms = new Float64Array(FORMS);
    if (isCut) return { order, joints, hidden, isCut, forms, fit: evenFit };
    if (Math.abs(mutualMoment(lines, joints, unit)) < COPLANAR) return null;
    return writeForms(lines, joints, unit, forms) ? { order, joints, hidden, isCut, forms, fit: evenFit } : null;
  }
  const moments = Float64Array.from({ length: SAMPLES }, (_, k) =>
    mutualMoment(lines, joints, turnedBack(lines, hidden, sampleAngle(k))),
  );
  const most = moments.reduce((largest, moment) => Math.max(largest, Math.abs(moment)), 0);
  if (most < COPLANAR) return null;
  const fit = fitCircle(moments.map((moment) => (moment / most) ** 4));
  if (!fit) return null;
  const forms = new Float64Array(KNOTS * FORMS);
  for (let k = 0; k < KNOTS; k++) {
    const part = forms.subarray(FORMS * k, FORMS * (k + 1));
    if (!writeForms(lines, joints, turnedBack(lines, hidden, knotAngle(k)), part)) return null;
  }
  return { order, joints, hidden, isCut, forms, fit };
}

/** Dixon's matrix of the pose under way, harmonic by harmonic. */
const harmonics = new Float64Array(KNOTS * ENTRIES);

const M = new Float64Array(EQUATIONS * COEFFICIENTS);
const D = new Float64Array(ENTRIES);
const values = new Float64Array(SAMPLES);
const pair = new Float64Array(2);
const coefficients = new Float64Array(COUNT);
const nothing = { coefficients, noise: 0, size: 0 };
const held = new Float64Array(DQ);

/** 1, cos θ, sin θ, cos 2θ, sin 2θ at the knots, as shares of a value there in the harmonics. */
const SHARES = Float64Array.from({ length: KNOTS * KNOTS }, (_, i) => {
  const [knot, k] = [Math.floor(i / KNOTS), i % KNOTS];
  const angle = Math.ceil(k / 2) * knotAngle(knot);
  return k === 0 ? 1 / KNOTS : ((k % 2 ? Math.cos(angle) : Math.sin(angle)) * 2) / KNOTS;
});

/**
 * Dixon's matrix, its largest entry scaled to 1.
 * @param {Elimination} elimination
 * @param {Float64Array} lines
 * @returns {boolean} false if there is nothing but rounding in it
 */
function writeHarmonics(elimination, lines) {
  const { order, forms } = elimination;
  let most = 0;
  harmonics.fill(0);
  for (let knot = 0; knot < KNOTS; knot++) {
    const from = order === 'between' ? FORMS * knot : 0;
    if (order !== 'between') writeFactor(elimination, lines, knotAngle(knot));
    let longest = 0;
    for (let m = 0; m < COEFFICIENTS; m++) {
      withFactor(order, products, DQ * m, held);
      longest = Math.max(longest, squareOf(held, 0));
      for (let row = 0; row < EQUATIONS; row++) {
        const at = from + DQ * row;
        let sum = 0;
        for (let k = 0; k < DQ; k++) sum += forms[at + k] * held[k];
        M[COEFFICIENTS * row + m] = sum;
      }
    }
    // Three forms are unit, and four of the products are multiplied with them: no minor is larger.
    most = Math.max(most, Math.sqrt(squareOf(forms, from + (EQUATIONS - 1) * DQ)) * longest * longest);
    writeDixonMatrix(M, D);
    for (let k = 0; k < KNOTS; k++) {
      const share = SHARES[KNOTS * knot + k];
      for (let i = 0; i < ENTRIES; i++) harmonics[ENTRIES * k + i] += share * D[i];
    }
  }
  let largest = 0;
  for (let i = 0; i < harmonics.length; i++) largest = Math.max(largest, Math.abs(harmonics[i]));
  if (!(largest > CANCELLED * most)) return false;
  for (let i = 0; i < harmonics.length; i++) harmonics[i] /= largest;
  return true;
}

/** @param {Float64Array} a @param {number} i @returns {number} the square of the length of a[i] … a[i + 7] */
function squareOf(a, i) {
  let square = 0;
  for (let k = i; k < i + DQ; k++) square += a[k] * a[k];
  return square;
}

/**
 * Dixon's matrix of the pose under way.
 * @param {number} angle  of the hidden joint
 * @param {Float64Array} out  6 × 6, row by row
 */
export function writeMatrixAt(angle, out) {
  const c = Math.cos(angle);
  const s = Math.sin(angle);
  const c2 = c * c - s * s;
  const s2 = 2 * c * s;
  for (let i = 0; i < ENTRIES; i++) {
    out[i] =
      harmonics[i] +
      c * harmonics[ENTRIES + i] +
      s * harmonics[2 * ENTRIES + i] +
      c2 * harmonics[3 * ENTRIES + i] +
      s2 * harmonics[4 * ENTRIES + i];
  }
}

/**
 * The polynomial in the angle of the hidden joint.
 * @param {Elimination} elimination
 * @param {Float64Array} lines
 * @param {Float64Array} goal
 * @returns {{ coefficients: Float64Array, noise: number, size: number }} the largest coefficient, and by how much the
 *   polynomial may be wrong; the coefficients are overwritten by the next call
 */
export function eliminate(elimination, lines, goal) {
  const { order, joints, forms, fit, isCut } = elimination;
  setGoal(goal);
  if (isCut && !writeForms(lines, joints, goal, forms)) return nothing;
  writeProducts(elimination, lines);
  if (!writeHarmonics(elimination, lines)) return nothing;
  let scale = 0;
  for (let k = 0; k < SAMPLES; k++) {
    writeMatrixAt(sampleAngle(k), D);
    writeDeterminant(D, pair);
    values[k] = pair[0];
    scale += pair[1] * pair[1];
  }
  let size = 0;
  for (let j = 0; j < COUNT; j++) {
    let sum = 0;
    for (let k = 0; k < SAMPLES; k++) sum += fit.inverse[SAMPLES * j + k] * values[k];
    coefficients[j] = sum;
    size = Math.max(size, Math.abs(sum));
  }
  let squares = 0;
  for (let k = 0; k < SAMPLES; k++) {
    let over = values[k];
    for (let j = 0; j < COUNT; j++) over -= fit.design[COUNT * k + j] * coefficients[j];
    squares += over * over;
  }
  const { misfit, pivot } = DOUBT[order === 'between' ? 'weighted' : 'even'];
  const doubt = misfit * Math.sqrt(squares / (SAMPLES - COUNT)) + pivot * Math.sqrt(scale / SAMPLES);
  const noise = fit.spread * doubt + ROUNDING * size;
  return { coefficients, noise, size };
}
