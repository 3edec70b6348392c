/**
 * The recorded postures, in the order in which controller code visits them: a part of the Program panel.
 *
 * @import { Files } from '../files/files.js'
 * @import { Page } from '../page.js'
 * @import { PostureDoc, RobotDoc } from '../../model/document.js'
 */
import $ from 'jquery/slim';
import { together } from '../../model/views.js';
import '../css/program.css';
import { fill, h, keepFocus } from '../parts/dom.js';
import { POSTURE_CSV } from '../../io/postureCsv.js';
import { download } from '../parts/download.js';
import { emptyState } from '../parts/emptyState.js';
import { fileNameOf } from '../files/files.js';
import { jointNumber, unitOf, withUnit } from '../parts/format.js';
import { icon } from '../parts/icons.js';
import { attempt, openPanel } from '../page.js';
import { TEXT } from '../strings.js';
import { POSTURES } from '../words/program.js';

/**
 * @param {Page} page
 * @param {HTMLElement} host
 * @param {Files} files
 */
export function createPosturesList(page, host, files) {
  const { store, addView, announce, clock } = page;
  const record = recordButton();
  record.hidden = true; // until it is known that the empty room does not offer it
  const content = h('div', {});
  const reasonLine = h('p', { class: 'reason sm', id: 'program-reason', role: 'note', hidden: true });
  fill(host, h('div', { class: 'table-head' }, h('span', { class: 'grow' }), record), content, reasonLine);

  /** @param {string | null} reason */
  function say(reason) {
    reasonLine.textContent = reason ?? '';
    reasonLine.hidden = reason === null;
    if (reason !== null) announce(reason);
  }
  const postureOf = (/** @type {HTMLElement} */ { dataset }) => store.state.doc.postures[Number(dataset.index)];

  $(host)
    .on('click', '[data-action=record]', () => {
      const reason = attempt(page, { type: 'record-posture' });
      say(reason);
      const added = store.state.doc.postures.at(-1);
      if (reason === null && added) announce(POSTURES.recorded(added.id));
    })
    .on('click', '[data-action=go]', ({ currentTarget }) => {
      const { id, q } = postureOf(currentTarget);
      store.dispatch({ type: 'set-posture', posture: q });
      announce(POSTURES.went(id));
    })
    .on('click', '[data-action=remove]', ({ currentTarget }) => {
      const { id } = postureOf(currentTarget);
      store.dispatch({ type: 'remove-posture', index: Number(currentTarget.dataset.index) });
      announce(POSTURES.removed(id));
    })
    .on('click', '[data-action=save]', () => {
      const { doc } = store.state;
      const name = `${fileNameOf(doc.robot.name)}.${POSTURE_CSV.extension}`;
      download(name, POSTURE_CSV.write(doc), POSTURE_CSV.mediaType, clock);
      announce(TEXT.files.saved(name));
    })
    .on('click', '[data-action=open]', files.choose)
    .on('click', '[data-action=code]', () => openPanel(page, 'code'));

  $(host)
    .on('input', 'input', ({ currentTarget }) => void (currentTarget.dataset.editing = ''))
    .on('change', 'input', ({ currentTarget }) => rename(currentTarget))
    .on('keydown', 'input', ({ key, currentTarget }) => {
      if (key === 'Enter') rename(currentTarget);
      if (key !== 'Escape') return;
      delete currentTarget.dataset.editing;
      currentTarget.removeAttribute('aria-invalid');
      currentTarget.value = postureOf(currentTarget).id;
      say(null);
    });

  /** @param {HTMLInputElement} input */
  function rename(input) {
    delete input.dataset.editing;
    const id = input.value.trim();
    const isNew = id !== postureOf(input).id;
    const reason = attempt(page, { type: 'rename-posture', index: Number(input.dataset.index), id });
    if (reason === null) input.removeAttribute('aria-invalid');
    else input.setAttribute('aria-invalid', 'true');
    say(reason);
    if (reason === null && isNew) announce(POSTURES.renamed(id));
  }

  function rebuild() {
    const { robot, postures } = store.state.doc;
    say(null);
    record.hidden = postures.length === 0;
    if (postures.length === 0) {
      fill(
        content,
        emptyState(
          POSTURES.empty,
          POSTURES.emptyDetail,
          h('div', { class: 'actions' }, recordButton('btn-primary'), openButton()),
        ),
      );
      return;
    }
    const rows = postures.map((posture, i) => row(posture, i, robot));
    fill(
      content,
      h('table', { class: 'moves', 'aria-label': POSTURES.title }, head(robot), h('tbody', {}, rows)),
      postures.length === 1 && h('p', { class: 'soft sm inset' }, POSTURES.one),
      h(
        'div',
        { class: 'actions inset' },
        postures.length > 1 &&
          h('button', { type: 'button', class: 'btn btn-primary', 'data-action': 'code' }, POSTURES.toCode),
        h('button', { type: 'button', class: 'btn', 'data-action': 'save' }, icon('download'), POSTURES.saveCsv),
        openButton(),
      ),
    );
  }

  /** A new name alone leaves every element where it is: the press that ended the typing may be on one of them. */
  function renew() {
    store.state.doc.postures.forEach(({ id }, i) => {
      for (const element of content.querySelectorAll(`[data-index="${i}"]`)) nameElement(element, id, i);
    });
  }

  /** @type {readonly PostureDoc[]} */
  let shown = [];
  let shape = '';
  addView(
    together(({ doc, session }) => [doc.postures, doc.robot.units, kindsOf(doc.robot), session.edition]),
    ([postures, units, kinds, edition]) => {
      const wanted = [units.length, units.angle, kinds, edition].join();
      const isSame = wanted === shape && postures.length === shown.length && postures.length > 0;
      if (isSame && postures.every(({ q }, i) => q === shown[i].q)) renew();
      else keepFocus(host, '[data-action=record]', rebuild);
      [shown, shape] = [postures, wanted];
    },
  );
}

