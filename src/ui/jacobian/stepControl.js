/**
 * Which quotient, and with which step: a slider over powers of ten, and a field that takes any step.
 *
 * @import { Page } from '../page.js'
 * @import { JacobianView } from '../../model/numbers/jacobianView.js'
 */
import { STEP_LIMITS, defaultStep, stepOf } from '../../model/numbers/jacobianNumbers.js';
import { PLOTTED } from '../../model/numbers/quotients.js';
import { h } from '../parts/dom.js';
import { readNumber } from '../parts/numberText.js';
import { createReasons } from '../parts/reasons.js';
import { stepText } from '../parts/scientific.js';
import { segments } from '../parts/segments.js';
import { JACOBIAN } from '../words/jacobian.js';

/** Of the slider, in powers of ten. */
const NOTCH = 1 / PLOTTED.perDecade;

/** @param {Page} page */
export function createStepControl({ store }) {
  const view = () => store.state.session.jacobian;
  /** @param {Partial<JacobianView>} change */
  const choose = (change) => store.dispatch({ type: 'show', change: { jacobian: { ...view(), ...change } } });
  const reasons = createReasons('jacobian-step-reason');

  const method = segments(JACOBIAN.method.label, ['forward', 'central'], JACOBIAN.method, (value) =>
    choose({ method: value, step: null }),
  );
  const quotient = segments(JACOBIAN.quotient.label, ['poses', 'kernel'], JACOBIAN.quotient, (value) =>
    choose({ quotient: value }),
  );
  const formula = h('span', { class: 'formula' });
  const quotientNote = h('p', { class: 'soft sm' });
  const slider = h('input', {
    type: 'range',
    min: PLOTTED.least,
    max: PLOTTED.most,
    step: NOTCH,
    'aria-label': JACOBIAN.stepSlider,
  });
  const track = h('span', { class: 'track' }, h('span', { class: 'home', 'aria-hidden': 'true' }), slider);
  const field = h('input', {
    type: 'text',
    inputmode: 'text',
    autocomplete: 'off',
    spellcheck: 'false',
    'aria-label': JACOBIAN.stepField,
  });
  const reset = h('button', { type: 'button', class: 'btn btn-small btn-outline' });
  const why = h('p', { class: 'soft sm' });

  slider.addEventListener('input', () => choose({ step: Number((10 ** Number(slider.value)).toPrecision(2)) }));
  field.addEventListener('change', () => {
    const { value, reason } = readNumber(field.value);
    const { least, most } = STEP_LIMITS;
    const fault =
      reason ?? (value >= least && value <= most ? null : JACOBIAN.stepRange(stepText(least), stepText(most)));
    reasons.set(field, fault);
    field.setAttribute('aria-invalid', String(fault !== null));
    if (fault === null && value !== null) choose({ step: value });
    draw(view());
  });
  reset.addEventListener('click', () => {
    choose({ step: null });
    slider.focus(); // the button is about to go
  });

  /** @param {JacobianView} now */
  function draw(now) {
    const step = stepOf(now);
    const own = defaultStep(now.method);
    method.draw(now.method);
    quotient.draw(now.quotient);
    formula.textContent = JACOBIAN.formula[now.method];
    quotientNote.textContent = JACOBIAN.quotient[now.quotient === 'poses' ? 'posesNote' : 'kernelNote'];
    const exponent = Math.log10(step);
    const share = (/** @type {number} */ x) => (x - PLOTTED.least) / (PLOTTED.most - PLOTTED.least);
    slider.value = String(exponent);
    slider.setAttribute('aria-valuetext', JACOBIAN.stepValue(stepText(step)));
    track.style.setProperty('--a', '0');
    track.style.setProperty('--b', String(Math.min(1, Math.max(0, share(exponent)))));
    track.style.setProperty('--h', String(share(Math.log10(own))));
    if (field.getAttribute('aria-invalid') !== 'true') field.value = stepText(step);
    reset.hidden = step === own;
    reset.textContent = JACOBIAN.toDefault(stepText(own));
    why.textContent = `${JACOBIAN.isDefault(stepText(own))}. ${JACOBIAN.defaultWhy[now.method]}`;
  }

  return {
    element: h(
      'div',
      { class: 'step-control' },
      h('div', { class: 'row-flex wrap' }, method.element, formula),
      h('div', { class: 'row-flex wrap' }, quotient.element),
      quotientNote,
      h(
        'div',
        { class: 'step-row' },
        h('span', {}, JACOBIAN.step),
        track,
        h('label', { class: 'field' }, field, h('span', { class: 'unit' }, 'rad')),
      ),
      reasons.element,
      h('div', { class: 'row-flex wrap' }, why, reset),
    ),
    draw,
    /** A step that was refused is let go. */
    forget() {
      reasons.set(field, null);
      field.setAttribute('aria-invalid', 'false');
    },
  };
}
