/**
 * The other five joints, once the hidden one is known (elimination.js): x, y and z from the null vectors of Dixon's matrix, then the two
 * neighbours of the hidden joint.
 *
 * The vectors are outer products, (1, y) ⊗ (1, z, z²) on the right and (1, y) ⊗ (1, x, x²) on the left. Two solutions that
 * share the hidden angle make the matrix lose two ranks, and the outer products have to be found in a plane of vectors.
 *
 * @import { Elimination } from './elimination.js'
 * @import { Loop } from './loopClosure.js'
 */
import { solveCholesky } from '../../cholesky.js';
import { factorise, nullVector } from './completePivoting.js';
import { SIZE } from './dixon.js';
import { DQ, multiply } from './dualQuaternion.js';
import { writeMatrixAt } from './elimination.js';
import { writeBetween, writeRest } from './restOfLoop.js';

/** A fifth pivot smaller than this, over the first: perhaps two solutions. */
const DOUBTFUL_PIVOT = 1e-5;

/** A slide farther than this many arm lengths is at infinity. */
const FARTHEST = 1e6;

const D = new Float64Array(SIZE * SIZE);
const LU = new Float64Array(SIZE * SIZE);
const v = new Float64Array(SIZE);
const w = new Float64Array(SIZE);

/**
 * @typedef {object} Tangents   cosine and sine, of any common length, of half the angles
 * @property {number} c  of e, the unknown y
 * @property {number} s
 * @property {number} c2  of f or d, the unknown z or x
 * @property {number} s2
 */

/** (1, y) ⊗ (1, t, t²), the larger parts of it. @param {ArrayLike<number>} u @returns {Tangents} */
function tangentsOf(u) {
  let k = 0;
  for (let i = 1; i < 3; i++) if (Math.abs(u[i]) + Math.abs(u[i + 3]) > Math.abs(u[k]) + Math.abs(u[k + 3])) k = i;
  const row = Math.abs(u[0]) + Math.abs(u[2]) >= Math.abs(u[3]) + Math.abs(u[5]) ? 0 : 3;
  const [c2, s2] = Math.abs(u[row]) >= Math.abs(u[row + 2]) ? [u[row], u[row + 1]] : [u[row + 1], u[row + 2]];
  return { c: u[k], s: u[k + 3], c2, s2 };
}

/**
 * @param {Float64Array} A  6 × 6, overwritten
 * @returns {Tangents[]}
 */
function tangentsFrom(A) {
  factorise(A);
  nullVector(A, 5, 5, v);
  const found = [tangentsOf(v)];
  if (Math.abs(A[28]) > DOUBTFUL_PIVOT * Math.abs(A[0])) return found;
  nullVector(A, 4, 4, v);
  nullVector(A, 4, 5, w);
  // v + t w is an outer product: the 2 × 2 minors vanish; the one with the largest coefficients is taken
  let best = [0, 0, 0];
  for (const [i, j] of [
    [0, 1],
    [0, 2],
    [1, 2],
  ]) {
    const minor = [
      v[i] * v[j + 3] - v[j] * v[i + 3],
      v[i] * w[j + 3] + w[i] * v[j + 3] - v[j] * w[i + 3] - w[j] * v[i + 3],
      w[i] * w[j + 3] - w[j] * w[i + 3],
    ];
    if (Math.max(...minor.map(Math.abs)) > Math.max(...best.map(Math.abs))) best = minor;
  }
  const [p, q, r] = best;
  const root = Math.sqrt(Math.max(0, q * q - 4 * p * r));
  const half = -(q + (q < 0 ? -root : root)) / 2;
  // the two roots t are half / r and p / half
  for (const [above, below] of [
    [half, r],
    [p, half],
  ]) {
    if (above !== 0 || below !== 0) found.push(tangentsOf(v.map((value, k) => below * value + above * w[k])));
  }
  return found;
}

const X = new Float64Array(DQ);
const basis = new Float64Array(4 * DQ);
const gram = new Float64Array(16);
const right = new Float64Array(4);
const shares = new Float64Array(4);

/** @param {boolean} slides @param {number} c @param {number} s @returns {number} radians or arm lengths */
const valueOf = (slides, c, s) => (slides ? (2 * s) / c : 2 * Math.atan2(s, c));

/**
 * Joints a and b: with C between them, a C b is a sum of C, A C, C B and A C B with the shares 1, tan a/2, tan b/2 and their
 * product. It is the inverse of X.
 * @param {Float64Array} lines
 * @param {Int8Array} joints
 * @returns {boolean}
 */
function writeShares(lines, [a, , b]) {
  multiply(lines, DQ * a, basis, 0, basis, DQ);
  multiply(basis, 0, lines, DQ * b, basis, 2 * DQ);
  multiply(basis, DQ, lines, DQ * b, basis, 3 * DQ);
  for (let i = 0; i < 4; i++) {
    right[i] = 0;
    for (let k = 0; k < DQ; k++) right[i] += basis[DQ * i + k] * (k === 0 || k === 4 ? X[k] : -X[k]);
    for (let j = 0; j <= i; j++) {
      gram[4 * i + j] = 0;
      for (let k = 0; k < DQ; k++) gram[4 * i + j] += basis[DQ * i + k] * basis[DQ * j + k];
    }
  }
  return solveCholesky(gram, right, shares);
}

/**
 * Postures that may be solutions, for an angle of the hidden joint at which the polynomial is zero. Call it right after
 * `eliminate`.
 * @param {Elimination} elimination
 * @param {Loop} loop
 * @param {number} angle
 * @returns {Float64Array[]} radians and arm lengths
 */
export function posturesAt(elimination, { lines, slides }, angle) {
  const { joints } = elimination;
  writeMatrixAt(angle, D);
  LU.set(D);
  const onRight = tangentsFrom(LU);
  for (let i = 0; i < SIZE; i++) for (let j = 0; j < SIZE; j++) LU[SIZE * i + j] = D[SIZE * j + i];
  const onLeft = tangentsFrom(LU);
  /** @type {Float64Array[]} */
  const postures = [];
  for (const { c, s, c2: cz, s2: sz } of onRight) {
    for (const { c2: cx, s2: sx } of onLeft) {
      const shareOf = (/** @type {number} */ m) => (m & 1 ? sx : cx) * (m & 2 ? s : c) * (m & 4 ? sz : cz);
      writeRest(elimination, lines, angle, shareOf, X);
      writeBetween(elimination, lines, angle, basis);
      if (!writeShares(lines, joints)) continue;
      const [p0, p1, p2, p3] = shares;
      const isUpper = Math.abs(p0) + Math.abs(p1) >= Math.abs(p2) + Math.abs(p3);
      const isLeft = Math.abs(p0) + Math.abs(p2) >= Math.abs(p1) + Math.abs(p3);
      const q = new Float64Array(6);
      const put = (/** @type {number} */ k, /** @type {number} */ cosine, /** @type {number} */ sine) => {
        q[joints[k]] = valueOf(slides[joints[k]], cosine, sine);
      };
      put(0, isUpper ? p0 : p2, isUpper ? p1 : p3);
      q[joints[1]] = angle;
      put(2, isLeft ? p0 : p1, isLeft ? p2 : p3);
      put(3, cx, sx);
      put(4, c, s);
      put(5, cz, sz);
      if (q.every((value) => Math.abs(value) < FARTHEST)) postures.push(q);
    }
  }
  return postures;
}
