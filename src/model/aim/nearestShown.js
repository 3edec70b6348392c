/**
 * The posture that is as near to a target as any was found, while the arm stands elsewhere: what "go as near as found" would
 * do, to be seen before it is done. Not while the tool is dragged, which has a wish of its own.
 *
 * @import { AppState } from '../session.js'
 */
import { isAtAnswer } from './aim.js';

/** @param {AppState} state @returns {readonly number[] | null} in document units */
export function nearestShown({ doc, session: { drag, target, answer } }) {
  if (!target || !answer || answer.isMet || drag || isAtAnswer(answer, doc.posture)) return null;
  return answer.posture;
}
