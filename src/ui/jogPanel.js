/**
 * A slider and a number for each joint, home, and a word about whatever is past its limits.
 *
 * @import { JogRow } from './jogRow.js'
 * @import { Page } from './page.js'
 */
import $ from 'jquery/slim';
import { homePosture } from '../model/document.js';
import { together } from '../model/views.js';
import { fill, h } from './dom.js';
import { icon } from './icons.js';
import { createJogRow, isInside, limitsInWords } from './jogRow.js';
import { TEXT } from './strings.js';

/**
 * @param {Page} page
 * @param {HTMLElement} host
 */
export function createJogPanel(page, host) {
  const { store, addView, announce } = page;
  const home = h(
    'button',
    { type: 'button', class: 'btn btn-icon', 'aria-label': TEXT.jog.home, title: TEXT.jog.home },
    icon('home'),
  );
  const list = h('div', { class: 'body' });
  const reasonLine = h('p', { class: 'reason sm', id: 'jog-reason', role: 'note' });
  fill(host, h('header', {}, h('h2', {}, TEXT.jog.title), h('span', { class: 'grow' }), home), list, reasonLine);

  $(home).on('click', () => {
    store.dispatch({ type: 'set-posture', posture: homePosture(store.state.doc.robot) });
    announce(TEXT.jog.atHome);
  });

  /** @type {Map<HTMLInputElement, string>} texts that were refused and still stand */
  const refused = new Map();

  /** @param {HTMLInputElement} field @param {string | null} reason */
  function onReason(field, reason) {
    field.parentElement?.classList.toggle('is-invalid', reason !== null);
    if (reason === null) refused.delete(field);
    else refused.set(field, reason);
    sayReasons();
  }

  function sayReasons() {
    const { robot, posture } = store.state.doc;
    for (const field of refused.keys()) if (!field.isConnected) refused.delete(field);
    const outside = robot.joints.flatMap((joint, i) =>
      isInside(joint, posture[i]) ? [] : [TEXT.jog.outside(`J${i + 1}`, limitsInWords(joint, robot.units))],
    );
    reasonLine.textContent = [...refused.values(), ...outside].join(' ');
    reasonLine.hidden = reasonLine.textContent === '';
  }

  /** @type {readonly JogRow[]} */
  let rows = [];
  let shape = '';
  let edition = -1;
  addView(
    together(({ doc, session }) => [doc.robot, doc.posture, session.heldJoint, session.edition]),
    ([robot, posture, heldJoint, now]) => {
      const limits = robot.joints.map(({ type, lower, upper, home: at }) => [type, lower, upper, at]);
      const wanted = JSON.stringify([robot.name, robot.units, limits]);
      if (wanted !== shape || now !== edition) rows.forEach((row) => row.forget());
      if (wanted !== shape) {
        rows = robot.joints.map((_, i) => createJogRow(page, robot, i, { reasonId: reasonLine.id, onReason }));
        fill(
          list,
          rows.map(({ row }) => row),
        );
      }
      [shape, edition] = [wanted, now];
      rows.forEach((row, i) => row.draw(posture[i], i === heldJoint));
      sayReasons();
    },
  );
}
