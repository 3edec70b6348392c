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

/** "−45° to 225°", "at most 160°". @param {JointDoc} joint @param {Units} units */
export function limitsInWords(joint, units) {
  const unit = unitOf(joint, units);
  const { lower, upper } = limitsOf(joint);
  const [least, most] = [lower, upper].map((value) => withUnit(editable(value), unit));
  if (lower === -Infinity) return TEXT.jog.atMost(most);
  return upper === Infinity ? TEXT.jog.atLeast(least) : TEXT.jog.between(least, most);
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
    step: 'any',
    'aria-label': TEXT.jog.slider(index + 1),
  });
  const field = h('input', {
    type: 'text',
    inputmode: 'text',
    autocomplete: 'off',
    spellcheck: 'false',
    'aria-label': TEXT.jog.field(index + 1, TEXT.table.unitName[unit]),
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
    command: (/** @type {number} */ value) => ({ type: 'set-joint-value', joint: index, value }),
    check: (value) => (isInside(joint, value) ? null : TEXT.jog.stops(`J${index + 1}`, limitsInWords(joint, units))),
    onDone: (/** @type {number} */ value) => `J${index + 1}: ${withUnit(jointNumber(value, unit), unit)}`,
    onReason(reason) {
      if (reason) field.setAttribute('aria-describedby', reasonId);
      else field.removeAttribute('aria-describedby');
      onReason(field, reason);
    },
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
  watchSlider(page, slider, index, { least, most, step: jointStep(unit) });

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

/** How many steps a key moves the slider; Home and End go to its ends. @type {Record<string, number>} */
const SLIDER_KEYS = {
  ...{ ArrowRight: 1, ArrowUp: 1, ArrowLeft: -1, ArrowDown: -1, PageUp: 100, PageDown: -100 },
  ...{ Home: -Infinity, End: Infinity },
};

/**
 * The range input's own steps count from its lower end, so that one that begins at −89.954° never meets zero: here they
 * count from zero, and the ends can be reached.
 * @param {Page} page
 * @param {HTMLInputElement} slider
 * @param {number} index
 * @param {{ least: number, most: number, step: number }} range
 */
function watchSlider({ store }, slider, index, { least, most, step }) {
  /** @type {string | null} */
  let gesture = null;
  let isGivenUp = false; // by Escape; the browser goes on dragging until the hand is off
  const now = () => store.state.doc.posture[index];
  const hold = (/** @type {boolean} */ isHeld) =>
    store.dispatch({ type: 'show', change: { heldJoint: isHeld ? index : null } });

  /** @param {number} value */
  function go(value) {
    const onStep = Number((Math.round(value / step) * step).toPrecision(12));
    gesture ??= newGesture();
    hold(true);
    const inside = Math.min(most, Math.max(least, value <= least || value >= most ? value : onStep));
    store.dispatch({ type: 'set-joint-value', joint: index, value: inside, gesture });
  }
  function end() {
    if (gesture) store.dispatch({ type: 'end-gesture' });
    gesture = null;
  }

  slider.addEventListener('pointerdown', () => {
    isGivenUp = false;
    hold(true);
  });
  slider.addEventListener('input', () => {
    if (isGivenUp) slider.value = String(now());
    else go(Number(slider.value));
  });
  slider.addEventListener('change', end);
  for (const name of ['pointerup', 'pointercancel', 'blur']) {
    slider.addEventListener(name, () => {
      isGivenUp = false;
      end();
      hold(false);
    });
  }
  slider.addEventListener('keydown', (event) => {
    if (event.key === 'Escape' && gesture) {
      gesture = null;
      isGivenUp = true;
      store.dispatch({ type: 'cancel-gesture' });
    }
    const steps = SLIDER_KEYS[event.key];
    if (steps === undefined || event.ctrlKey || event.altKey || event.metaKey) return;
    event.preventDefault();
    go(now() + steps * step);
  });
  slider.addEventListener('keyup', end); // however long a key is held, it is one step to undo
}
