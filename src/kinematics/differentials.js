/**
 * Between joint rates and twists, and between wrenches and joint torques. Twists and wrenches are at the TCP, linear part
 * first: [v, ω] in m/s and rad/s, [f, m] in N and N·m; in base axes, or in the tool's axes where asked for.
 *
 * @import { Chain } from './chain.js'
 * @import { Part } from './measures/homogeneous.js'
 *
 * @typedef {'base' | 'tool'} Axes  along which a twist or wrench is written; it stays at the TCP either way
 *
 * @typedef {object} RatesOptions
 * @property {Axes} [frame]   of the twist, and of the achieved one; base by default
 * @property {Part} [part]    what of the twist is to be met; by default what the arm is there for (homogeneous.js, ownPart)
 * @property {number} [damping]  λ in homogeneous scale, the same everywhere; by default as much as dampingAt gives
 * @property {number} [lengthScale]  metres; what a metre weighs against a radian where not all can be met
 *
 * @typedef {object} Rates
 * @property {Float64Array} rates  n; rad/s, m/s for slides
 * @property {Float64Array} achievedTwist  6: what the TCP does at these rates, by the undamped Jacobian
 * @property {boolean} isDamped  whether the rates were held back: then the twist is missed where the arm moves badly
 * @property {number} damping    λ
 */
import { tcpPose } from './forward.js';
import { RANK_TOLERANCE, ownPart, rowsOfPart, singularValuesOf } from './measures/homogeneous.js';
import { geometricJacobian } from './jacobian.js';
import { isSlide } from './limits.js';

/**
 * Damping begins where the smallest singular value in homogeneous scale falls below BEGIN and has its full value LARGEST at
 * the singularity itself. As both are the same, a unit twist in the worst direction is answered with rates of 1 / BEGIN = 20
 * at the edge and, in proportion to the singular value, with none at the singularity; no rates are ever larger. The
 * industrial arms of the library have 0.1 to 0.2 in half of their postures. All these numbers are free of units.
 */
const BEGIN = 0.05;
const LARGEST = 0.05;

/**
 * How much to damp where the smallest singular value is σ: λ² = (1 − (σ / BEGIN)²) · LARGEST², nothing above BEGIN. The
 * damped inverse is that of Nakamura & Hanafusa (1986) and Wampler (1986); growth with the smallest singular value
 * follows Maciejewski & Klein (1988), in the smooth form of Chiaverini, Siciliano & Egeland (1994).
 * @example
 * dampingAt(0.2) // → 0
 * dampingAt(0) // → 0.05
 * @param {number} smallest
 */
export const dampingAt = (smallest) => (smallest < BEGIN ? LARGEST * Math.sqrt(1 - (smallest / BEGIN) ** 2) : 0);

/**
 * What the TCP does at given joint rates.
 * @param {Chain} chain
 * @param {ArrayLike<number>} q
 * @param {ArrayLike<number>} rates  n; rad/s, m/s for slides
 * @param {{ frame?: Axes }} [options]
 * @returns {Float64Array} 6
 */
export function twistOf(chain, q, rates, { frame = 'base' } = {}) {
  requireNumbers('joint rates', rates, chain.dof);
  const twist = times(geometricJacobian(chain, q), rates);
  return frame === 'base' ? twist : turned(chain, q, twist, frame, 'to');
}

/**
 * The joint rates that come nearest to a twist: least squares in homogeneous scale, and the smallest such rates where there
 * is a choice; held back near singularities.
 * @param {Chain} chain
 * @param {ArrayLike<number>} q
 * @param {ArrayLike<number>} twist  6
 * @param {RatesOptions} [options]
 * @returns {Rates}
 */
export function ratesFor(chain, q, twist, { frame = 'base', part = ownPart(chain), damping, lengthScale } = {}) {
  requireNumbers('numbers in the twist', twist, 6);
  if (damping !== undefined && !(damping >= 0 && damping < Infinity)) {
    throw new RangeError(`Expected the damping to be at least 0, got ${damping}.`);
  }
  const J = geometricJacobian(chain, q);
  const { singularValues, U, V, lengthScale: L, freedoms } = singularValuesOf(chain, J, { part, lengthScale });
  const { first, rows } = rowsOfPart(part);
  const wanted = turned(chain, q, twist, frame, 'from');
  for (let i = 0; i < 3; i++) wanted[i] /= L;
  const unit = part === 'linear' ? L : 1; // those singular values are in metres
  const smallest = freedoms > 0 ? singularValues[freedoms - 1] / unit : 1;
  const lambda = damping ?? dampingAt(smallest);
  const rates = new Float64Array(chain.dof);
  for (let j = 0; j < freedoms; j++) {
    const sigma = singularValues[j] / unit;
    if (lambda === 0 && sigma <= RANK_TOLERANCE) continue; // what no rate can make is not tried
    let along = 0;
    for (let i = 0; i < rows; i++) along += U[rows * j + i] * wanted[first + i];
    const factor = (along * sigma) / (sigma * sigma + lambda * lambda);
    for (let k = 0; k < chain.dof; k++) rates[k] += factor * V[chain.dof * j + k];
  }
  for (let k = 0; k < chain.dof; k++) if (isSlide(chain.packed, k)) rates[k] *= L;
  const achieved = times(J, rates);
  return {
    rates,
    achievedTwist: frame === 'base' ? achieved : turned(chain, q, achieved, frame, 'to'),
    isDamped: lambda > 0,
    damping: lambda,
  };
}

