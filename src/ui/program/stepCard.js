/**
 * All that the chosen step says, to be edited; below the table. Its elements stay for as long as the step is the same one, of
 * the same kind.
 *
 * @import { Page } from '../page.js'
 * @import { Reasons } from '../parts/reasons.js'
 * @import { Doc, Ending, MoveStep, SpeedUnit, StepDoc } from '../../model/document.js'
 * @import { MotionCommand, NewStep } from '../../model/program/motionCommands.js'
 * @import { IconName } from '../parts/icons.js'
 *
 * @typedef {'go' | 'again' | 'up' | 'down' | 'duplicate' | 'disable' | 'remove'} StepAct
 */
import { JOINT_LAWS, STEP_LAWS } from '../../model/documentRules.js';
import { isMove } from '../../model/program/motionProgram.js';
import { firstManner } from '../../model/program/newSteps.js';
import '../css/robotDetails.css';
import { fill, h } from '../parts/dom.js';
import { unitSign } from '../parts/format.js';
import { icon } from '../parts/icons.js';
import { createStepFields } from './stepFields.js';
import { speedUnitText, stepIcon, targetText } from './stepText.js';
import { targetFields, targetNumbers } from './targetFields.js';
import { PROGRAM } from '../words/program.js';

/**
 * @param {Page} page
 * @param {Reasons} reasons
 * @param {(act: StepAct) => void} act
 */
