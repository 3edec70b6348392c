/**
 * Whether the direction that a singularity takes is looked for: where one is in the way of a drag or of the pendant, and
 * where the arm stands as near to its target as it can.
 * @import { AppState } from '../session.js'
 */
import { isAtAnswer } from './aim.js';

/** Where a direction is lost at the place itself, or none is. */
const NEAR = ['reach', 'orientation', 'freedom'];

/** @param {AppState} state @returns {'stopped' | 'near' | null} */
export function lostWanted({ doc, session: { drag, jogEnd, answer, target } }) {
  if (drag?.hindrance) return drag.hindrance.kind === 'singularity' ? 'stopped' : 'near';
  if (jogEnd && jogEnd.posture === doc.posture) {
    if (jogEnd.why === 'singularity') return 'stopped';
    if (NEAR.includes(jogEnd.why)) return 'near';
  }
  return target && answer && !answer.isMet && isAtAnswer(answer, doc.posture) ? 'near' : null;
}
