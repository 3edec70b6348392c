/**
 * How well an arm moves here: measures on the singular values of its Jacobian in homogeneous scale (homogeneous.js says what
 * is divided by what).
 *
 * @import { Chain } from './chain.js'
 * @import { Decomposition, Part, PartOptions } from './measures/homogeneous.js'
 *
 * @typedef {object} Dexterity
 * @property {Part} part  of the Jacobian that was measured
 * @property {number} lengthScale  metres
 * @property {Float64Array} singularValues  min(rows, n), falling; metres for the linear part, else pure numbers
 * @property {number} freedoms  independent motions in general, r
 * @property {number} rank      independent motions here; singular if less than `freedoms`
 * @property {number} manipulability  σ_1 · … · σ_r (Yoshikawa 1985). With r = 6, or 3 in a part, it is √det(J Jᵀ); with r = n
 *   it is √det(JᵀJ): how large the patch of twists is that joint rates of norm 1 fill in the n directions that the arm has
 *   here, saying nothing of those it never has. m^r for the linear part
 * @property {number} conditionNumber  σ_1 / σ_r, from 1 to Infinity
 * @property {number} isotropy  its inverse, from 0 to 1
 *
 * @typedef {object} Ellipsoid
 * @property {Part} part
 * @property {number} lengthScale  metres
 * @property {Float64Array} center  the TCP in base axes, metres
 * @property {Float64Array} axes  3 · 3, column-major: unit directions in base axes, right-handed
 * @property {Float64Array} halfLengths  3, along the axes; Infinity where any force can be held
 * @property {number} rank  how many half lengths of the velocity ellipsoid are not 0: 3 a body, 2 a disc, 1 a line, 0 a point
 * @property {boolean} isDegenerate  whether that is fewer than 3
 */
import { singularValuesOf } from './measures/homogeneous.js';
import { tcpPose } from './forward.js';
import { geometricJacobian } from './jacobian.js';

/**
 * @param {Chain} chain
 * @param {ArrayLike<number>} q
 * @param {PartOptions} [options]
 * @returns {Dexterity}
 */
export function dexterity(chain, q, options = {}) {
  const { part, lengthScale, singularValues, freedoms, rank } = decomposeAt(chain, q, options);
  let manipulability = 1;
  for (let i = 0; i < freedoms; i++) manipulability *= singularValues[i];
  if (freedoms === 0) manipulability = 0;
  const isRegular = freedoms > 0 && rank >= freedoms;
  return {
    part,
    lengthScale,
    singularValues,
    freedoms,
    rank,
    manipulability,
    conditionNumber: isRegular ? singularValues[0] / singularValues[freedoms - 1] : Infinity,
    isotropy: isRegular ? singularValues[freedoms - 1] / singularValues[0] : 0,
  };
}

/** @param {Chain} chain @param {ArrayLike<number>} q @param {PartOptions} options @returns {Decomposition} */
const decomposeAt = (chain, q, options) => singularValuesOf(chain, geometricJacobian(chain, q), options);

/**
 * The velocities of the TCP, in m/s, or angular velocities, in rad/s, that joint rates of norm 1 rad/s make; the rate ḋ of a
 * slide counts as ḋ / L.
 * @param {Chain} chain
 * @param {ArrayLike<number>} q
 * @param {{ part?: 'linear' | 'angular', lengthScale?: number }} [options]  the linear part by default
 * @returns {Ellipsoid}
 */
export function velocityEllipsoid(chain, q, { part = 'linear', lengthScale } = {}) {
  if (part !== 'linear' && part !== 'angular') {
    throw new RangeError(`Expected the part to be 'linear' or 'angular', got '${part}'.`);
  }
  const { singularValues, rank, U: axes, lengthScale: L } = decomposeAt(chain, q, { part, lengthScale });
  if (handedness(axes) < 0) for (let i = 6; i < 9; i++) axes[i] = -axes[i];
  return {
    part,
    lengthScale: L,
    center: tcpPose(chain, q).slice(12, 15),
    axes,
    halfLengths: Float64Array.from({ length: 3 }, (_, i) => (i < rank ? singularValues[i] : 0)),
    rank,
    isDegenerate: rank < 3,
  };
}

/**
 * The forces that the TCP can hold, in N, or moments, in N·m, with joint torques of norm 1 N·m, the force F of a slide
 * counting as the torque F · L. Its half lengths are the reciprocals of the velocity ellipsoid's, along the same axes
 * (Yoshikawa 1985): where an arm moves least it holds most. Along an axis that cannot be moved along, the links hold
 * whatever comes: that half length is Infinity, and not for drawing.
 * @param {Chain} chain
 * @param {ArrayLike<number>} q
 * @param {{ part?: 'linear' | 'angular', lengthScale?: number }} [options]
 * @returns {Ellipsoid}
 */
export function forceEllipsoid(chain, q, options) {
  const ofVelocity = velocityEllipsoid(chain, q, options);
  return { ...ofVelocity, halfLengths: ofVelocity.halfLengths.map((half) => (half === 0 ? Infinity : 1 / half)) };
}

/** The determinant of three unit columns at right angles: 1 or −1. @param {Float64Array} R  3 · 3 */
const handedness = (R) =>
  R[0] * (R[4] * R[8] - R[5] * R[7]) + R[1] * (R[5] * R[6] - R[3] * R[8]) + R[2] * (R[3] * R[7] - R[4] * R[6]);