export function createStepCard(page, reasons, act) {
  const { store } = page;
  const { field: words } = PROGRAM;
  const element = h('section', { class: 'step-card', hidden: true });
  /** @type {{ program: number, step: number } | null} */
  let at = null;
  let shape = '';
  /** Of the target, and of what an arc goes through, folded away at first. */
  const numbers = { isOpen: false };
  const viaNumbers = { isOpen: false };

  let fields = createStepFields(page, reasons, changed);

  const docNow = () => store.state.doc;
  const now = () => /** @type {StepDoc} */ (docNow().motionPrograms[at?.program ?? 0].steps[at?.step ?? 0]);

  /** @param {object} change @returns {MotionCommand} */
  function changed(change) {
    const { program, step } = at ?? { program: 0, step: 0 };
    return { type: 'edit-step', program, step, to: /** @type {NewStep} */ ({ ...now(), ...change }) };
  }

  /** @returns {MoveStep} */
  const move = () => /** @type {MoveStep} */ (now());
  const within = () => ({ doc: docNow(), step: move() });

  /** @param {MoveStep} step @param {Doc} doc */
  function moveFields(step, doc) {
    const { units } = doc.robot;
    const manner = (/** @type {'joint' | 'linear'} */ kind) => {
      const { speed, speedUnit } = firstManner(doc, kind);
      const { law } = move();
      const isLost = kind !== 'joint' && law !== undefined && !STEP_LAWS.includes(law);
      return { kind, speed, speedUnit, ...(isLost && { law: undefined }) };
    };
    const isJoint = step.kind === 'joint';
    const unit = (/** @type {SpeedUnit} */ name) => speedUnitText(name, units);
    const turn = { 'length/s': unit('length/s'), 'angle/s': unit('angle/s') };
    const value = () => ('value' in move().ending ? /** @type {{ value: number }} */ (move().ending).value : 0);
    const ending = (/** @type {string} */ kind) =>
      /** @type {{ ending: Ending }} */ ({
        ending:
          kind === 'fine'
            ? { kind }
            : { kind, value: kind === 'percent' ? Math.min(100, value() || 50) : value() || 10 },
      });
    return [
      h(
        'div',
        { class: 'captioned-row' },
        fields.number(
          words.speed,
          () => move().speed,
          (speed) => ({ speed }),
          () => (isJoint ? '%' : ''),
        ),
        isJoint
          ? fields.choice(
              words.kind,
              { joint: PROGRAM.kind.joint, linear: PROGRAM.kind.linear },
              () => move().kind,
              () => manner('linear'),
            )
          : fields.choice(
              words.unit,
              turn,
              () => move().speedUnit,
              (speedUnit) => ({ speedUnit }),
            ),
        fields.number(
          words.acceleration,
          () => move().acceleration,
          (acceleration) => ({ acceleration }),
          () => '%',
        ),
        fields.choice(words.ending, PROGRAM.endings, () => move().ending.kind, ending),
        step.ending.kind !== 'fine' &&
          fields.number(
            words.value,
            value,
            (typed) => ({ ending: { ...move().ending, value: typed } }),
            () => (move().ending.kind === 'percent' ? '%' : unitSign(units.length)),
          ),
        fields.choice(
          words.law,
          Object.fromEntries(
            ['', ...(isJoint ? JOINT_LAWS : STEP_LAWS)].map((law) => [
              law,
              PROGRAM.laws[/** @type {keyof typeof PROGRAM.laws} */ (law)],
            ]),
          ),
          () => move().law ?? '',
          (law) => ({ law: law || undefined }),
        ),
        targetFields(fields, step, doc, within),
        step.kind === 'linear' &&
          fields.choice(
            words.kind,
            { joint: PROGRAM.kind.joint, linear: PROGRAM.kind.linear },
            () => move().kind,
            () => manner('joint'),
          ),
      ),
      targetNumbers(fields, step, doc, within, viaNumbers, 'via'),
      targetNumbers(fields, step, doc, within, numbers),
    ];
  }

  /** @param {StepDoc} step @param {Doc} doc */
  function fieldsOf(step, doc) {
    const signal = () =>
      fields.choice(
        words.signal,
        PROGRAM.on,
        () => /** @type {{ value: string }} */ (/** @type {unknown} */ (now())).value,
        (value) => ({ value }),
      );
    /** @param {'seconds' | 'output' | 'input'} name */
    const number = (name) =>
      fields.number(
        words[name],
        () => /** @type {Record<string, number>} */ (/** @type {unknown} */ (now()))[name],
        (value) => ({ [name]: value }),
        () => (name === 'seconds' ? 's' : ''),
      );
    const row = (/** @type {HTMLElement[]} */ ...fields) => h('div', { class: 'captioned-row' }, fields);
    const text = (/** @type {'label' | 'text' | 'program'} */ name, /** @type {string} */ label) =>
      fields.text(
        label,
        () => /** @type {Record<string, string>} */ (/** @type {unknown} */ (now()))[name],
        (value) => ({ [name]: value }),
        'is-wide',
      );
    if (isMove(step)) return moveFields(step, doc);
    if (step.kind === 'wait') return [row(number('seconds'))];
    if (step.kind === 'set-output') return [row(number('output'), signal())];
    if (step.kind === 'wait-input') return [row(number('input'), signal())];
    if (step.kind === 'label') return [row(text('label', words.label))];
    if (step.kind === 'comment') return [row(text('text', words.text))];
    const known = Object.fromEntries(doc.motionPrograms.map(({ id, name }) => [id, name]));
    return [
      row(
        Object.hasOwn(known, step.program)
          ? fields.choice(
              words.call,
              known,
              () => ('program' in now() ? step.program : ''),
              (program) => ({ program }),
            )
          : text('program', words.call),
      ),
    ];
  }

  /** @param {StepDoc} step @param {number} number  from 1 */
  function head(step, number) {
    const isOff = step.disabled === true;
    /** @param {StepAct} name @param {string} label @param {IconName} picture */
    const button = (name, label, picture) => {
      const control = h(
        'button',
        {
          type: 'button',
          class: 'btn btn-icon',
          'data-action': name,
          'aria-label': PROGRAM.actOn(label, number),
          title: label,
        },
        icon(picture),
      );
      control.addEventListener('click', () => act(name));
      return control;
    };
    const go = h('button', { type: 'button', class: 'btn btn-outline', 'data-action': 'go' }, PROGRAM.goThere);
    go.addEventListener('click', () => act('go'));
    const { act: names } = PROGRAM;
    return h(
      'div',
      { class: 'step-card-head' },
      stepIcon(step.kind),
      h('h2', {}, PROGRAM.card(number)),
      h('span', { class: 'soft sm step-card-kind' }, PROGRAM.kindOf[step.kind]),
      h('span', { class: 'grow' }),
      isMove(step) && go,
      isMove(step) && button('again', names.again, 'record'),
      button('duplicate', names.duplicate, 'copy'),
      button('disable', isOff ? names.enable : names.disable, isOff ? 'check' : 'slash'),
      button('remove', names.remove, 'trash'),
    );
  }

  /** @param {StepDoc} step @param {Doc} doc */
  function details(step, doc) {
    if (!isMove(step)) return null;
    const { target, frame } = step;
    const facts = [
      frame !== undefined && PROGRAM.frame(frame),
      target.kind === 'pose' && target.configuration !== undefined && PROGRAM.configuration(target.configuration),
      target.kind !== 'target' && targetText(doc, target),
    ];
    return h('p', { class: 'soft sm step-facts' }, facts.filter(Boolean).join(' · '));
  }

  return {
    element,
    /** @param {Doc} doc @param {number} program @param {number} step  −1: none */
    draw(doc, program, step) {
      const chosen = doc.motionPrograms[program]?.steps[step];
      element.hidden = chosen === undefined;
      if (!chosen) {
        shape = '';
        at = null;
        return;
      }
      at = { program, step };
      const { length, angle } = doc.robot.units;
      const key = isMove(chosen) ? [chosen.ending.kind, chosen.target.kind, chosen.via?.kind, chosen.frame] : [];
      const ids = [...doc.targets, ...doc.frames, ...doc.motionPrograms].map(({ id }) => id);
      const called = chosen.kind === 'call' && chosen.program;
      const wanted = [
        chosen.id,
        chosen.kind,
        step,
        program,
        chosen.disabled,
        length,
        angle,
        called,
        doc.robot.joints.map(({ type }) => type).join(),
        ...key,
        ...ids,
      ].join();
      if (wanted !== shape) {
        shape = wanted;
        redraw(chosen, doc);
      }
      fields.refresh();
    },
    forget: () => fields.forget(),
  };

  /** @param {StepDoc} step @param {Doc} doc */
  function redraw(step, doc) {
    const had = document.activeElement instanceof HTMLElement && element.contains(document.activeElement);
    const action = had ? /** @type {HTMLElement} */ (document.activeElement).dataset.action : null;
    fields = createStepFields(page, reasons, changed);
    element.setAttribute('aria-label', PROGRAM.card((at?.step ?? 0) + 1));
    const comment =
      step.kind === 'comment'
        ? null
        : fields.text(
            words.comment,
            () => /** @type {{ comment?: string }} */ (now()).comment ?? '',
            (text) => ({ comment: text || undefined }),
            'is-wide',
          );
    fill(element, head(step, (at?.step ?? 0) + 1), details(step, doc), fieldsOf(step, doc), comment);
    if (!action) return;
    const again = [...element.querySelectorAll('[data-action]')].find(
      (one) => one instanceof HTMLElement && one.dataset.action === action,
    );
    if (again instanceof HTMLElement) again.focus();
  }
}
