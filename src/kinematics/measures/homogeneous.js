/**
 * Jacobians made comparable. Metres and radians do not add, so the singular values of a bare Jacobian change with the unit
 * of length and mean nothing (Lipkin & Duffy 1988). Here, with a stated length L:
 *
 *   the linear rows (m/s) are divided by L           a velocity v counts as the turning rate v / L
 *   the columns of slides (per m/s) are multiplied by L   a slide's rate ḋ counts as the turning rate ḋ / L
 *
 * After that every entry is a pure number, the column of a turning joint has length 1 or more and that of a slide exactly 1,
 * and an arm drawn in millimetres gets the numbers of the same arm in metres. L is the chain's characteristic length unless
 * something else is asked for; with L = 1 m the linear rows are those of the books.
 *
 * @import { Chain } from '../chain.js'
 * @import { Svd } from './singularValues.js'
 *
 * @typedef {'full' | 'linear' | 'angular'} Part  which rows of the Jacobian: all six, those of the velocity of the TCP, or
 *   those of the angular velocity
 *
 * @typedef {object} PartOptions
 * @property {Part} [part]  by default the one that ownPart gives
 * @property {number} [lengthScale]  L, metres; the chain's characteristic length by default
 *
 * @typedef {object} Decomposition
 * @property {Part} part
 * @property {number} lengthScale  metres
 * @property {number} freedoms  how many independent motions the arm has in this part, in general
 * @property {number} rank   how many it has here
 * @property {number} rows   6 or 3
 * @property {Float64Array} singularValues  min(rows, n), falling. Full and angular: pure numbers. Linear: metres, m/s at the
 *   TCP for joint rates of norm 1 rad/s, in which a slide's rate counts as ḋ / L
 * @property {Float64Array} U  rows · rows, column-major: unit directions of twist, base axes; linear entries over L if full
 * @property {Float64Array} V  n · n, column-major: unit directions of joint motion; a slide's entry over L
 */
import { requireRoom } from '../checks.js';
import { geometricJacobian } from '../jacobian.js';
import { isSlide } from '../limits.js';
import { createRandom } from '../random.js';
import { createSvd, decompose } from './singularValues.js';

/**
 * A singular value below this, relative to the largest or to 1, is nought: the roundings of a Jacobian come to some 1e-15,
 * and postures are typed with less than twelve digits or mean a singularity exactly.
 */
export const RANK_TOLERANCE = 1e-12;

/** What the rank of an arm in general is measured with, at postures taken at random; a typed table has nine digits at most. */
const GENERAL_TOLERANCE = 1e-9;
const GENERAL_POSTURES = 5;

const ALL_PARTS = /** @type {const} */ (['full', 'linear', 'angular']);
const FIRST_ROW = { full: 0, linear: 0, angular: 3 };
const ROWS = { full: 6, linear: 3, angular: 3 };

/** @param {Part} part @returns {{ first: number, rows: number }} */
export function rowsOfPart(part) {
  if (!ALL_PARTS.includes(part)) {
    throw new RangeError(`Expected the part to be 'full', 'linear' or 'angular', got '${part}'.`);
  }
  return { first: FIRST_ROW[part], rows: ROWS[part] };
}

/**
 * @param {Chain} chain
 * @param {number} [lengthScale]
 * @returns {number} metres
 */
export function checkedScale({ characteristicLength }, lengthScale = characteristicLength) {
  if (!(lengthScale > 0 && lengthScale < Infinity)) {
    throw new RangeError(`Expected a positive length scale in metres, got ${lengthScale}.`);
  }
  return lengthScale;
}

/**
 * The Jacobian J of `chain` in place: linear rows over L, columns of slides times L.
 * @param {Chain} chain
 * @param {Float64Array} J  6 · n, changed
 * @param {number} L  metres
 */
export function homogenise({ packed, dof }, J, L) {
  for (let k = 0, at = 0; k < dof; k++, at += 6) {
    if (isSlide(packed, k)) continue; // an axis over L times L, and no turning
    J[at] /= L;
    J[at + 1] /= L;
    J[at + 2] /= L;
  }
}

/** @param {ArrayLike<number>} J 6 · n @param {number} first @param {Float64Array} out rows · n */
export function selectRows(J, first, out) {
  const rows = (6 * out.length) / J.length;
  for (let at = 0, to = 0; to < out.length; at += 6, to += rows) {
    for (let i = 0; i < rows; i++) out[to + i] = J[at + first + i];
  }
}

