/**
 * A slider and a number for each joint. A pull of the slider is one undo step, and Escape during it leaves no trace.
 *
 * @import { Page } from './page.js'
 * @import { CellEditor } from './cellEditor.js'
 * @import { JointDoc, RobotDoc } from '../model/document.js'
 */
import $ from 'jquery/slim';
import { homePosture } from '../model/document.js';
import { together } from '../model/views.js';
import { editCell } from './cellEditor.js';
import { fill, h } from './dom.js';
import { editable, jointNumber, jointStep, unitOf, unitSign, withUnit } from './format.js';
import { icon } from './icons.js';
import { newGesture } from './page.js';
import { TEXT } from './strings.js';

/** How far a slider goes where the joint has no limit: a turn either way, or two metres. */
const SLIDER_REACH = { deg: 360, rad: 2 * Math.PI, mm: 2000, cm: 200, m: 2 };

/** The ends of a joint's slider, in document units. @param {JointDoc} joint @param {RobotDoc['units']} units */
function sliderRange(joint, units) {
  const reach = SLIDER_REACH[unitOf(joint, units)];
  return {
    lower: joint.lower ?? Math.min(-reach, joint.upper ?? 0),
    upper: joint.upper ?? Math.max(reach, joint.lower ?? 0),
  };
}

/**
 * @param {Page} page
 * @param {HTMLElement} host
 */
export function createJogPanel(page, host) {
  const { store, addView, announce } = page;
  const homeButton = h(
    'button',
    { type: 'button', class: 'btn btn-icon', 'aria-label': TEXT.jog.home, title: TEXT.jog.home },
    icon('home'),
  );
  const list = h('div', { class: 'body' });
  const reasonLine = h('p', { class: 'reason sm', id: 'jog-reason', role: 'note' });
  fill(host, h('header', {}, h('h2', {}, TEXT.jog.title), h('span', { class: 'grow' }), homeButton), list, reasonLine);

  $(homeButton).on('click', () => {
    store.dispatch({ type: 'set-posture', posture: homePosture(store.state.doc.robot) });
    announce(TEXT.jog.atHome);
  });

  /** @type {{ row: HTMLElement, slider: HTMLInputElement, cell: CellEditor }[]} */
  let rows = [];

  /** @param {JointDoc} joint @param {number} index @param {RobotDoc} robot */
  function makeRow(joint, index, { units }) {
    const unit = unitOf(joint, units);
    const { lower, upper } = sliderRange(joint, units);
    const slider = h('input', {
      type: 'range',
      min: lower,
      max: upper,
      step: jointStep(unit),
      'aria-label': TEXT.jog.slider(index + 1),
    });
    const field = h('input', {
      type: 'text',
      inputmode: 'text',
      autocomplete: 'off',
      spellcheck: 'false',
      'aria-label': TEXT.jog.field(index + 1, TEXT.table.unitName[unit]),
      'aria-describedby': reasonLine.id,
    });
    const row = h(
      'div',
      { class: 'jog' },
      h('span', { class: 'name', title: TEXT.table.jointType[joint.type] }, `J${index + 1}`),
      h('span', { class: 'track' }, h('span', { class: 'home', 'aria-hidden': 'true' }), slider),
      h('label', { class: 'field' }, field, h('span', { class: 'unit' }, unitSign(unit))),
    );
    const part = (/** @type {number} */ value) => (upper > lower ? (value - lower) / (upper - lower) : 0);
    row.style.setProperty('--h', String(Math.min(1, Math.max(0, part(homePosture(store.state.doc.robot)[index])))));

    const now = () => store.state.doc.posture[index];
    const cell = editCell(page, field, {
      command: (value) => ({ type: 'set-joint-value', joint: index, value }),
      check: (value) => stopReason(index, value),
      onDone: (value) => `J${index + 1}: ${withUnit(jointNumber(value, unit), unit)}`,
      onReason: (reason) => showReason(field, reason),
      text: () => editable(now()),
      resting: () => jointNumber(now(), unit),
    });
    field.addEventListener('keydown', (event) => {
      const step = { ArrowUp: 1, ArrowDown: -1, PageUp: 10, PageDown: -10 }[event.key];
      if (!step) return;
      event.preventDefault();
      const joints = store.state.doc.robot.joints;
      const { lower: least = -Infinity, upper: most = Infinity } = joints[index];
      const value = Math.min(most, Math.max(least, now() + step * jointStep(unit) * 10));
      field.value = editable(Number(value.toFixed(9)));
      field.dispatchEvent(new Event('input'));
    });
    watchSlider(slider, index);
    return { row, slider, cell };
  }

  /** @param {HTMLInputElement} slider @param {number} index */
  function watchSlider(slider, index) {
    /** @type {string | null} */
    let gesture = null;
    const hold = (/** @type {boolean} */ held) =>
      store.dispatch({ type: 'show', change: { heldJoint: held ? index : null } });
    const release = () => {
      if (gesture) store.dispatch({ type: 'end-gesture' });
      gesture = null;
    };
    slider.addEventListener('pointerdown', () => hold(true));
    slider.addEventListener('input', () => {
      gesture ??= newGesture();
      hold(true);
      store.dispatch({ type: 'set-joint-value', joint: index, value: Number(slider.value), gesture });
    });
    slider.addEventListener('change', release);
    for (const end of ['pointerup', 'pointercancel']) slider.addEventListener(end, () => hold(false));
    slider.addEventListener('blur', () => hold(false));
    slider.addEventListener('keydown', (event) => {
      if (event.key !== 'Escape' || !gesture) return;
      gesture = null;
      store.dispatch({ type: 'cancel-gesture' });
    });
  }

  /** @param {number} index @param {number} value @returns {string | null} why the joint cannot go there */
  function stopReason(index, value) {
    const { joints, units } = store.state.doc.robot;
    const joint = joints[index];
    const { lower = -Infinity, upper = Infinity } = joint;
    if (value >= lower && value <= upper) return null;
    return TEXT.jog.stops(`J${index + 1}`, ...limitsText(joint, units));
  }

  /** @type {Map<HTMLInputElement, string>} */
  const reasons = new Map();
  /** @param {HTMLInputElement} field @param {string | null} reason */
  function showReason(field, reason) {
    field.parentElement?.classList.toggle('is-invalid', reason !== null);
    if (reason === null) reasons.delete(field);
    else reasons.set(field, reason);
    sayReasons();
  }

  function sayReasons() {
    const { robot, posture } = store.state.doc;
    for (const field of reasons.keys()) if (!field.isConnected) reasons.delete(field);
    const outside = robot.joints.flatMap((joint, i) =>
      stopReason(i, posture[i]) ? [TEXT.jog.outside(`J${i + 1}`, ...limitsText(joint, robot.units))] : [],
    );
    reasonLine.textContent = [...reasons.values(), ...outside].join(' ');
    reasonLine.hidden = reasonLine.textContent === '';
  }

  /** @type {string} */
  let shape = '';
  let edition = -1;
  addView(
    together(({ doc, session }) => [doc.robot, doc.posture, session.heldJoint, session.edition]),
    ([robot, posture, heldJoint, now]) => {
      if (now !== edition) rows.forEach(({ cell }) => cell.forget());
      edition = now;
      const wanted = JSON.stringify([
        robot.name,
        robot.units,
        robot.joints.map(({ type, lower, upper, home }) => [type, lower, upper, home]),
      ]);
      if (wanted !== shape) {
        rows = robot.joints.map((joint, i) => makeRow(joint, i, robot));
        fill(
          list,
          rows.map(({ row }) => row),
        );
      }
      shape = wanted;
      robot.joints.forEach((joint, i) => drawRow(joint, posture[i], i === heldJoint, rows[i], robot.units));
      sayReasons();
    },
  );
}

