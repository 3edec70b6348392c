/**
 * A slider and a number for each joint, home and zero, and a word about whatever is past its limits.
 *
 * @import { JogRow } from './jogRow.js'
 * @import { JointNumbers } from '../../model/numbers/jointNumbers.js'
 * @import { Page } from '../page.js'
 * @import { RobotDoc } from '../../model/document.js'
 */
import $ from 'jquery/slim';
import { homePosture, limitsOf } from '../../model/document.js';
import { isInside } from '../../model/jog/jogRange.js';
import { together } from '../../model/views.js';
import { fill, h } from '../parts/dom.js';
import { jointNumber, unitOf, withUnit } from '../parts/format.js';
import { createGoToMenu } from './goToMenu.js';
import { icon } from '../parts/icons.js';
import { createJogModes } from './jogModes.js';
import { createJogRow, limitsInWords } from './jogRow.js';
import { jointNumbers } from './jointNumbers.js';
import { createMotionFold } from './motionFold.js';
import { createPendantSwitch } from './pendantSwitch.js';
import { createReasons } from '../parts/reasons.js';
import { TEXT } from '../strings.js';

/**
 * @param {Page} page
 * @param {HTMLElement} host
 */
export function createJogPanel(page, host) {
  const { store, addView, announce } = page;
  const zero = h('button', { type: 'button', class: 'btn soft', title: TEXT.jog.zero }, TEXT.jog.zeroShort);
  const home = h(
    'button',
    { type: 'button', class: 'btn btn-icon', 'aria-label': TEXT.jog.home, title: TEXT.jog.home },
    icon('home'),
  );
  const list = h('div', { class: 'body' });
  const keep = h('input', { type: 'checkbox', role: 'switch', checked: true });
  const keepRow = h('label', { class: 'switch' }, keep, TEXT.jog.keep);
  const modes = createJogModes(page, list);
  const pendant = createPendantSwitch(page);
  const reasons = createReasons('jog-refused');
  const remarkLine = h('p', { class: 'reason sm', role: 'note', hidden: true });
  fill(
    host,
    h(
      'header',
      {},
      h('h2', {}, TEXT.jog.title),
      modes.switcher,
      h('span', { class: 'grow' }),
      zero,
      home,
      createGoToMenu(page),
    ),
    list,
    modes.pendant,
    h('div', { class: 'jog-switches' }, keepRow, modes.dialsRow, modes.buttonsRow, pendant.row),
    pendant.note,
    h('div', { id: 'jog-reason' }, reasons.element, remarkLine),
    createMotionFold(page),
  );

  const numbers = () => store.state.session.numbers;
  /** What is said of a posture for as long as the arm stands in it. @type {{ of: readonly number[], text: string } | null} */
  let remark = null;

  $(home).on('click', () => {
    store.dispatch({ type: 'set-posture', posture: homePosture(store.state.doc.robot) });
    announce(TEXT.jog.atHome);
  });
  $(zero).on('click', () => {
    const { robot } = store.state.doc;
    const { keepsLimits } = numbers();
    const joints = jointNumbers(store.state);
    const { posture, stopped } = joints.zero(robot, keepsLimits);
    store.dispatch({ type: 'set-posture', posture });
    const { doc } = store.state;
    const shown = joints.robot(doc);
    const notThere = (keepsLimits ? stopped : []).map((i) => {
      const unit = unitOf(shown.joints[i], shown.units);
      const value = withUnit(jointNumber(joints.values(doc)[i], unit), unit);
      return TEXT.jog.notZero(`J${i + 1}`, limitsInWords(shown.joints[i], shown.units), value);
    });
    remark = notThere.length ? { of: store.state.doc.posture, text: notThere.join(' ') } : null;
    sayRemarks();
    announce(remark?.text ?? TEXT.jog.atZero);
  });
  $(keep).on('change', () => {
    const keepsLimits = keep.checked;
    store.dispatch({ type: 'show', change: { numbers: { ...numbers(), keepsLimits } } });
    announce(keepsLimits ? TEXT.jog.keepsNow : TEXT.jog.keepsNot);
  });

  /** How long the numbers can become: the fields of all rows are as wide. @param {JointNumbers} joints */
  function mostDigits(joints) {
    const { units, joints: shown } = joints.robot(store.state.doc);
    const values = joints.values(store.state.doc);
    const texts = shown.flatMap((joint, i) =>
      [...Object.values(limitsOf(joint)), values[i]]
        .filter(Number.isFinite)
        .map((value) => jointNumber(value, unitOf(joint, units))),
    );
    return Math.max(...texts.map(({ length }) => length));
  }

  let said = '';
  function sayRemarks() {
    const { doc } = store.state;
    if (remark?.of !== doc.posture) remark = null;
    const joints = jointNumbers(store.state);
    const { units, joints: shown } = joints.robot(doc);
    const values = joints.values(doc);
    const outside = shown.flatMap((joint, i) =>
      isInside(joint, values[i])
        ? []
        : [TEXT.jog.outside(`J${i + 1}`, limitsInWords(joint, units) + joints.condition(doc, i))],
    );
    const text = [...(remark ? [remark.text] : []), ...outside].join(' ');
    if (text === said) return;
    said = remarkLine.textContent = text;
    remarkLine.hidden = text === '';
  }

  /** @type {readonly JogRow[]} */
  let rows = [];
  /** What the rows were made for. */
  let shape = '';
  /** @type {RobotDoc | null} */
  let robotThen = null;
  /** @type {JointNumbers | null} */
  let jointsThen = null;
  let edition = -1;
  addView(
    together(({ doc, session }) => [
      doc.robot,
      doc.posture,
      session.heldJoint,
      session.edition,
      session.numbers.keepsLimits,
      session.numbers.isPendant,
    ]),
    ([robot, , heldJoint, now, keepsLimits]) => {
      const joints = jointNumbers(store.state);
      if (robot !== robotThen || now !== edition || joints !== jointsThen) {
        const limits = robot.joints.map(({ type, lower, upper, home: at }) => [type, lower, upper, at]);
        const wanted = JSON.stringify([
          robot.name,
          robot.units,
          limits,
          robot.joints.map(({ controller }) => controller),
        ]);
        const isOther = wanted !== shape || joints !== jointsThen;
        if (isOther || now !== edition) rows.forEach((row) => row.forget());
        if (isOther) {
          rows = robot.joints.map((_, i) => createJogRow(page, robot, i, reasons.set, joints));
          fill(
            list,
            rows.map(({ row }) => row),
          );
          list.style.setProperty('--digits', String(mostDigits(joints)));
          keepRow.hidden = robot.joints.every((joint) =>
            Object.values(limitsOf(joint)).every((limit) => !Number.isFinite(limit)),
          );
        }
        [robotThen, jointsThen, shape, edition] = [robot, joints, wanted, now];
      }
      if (keep.checked !== keepsLimits) keep.checked = keepsLimits;
      const values = joints.values(store.state.doc);
      rows.forEach((row, i) => row.draw(values[i], i === heldJoint, keepsLimits));
      sayRemarks();
    },
  );
}
