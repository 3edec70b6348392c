/**
 * The ellipsoid at the tool, as it is drawn: which velocities joint rates of norm 1 rad/s make, or which forces joint torques
 * of norm 1 N·m hold. The scale is the arm's own and does not change with the posture, so that pictures can be compared.
 *
 * @import { Chain } from '../../kinematics/chain.js'
 *
 * @typedef {'velocity' | 'force'} EllipsoidKind
 *
 * @typedef {object} DrawnEllipsoid
 * @property {EllipsoidKind} kind
 * @property {Float64Array} center       metres
 * @property {Float64Array} axes         3 · 3, column-major
 * @property {readonly number[]} halves  m/s or N, along the axes; Infinity where any force is held
 * @property {readonly number[]} drawn   metres, along the axes
 * @property {number} scale              metres drawn for 1 m/s or 1 N
 * @property {boolean} isCut             drawn shorter than it is along one axis or more
 */
import { forceEllipsoid, velocityEllipsoid } from '../../kinematics/dexterity.js';

/** Metres drawn for 1 m/s. */
const VELOCITY_SCALE = 0.2;

/** No longer than this many characteristic lengths is drawn to either side: what goes on is cut, and the page says so. */
const LONGEST = 1.5;

/** 1, 2 or 5 times a power of ten, the nearest below. @param {number} value */
function roundDown(value) {
  const power = 10 ** Math.floor(Math.log10(value) + 1e-9);
  const factor = [5, 2].find((step) => step * power <= value) ?? 1;
  return Number((factor * power).toPrecision(1));
}

/** Metres drawn for 1 m/s or 1 N. @param {Chain} chain @param {EllipsoidKind} kind */
export const ellipsoidScale = ({ characteristicLength: L }, kind) =>
  kind === 'velocity' ? VELOCITY_SCALE : roundDown(2 * VELOCITY_SCALE * L ** 2);

/**
 * @param {Chain} chain
 * @param {ArrayLike<number>} q
 * @param {EllipsoidKind} kind
 * @returns {DrawnEllipsoid}
 */
export function ellipsoidAt(chain, q, kind) {
  const { center, axes, halfLengths } = (kind === 'velocity' ? velocityEllipsoid : forceEllipsoid)(chain, q);
  const halves = Array.from(halfLengths);
  const scale = ellipsoidScale(chain, kind);
  const most = LONGEST * chain.characteristicLength;
  return {
    ...{ kind, center, axes, halves, scale },
    drawn: halves.map((half) => Math.min(most, half * scale)),
    isCut: halves.some((half) => half * scale > most),
  };
}
