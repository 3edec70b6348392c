/**
 * A row of the table as motions: how frame i−1 becomes frame i, one elementary motion after the other, in the order of the
 * convention. Standard DH first turns and slides along the old z, then along the new x; modified DH the other way round.
 *
 * @import { Convention, DhField } from '../document.js'
 *
 * @typedef {object} Motion
 * @property {DhField} field
 * @property {boolean} turns  about the axis, rather than sliding along it
 * @property {'x' | 'z'} axis
 * @property {0 | 1} number   of the frame whose axis it is: 0 that of i−1, 1 that of i
 */

/** @param {DhField} field @param {boolean} turns @param {'x' | 'z'} axis @param {0 | 1} number @returns {Motion} */
const motion = (field, turns, axis, number) => Object.freeze({ field, turns, axis, number });

/** @type {Record<Convention, readonly Motion[]>} */
export const ROW_MOTIONS = {
  standard: [
    motion('theta', true, 'z', 0),
    motion('d', false, 'z', 0),
    motion('a', false, 'x', 1),
    motion('alpha', true, 'x', 1),
  ],
  modified: [
    motion('alpha', true, 'x', 0),
    motion('a', false, 'x', 0),
    motion('theta', true, 'z', 1),
    motion('d', false, 'z', 1),
  ],
};

/** @param {string} field @returns {field is DhField} */
export const isRowField = (field) => ROW_MOTIONS.standard.some((one) => one.field === field);

/**
 * How far a row is built up: the motion that is under way, or was the last, and how much of it is done; null before the first.
 * @param {Convention} convention
 * @param {number} at  0 … 4
 * @returns {{ motion: Motion, index: number, share: number } | null}
 */
export function motionAt(convention, at) {
  if (at <= 0) return null;
  const index = Math.min(3, Math.ceil(at) - 1);
  const share = at - index;
  return { motion: ROW_MOTIONS[convention][index], index, share: share * share * (3 - 2 * share) };
}
