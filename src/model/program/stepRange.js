/**
 * Steps that are chosen together, one after another: from the one where the choice was begun to the one that is chosen
 * now. `session.stepRange` holds for as long as its `to` is that one, and both are there.
 *
 * @import { AppState } from '../session.js'
 */
import { shownProgram } from './shownProgram.js';

/**
 * The steps that are chosen, by index.
 * @param {Pick<AppState, 'doc' | 'session'>} state
 * @returns {{ first: number, count: number } | null}  null: none is
 */
export function chosenSteps({ doc, session }) {
  const { program, step } = shownProgram({ doc, session });
  if (!program || step < 0) return null;
  const { stepRange } = session;
  const other = stepRange?.to === session.step ? program.steps.findIndex(({ id }) => id === stepRange?.from) : step;
  if (other < 0) return { first: step, count: 1 };
  return { first: Math.min(step, other), count: Math.abs(step - other) + 1 };
}

/**
 * The session's change by which a step is chosen with all from where the choice was begun.
 * @param {Pick<AppState, 'doc' | 'session'>} state
 * @param {string} to  its id
 * @returns {Pick<AppState['session'], 'step' | 'stepRange'>}
 */
export function extendedTo({ session }, to) {
  const { step, stepRange } = session;
  const from = (stepRange?.to === step ? stepRange?.from : step) ?? to;
  return { step: to, stepRange: from === to ? null : { from, to } };
}
