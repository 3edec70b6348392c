/**
 * A pose pasted as text: how it is understood, what target it makes, or what was expected and what came. Nothing is aimed at
 * before that is looked at.
 *
 * @import { Page } from '../page.js'
 * @import { TargetFields } from './targetFields.js'
 * @import { PoseText } from '../../io/poseText.js'
 * @import { Units } from '../../model/document.js'
 * @import { Read, Reading } from '../../model/numbers/poseReadings.js'
 */
import { readPoseText } from '../../io/poseText.js';
import { WPR } from '../../model/numbers/angleForm.js';
import { ANGLE_UNITS, LENGTH_UNITS } from '../../model/documentRules.js';
import { orientationForm } from '../../model/numbers/orientationForms.js';
import { readAs, readingsOf } from '../../model/numbers/poseReadings.js';
import { targetNumbers } from '../../model/aim/targetForm.js';
import { fill, h } from '../parts/dom.js';
import { copyable, fixed, poseNumber, unitSign } from '../parts/format.js';
import { createPoseGrid } from '../pose/poseGrid.js';
import { MATRIX, lengthInWords, matrixInWords } from './targetForms.js';
import { TARGET } from '../words/target.js';

const words = TARGET.paste;
const PURE_DECIMALS = 5;

/**
 * @param {Page} page
 * @param {TargetFields} fields
 * @param {HTMLElement} host
 * @param {() => void} onClose
 */
export function createTargetPaste(page, fields, host, onClose) {
  const { store, announce } = page;
  const { robot } = store.state.doc;
  /** @type {{ found: PoseText | null, readings: readonly Reading[], read: Read | null }} */
  const now = { found: null, readings: [], read: null };

  const text = h('textarea', {
    class: 'text-box',
    rows: 3,
    spellcheck: 'false',
    'aria-label': words.text,
    placeholder: words.hint,
  });
  const summary = h('p', { class: 'soft sm' });
  const as = h('select', { class: 'choice-box', 'aria-label': words.as });
  const length = unitSelect(words.lengths, LENGTH_UNITS);
  const angle = unitSelect(words.angles, ANGLE_UNITS);
  const choices = h('div', { class: 'paste-as', hidden: true }, as, length, angle);
  const preview = h('div', { role: 'group', 'aria-label': words.preview });
  const reason = h('p', { class: 'reason sm', role: 'status', hidden: true });
  const mend = h('button', { type: 'button', class: 'btn btn-small btn-outline', hidden: true });
  const use = h('button', { type: 'button', class: 'btn btn-outline', disabled: true }, words.use);
  const cancel = h('button', { type: 'button', class: 'btn' }, words.cancel);
  fill(host, text, summary, choices, preview, reason, mend, h('div', { class: 'actions' }, cancel, use));

  /** @param {string | null} why */
  function refuse(why) {
    reason.textContent = why ?? '';
    reason.hidden = why === null;
    use.disabled = why !== null || now.read === null;
  }

  /** The text is another: everything is guessed anew. */
  function read() {
    const { found, fault } = readPoseText(text.value);
    Object.assign(now, { found, readings: [], read: null });
    choices.hidden = !found;
    fill(preview);
    mend.hidden = true;
    summary.textContent = found ? words.found(found.numbers.length, words.format[found.format] ?? '') : '';
    if (!found) {
      refuse(fault.kind === 'empty' ? null : words.fault[fault.kind](fault));
      use.disabled = true;
      return;
    }
    now.readings = readingsOf(found.numbers, found.said, store.state.session.targetForm);
    fill(
      as,
      now.readings.map((reading) =>
        h(
          'option',
          { value: reading.id },
          reading.kind === 'form' ? words.andForm(reading.form.name) : words.reading[reading.id],
        ),
      ),
    );
    if (now.readings[0].id === 'rotation-first') summary.textContent += ` ${words.either}`;
    as.disabled = now.readings.length === 1;
    length.value = found.units.length ?? robot.units.length;
    angle.value = found.units.angle ?? robot.units.angle;
    draw();
  }

  function draw() {
    const { found } = now;
    const reading = now.readings.find(({ id }) => id === as.value);
    if (!found || !reading) return;
    angle.hidden = reading.kind !== 'form' || !reading.form.quantities.includes('angle');
    const units = /** @type {Units} */ ({ length: length.value, angle: angle.value });
    now.read = readAs(reading, found.numbers, units, robot, fields.seen());
    const { target, fault, mended } = now.read;
    fill(preview, target && targetGrid(target));
    mend.hidden = !mended;
    mend.textContent = reading.kind === 'matrix' ? TARGET.nearestRotation : TARGET.scale;
    refuse(fault ? ('of' in fault ? lengthInWords(fault) : matrixInWords(fault)) : null);
  }

  /** As the panel will show it. @param {readonly number[]} target */
  function targetGrid(target) {
    const id = store.state.session.targetForm;
    const form = id === MATRIX ? WPR : orientationForm(id);
    const { units } = robot;
    const isAngle = (/** @type {number} */ k) => form.quantities[k - 3] === 'angle';
    const grid = createPoseGrid(
      ['X', 'Y', 'Z', ...form.labels].map((label, k) => ({
        label,
        unit: k < 3 ? unitSign(units.length) : isAngle(k) ? unitSign(units.angle) : '',
      })),
    );
    grid.draw(
      targetNumbers(form, robot, target).map((value, k) =>
        k < 3
          ? poseNumber(value, units.length)
          : isAngle(k)
            ? poseNumber(value, units.angle)
            : fixed(value, PURE_DECIMALS),
      ),
    );
    return grid.element;
  }

  text.addEventListener('input', read);
  for (const control of [as, length, angle]) control.addEventListener('change', draw);
  mend.addEventListener('click', () => {
    const { found, read: last } = now;
    if (!found || !last?.mended) return;
    const [chosen, of, turn] = [as.value, length.value, angle.value];
    text.value = copyable(last.mended);
    read();
    [as.value, length.value, angle.value] = [chosen, of, turn];
    draw();
    use.focus();
  });
  cancel.addEventListener('click', onClose);
  host.addEventListener('keydown', (event) => {
    if (event.key !== 'Escape') return;
    event.stopPropagation();
    onClose();
  });
  use.addEventListener('click', () => {
    const target = now.read?.target;
    if (!target) return;
    store.dispatch(fields.aimAt(target));
    announce(words.done);
    onClose();
  });

  return {
    /** @param {string} pasted */
    open(pasted) {
      text.value = pasted.slice(0, 2 * 4000);
      read();
      text.focus();
    },
  };
}

/** @param {string} label @param {readonly string[]} units */
const unitSelect = (label, units) =>
  h(
    'select',
    { class: 'choice-box', 'aria-label': label },
    units.map((unit) => h('option', { value: unit }, unit)),
  );
