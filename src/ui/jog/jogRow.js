/**
 * One joint in the jog panel: a slider and a number. Neither wraps a value; a limit stops both, unless the person has said
 * that limits are not to be kept.
 *
 * @import { Page } from '../page.js'
 * @import { JointDoc, RobotDoc, Units } from '../../model/document.js'
 * @import { JointNumbers } from '../../model/numbers/jointNumbers.js'
 * @import { Reasons } from '../parts/reasons.js'
 * @import { Range } from '../../model/jog/jogRange.js'
 */
import { homePosture, isSliding, limitsOf, quantityOf } from '../../model/document.js';
import { grown, inside, isInside, jogRange, limitMargin } from '../../model/jog/jogRange.js';
import { groundOf } from '../../model/numbers/jointNumbers.js';
import { editCell } from '../robot/cellEditor.js';
import { fill, h } from '../parts/dom.js';
import { editable, jointNumber, jointStep, unitOf, unitSign, withUnit } from '../parts/format.js';
import { icon } from '../parts/icons.js';
import { stepsOf } from './jogKeys.js';
import { watchSlider } from './jogSlider.js';
import { TEXT } from '../strings.js';

/** A joint is near a limit where less is left than this share of its slider. */
const NEAR = 0.05;

/** "−45° to 225°", "at most 160°". @param {JointDoc} joint @param {Units} units */
export function limitsInWords(joint, units) {
  const unit = unitOf(joint, units);
  const { lower, upper } = limitsOf(joint);
  const [least, most] = [lower, upper].map((value) => withUnit(editable(value), unit));
  if (lower === -Infinity) return TEXT.jog.atMost(most);
  return upper === Infinity ? TEXT.jog.atLeast(least) : TEXT.jog.between(least, most);
}

/**
 * @param {Page} page
 * @param {RobotDoc} robot
 * @param {number} index
 * @param {Reasons['set']} onReason
 * @param {JointNumbers} numbers  that it shows; another row is made for others
 */
