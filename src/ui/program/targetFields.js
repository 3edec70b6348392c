/**
 * Where a move ends, as fields of its card: which target, with which tool and from which user frame it is seen, and, folded away,
 * its numbers. Likewise the place that an arc goes through.
 *
 * @import { StepFields } from './stepFields.js'
 * @import { Doc, JointDoc, MoveStep, PoseTarget, StepTarget } from '../../model/document.js'
 */
import { atNumbers, inFrame, poseNumbers } from '../../model/program/stepFrame.js';
import { h } from '../parts/dom.js';
import { unitSign } from '../parts/format.js';
import { targetText } from './stepText.js';
import { PROGRAM } from '../words/program.js';

const { field: words } = PROGRAM;

/** @typedef {'target' | 'via'} Part */

/** @param {MoveStep} step @param {Part} part @returns {StepTarget} */
const partOf = (step, part) => /** @type {StepTarget} */ (step[part]);

/**
 * @param {StepFields} fields
 * @param {MoveStep} step
 * @param {Doc} doc
 * @param {() => { doc: Doc, step: MoveStep }} now
 */
export function targetFields(fields, step, doc, now) {
  const ids = (/** @type {Doc['frames'][number]['kind']} */ kind) =>
    Object.fromEntries(doc.frames.filter((frame) => frame.kind === kind).map(({ id }) => [id, id]));
  const places = Object.fromEntries(doc.targets.map(({ id }) => [`target ${id}`, id]));
  const [tools, users] = [ids('tool'), ids('user')];
  /** @param {Part} part @param {string} label @param {StepTarget} target */
  const place = (part, label, target) =>
    Object.keys(places).length > 0 &&
    fields.choice(
      label,
      { '': PROGRAM.asRecorded[target.kind] || targetText(doc, target), ...places },
      () => {
        const chosen = partOf(now().step, part);
        return chosen.kind === 'target' ? `target ${targetText(now().doc, chosen)}` : '';
      },
      (chosen) => (chosen === '' ? {} : { [part]: { kind: 'target', id: chosen.slice('target '.length) } }),
    );
  return [
    step.via && place('via', words.via, step.via),
    place('target', words.target, step.target),
    Object.keys(tools).length > 0 &&
      fields.choice(
        words.tool,
        { '': PROGRAM.activeTool, ...tools },
        () => now().step.tool ?? '',
        (tool) => ({ tool: tool || undefined }),
      ),
    step.target.kind === 'pose' &&
      Object.keys(users).length > 0 &&
      fields.choice(
        words.frame,
        { '': PROGRAM.world, ...users },
        () => now().step.frame ?? '',
        (frame) => inFrame(now().doc, now().step, frame || undefined),
      ),
  ];
}

/**
 * @param {StepFields} fields
 * @param {MoveStep} step
 * @param {Doc} doc
 * @param {() => { doc: Doc, step: MoveStep }} now
 * @param {{ isOpen: boolean }} fold   kept for the next step
 * @param {Part} [part]
 * @returns {HTMLElement | null}  null: it is a target of its own, with its own fields; or there is none
 */
export function targetNumbers(fields, step, doc, now, fold, part = 'target') {
  const kind = step[part]?.kind;
  if (kind === undefined || kind === 'target') return null;
  const { joints, units } = doc.robot;
  const pose = () => /** @type {PoseTarget} */ (now().step[part]);
  /** @returns {readonly number[]} */
  const values = () => {
    const target = partOf(now().step, part);
    return target.kind === 'posture' ? target.values : poseNumbers(now().doc, pose());
  };
  const names = kind === 'posture' ? joints.map((_, i) => PROGRAM.joint(i + 1)) : PROGRAM.pose;
  const numbers = names.map((name, i) =>
    fields.number(
      PROGRAM.of[part](name),
      () => values()[i],
      (value) => {
        const next = values().with(i, value);
        return { [part]: kind === 'posture' ? { kind, values: next } : atNumbers(pose(), next) };
      },
      () => unitSign(kind === 'posture' ? unitOf(joints[i], units) : i < 3 ? units.length : units.angle),
      name,
    ),
  );
  const configuration =
    kind === 'pose' &&
    part === 'target' && // the way decides in which posture an arc is gone
    fields.text(
      words.configuration,
      () => pose().configuration ?? '',
      (text) => ({ target: { ...pose(), configuration: text || undefined } }),
      'is-wide',
    );
  const element = h(
    'details',
    { class: 'step-target' },
    h('summary', { class: 'sm' }, PROGRAM.numbers[part]),
    h('div', { class: 'captioned-row' }, numbers, configuration),
  );
  element.open = fold.isOpen;
  element.addEventListener('toggle', () => (fold.isOpen = element.open));
  return element;
}

/** @param {JointDoc} joint @param {Doc['robot']['units']} units */
const unitOf = ({ type }, units) => (type === 'prismatic' ? units.length : units.angle);
