/**
 * A slider and a number for each joint, home and zero, and a word about whatever is past its limits.
 *
 * @import { JogRow } from './jogRow.js'
 * @import { Page } from './page.js'
 * @import { RobotDoc } from '../model/document.js'
 */
import $ from 'jquery/slim';
import { homePosture, limitsOf } from '../model/document.js';
import { isInside, zeroPosture } from '../model/jogRange.js';
import { together } from '../model/views.js';
import { fill, h } from './dom.js';
import { jointNumber, unitOf, withUnit } from './format.js';
import { createGoToMenu } from './goToMenu.js';
import { icon } from './icons.js';
import { createJogModes } from './jogModes.js';
import { createJogRow, limitsInWords } from './jogRow.js';
import { createReasons } from './reasons.js';
import { TEXT } from './strings.js';

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
    h('div', { class: 'jog-switches' }, keepRow, modes.buttonsRow),
    h('div', { id: 'jog-reason' }, reasons.element, remarkLine),
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
    const { posture, stopped } = zeroPosture(robot, keepsLimits);
    store.dispatch({ type: 'set-posture', posture });
    const notThere = (keepsLimits ? stopped : []).map((i) => {
      const unit = unitOf(robot.joints[i], robot.units);
      const value = withUnit(jointNumber(posture[i], unit), unit);
      return TEXT.jog.notZero(`J${i + 1}`, limitsInWords(robot.joints[i], robot.units), value);
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

  let said = '';
  function sayRemarks() {
    const { robot, posture } = store.state.doc;
    if (remark?.of !== posture) remark = null;
    const outside = robot.joints.flatMap((joint, i) =>
      isInside(joint, posture[i]) ? [] : [TEXT.jog.outside(`J${i + 1}`, limitsInWords(joint, robot.units))],
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
  let edition = -1;
  addView(
    together(({ doc, session }) => [
      doc.robot,
      doc.posture,
      session.heldJoint,
      session.edition,
      session.numbers.keepsLimits,
    ]),
    ([robot, posture, heldJoint, now, keepsLimits]) => {
      if (robot !== robotThen || now !== edition) {
        const limits = robot.joints.map(({ type, lower, upper, home: at }) => [type, lower, upper, at]);
        const wanted = JSON.stringify([robot.name, robot.units, limits]);
        if (wanted !== shape || now !== edition) rows.forEach((row) => row.forget());
        if (wanted !== shape) {
          rows = robot.joints.map((_, i) => createJogRow(page, robot, i, reasons.set));
          fill(
            list,
            rows.map(({ row }) => row),
          );
          keepRow.hidden = robot.joints.every((joint) =>
            Object.values(limitsOf(joint)).every((limit) => !Number.isFinite(limit)),
          );
        }
        [robotThen, shape, edition] = [robot, wanted, now];
      }
      if (keep.checked !== keepsLimits) keep.checked = keepsLimits;
      rows.forEach((row, i) => row.draw(posture[i], i === heldJoint, keepsLimits));
      sayRemarks();
    },
  );
}
