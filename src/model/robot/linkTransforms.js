/**
 * A_i, the transform that one row of the table makes: in numbers, and in symbols as the books print it.
 *
 *   standard   A_i = Rz(θ_i) · Tz(d_i) · Tx(a_i) · Rx(α_i)
 *   modified   A_i = Rx(α_i) · Tx(a_i) · Rz(θ_i) · Tz(d_i), where a and α stand in the row that the page calls i (Craig's i − 1)
 *
 * @import { Chain } from '../../kinematics/chain.js'
 * @import { Convention } from '../document.js'
 *
 * @typedef {object} LinkRow  of a posture: the joint value is in θ or d
 * @property {number} theta  radians
 * @property {number} d      metres
 * @property {number} a
 * @property {number} alpha
 */
import { exactCosine, exactSine } from '../../kinematics/angles.js';

/**
 * @param {Chain} chain
 * @param {ArrayLike<number>} q
 * @returns {LinkRow[]}
 */
export const linkRows = ({ joints }, q) =>
  joints.map(({ type, theta, d, a, alpha }, i) =>
    type === 'prismatic' ? { theta, d: d + q[i], a, alpha } : { theta: theta + q[i], d, a, alpha },
  );

/**
 * @param {Convention} convention
 * @param {LinkRow} row
 * @returns {Float64Array} column-major, metres
 */
export function linkTransform(convention, { theta, d, a, alpha }) {
  const [c, s, ca, sa] = [exactCosine(theta), exactSine(theta), exactCosine(alpha), exactSine(alpha)];
  const columns =
    convention === 'standard'
      ? [c, s, 0, 0, -s * ca, c * ca, sa, 0, s * sa, -c * sa, ca, 0, a * c, a * s, d, 1]
      : [c, s * ca, s * sa, 0, -s, c * ca, c * sa, 0, 0, -sa, ca, 0, a, -d * sa, d * ca, 1];
  return Float64Array.from(columns, (value) => value + 0);
}

/** Row by row, with c and s for cosine and sine. @type {Record<Convention, readonly (readonly string[])[]>} */
export const LINK_SYMBOLS = {
  standard: [
    ['cθ', '−sθ cα', 'sθ sα', 'a cθ'],
    ['sθ', 'cθ cα', '−cθ sα', 'a sθ'],
    ['0', 'sα', 'cα', 'd'],
    ['0', '0', '0', '1'],
  ],
  modified: [
    ['cθ', '−sθ', '0', 'a'],
    ['sθ cα', 'cθ cα', '−sα', '−d sα'],
    ['sθ sα', 'cθ sα', 'cα', 'd cα'],
    ['0', '0', '0', '1'],
  ],
};

/** The four motions, in the order of the product. @type {Record<Convention, readonly ['theta' | 'd' | 'a' | 'alpha', string][]>} */
export const LINK_MOTIONS = {
  standard: [
    ['theta', 'Rz'],
    ['d', 'Tz'],
    ['a', 'Tx'],
    ['alpha', 'Rx'],
  ],
  modified: [
    ['alpha', 'Rx'],
    ['a', 'Tx'],
    ['theta', 'Rz'],
    ['d', 'Tz'],
  ],
};
