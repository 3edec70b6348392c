/**
 * How the pendant moves: by steps that are chosen or typed, or for as long as a button is held, at a share of a stated rate.
 *
 * @import { Page } from '../page.js'
 * @import { JogChoices } from '../../model/jog/jogChoices.js'
 */
import { isSliding } from '../../model/document.js';
import { RATES, STEPS, STEP_RANGE } from '../../model/jog/jogChoices.js';
import { together } from '../../model/views.js';
import { h } from '../parts/dom.js';
import { editable, plain } from '../parts/format.js';
import { readNumber } from '../parts/numberText.js';
import { createReasons } from '../parts/reasons.js';
import { PENDANT } from '../words/jogPendant.js';

const KINDS = /** @type {const} */ (['step', 'turn']);

/** @param {Page} page @returns {HTMLElement} */
export function createJogRate({ store, addView }) {
  const jog = () => store.state.session.jog;
  /** @param {Partial<JogChoices>} change */
  const choose = (change) => store.dispatch({ type: 'show', change: { jog: { ...jog(), ...change } } });
  const reasons = createReasons('jog-step-reason');

  const ways = [true, false].map((isByStep) => {
    const button = h(
      'button',
      { type: 'button', title: isByStep ? PENDANT.byStepTitle : PENDANT.byHoldingTitle },
      isByStep ? PENDANT.byStep : PENDANT.byHolding,
    );
    button.addEventListener('click', () => choose({ isByStep }));
    return { isByStep, button };
  });

  const sizes = KINDS.map((kind) => {
    const buttons = STEPS[kind].map((value) => {
      const button = h('button', { type: 'button' }, plain(value));
      button.addEventListener('click', () => choose({ [kind]: value }));
      return { value, button };
    });
    const input = h('input', {
      type: 'text',
      inputmode: 'decimal',
      autocomplete: 'off',
      spellcheck: 'false',
      'aria-label': PENDANT.size[kind],
    });
    const refuse = (/** @type {string | null} */ reason) => {
      input.setAttribute('aria-invalid', String(reason !== null));
      reasons.set(input, reason);
    };
    let shown = NaN;
    const show = () => {
      shown = jog()[kind];
      input.value = editable(shown);
      refuse(null);
    };
    show();
    input.addEventListener('change', () => {
      const { value, reason } = readNumber(input.value);
      if (value === null) return refuse(reason);
      const { least, most } = STEP_RANGE[kind];
      if (!(value >= least && value <= most)) return refuse(PENDANT.sizeRange(plain(least), plain(most)));
      choose({ [kind]: value });
      show();
    });
    input.addEventListener('focus', () => input.select());
    input.addEventListener('keydown', (event) => {
      if (event.key === 'Escape') show();
    });
    const unit = h('span', { class: 'unit', 'aria-hidden': 'true' }, PENDANT.sizeUnit[kind]);
    const row = h(
      'div',
      { class: 'jog-size' },
      h(
        'div',
        { class: 'seg', role: 'group', 'aria-label': PENDANT.sizes[kind] },
        buttons.map(({ button }) => button),
      ),
      h('label', { class: 'field' }, input, unit),
    );
    /** What is being typed stays, unless another step was chosen. */
    const follow = () => {
      if (jog()[kind] !== shown) show();
    };
    return { kind, row, buttons, follow };
  });

  const slider = h('input', { type: 'range', min: 1, max: 100, step: 1, 'aria-label': PENDANT.speed });
  slider.addEventListener('input', () => choose({ percent: Number(slider.value) }));
  const percent = h('output', { class: 'jog-percent' });
  const note = h('p', { class: 'soft sm' });
  const speed = h(
    'div',
    { class: 'jog-speed' },
    h('span', { class: 'soft', 'aria-hidden': 'true' }, PENDANT.speedCaption),
    h('span', { class: 'track' }, slider),
    percent,
    note,
  );

  addView(
    together(({ doc, session }) => [session.jog, doc.robot.joints]),
    ([now, joints]) => {
      const isTool = now.mode === 'tool';
      for (const { isByStep, button } of ways) button.setAttribute('aria-pressed', String(isByStep === now.isByStep));
      for (const { kind, row, buttons, follow } of sizes) {
        const isOfUse = isTool || joints.some((joint) => isSliding(joint) === (kind === 'step'));
        row.hidden = !now.isByStep || !isOfUse;
        for (const { value, button } of buttons) button.setAttribute('aria-pressed', String(value === now[kind]));
        follow();
      }
      speed.hidden = now.isByStep;
      slider.value = String(now.percent);
      slider.setAttribute('aria-valuetext', PENDANT.speedText(now.percent));
      const share = (now.percent - 1) / 99;
      speed.style.setProperty('--a', '0');
      speed.style.setProperty('--b', String(share));
      percent.textContent = PENDANT.speedText(now.percent);
      const rate = (/** @type {number} */ full) => editable((full * now.percent) / 100);
      note.textContent = PENDANT.speedNote(rate(RATES.millimetres), rate(RATES.degrees), isTool);
    },
  );
  return h(
    'div',
    { class: 'jog-rate' },
    h(
      'div',
      { class: 'seg jog-how', role: 'group', 'aria-label': PENDANT.how },
      ways.map(({ button }) => button),
    ),
    h(
      'div',
      { class: 'jog-sizes' },
      sizes.map(({ row }) => row),
      speed,
    ),
    reasons.element,
  );
}
