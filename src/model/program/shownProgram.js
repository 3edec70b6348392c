/**
 * The motion program that the page shows, and the step of it that is chosen.
 * @import { MotionProgramDoc } from '../document.js'
 * @import { AppState } from '../session.js'
 */

/**
 * The one that is played or was chosen; else the first.
 * @param {Pick<AppState, 'doc' | 'session'>} state
 * @returns {{ program: MotionProgramDoc | null, index: number, step: number }}  step: −1 where none is chosen
 */
export function shownProgram({ doc: { motionPrograms }, session }) {
  const index = Math.max(
    0,
    motionPrograms.findIndex(({ id }) => id === session.playback?.program),
  );
  const program = motionPrograms[index] ?? null;
  return { program, index, step: program ? program.steps.findIndex(({ id }) => id === session.step) : -1 };
}
