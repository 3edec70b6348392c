/**
 * Motion programs: lists of moves and of what is done between them, in no controller's language, in the document's units. A
 * step keeps what a controller's statement carries (speed, acceleration, how it ends, tool, user frame), so that code can be
 * written from it.
 *
 * @import { Doc, PoseDoc, TargetDoc } from './document.js'
 *
 * @typedef {{ readonly kind: 'posture', readonly values: readonly number[] }} PostureTarget
 * @typedef {{ readonly kind: 'target', readonly id: string }} NamedTarget   one of the document's targets
 * @typedef {PoseDoc & { readonly kind: 'pose', readonly configuration?: string }} PoseTarget  in the step's user frame, or the world
 * @typedef {PostureTarget | NamedTarget | PoseTarget} StepTarget
 *
 * @typedef {{ readonly kind: 'fine' } | { readonly kind: 'percent' | 'distance', readonly value: number }} Ending
 *   fine: it stops there; else the corner is rounded, by a share or from that far away on
 *
 * @typedef {'trapezoid' | 'doubleS' | 'cubic' | 'quintic'} StepLaw
 * @typedef {'%' | 'length/s' | 'angle/s'} SpeedUnit  of the joint rates; of the tool's way; of its turn
 *
 * @typedef {object} MoveDoc
 * @property {string} id           unique in its program
 * @property {'joint' | 'linear' | 'circular'} kind
 * @property {StepTarget} target
 * @property {StepTarget} [via]    of a circular move, and only of it
 * @property {number} speed        of a joint move in %, of the others per second
 * @property {SpeedUnit} speedUnit
 * @property {number} acceleration  %
 * @property {Ending} ending
 * @property {StepLaw} [law]
 * @property {string} [tool]       the id of a tool in the document; absent: the active one
 * @property {string} [frame]      the id of a user frame that its poses are given in; absent: the world
 * @property {string} [comment]
 * @property {boolean} [disabled]
 *
 * @typedef {{ readonly id: string, readonly comment?: string, readonly disabled?: boolean }} Anything
 * @typedef {Anything & { readonly kind: 'wait', readonly seconds: number }} WaitDoc
 * @typedef {Anything & { readonly kind: 'set-output', readonly output: number, readonly value: Signal }} OutputDoc
 * @typedef {Anything & { readonly kind: 'wait-input', readonly input: number, readonly value: Signal }} InputDoc
 * @typedef {Anything & { readonly kind: 'call', readonly program: string }} CallDoc  by id: one of these programs, or one that only the controller has
 * @typedef {Anything & { readonly kind: 'label', readonly label: string }} LabelDoc
 * @typedef {{ readonly id: string, readonly kind: 'comment', readonly text: string, readonly disabled?: boolean }} CommentDoc
 * @typedef {'on' | 'off'} Signal
 *
 * @typedef {Readonly<MoveDoc>} MoveStep
 * @typedef {MoveStep | WaitDoc | OutputDoc | InputDoc | CallDoc | LabelDoc | CommentDoc} StepDoc
 * @typedef {StepDoc['kind']} StepKind
 * @typedef {{ readonly id: string, readonly name: string, readonly steps: readonly StepDoc[] }} MotionProgramDoc
 */

import { issue } from './refusalParts.js';

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
    return numbers.length === 0 ? [] : [`step ${listed(numbers)} of "${name}"`];
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
