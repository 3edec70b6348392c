/**
 * What is marked at steps of the program: what cannot be a move, and what comes too near to something.
 *
 * @import { AppState } from '../../model/session.js'
 * @import { Question } from '../../model/program/planned.js'
 * @import { ProgramCheck } from '../../model/workcell/checked.js'
 */
import { memo } from '../../model/memo.js';
import { motionMoves } from '../../model/program/motionPlan.js';
import { isSameQuestion, questionNow } from '../../model/program/planning.js';
import { checkNow } from '../../model/workcell/programCheck.js';
import { touchShort } from '../workcell/touchText.js';

/** @returns {(state: AppState) => ReadonlyMap<number, string>} why a step cannot be a move, from where the program is played */
export function createStepFaults() {
  /** @type {Question | null} */
  let asked = null;
  /** @type {ReadonlyMap<number, string>} */
  let found = new Map();
  return (state) => {
    const question = questionNow(state);
    if (isSameQuestion(question, asked)) return found;
    asked = question;
    const { issues } = question ? motionMoves(question.doc, question.program, question.start) : { issues: [] };
    found = new Map(issues.map(({ step, message }) => [step, message]));
    return found;
  };
}

const wordsOf = memo(
  (/** @type {ProgramCheck | null} */ check) =>
    new Map((check?.touches ?? []).map((touch) => [touch.step, touchShort(touch)])),
);

/** @param {AppState} state @returns {ReadonlyMap<number, string>} */
export const stepTouchWords = (state) => wordsOf(checkNow(state));
