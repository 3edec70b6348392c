/**
 * A motion program on its way into time: what was asked, how far the answer is, and the answer. An answer to another question
 * than the present one is stale: it is never played.
 *
 * A program begins where the arm stands. Once it has been played, or looked at in time, it begins where it began then; until
 * the arm is moved otherwise while it stands at the program's beginning or end.
 *
 * @import { Doc, MotionProgramDoc } from '../document.js'
 * @import { Playback } from './player.js'
 * @import { Planned, Question } from './planned.js'
 * @import { AppState } from '../session.js'
 */
import { memo } from '../memo.js';
import { firstPlayback, moveAt } from './player.js';
import { shownProgram } from './shownProgram.js';

const playbackFrom = memo(
  /**
   * @param {Playback | null} kept
   * @param {string} program
   * @param {readonly number[]} posture
   * @returns {Playback}
   */
  (kept, program, posture) => {
    if (!kept || kept.program !== program) return firstPlayback(program, posture, kept);
    const isElsewhere = !kept.isPlaying && kept.posture !== posture && (kept.time === 0 || kept.isOver);
    return isElsewhere ? firstPlayback(program, posture, kept) : kept;
  },
);

/**
 * Where in its time the program is; the same object for as long as it is the same.
 * @param {AppState} state
 * @returns {Playback | null}  null: there is no program
 */
export function playbackNow(state) {
  const { program } = shownProgram(state);
  return program && playbackFrom(state.session.playback, program.id, state.doc.posture);
}

const asked = memo(
  /** @param {Doc} doc @param {MotionProgramDoc} program @param {readonly number[]} start @returns {Question} */
  (doc, program, start) => ({ doc, program, start }),
);

/** @param {AppState} state @returns {Question | null} */
export function questionNow(state) {
  const { program } = shownProgram(state);
  const playback = playbackNow(state);
  return program && playback && asked(state.doc, program, playback.start);
}

/** What a plan does not depend on. @type {readonly (keyof Doc)[]} */
const NO_MATTER = ['posture', 'postures', 'obstacles', 'programs', 'codeOptions', 'extensions'];

/** Whether both have the same answer. @param {Question | null} one @param {Question | null} other */
export function isSameQuestion(one, other) {
  if (one === other) return true;
  if (!one || !other || one.program !== other.program) return false;
  if (one.start !== other.start && one.start.some((value, i) => value !== other.start[i])) return false;
  if (one.doc === other.doc) return true;
  const keys = /** @type {(keyof Doc)[]} */ (Object.keys({ ...one.doc, ...other.doc }));
  return keys.every((key) => one.doc[key] === other.doc[key] || NO_MATTER.includes(key));
}

/**
 * The plan, if it is of the program as it is now.
 * @param {AppState} state
 * @returns {Planned | null}
 */
export function planNow(state) {
  const { planning } = state.session;
  return planning?.planned && isSameQuestion(planning.question, questionNow(state)) ? planning.planned : null;
}

/**
 * The step that is under way, or at which the program has stopped; none before it is first played.
 * @param {AppState} state
 * @returns {number | null} its index in the program
 */
export function stepNow(state) {
  const planned = planNow(state);
  const { playback } = state.session;
  if (!planned || !playback || playbackNow(state) !== playback) return null;
  const move = moveAt(planned.plan, playback.time);
  return move === null ? null : planned.steps[move];
}