export function createJogRow(page, robot, index, onReason, numbers) {
  const { store } = page;
  const shown = () => numbers.robot(store.state.doc);
  const { units } = shown();
  const joint = () => shown().joints[index] ?? robot.joints[index];
  const { type } = joint();
  const unit = unitOf(joint(), units);
  const limits = () => limitsOf(joint());
  const home = () => homePosture(shown())[index];
  const now = () => numbers.values(store.state.doc)[index];
  const keepsLimits = () => store.state.session.numbers.keepsLimits;

  const slider = h('input', {
    type: 'range',
    step: 'any',
    'aria-label': TEXT.jog.slider(index + 1),
    title: TEXT.jog.keys,
  });
  const field = h('input', {
    type: 'text',
    inputmode: 'text',
    autocomplete: 'off',
    spellcheck: 'false',
    'aria-label': TEXT.jog.field(index + 1, TEXT.table.unitName[unit]),
  });
  const mark = (/** @type {string} */ name) => h('span', { class: name, 'aria-hidden': 'true' });
  const margin = h('small', { class: 'margin' }); // seen where there are dials
  const row = h(
    'div',
    { class: isSliding(joint()) ? 'jog slides' : 'jog' },
    h('span', { class: 'name', title: TEXT.table.jointType[type] }, `J${index + 1}`),
    h(
      'span',
      { class: 'track' },
      Number.isFinite(limits().lower) && mark('stop lower'),
      Number.isFinite(limits().upper) && mark('stop upper'),
      mark('home'),
      slider,
    ),
    h('label', { class: 'field' }, field, h('span', { class: 'unit' }, unitSign(unit))),
    margin,
  );

  /** @type {Range} */
  let range = { least: 0, most: 0 };
  const part = (/** @type {number} */ value) => {
    const { least, most } = range;
    return Math.min(1, Math.max(0, most > least ? (value - least) / (most - least) : 0));
  };
  /** @param {string} name @param {number} value */
  const place = (name, value) => row.style.setProperty(name, String(part(value)));

  /** @param {Range} next */
  function span(next) {
    if (next.least === range.least && next.most === range.most) return;
    range = next;
    slider.min = String(range.least);
    slider.max = String(range.most);
    place('--h', home());
    place('--lower', limits().lower);
    place('--upper', limits().upper);
  }

  const cell = editCell(page, field, {
    measure: () => ({ quantity: quantityOf(joint(), 'home'), units }),
    command: (/** @type {number} */ value) => numbers.command(groundOf(store.state), index, value),
    check: (value) =>
      isInside(joint(), value) || !keepsLimits()
        ? null
        : TEXT.jog.stops(`J${index + 1}`, limitsInWords(joint(), units) + numbers.condition(store.state.doc, index)),
    onDone: (/** @type {number} */ value) => `J${index + 1}: ${withUnit(jointNumber(value, unit), unit)}`,
    onReason: (reason, refused) => onReason(field, reason, refused, (way) => cell.settle(way)),
    text: () => editable(now()),
    resting: () => jointNumber(now(), unit),
  });
  field.addEventListener('keydown', (event) => {
    const steps = event.key === 'ArrowLeft' || event.key === 'ArrowRight' ? null : stepsOf(event);
    if (steps === null) return;
    event.preventDefault();
    const wanted = now() + steps * jointStep(unit);
    cell.type(editable(keepsLimits() ? inside(joint(), wanted) : wanted));
  });
  watchSlider(page, slider, index, {
    home,
    step: jointStep(unit),
    range: () => range,
    command: (value) => numbers.command(groundOf(store.state), index, value),
    now,
    hold: (value) => (keepsLimits() ? inside(joint(), value) : value),
    /** At an end that is no limit there is more to come. */
    onRest() {
      const value = now();
      const { lower, upper } = limits();
      const isStop = keepsLimits() && (value <= lower || value >= upper);
      if (!isStop) span(grown(range, value, true));
      redraw();
    },
  });

  /** @type {readonly [value: number, isHeld: boolean, keeps: boolean, lower: number, upper: number] | null} what stands there */
  let drawn = null;
  function redraw() {
    if (!drawn) return;
    const [value, isHeld, keeps] = drawn;
    const { lower, upper } = limits();
    span(grown(range, value));
    slider.value = String(value);
    slider.setAttribute('aria-valuetext', inWords(value));
    place('--a', Math.min(0, value));
    place('--b', Math.max(0, value));
    place('--v', value);
    const left = limitMargin(joint(), value);
    const isNear = left.by < NEAR * (range.most - range.least);
    const by = withUnit(jointNumber(Math.abs(left.by), unit), unit);
    const words = left.by < 0 ? TEXT.jog.beyond(by) : left.limit ? TEXT.jog.toLimit(by) : TEXT.jog.noLimit;
    fill(margin, isNear && icon('exclamation'), words);
    row.classList.toggle('is-near', isNear);
    row.classList.toggle('on', isHeld);
    row.classList.toggle('is-outside', !isInside(joint(), value));
    row.classList.toggle('at-lower', isHeld && keeps && value === lower);
    row.classList.toggle('at-upper', isHeld && keeps && value === upper);
    cell.refresh();
  }

  /** @param {number} value */
  function inWords(value) {
    const text = withUnit(jointNumber(value, unit), unit);
    if (!isInside(joint(), value)) return TEXT.jog.outsideShort(text);
    const { lower, upper } = limits();
    return value === lower || value === upper ? TEXT.jog.atLimitShort(text) : text;
  }

  return {
    row,
    forget() {
      cell.forget();
      drawn = null;
    },
    /** @param {number} value @param {boolean} isHeld @param {boolean} keeps */
    draw(value, isHeld, keeps) {
      const { lower, upper } = limits();
      /** @type {NonNullable<typeof drawn>} */
      const next = [value, isHeld, keeps, lower, upper];
      if (drawn?.every((one, i) => one === next[i])) return;
      if (!drawn || [2, 3, 4].some((i) => drawn?.[i] !== next[i])) span(jogRange(shown(), index, keeps));
      drawn = next;
      redraw();
    },
  };
}

/** @typedef {ReturnType<typeof createJogRow>} JogRow */