/** @param {JointDoc} joint @param {RobotDoc['units']} units @returns {[lower: string, upper: string]} */
function limitsText(joint, units) {
  const unit = unitOf(joint, units);
  const text = (/** @type {number | undefined} */ value) =>
    value === undefined ? TEXT.jog.noLimit : withUnit(editable(value), unit);
  return [text(joint.lower), text(joint.upper)];
}

/**
 * @param {JointDoc} joint
 * @param {number} value
 * @param {boolean} isHeld
 * @param {{ row: HTMLElement, slider: HTMLInputElement, cell: CellEditor }} elements
 * @param {RobotDoc['units']} units
 */
function drawRow(joint, value, isHeld, { row, slider, cell }, units) {
  const unit = unitOf(joint, units);
  const { lower, upper } = sliderRange(joint, units);
  const part = (/** @type {number} */ v) => Math.min(1, Math.max(0, upper > lower ? (v - lower) / (upper - lower) : 0));
  slider.value = String(value);
  slider.setAttribute('aria-valuetext', withUnit(jointNumber(value, unit), unit));
  row.style.setProperty('--a', String(Math.min(part(0), part(value))));
  row.style.setProperty('--b', String(Math.max(part(0), part(value))));
  row.classList.toggle('on', isHeld);
  const { lower: least = -Infinity, upper: most = Infinity } = joint;
  row.classList.toggle('is-outside', value < least || value > most);
  cell.refresh();
}
