/**
 * What is done to motion programs as a whole: every move changed, and who uses what.
 *
 * @import { Doc, MotionProgramDoc, MoveStep, StepDoc, StepTarget } from '../document.js'
 */
import { issue, shown } from '../refusalParts.js';

/** @param {StepDoc} step @returns {step is MoveStep} */
export const isMove = (step) => step.kind === 'joint' || step.kind === 'linear' || step.kind === 'circular';

/**
 * The programs with every move another, as `change` makes it of the old one; the very same list where none is.
 * @param {readonly MotionProgramDoc[]} programs
 * @param {(move: MoveStep) => MoveStep} change
 */
export function withMoves(programs, change) {
  let isSame = true;
  const next = programs.map((program) => {
    const steps = program.steps.map((step) => (isMove(step) ? change(step) : step));
    if (steps.every((step, i) => step === program.steps[i])) return program;
    isSame = false;
    return { ...program, steps };
  });
  return isSame ? programs : next;
}

/**
 * A move with each of its targets another; the very same where none is.
 * @param {MoveStep} move
 * @param {(target: StepTarget) => StepTarget} change
 * @returns {MoveStep}
 */
export function withTargets(move, change) {
  const target = change(move.target);
  const via = move.via && change(move.via);
  return target === move.target && via === move.via ? move : { ...move, target, ...(via && { via }) };
}

/**
 * Every posture in the programs, as a change of the joints changes it.
 * @param {readonly MotionProgramDoc[]} programs
 * @param {(q: readonly number[]) => readonly number[]} values
 */
export const withPostures = (programs, values) =>
  withMoves(programs, (move) =>
    withTargets(move, (target) => (target.kind === 'posture' ? { ...target, values: values(target.values) } : target)),
  );

/**
 * The first step that says of `uses` that it uses something, in words: 'step 3 of "Main"'; null where none does.
 * @param {Pick<Doc, 'motionPrograms'>} doc
 * @param {(step: StepDoc) => boolean} uses
 * @returns {string | null}
 */
export function usersIn({ motionPrograms }, uses) {
  const found = motionPrograms.flatMap(({ name, steps }) => {
    const numbers = steps.flatMap((step, i) => (uses(step) ? [i + 1] : []));
    return numbers.length === 0 ? [] : [`step ${listed(numbers)} of ${shown(name)}`];
  });
  return found.length === 0 ? null : found.join(', ');
}

const MOST_NAMED = 5;

/** @param {number[]} numbers */
const listed = (numbers) => numbers.slice(0, MOST_NAMED).join(', ') + (numbers.length > MOST_NAMED ? ', …' : '');

/** Why something cannot go: steps use it. @param {string} path @param {string} what @param {string} users */
export const inUse = (path, what, users) => issue('in-use', path, `${what} is used by ${users}; it stays while it is.`);

/** Whether a move goes to, or past, a named target. @param {string} id */
export const goesTo = (id) => (/** @type {StepDoc} */ step) =>
  isMove(step) && [step.target, step.via].some((target) => target?.kind === 'target' && target.id === id);

/** Whether a move names a user frame or a tool. @param {string} id */
export const isIn = (id) => (/** @type {StepDoc} */ step) => isMove(step) && (step.tool === id || step.frame === id);
