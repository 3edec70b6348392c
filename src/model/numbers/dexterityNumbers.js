/**
 * How well the arm moves here, in document units: singular values, their product and ratio, and the motion that is lost or
 * costs most.
 *
 * @import { RobotDoc } from '../document.js'
 * @import { Chain } from '../../kinematics/chain.js'
 * @import { Part } from '../../kinematics/measures/homogeneous.js'
 * @import { JacobianFrame } from './jacobianView.js'
 *
 * @typedef {object} WorstMotion
 * @property {boolean} isLost       it cannot be made at all
 * @property {number} lostFreedoms
 * @property {readonly number[] | null} along  unit vector; null where its part of the motion is nothing to speak of
 * @property {readonly number[] | null} about  likewise
 * @property {boolean} isMixed      both at once
 * @property {readonly { joint: number, share: number }[]} joints  that make it, the one that moves most first; share of 1
 *
 * @typedef {object} DexterityNumbers
 * @property {Part} part
 * @property {readonly number[]} values   singular values, falling: in the document's length where the part is linear, else pure
 * @property {number} freedoms
 * @property {number} rank
 * @property {number} lengthScale         in the document's unit
 * @property {number} manipulability      in the length's power `freedoms` where the part is linear
 * @property {number} conditionNumber
 * @property {WorstMotion | null} worst   null if the arm has no motion in this part at all
 */
import { dexterity } from '../../kinematics/dexterity.js';
import { isSlide } from '../../kinematics/limits.js';
import { ownPart } from '../../kinematics/measures/homogeneous.js';
import { lostMotion } from '../../kinematics/singularity.js';
import { axesAt, seenAlong } from './jacobianNumbers.js';
import { fromKernel } from '../units.js';

/** A part of a motion, or a joint's share of it, below this is left out when it is put in words. */
const FAINT = 0.05;

export const partOf = (/** @type {Chain} */ chain, /** @type {Part | null} */ part) => part ?? ownPart(chain);

/**
 * @param {RobotDoc} robot
 * @param {Chain} chain
 * @param {ArrayLike<number>} q
 * @param {Part} part
 * @param {JacobianFrame} frame  whose axes directions are told along
 * @param {Float64Array | null} [T_world_user]
 * @returns {DexterityNumbers}
 */
export function dexterityNumbers({ units }, chain, q, part, frame, T_world_user = null) {
  const found = dexterity(chain, q, { part });
  const { freedoms, rank, conditionNumber, lengthScale } = found;
  const values = Array.from(found.singularValues, (value) =>
    part === 'linear' ? fromKernel('length', value, units) : value,
  );
  return {
    ...{ part, values, freedoms, rank, conditionNumber },
    lengthScale: fromKernel('length', lengthScale, units),
    manipulability: rank < freedoms || freedoms === 0 ? 0 : values.slice(0, freedoms).reduce((a, b) => a * b, 1),
    worst: freedoms === 0 ? null : worstMotion(chain, q, part, axesAt(chain, q, frame, T_world_user)),
  };
}

/** @param {Chain} chain @param {ArrayLike<number>} q @param {Part} part @param {Float64Array} T  of the axes @returns {WorstMotion} */
function worstMotion(chain, q, part, T) {
  const { linear, angular, rates, gain, lostFreedoms, lengthScale: L } = lostMotion(chain, q, { part });
  const [moved, turned] = [Math.hypot(...linear) / L, Math.hypot(...angular)];
  const along = moved > FAINT ? unitOf(seenAlong(linear, T)) : null;
  const about = turned > FAINT ? unitOf(seenAlong(angular, T)) : null;
  const joints = Array.from(rates, (rate, joint) => ({
    joint,
    share: isSlide(chain.packed, joint) ? rate / L : rate,
  }))
    .filter(({ share }) => Math.abs(share) > FAINT)
    .sort((a, b) => Math.abs(b.share) - Math.abs(a.share));
  return { isLost: gain === Infinity, lostFreedoms, along, about, isMixed: along !== null && about !== null, joints };
}

/** @param {Float64Array} vector @returns {number[]} */
function unitOf(vector) {
  const length = Math.hypot(...vector);
  return Array.from(vector, (value) => value / length);
}
