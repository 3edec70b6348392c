/**
 * How a controller's pendant counts the joint: its sign, its zero, and the joint whose number it follows; with what comes of
 * them as a formula.
 *
 * @import { Page } from '../page.js'
 * @import { Reasons } from '../parts/reasons.js'
 * @import { ControllerCommand } from '../../model/controller/controllerCommand.js'
 * @import { ControllerDoc } from '../../model/document.js'
 */
import { quantityOf } from '../../model/document.js';
import { captioned, captionedSelect, select, textInput } from '../parts/captioned.js';
import { editCell } from './cellEditor.js';
import { h } from '../parts/dom.js';
import { compact, plain, unitOf, unitSign } from '../parts/format.js';
import { readNumber } from '../parts/numberText.js';
import { attempt } from '../page.js';
import { pendantLine } from '../jog/pendantLine.js';
import { TEXT } from '../strings.js';
import { readTyped } from '../parts/typedNumber.js';
import { JOINT_CONTROLLER as WORDS } from '../words/controller.js';

const WIDEST = 9;

/** Of a coupling that was just chosen: as a FANUC counts J3. */
const USUAL_COUPLING = -1;

/** @param {Page} page @param {number} index @param {Reasons['set']} onReason */
export function createControllerControls(page, index, onReason) {
  const { store, announce } = page;
  const robot = () => store.state.doc.robot;
  const controller = () => robot().joints[index].controller;
  /** @param {Partial<ControllerDoc>} change @returns {ControllerCommand} */
  const command = (change) => ({ type: 'set-controller', joint: index, controller: { ...controller(), ...change } });
  const line = () => pendantLine(robot(), index);

  /** @param {HTMLSelectElement} control @param {Partial<ControllerDoc>} change */
  function choose(control, change) {
    const against = attempt(page, command(change));
    onReason(control, against);
    announce(against ?? line());
    draw(); // what was refused goes back
  }

  const sign = select(WORDS.sign(index + 1), /** @type {const} */ (['1', '-1']), WORDS.signs, (wanted) =>
    choose(sign, { sign: wanted === '1' ? 1 : -1 }),
  );
  const others = robot().joints.flatMap(({ id }, i) => (i === index ? [] : [{ id, name: `J${i + 1}` }]));
  const names = { '': WORDS.none, ...Object.fromEntries(others.map(({ id, name }) => [id, name])) };
  const coupledTo = select(WORDS.coupledTo(index + 1), ['', ...others.map(({ id }) => id)], names, (id) =>
    choose(
      coupledTo,
      id === ''
        ? { coupledTo: undefined, coupling: 0 }
        : { coupledTo: id, coupling: controller().coupling || USUAL_COUPLING },
    ),
  );

  /** @param {'offset' | 'coupling'} field @param {string} label */
  function number(field, label) {
    const input = textInput({ 'aria-label': label });
    const editor = editCell(page, input, {
      measure,
      // a coupling is a pure number, which no unit is converted for
      read: (typed) => (field === 'coupling' ? readNumber(typed) : readTyped(typed, measure())),
      command: (/** @type {number} */ value) => command({ [field]: value }),
      onDone: line,
      onReason: (reason, refused) => onReason(input, reason, refused, (way) => editor.settle(way)),
      text: () => plain(controller()[field]),
      resting: () => compact(controller()[field], WIDEST).text,
    });
    function measure() {
      return { quantity: quantityOf(robot().joints[index], 'home'), units: robot().units };
    }
    return { input, editor };
  }
  const unit = unitOf(robot().joints[index], robot().units);
  const offset = number('offset', WORDS.offset(index + 1, TEXT.table.unitName[unit]));
  const coupling = number('coupling', WORDS.coupling(index + 1));
  const couplingBox = captioned(WORDS.couplingShort, coupling.input);
  const formula = h('p', { class: 'sm', role: 'note' });

  function draw() {
    const now = controller();
    sign.value = String(now.sign);
    coupledTo.value = now.coupledTo ?? '';
    couplingBox.hidden = now.coupledTo === undefined;
    formula.textContent = line();
  }

  return {
    element: h(
      'div',
      { class: 'joint-controller', role: 'group', 'aria-label': WORDS.group(index + 1) },
      h('p', { class: 'soft sm' }, WORDS.about),
      h(
        'div',
        { class: 'captioned-row' },
        captionedSelect(sign, WORDS.signShort),
        captioned(WORDS.offsetShort, offset.input, unitSign(unit)),
        captionedSelect(coupledTo, WORDS.coupledToShort),
        couplingBox,
      ),
      formula,
    ),
    editor: {
      refresh: () => [offset, coupling].forEach(({ editor }) => editor.refresh()),
      forget: () => [offset, coupling].forEach(({ editor }) => editor.forget()),
    },
    draw,
  };
}
