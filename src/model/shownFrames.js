/**
 * Which frames the scene shows, by what a person asked for: the words beside the picture say the same.
 *
 * @import { Session } from './session.js'
 */

/**
 * @param {Session} session
 * @param {number} count  of joints
 * @returns {(number | 'tool')[]}  0 is the base
 */
export function shownFrames({ frames, build, pointedCell, cell, heldJoint }, count) {
  if (build) return [build.joint, build.joint + 1];
  const row = (pointedCell ?? cell)?.joint ?? heldJoint;
  if (frames === 'none') return [];
  if (frames === 'all') return [...Array.from({ length: count + 1 }, (_, i) => i), 'tool'];
  if (frames === 'row' && row !== null) return [row, row + 1];
  return [0, 'tool'];
}
