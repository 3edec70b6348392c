/**
 * Above and below the DH table: which convention it follows, one joint more, and what the last such act did.
 *
 * @import { Page } from '../page.js'
 */
import { refusal } from '../../model/refusals.js';
import { createConventionMenu } from './conventionMenu.js';
import { createCopyTableMenu } from './copyTableMenu.js';
import { h } from '../parts/dom.js';
import { icon } from '../parts/icons.js';
import { attempt } from '../page.js';
import { TEXT } from '../strings.js';
import { createUnitsMenu } from '../unitsMenu.js';

/** @param {Page} page */
export function createStructureControls(page) {
  const { store, addView, announce } = page;
  const order = h('span', { class: 'soft sm formula' });
  const reason = h('span', { class: 'soft sm', id: 'no-more-joints' });
  const add = h(
    'button',
    { type: 'button', class: 'btn', 'aria-describedby': reason.id },
    icon('plus'),
    TEXT.structure.add,
  );
  const note = h('p', { class: 'note soft sm' });
  /** The robot that the note speaks of. @type {unknown} */
  let noted = null;

  /** Aloud, and on the page until the robot changes again. @param {string} text */
  function say(text) {
    announce(text);
    note.textContent = text;
    noted = store.state.doc.robot;
  }

  const addLast = () => {
    const last = store.state.doc.robot.joints.length - 1;
    return /** @type {const} */ ({ type: 'add-joint', after: last });
  };
  // Not `disabled`, which would lose the focus with the sixth joint and the reason with it.
  add.addEventListener('click', () => {
    const command = addLast();
    const against = attempt(page, command);
    if (against === null) say(TEXT.structure.added(`J${command.after + 2}`));
    else announce(against);
  });

  addView(
    ({ doc }) => doc.robot,
    (robot) => {
      order.textContent = TEXT.table.conventionOrder[robot.convention];
      const against = refusal(store.state.doc, addLast());
      add.setAttribute('aria-disabled', String(against !== null));
      reason.textContent = against?.message ?? '';
      if (robot !== noted) note.textContent = '';
    },
  );

  return {
    head: h(
      'div',
      { class: 'table-head' },
      createConventionMenu(page, say),
      order,
      createUnitsMenu(page, 'phone-only'),
    ),
    foot: h('div', { class: 'table-foot' }, add, createCopyTableMenu(page, say), reason, note),
    say,
  };
}
