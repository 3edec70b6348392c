/**
 * The recorded postures, in the order in which a program visits them.
 *
 * @import { Page } from './page.js'
 * @import { PostureDoc, RobotDoc } from '../model/document.js'
 */
import $ from 'jquery/slim';
import { together } from '../model/views.js';
import { fill, h } from './dom.js';
import { emptyState } from './emptyState.js';
import { jointNumber, unitOf, withUnit } from './format.js';
import { icon } from './icons.js';
import { attempt, openPanel } from './page.js';
import { TEXT } from './strings.js';

/**
 * @param {Page} page
 * @param {HTMLElement} host
 */
export function createProgramPanel(page, host) {
  const { store, addView, announce } = page;
  const record = recordButton();
  const content = h('div', {});
  const reasonLine = h('p', { class: 'reason sm', id: 'program-reason', role: 'note', hidden: true });
  fill(
    host,
    h('div', { class: 'table-head' }, h('h2', {}, TEXT.program.title), h('span', { class: 'grow' }), record),
    content,
    reasonLine,
  );

  /** @param {string | null} reason */
  function say(reason) {
    reasonLine.textContent = reason ?? '';
    reasonLine.hidden = reason === null;
    if (reason !== null) announce(reason);
  }

  $(host)
    .on('click', '[data-action=record]', () => {
      const reason = attempt(page, { type: 'record-posture' });
      say(reason);
      const added = store.state.doc.postures.at(-1);
      if (reason === null && added) announce(TEXT.program.recorded(added.id));
    })
    .on('click', '[data-action=go]', ({ currentTarget }) => {
      const { q } = store.state.doc.postures[Number(currentTarget.dataset.index)];
      store.dispatch({ type: 'set-posture', posture: q });
    })
    .on('click', '[data-action=remove]', ({ currentTarget }) => {
      store.dispatch({ type: 'remove-posture', index: Number(currentTarget.dataset.index) });
      say(null);
      record.focus();
    })
    .on('click', '[data-action=code]', () => openPanel(page, 'code'))
    .on('change', 'input', ({ currentTarget }) => {
      const index = Number(currentTarget.dataset.index);
      const reason = attempt(page, { type: 'rename-posture', index, id: currentTarget.value.trim() });
      if (reason === null) currentTarget.removeAttribute('aria-invalid');
      else currentTarget.setAttribute('aria-invalid', 'true');
      say(reason);
    })
    .on('keydown', 'input', ({ key, currentTarget }) => {
      if (key === 'Enter') currentTarget.blur();
      if (key !== 'Escape') return;
      currentTarget.value = store.state.doc.postures[Number(currentTarget.dataset.index)].id;
      currentTarget.removeAttribute('aria-invalid');
      say(null);
    });

  addView(
    together(({ doc }) => [doc.robot, doc.postures]),
    ([robot, postures]) => {
      record.hidden = postures.length === 0;
      if (postures.length === 0) {
        fill(content, emptyState(TEXT.program.empty, TEXT.program.emptyDetail, recordButton('btn-primary')));
        return;
      }
      const rows = postures.map((posture, i) => row(posture, i, robot));
      fill(
        content,
        h('table', { class: 'moves', 'aria-label': TEXT.program.title }, head(robot), h('tbody', {}, rows)),
        postures.length === 1
          ? h('p', { class: 'soft sm inset' }, TEXT.program.one)
          : h(
              'div',
              { class: 'actions inset' },
              h('button', { type: 'button', class: 'btn btn-primary', 'data-action': 'code' }, TEXT.program.toCode),
            ),
      );
    },
  );
}

/** @param {'btn-outline' | 'btn-primary'} [look] */
const recordButton = (look = 'btn-outline') =>
  h('button', { type: 'button', class: `btn ${look}`, 'data-action': 'record' }, icon('record'), TEXT.program.record);

/** @param {RobotDoc} robot */
function head({ joints, units }) {
  const used = [...new Set(joints.map((joint) => unitOf(joint, units)))].join(', ');
  const { name, values } = TEXT.program.heads;
  return h(
    'thead',
    {},
    h(
      'tr',
      {},
      h('td'),
      h('th', { scope: 'col' }, name),
      h('th', { scope: 'col' }, values, ' ', h('span', { class: 'unit' }, used)),
      h('td'),
    ),
  );
}

/** @param {PostureDoc} posture @param {number} index @param {RobotDoc} robot */
function row({ id, q }, index, { joints, units }) {
  const numbers = joints.map((joint, i) => jointNumber(q[i], unitOf(joint, units)));
  const inWords = joints.map((joint, i) => withUnit(numbers[i], unitOf(joint, units))).join(', ');
  return h(
    'tr',
    {},
    h('td', {}, String(index + 1)),
    h(
      'td',
      {},
      h('input', {
        class: 'name-field',
        value: id,
        'data-index': index,
        'data-own-undo': true,
        'aria-label': TEXT.program.name(index + 1),
        'aria-describedby': 'program-reason',
        autocomplete: 'off',
        spellcheck: 'false',
        maxlength: 64,
      }),
    ),
    h(
      'td',
      { class: 'soft', title: inWords },
      h(
        'div',
        { class: 'values' },
        numbers.map((number) => h('span', {}, number)),
      ),
    ),
    h(
      'td',
      {},
      h(
        'button',
        {
          type: 'button',
          class: 'btn btn-icon',
          'data-action': 'go',
          'data-index': index,
          'aria-label': TEXT.program.go(id),
          title: TEXT.program.go(id),
        },
        icon('target'),
      ),
      h(
        'button',
        {
          type: 'button',
          class: 'btn btn-icon',
          'data-action': 'remove',
          'data-index': index,
          'aria-label': TEXT.program.remove(id),
          title: TEXT.program.remove(id),
        },
        icon('trash'),
      ),
    ),
  );
}