/**
 * @param {ArrayLike<number>} values  falling, in homogeneous scale
 * @param {number} [tolerance]
 */
export function rankOf(values, tolerance = RANK_TOLERANCE) {
  const floor = tolerance * Math.max(1, values[0]);
  let rank = 0;
  while (rank < values.length && values[rank] > floor) rank++;
  return rank;
}

/** @type {WeakMap<Chain, Readonly<Record<Part, number>>>} chains are frozen, so what was found stays true */
const known = new WeakMap();

/**
 * How many independent motions an arm has, whatever the posture but for the singular ones: the rank of its Jacobian, or of
 * a part of it, at postures taken at random, limits ignored. A 6R arm has 6, a planar 3R arm 3 and 2 linear ones, and a
 * planar 4R arm has no more: a singularity is a posture with fewer than these, not fewer than joints.
 * @param {Chain} chain
 * @returns {Readonly<Record<Part, number>>}
 */
export function freedomsOf(chain) {
  const found = known.get(chain);
  if (found) return found;
  const { dof, packed, characteristicLength: L } = chain;
  const random = createRandom(1);
  const q = new Float64Array(dof);
  const J = new Float64Array(6 * dof);
  const freedoms = { full: 0, linear: 0, angular: 0 };
  for (let sample = 0; sample < GENERAL_POSTURES; sample++) {
    for (let i = 0; i < dof; i++) q[i] = (2 * random() - 1) * (isSlide(packed, i) ? L : Math.PI);
    homogenise(chain, geometricJacobian(chain, q, J), L);
    for (const part of ALL_PARTS) {
      const { first, rows } = rowsOfPart(part);
      const A = new Float64Array(rows * dof);
      selectRows(J, first, A);
      const { values } = decompose(A, createSvd(rows, dof));
      freedoms[part] = Math.max(freedoms[part], rankOf(values, GENERAL_TOLERANCE));
    }
  }
  known.set(chain, Object.freeze(freedoms));
  return freedoms;
}

/**
 * What the arm is there for. Where every joint moves the TCP independently (a planar 2R arm, an anthropomorphic 3R arm, a
 * gantry), it places a point and the orientation follows: `linear`, as in the books; its six rows taken together never
 * lose rank, stretched or not. Any other arm: `full`.
 * @param {Chain} chain
 * @returns {Part}
 */
export const ownPart = (chain) => (freedomsOf(chain).linear === chain.dof ? 'linear' : 'full');

/** Room for each number of joints: nothing here calls back. @type {{ scaled: Float64Array, svds: Record<Part, Svd> }[]} */
const rooms = [];
const roomFor = (/** @type {number} */ dof) =>
  (rooms[dof] ??= {
    scaled: new Float64Array(6 * dof),
    svds: { full: createSvd(6, dof), linear: createSvd(3, dof), angular: createSvd(3, dof) },
  });
/** @type {Float64Array[]} */
const selections = [];

/**
 * The singular value decomposition of a Jacobian of `chain` in homogeneous scale, or of a part of it.
 * @param {Chain} chain
 * @param {ArrayLike<number>} J  6 · n, linear part first, as geometricJacobian or finiteDifferenceJacobian give it
 * @param {PartOptions} [options]
 * @returns {Decomposition}
 */
export function singularValuesOf(chain, J, { part = ownPart(chain), lengthScale } = {}) {
  const L = checkedScale(chain, lengthScale);
  const { first, rows } = rowsOfPart(part);
  requireRoom(J, 6 * chain.dof);
  const { scaled, svds } = roomFor(chain.dof);
  for (let i = 0; i < scaled.length; i++) {
    if (!Number.isFinite(J[i])) throw new RangeError(`Expected a Jacobian of finite numbers, got ${J[i]}.`);
    scaled[i] = J[i];
  }
  homogenise(chain, scaled, L);
  const A = (selections[rows * chain.dof] ??= new Float64Array(rows * chain.dof));
  selectRows(scaled, first, A);
  const { values, U, V } = decompose(A, svds[part]);
  const unit = part === 'linear' ? L : 1;
  return {
    part,
    lengthScale: L,
    freedoms: freedomsOf(chain)[part],
    rank: rankOf(values),
    rows,
    singularValues: values.map((value) => value * unit),
    U: U.slice(),
    V: V.slice(),
  };
}
