/**
 * What belongs to one joint beside its row: limits, home and rates, how its link is drawn, and how a pendant counts it.
 *
 * @import { Page } from '../page.js'
 * @import { CellEditor } from './cellEditor.js'
 * @import { Reasons } from '../parts/reasons.js'
 * @import { RobotDoc } from '../../model/document.js'
 */
import { homePosture, quantityOf } from '../../model/document.js';
import { together } from '../../model/views.js';
import { captioned, textInput } from '../parts/captioned.js';
import { editCell } from './cellEditor.js';
import { createControllerControls } from './controllerControls.js';
import '../css/robotDetails.css';
import { fill, h } from '../parts/dom.js';
import { compact, jointNumber, plain, unitOf, unitSign, withUnit } from '../parts/format.js';
import { createLinkControls } from './linkControls.js';
import { attempt } from '../page.js';
import { createReasons } from '../parts/reasons.js';
import { TEXT } from '../strings.js';
import { readTyped, readTypedLimit } from '../parts/typedNumber.js';
import { DETAILS } from '../words/robotDetails.js';

const LIMITS = /** @type {const} */ (['lower', 'upper', 'home']);
const RATES = /** @type {const} */ (['velocity', 'acceleration']);

/** How many characters of a number a field has room for. */
const WIDEST = 9;

/**
 * @param {Page} page
 * @param {HTMLElement} host
 * @param {{ automaticRadii: (robot: RobotDoc) => readonly number[] }} scene
 */
export function createJointDetails(page, host, scene) {
  const { addView } = page;
  /** @type {(Pick<CellEditor, 'forget' | 'refresh'>)[]} */
  let editors = [];
  /** @type {((robot: RobotDoc) => void)[]} */
  let drawings = [];

  /** @param {RobotDoc} robot @param {number} index */
  function build(robot, index) {
    const reasons = createReasons('joint-details-reason');
    const limits = LIMITS.map((field) => limitField(page, index, field, reasons.set));
    const rates = RATES.map((rate) => rateField(page, index, rate, reasons.set));
    const link = createLinkControls(page, index, scene, reasons.set);
    const use = createUse(page, index);
    const controller = createControllerControls(page, index, reasons.set);
    editors = [...limits, ...rates, link, controller].map(({ editor }) => editor);
    drawings = [link.draw, use.draw, controller.draw];
    fill(
      host,
      h(
        'div',
        { class: 'captioned-row' },
        limits.map(({ element }) => element),
      ),
      use.element,
      h(
        'div',
        { class: 'captioned-row' },
        rates.map(({ element }) => element),
      ),
      link.element,
      controller.element,
      reasons.element,
    );
  }

  let shape = '';
  let edition = -1;
  addView(
    together(({ doc, session }) => [doc.robot, doc.posture, session.openJoint, session.edition]),
    ([robot, , index, now]) => {
      if (index === null) return;
      const { id, type } = robot.joints[index];
      const { length, angle } = robot.units;
      const wanted = [index, id, type, length, angle, ...robot.joints.map((joint) => joint.id)].join();
      if (now !== edition) editors.forEach((editor) => editor.forget());
      edition = now;
      if (wanted !== shape) build(robot, index);
      shape = wanted;
      editors.forEach((editor) => editor.refresh());
      for (const draw of drawings) draw(robot);
    },
  );
}

/** A number as it stands in a field that nobody edits. @param {HTMLInputElement} input @param {number | undefined} value */
function rest(input, value) {
  if (value === undefined) return '';
  const { text, isRounded } = compact(value, WIDEST);
  input.title = isRounded ? plain(value) : '';
  return text;
}

/** What the values of a joint are measured in. @param {Page} page @param {number} index */
const measureOf =
  ({ store }, index) =>
  () => {
    const { joints, units } = store.state.doc.robot;
    return { quantity: quantityOf(joints[index], 'home'), units };
  };

/**
 * @param {Page} page
 * @param {number} index
 * @param {'lower' | 'upper' | 'home'} field
 * @param {Reasons['set']} onReason
 */
