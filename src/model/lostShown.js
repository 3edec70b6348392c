/**
 * Whether the direction that a singularity takes is looked for: where one is in a drag's way, and where the arm stands as
 * near to its target as it can.
 * @import { AppState } from './session.js'
 */
import { isAtAnswer } from './aim.js';

/** @param {AppState} state @returns {'stopped' | 'near' | null} */
export function lostWanted({ doc, session: { drag, answer, target } }) {
  if (drag?.hindrance) return drag.hindrance.kind === 'singularity' ? 'stopped' : 'near';
  return target && answer && !answer.isMet && isAtAnswer(answer, doc.posture) ? 'near' : null;
}
