/**
 * What the joints of a document's arm may do in time, and what is assumed of those that do not say it.
 * @import { JointDoc, Units } from '../document.js'
 * @import { JointLimits } from '../../motion/moves.js'
 *
 * @typedef {object} Assumption   joints: their indices, from 0; steps: theirs, from 0
 * @property {'joint-rate' | 'joint-acceleration' | 'tool-turn' | 'tool-speed' | 'tool-acceleration' | 'input' | 'call'} what
 * @property {readonly number[]} [joints]
 * @property {readonly number[]} [steps]
 */
import { isSliding, quantityOf } from '../document.js';
import { toKernel } from '../units.js';

/** What is assumed of an arm that does not say it: rad/s and m/s of its joints, and so long from rest to that rate. */
export const ASSUMED_TURN_RATE = Math.PI;
export const ASSUMED_SLIDE_RATE = 0.5;
export const ASSUMED_SPEED_UP = 0.25;

/**
 * @param {readonly JointDoc[]} joints
 * @param {Units} units
 * @returns {{ limits: JointLimits, assumed: Assumption[] }}
 */
export function limitsOf(joints, units) {
  const stated = (/** @type {JointDoc} */ joint, /** @type {'velocity' | 'acceleration' | 'jerk'} */ rate) => {
    const value = joint[rate];
    return value === undefined ? null : toKernel(quantityOf(joint, 'home'), value, units);
  };
  const rates = Float64Array.from(
    joints,
    (joint) => stated(joint, 'velocity') ?? (isSliding(joint) ? ASSUMED_SLIDE_RATE : ASSUMED_TURN_RATE),
  );
  const accelerations = Float64Array.from(
    joints,
    (joint, i) => stated(joint, 'acceleration') ?? rates[i] / ASSUMED_SPEED_UP,
  );
  const jerks = joints.map((joint) => stated(joint, 'jerk'));
  const without = (/** @type {'velocity' | 'acceleration'} */ rate) =>
    joints.flatMap((joint, i) => (joint[rate] === undefined ? [i] : []));
  const assumed = /** @type {const} */ ([
    ['joint-rate', without('velocity')],
    ['joint-acceleration', without('acceleration')],
  ]);
  return {
    limits: { rates, accelerations, ...(jerks.every((jerk) => jerk !== null) && { jerks: Float64Array.from(jerks) }) },
    assumed: assumed.filter(([, which]) => which.length > 0).map(([what, which]) => ({ what, joints: which })),
  };
}
