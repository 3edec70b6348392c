/**
 * The axes that the tool is dragged along and turned about.
 *
 * @import { Chain } from '../../kinematics/chain.js'
 *
 * @typedef {'world' | 'base' | 'tool' | 'user'} HandleAxes
 *
 * @typedef {object} Handle
 * @property {boolean | null} isShown  null: as the screen has room for it
 * @property {HandleAxes} axes
 * @property {boolean} snaps   moves and turns in whole steps
 * @property {number} across   the axis across the plane in which arrow keys move the tool
 */
import { identity } from '../../kinematics/pose.js';
import { roundStep } from '../roundStep.js';
import { toRadians } from '../units.js';

/** @type {Handle} */
export const FIRST_HANDLE = { isShown: null, axes: 'base', snaps: false, across: 2 };

/** Of its characteristic length, what a step of the tool is about: 10 mm for an arm that reaches a metre. */
const STEP_SHARE = 1 / 50;
const TURN_STEP = toRadians(5);

/**
 * The steps of a drag that snaps, and of a key: round ones, small and large as the arm is.
 * @param {Pick<Chain, 'characteristicLength'>} chain
 * @returns {{ metres: number, radians: number }}
 */
export const handleStep = ({ characteristicLength }) => ({
  metres: roundStep(characteristicLength * STEP_SHARE).step,
  radians: TURN_STEP,
});

/**
 * The pose whose axes they are; where it is does not matter.
 * @param {HandleAxes} axes
 * @param {Pick<Chain, 'base'>} chain
 * @param {Float64Array} T_world_tcp
 * @param {Float64Array | null} [T_world_user]  a frame that a person has defined; the base if there is none
 * @returns {Float64Array} column-major
 */
export function poseOfAxes(axes, chain, T_world_tcp, T_world_user = null) {
  if (axes === 'world') return identity();
  if (axes === 'tool') return T_world_tcp;
  return (axes === 'user' && T_world_user) || chain.base;
}
