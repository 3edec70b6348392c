/**
 * Which frames the scene shows, by what a person asked for: the words beside the picture say the same.
 *
 * @import { Doc } from '../document.js'
 * @import { Session } from '../session.js'
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

/**
 * User frames are drawn wherever any frame is, but not over a row that is being built up.
 * @param {Pick<Doc, 'frames'>} doc
 * @param {Pick<Session, 'frames' | 'build'>} session
 */
export const shownUserFrames = ({ frames }, session) =>
  session.frames === 'none' || session.build ? [] : frames.filter(({ kind }) => kind === 'user');
