/**
 * One joint in the jog panel: a slider and a number. A pull of the slider is one undo step, and Escape during it leaves
 * no trace.
 *
 * @import { Page } from './page.js'
 * @import { JointDoc, RobotDoc, Units } from '../model/document.js'
 */
import { homePosture, limitsOf } from '../model/document.js';
import { editCell } from './cellEditor.js';
import { h } from './dom.js';
import { editable, jointNumber, jointStep, unitOf, unitSign, withUnit } from './format.js';
import { newGesture } from './page.js';
import { TEXT } from './strings.js';

/** How far a slider goes where the joint has no limit: a turn either way, or two metres. */
const SLIDER_REACH = { deg: 360, rad: 2 * Math.PI, mm: 2000, cm: 200, m: 2 };

/** Arrow keys in the number step ten of its last digits, page keys a hundred. */
const KEY_STEPS = { ArrowUp: 10, ArrowDown: -10, PageUp: 100, PageDown: -100 };

/** The ends of a joint's slider, in document units. @param {JointDoc} joint @param {Units} units */
function sliderRange(joint, units) {
  const reach = SLIDER_REACH[unitOf(joint, units)];
  const { lower, upper } = limitsOf(joint);
  return {
    least: Number.isFinite(lower) ? lower : Math.min(-reach, upper),
    most: Number.isFinite(upper) ? upper : Math.max(reach, lower),
  };
}

/** @param {JointDoc} joint @param {Units} units @returns {[lower: string, upper: string]} */
export function limitsInWords(joint, units) {
  const unit = unitOf(joint, units);
  const inWords = (/** @type {number} */ value) =>
    Number.isFinite(value) ? withUnit(editable(value), unit) : TEXT.jog.noLimit;
  const { lower, upper } = limitsOf(joint);
  return [inWords(lower), inWords(upper)];
}

/** @param {JointDoc} joint @param {number} value */
export function isInside(joint, value) {
  const { lower, upper } = limitsOf(joint);
  return value >= lower && value <= upper;
}

/**
 * @param {Page} page
 * @param {RobotDoc} robot
 * @param {number} index
 * @param {object} given
 * @param {string} given.reasonId  of the element that says why a number was refused
 * @param {(input: HTMLInputElement, reason: string | null) => void} given.onReason
 */
export function createJogRow(page, { joints, units }, index, { reasonId, onReason }) {
  const { store } = page;
  const joint = joints[index];
  const unit = unitOf(joint, units);
  const { least, most } = sliderRange(joint, units);
  const now = () => store.state.doc.posture[index];
  const part = (/** @type {number} */ value) =>
    Math.min(1, Math.max(0, most > least ? (value - least) / (most - least) : 0));

  const slider = h('input', {
    type: 'range',
    min: least,
    max: most,
    step: jointStep(unit),
    'aria-label': TEXT.jog.slider(index + 1),
  });
  const field = h('input', {
    type: 'text',
    inputmode: 'text',
    autocomplete: 'off',
    spellcheck: 'false',
    'aria-label': TEXT.jog.field(index + 1, TEXT.table.unitName[unit]),
    'aria-describedby': reasonId,
  });
  const row = h(
    'div',
    { class: 'jog' },
    h('span', { class: 'name', title: TEXT.table.jointType[joint.type] }, `J${index + 1}`),
    h('span', { class: 'track' }, h('span', { class: 'home', 'aria-hidden': 'true' }), slider),
    h('label', { class: 'field' }, field, h('span', { class: 'unit' }, unitSign(unit))),
  );
  row.style.setProperty('--h', String(part(homePosture(store.state.doc.robot)[index])));

  const cell = editCell(page, field, {
    command: (value) => ({ type: 'set-joint-value', joint: index, value }),
    check: (value) => (isInside(joint, value) ? null : TEXT.jog.stops(`J${index + 1}`, ...limitsInWords(joint, units))),
    onDone: (value) => `J${index + 1}: ${withUnit(jointNumber(value, unit), unit)}`,
    onReason: (reason) => onReason(field, reason),
    text: () => editable(now()),
    resting: () => jointNumber(now(), unit),
  });
  field.addEventListener('keydown', (event) => {
    const steps = Object.entries(KEY_STEPS).find(([key]) => key === event.key)?.[1];
    if (!steps) return;
    event.preventDefault();
    const { lower, upper } = limitsOf(joint);
    cell.type(editable(Math.min(upper, Math.max(lower, now() + steps * jointStep(unit)))));
  });
  watchSlider(page, slider, index);

  return {
    row,
    forget: cell.forget,
    /** @param {number} value @param {boolean} isHeld */
    draw(value, isHeld) {
      slider.value = String(value);
      slider.setAttribute('aria-valuetext', withUnit(jointNumber(value, unit), unit));
      row.style.setProperty('--a', String(Math.min(part(0), part(value))));
      row.style.setProperty('--b', String(Math.max(part(0), part(value))));
      row.classList.toggle('on', isHeld);
      row.classList.toggle('is-outside', !isInside(joint, value));
      cell.refresh();
    },
  };
}

/** @typedef {ReturnType<typeof createJogRow>} JogRow */

/** @param {Page} page @param {HTMLInputElement} slider @param {number} index */
function watchSlider({ store }, slider, index) {
  /** @type {string | null} */
  let gesture = null;
  const hold = (/** @type {boolean} */ isHeld) =>
    store.dispatch({ type: 'show', change: { heldJoint: isHeld ? index : null } });
  slider.addEventListener('pointerdown', () => hold(true));
  slider.addEventListener('input', () => {
    gesture ??= newGesture();
    hold(true);
    store.dispatch({ type: 'set-joint-value', joint: index, value: Number(slider.value), gesture });
  });
  slider.addEventListener('change', () => {
    if (gesture) store.dispatch({ type: 'end-gesture' });
    gesture = null;
  });
  for (const end of ['pointerup', 'pointercancel', 'blur']) slider.addEventListener(end, () => hold(false));
  slider.addEventListener('keydown', (event) => {
    if (event.key !== 'Escape' || !gesture) return;
    gesture = null;
    store.dispatch({ type: 'cancel-gesture' });
  });
}