/**
 * The joint torques, in N·m (forces, in N, for slides), with which the arm at rest applies a wrench at its TCP to whatever
 * it touches, its own weight aside: τ = Jᵀ w, from virtual work, τ · q̇ = w · twist. A wrench that the surroundings apply to
 * the arm is held by the torques of its opposite.
 * @param {Chain} chain
 * @param {ArrayLike<number>} q
 * @param {ArrayLike<number>} wrench  6
 * @param {{ frame?: Axes }} [options]
 * @returns {Float64Array} n
 */
export function staticTorques(chain, q, wrench, { frame = 'base' } = {}) {
  requireNumbers('numbers in the wrench', wrench, 6);
  const J = geometricJacobian(chain, q);
  const applied = turned(chain, q, wrench, frame, 'from');
  return Float64Array.from({ length: chain.dof }, (_, k) => {
    let torque = 0;
    for (let i = 0; i < 6; i++) torque += J[6 * k + i] * applied[i];
    return torque;
  });
}

/**
 * The same motion of a rigid body written at another of its points: v + ω × offset.
 * @example
 * Array.from(moveTwist([0, 0, 0, 0, 0, 2], [1, 0, 0])) // → [0, 2, 0, 0, 0, 2]
 * @param {ArrayLike<number>} twist
 * @param {ArrayLike<number>} offset  from the old point to the new one, metres, in the twist's axes
 * @returns {Float64Array} 6
 */
export function moveTwist(twist, offset) {
  requireNumbers('numbers in the twist', twist, 6);
  requireNumbers('numbers in the offset', offset, 3);
  const [vx, vy, vz, wx, wy, wz] = Array.from(twist);
  const [x, y, z] = Array.from(offset);
  return Float64Array.of(vx + wy * z - wz * y, vy + wz * x - wx * z, vz + wx * y - wy * x, wx, wy, wz);
}

/**
 * The same load written at another point: m − offset × f. With moveTwist it leaves the power as it is.
 * @example
 * Array.from(moveWrench([0, 0, -10, 0, 0, 0], [1, 0, 0])) // → [0, 0, -10, 0, -10, 0]
 * @param {ArrayLike<number>} wrench
 * @param {ArrayLike<number>} offset  from the old point to the new one, metres, in the wrench's axes
 * @returns {Float64Array} 6
 */
export function moveWrench(wrench, offset) {
  requireNumbers('numbers in the wrench', wrench, 6);
  requireNumbers('numbers in the offset', offset, 3);
  const [fx, fy, fz, mx, my, mz] = Array.from(wrench);
  const [x, y, z] = Array.from(offset);
  return Float64Array.of(fx, fy, fz, mx - y * fz + z * fy, my - z * fx + x * fz, mz - x * fy + y * fx);
}

/**
 * @param {string} what
 * @param {ArrayLike<number>} values
 * @param {number} count
 */
function requireNumbers(what, values, count) {
  if (values === null || typeof values !== 'object' || values.length !== count) {
    throw new RangeError(`Expected ${count} ${what}, got ${values?.length ?? typeof values}.`);
  }
  for (let i = 0; i < count; i++) {
    if (!Number.isFinite(values[i])) throw new RangeError(`Expected finite ${what}, got ${values[i]}.`);
  }
}

/** @param {Float64Array} J @param {ArrayLike<number>} rates @returns {Float64Array} 6 */
function times(J, rates) {
  const twist = new Float64Array(6);
  for (let k = 0; k < rates.length; k++) for (let i = 0; i < 6; i++) twist[i] += J[6 * k + i] * rates[k];
  return twist;
}

/**
 * A twist or wrench from the axes `frame` into the base's, or to them from the base's.
 * @param {Chain} chain
 * @param {ArrayLike<number>} q
 * @param {ArrayLike<number>} six
 * @param {Axes} frame
 * @param {'from' | 'to'} way
 * @returns {Float64Array} 6, a copy
 */
function turned(chain, q, six, frame, way) {
  if (frame !== 'base' && frame !== 'tool')
    throw new RangeError(`Expected the frame 'base' or 'tool', got '${frame}'.`);
  const out = Float64Array.from(six);
  if (frame === 'base') return out;
  const R = tcpPose(chain, q);
  for (let block = 0; block < 6; block += 3) {
    for (let i = 0; i < 3; i++) {
      out[block + i] = 0;
      for (let j = 0; j < 3; j++) out[block + i] += (way === 'from' ? R[4 * j + i] : R[4 * i + j]) * six[block + j];
    }
  }
  return out;
}
