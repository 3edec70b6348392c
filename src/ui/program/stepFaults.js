/**
 * What is marked at steps of the program: what cannot be a move, and what comes too near to something.
 *
 * @import { AppState } from '../../model/session.js'
 * @import { StepIssue } from '../../model/program/motionPlan.js'
 * @import { ProgramCheck } from '../../model/workcell/checked.js'
 */
import { memo } from '../../model/memo.js';
import { isSameQuestion, questionNow } from '../../model/program/planning.js';
import { checkNow } from '../../model/workcell/programCheck.js';
import { touchShort } from '../workcell/touchText.js';

/** @type {readonly StepIssue[]} */
const NONE = [];

const messagesOf = memo(
  (/** @type {readonly StepIssue[]} */ issues) => new Map(issues.map(({ step, message }) => [step, message])),
);

/**
 * Why a step cannot be a move, from where the program is played; nothing as long as that is being found out.
 * @param {AppState} state
 * @returns {ReadonlyMap<number, string>}
 */
export function stepFaults(state) {
  const { planning } = state.session;
  const isKnown = planning !== null && isSameQuestion(planning.question, questionNow(state));
  return messagesOf(isKnown ? planning.issues : NONE);
}

const wordsOf = memo(
  (/** @type {ProgramCheck | null} */ check) =>
    new Map((check?.touches ?? []).map((touch) => [touch.step, touchShort(touch)])),
);

/** @param {AppState} state @returns {ReadonlyMap<number, string>} */
export const stepTouchWords = (state) => wordsOf(checkNow(state));
