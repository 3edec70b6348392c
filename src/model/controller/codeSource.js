/**
 * What of a document can become controller code: its motion programs, its recorded postures, its targets; and what of it is
 * asked for: speeds, and the frame that positions are given in.
 *
 * @import { Doc, MotionProgramDoc, MoveStep } from '../document.js'
 *
 * @typedef {{ kind: 'program', id: string } | { kind: 'postures' } | { kind: 'targets' }} CodeSource
 */
import { titleOf } from '../../karel/write/header.js';
import { isMove, withMoves } from '../program/motionProgram.js';

/** A way that nobody has looked at needs two ends. */
const FEWEST_POSTURES = 2;

/** % of the joint rates, where nobody has said one. */
export const FIRST_SPEED = 20;

/** @param {Doc} doc @returns {CodeSource[]} in the order in which they are offered */
export function codeSources({ motionPrograms, postures, targets }) {
  return [
    ...motionPrograms
      .filter(({ steps }) => steps.some((step) => isMove(step) || step.kind === 'call'))
      .map(({ id }) => /** @type {CodeSource} */ ({ kind: 'program', id })),
    ...(postures.length >= FEWEST_POSTURES ? [/** @type {CodeSource} */ ({ kind: 'postures' })] : []),
    ...(targets.length > 0 ? [/** @type {CodeSource} */ ({ kind: 'targets' })] : []),
  ];
}

/** @param {CodeSource} source */
export const sourceKey = (source) => (source.kind === 'program' ? `program ${source.id}` : source.kind);

/** What it is called in the header. @param {Doc} doc @param {CodeSource} source */
export function sourceName({ motionPrograms }, source) {
  if (source.kind === 'postures') return 'recorded postures';
  if (source.kind === 'targets') return 'targets';
  return motionPrograms.find(({ id }) => id === source.id)?.name ?? '';
}

/**
 * The document with a program of what is asked for.
 * @param {Doc} doc
 * @param {CodeSource} source  of the document
 * @param {number} [speed]     %: of the speeds of a program, or of the joint rates where there are none
 * @returns {{ doc: Doc, program: MotionProgramDoc }}
 */
export function sourceProgram(doc, source, speed) {
  if (source.kind === 'program') {
    const share = (speed ?? 100) / 100;
    const motionPrograms =
      share === 1
        ? doc.motionPrograms
        : withMoves(doc.motionPrograms, (move) => ({ ...move, speed: move.speed * share }));
    const found = motionPrograms.find(({ id }) => id === source.id);
    if (!found) throw new RangeError(`Expected a program of the document, got "${source.id}".`);
    return { doc: { ...doc, motionPrograms }, program: found };
  }
  const steps =
    source.kind === 'postures'
      ? doc.postures.map(({ id, q }) => jointStep(doc, id, { kind: 'posture', values: q }, speed))
      : doc.targets.map(({ id }) => jointStep(doc, id, { kind: 'target', id }, speed));
  return { doc, program: { id: 'code', name: sourceName(doc, source), steps } };
}

/** @param {Doc} doc @param {string} id @param {MoveStep['target']} target @param {number} [speed] @returns {MoveStep} */
const jointStep = ({ activeTool }, id, target, speed = FIRST_SPEED) => ({
  ...{ id, kind: 'joint', target, speed, speedUnit: '%', acceleration: 100, ending: { kind: 'fine' }, comment: id },
  ...(activeTool !== undefined && { tool: activeTool }),
});

/** What code is called after where nobody has said it. @param {Doc} doc @param {CodeSource} source */
export const firstName = (doc, source) => (source.kind === 'program' ? sourceName(doc, source) : doc.robot.name);

/** What the header of a text says that it was written of; null where it is nothing of this document. @param {Doc} doc @param {string} text @returns {CodeSource | null} */
export function sourceOfText(doc, text) {
  const words = (/** @type {string} */ one) => one.replaceAll(';', ',').replace(/\s+/g, ' ');
  // Signs of comments, and the numbers of TP's lines.
  const head = words(text.replace(/^\s*(?:--|;|\d+:\s*!)/gm, ' ').replace(/;\s*$/gm, ' '));
  const found = codeSources(doc).filter((source) =>
    head.includes(words(`${titleOf({ name: sourceName(doc, source), robotName: doc.robot.name })} Written by`)),
  );
  return found[0] ?? null;
}