/** @param {RobotDoc} robot */
const kindsOf = ({ joints }) => joints.map(({ type }) => type).join(' ');

/** @param {'btn-outline' | 'btn-primary'} [look] */
const recordButton = (look = 'btn-outline') =>
  h('button', { type: 'button', class: `btn ${look}`, 'data-action': 'record' }, icon('record'), POSTURES.record);

const openButton = () =>
  h(
    'button',
    { type: 'button', class: 'btn', 'data-action': 'open', title: POSTURES.openCsvTitle },
    icon('folder'),
    POSTURES.openCsv,
  );

/** @param {RobotDoc} robot */
function head({ joints, units }) {
  const used = [...new Set(joints.map((joint) => unitOf(joint, units)))].join(', ');
  const { name, values } = POSTURES.heads;
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

/** What a control of a row is called, by the posture's name. @param {Element} element @param {string} id @param {number} index */
function nameElement(element, id, index) {
  if (element instanceof HTMLInputElement) {
    if (!('editing' in element.dataset)) element.value = element.title = id;
    element.setAttribute('aria-label', POSTURES.name(index + 1));
    return;
  }
  const label = element.getAttribute('data-action') === 'go' ? POSTURES.go(id) : POSTURES.remove(id);
  element.setAttribute('aria-label', label);
  element.setAttribute('title', label);
}

/** @param {PostureDoc} posture @param {number} index @param {RobotDoc} robot */
function row({ id, q }, index, { joints, units }) {
  const numbers = joints.map((joint, i) => jointNumber(q[i], unitOf(joint, units)));
  const inWords = joints.map((joint, i) => withUnit(numbers[i], unitOf(joint, units))).join(', ');
  const field = h('input', {
    class: 'name-field',
    ...{ 'data-action': 'name', 'data-index': index, 'aria-describedby': 'program-reason' },
    ...{ autocomplete: 'off', spellcheck: 'false', maxlength: 64 },
  });
  const button = (/** @type {'go' | 'remove'} */ action) =>
    h(
      'button',
      { type: 'button', class: 'btn btn-icon', 'data-action': action, 'data-index': index },
      icon(action === 'go' ? 'target' : 'trash'),
    );
  const controls = [field, button('go'), button('remove')];
  for (const control of controls) nameElement(control, id, index);
  const values = h(
    'div',
    { class: 'values' },
    numbers.map((number) => h('span', {}, number)),
  );
  return h(
    'tr',
    {},
    h('td', {}, String(index + 1)),
    h('td', {}, field),
    h('td', { class: 'soft', title: inWords }, values),
    h('td', {}, controls.slice(1)),
  );
}