function limitField(page, index, field, onReason) {
  const { store } = page;
  const { robot } = store.state.doc;
  const unit = unitOf(robot.joints[index], robot.units);
  const isEndless = field !== 'home' && robot.joints[index].type === 'continuous';
  const now = () => store.state.doc.robot.joints[index][field];
  const measure = measureOf(page, index);
  const text = () => (now() === undefined ? '' : plain(Number(now())));
  const input = textInput({
    'aria-label': DETAILS.field(index + 1, DETAILS[field], TEXT.table.unitName[unit]),
    placeholder: field === 'home' ? plain(homePosture(robot)[index]) : DETAILS.none,
    disabled: isEndless,
    title: isEndless ? DETAILS.endless : null,
  });
  const editor = editCell(page, input, {
    measure,
    read: (typed) => (field === 'home' ? readTyped : readTypedLimit)(typed, measure()),
    command: (/** @type {number | undefined} */ value) => ({ type: 'set-joint-field', joint: index, field, value }),
    onDone: () => DETAILS.set(DETAILS[field], text() || DETAILS.none),
    onReason: (reason, refused) => onReason(input, reason, refused, (way) => editor.settle(way)),
    text,
    resting: () => rest(input, now()),
  });
  // The view shows the limits of the joint as an arc while one of them is edited.
  input.addEventListener('focus', () => store.dispatch({ type: 'show', change: { heldJoint: index } }));
  input.addEventListener('blur', () => store.dispatch({ type: 'show', change: { heldJoint: null } }));
  const look = field === 'home' ? '' : 'is-optional';
  return { element: captioned(DETAILS[field], input, unitSign(unit), look), editor };
}

/**
 * @param {Page} page
 * @param {number} index
 * @param {'velocity' | 'acceleration'} rate
 * @param {Reasons['set']} onReason
 */
function rateField(page, index, rate, onReason) {
  const { store } = page;
  const { robot } = store.state.doc;
  const unit = unitOf(robot.joints[index], robot.units);
  const isRate = rate === 'velocity';
  const now = () => store.state.doc.robot.joints[index][rate];
  const measure = measureOf(page, index);
  const text = () => (now() === undefined ? '' : plain(Number(now())));
  const spoken = (isRate ? DETAILS.spokenPerSecond : DETAILS.spokenPerSecondSquared)(TEXT.table.unitName[unit]);
  const input = textInput({
    'aria-label': DETAILS.field(index + 1, DETAILS[rate], spoken),
    placeholder: DETAILS.none,
  });
  const editor = editCell(page, input, {
    measure,
    read: (typed) => readTypedLimit(typed, measure()),
    command: (/** @type {number | undefined} */ value) => ({ type: 'set-joint-rate', joint: index, rate, value }),
    onDone: () => DETAILS.set(DETAILS[rate], text() || DETAILS.none),
    onReason: (reason, refused) => onReason(input, reason, refused, (way) => editor.settle(way)),
    text,
    resting: () => rest(input, now()),
  });
  const sign = (isRate ? DETAILS.perSecond : DETAILS.perSecondSquared)(unitSign(unit));
  return { element: captioned(DETAILS[rate], input, sign, 'is-optional'), editor };
}

/** Where the joint stands, to be taken as a limit or as home. @param {Page} page @param {number} index */
function createUse(page, index) {
  const { store, announce } = page;
  const words = h('span', { class: 'soft' });
  const reason = h('p', { class: 'reason sm', role: 'note', hidden: true });
  const inWords = () => {
    const { robot, posture } = store.state.doc;
    const unit = unitOf(robot.joints[index], robot.units);
    return withUnit(jointNumber(posture[index], unit), unit);
  };
  const buttons = LIMITS.map((field) => {
    const button = h('button', { type: 'button', class: 'btn btn-small' }, DETAILS[field]);
    button.addEventListener('click', () => {
      const value = store.state.doc.posture[index];
      const against = attempt(page, { type: 'set-joint-field', joint: index, field, value });
      reason.textContent = against ?? '';
      reason.hidden = against === null;
      announce(against ?? DETAILS.set(DETAILS[field], inWords()));
    });
    return { field, button };
  });
  const { type } = store.state.doc.robot.joints[index];
  return {
    element: h(
      'div',
      {},
      h(
        'div',
        { class: 'use-row sm' },
        words,
        buttons.filter(({ field }) => field === 'home' || type !== 'continuous').map(({ button }) => button),
      ),
      reason,
    ),
    draw() {
      words.textContent = DETAILS.use(inWords());
      reason.hidden = true;
      for (const { field, button } of buttons) button.setAttribute('aria-label', DETAILS.useAs[field](inWords()));
    },
  };
}
