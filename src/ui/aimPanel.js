/**
 * The target: six numbers, "move there", and what inverse kinematics said. Until someone types, the fields follow the tool.
 *
 * @import { Page } from './page.js'
 * @import { AppState } from '../model/session.js'
 */
import $ from 'jquery/slim';
import { aim, poseFromXyzwpr, xyzwprOf } from '../model/aim.js';
import { memo } from '../model/memo.js';
import { together } from '../model/views.js';
import { differenceInWords, verdictInWords } from './verdict.js';
import { fill, h } from './dom.js';
import { editable, poseNumber, roundedPose, unitSign } from './format.js';
import { icon } from './icons.js';
import { readNumber } from './numberText.js';
import { POSE_NAMES } from './posePanel.js';
import { TEXT } from './strings.js';

/**
 * @param {Page} page
 * @param {HTMLElement} host
 */
export function createAimPanel(page, host) {
  const { store, addView, derived, announce } = page;
  const follow = h(
    'button',
    { type: 'button', class: 'btn btn-icon', 'aria-label': TEXT.aim.follow, title: TEXT.aim.follow },
    icon('crosshair'),
  );
  const reasonLine = h('p', { class: 'reason sm', id: 'aim-reason' });
  const verdict = h('p', { class: 'verdict-line sm' });
  const move = h('button', { type: 'submit', class: 'btn btn-primary' }, TEXT.aim.move);
  const nearest = h('button', { type: 'button', class: 'btn btn-outline' }, TEXT.aim.nearest);
  const fields = POSE_NAMES.map((_, k) =>
    h('input', {
      type: 'text',
      inputmode: 'text',
      autocomplete: 'off',
      spellcheck: 'false',
      'data-index': k,
      'data-own-undo': true,
      'aria-describedby': reasonLine.id,
    }),
  );
  const units = POSE_NAMES.map(() => h('span', { class: 'unit' }));
  const form = h(
    'form',
    { class: 'body', novalidate: true },
    h(
      'div',
      { class: 'aim-fields' },
      POSE_NAMES.map((name, k) =>
        h(
          'label',
          { class: 'field' },
          h('b', { class: k < 3 ? `axis-${'xyz'[k]}` : 'soft' }, name),
          fields[k],
          units[k],
        ),
      ),
    ),
    reasonLine,
    verdict,
    h('div', { class: 'actions' }, nearest, move),
  );
  fill(
    host,
    h(
      'header',
      {},
      h('h2', {}, TEXT.aim.title),
      h('span', { class: 'soft' }, TEXT.pose.frame),
      h('span', { class: 'grow' }),
      h('span', { class: 'soft' }, TEXT.pose.convention),
      follow,
    ),
    form,
  );

  const toolNow = memo(xyzwprOf);
  const poseOf = memo(poseFromXyzwpr);
  /** What the fields say: the target someone asked for, or the tool while nobody aims. @param {AppState} state */
  const target = ({ doc, session }) => session.target ?? toolNow(doc.robot, derived.tcp(doc));
  const unitOfField = (/** @type {number} */ k) => store.state.doc.robot.units[k < 3 ? 'length' : 'angle'];

  /** @param {string | null} reason @param {HTMLInputElement} [field] */
  function mark(reason, field) {
    for (const other of fields) {
      const isBad = reason !== null && other === field;
      if (isBad) other.setAttribute('aria-invalid', 'true');
      else other.removeAttribute('aria-invalid');
      other.parentElement?.classList.toggle('is-invalid', isBad);
    }
    reasonLine.textContent = reason ?? '';
    reasonLine.hidden = reason === null;
  }

  /** The target, unless a field holds no number: that one is then marked. @returns {readonly number[] | null} */
  function read() {
    for (const field of fields) {
      const { reason } = readNumber(field.value);
      if (reason === null) continue;
      mark(reason, field);
      announce(reason);
      field.focus();
      return null;
    }
    mark(null);
    return target(store.state);
  }

  function aimThere() {
    const numbers = read();
    if (!numbers) return;
    const { doc } = store.state;
    const answer = aim(doc, derived.chain(doc), poseOf(doc.robot, numbers));
    if (answer.isMet) store.dispatch({ type: 'set-posture', posture: answer.posture });
    store.dispatch({ type: 'show', change: { target: numbers, answer } });
    announce(verdictInWords(doc.robot, answer));
  }

  /** From the first typed number on, the others are what their fields show. @param {number} typed @param {number} value */
  function ask(typed, value) {
    const isFirst = store.state.session.target === null;
    const numbers = target(store.state).map((old, k) =>
      k === typed ? value : isFirst ? roundedPose(old, unitOfField(k)) : old,
    );
    store.dispatch({ type: 'show', change: { target: numbers, answer: null } });
  }

  $(form).on('submit', (event) => {
    event.preventDefault();
    aimThere();
  });
  $(form).on('input', 'input', ({ currentTarget }) => {
    const { value, reason } = readNumber(currentTarget.value);
    if (reason !== null) return; // said when the person asks to move
    mark(null);
    ask(Number(currentTarget.dataset.index), value);
  });
  $(follow).on('click', () => {
    for (const field of fields) field.value = '';
    mark(null);
    store.dispatch({ type: 'show', change: { target: null, answer: null } });
    fields.forEach(show);
    announce(TEXT.aim.following);
  });
  $(nearest).on('click', () => {
    const { answer } = store.state.session;
    if (!answer) return;
    store.dispatch({ type: 'set-posture', posture: answer.posture });
    announce(TEXT.aim.wentNearest);
  });

  /** @param {HTMLInputElement} field @param {number} k */
  function show(field, k) {
    if (document.activeElement === field || field.getAttribute('aria-invalid') === 'true') return;
    const value = target(store.state)[k];
    field.value = store.state.session.target ? editable(value) : poseNumber(value, unitOfField(k));
  }
  $(form).on('focusout', 'input', ({ currentTarget }) => {
    // A text that is a number stands as the document would write it; any other waits for the person to mend it.
    if (readNumber(currentTarget.value).reason === null)
      currentTarget.value = editable(target(store.state)[Number(currentTarget.dataset.index)]);
  });

  addView(
    ({ doc }) => doc.robot,
    () => {
      mark(null);
      fields.forEach((field, k) => {
        units[k].textContent = unitSign(unitOfField(k));
        field.setAttribute('aria-label', TEXT.aim.field(POSE_NAMES[k], TEXT.table.unitName[unitOfField(k)]));
      });
    },
  );
  addView(target, () => fields.forEach(show));
  addView(
    together((state) => [
      state.doc.robot,
      derived.tcp(state.doc),
      target(state),
      state.session.target,
      state.session.answer,
    ]),
    ([robot, T_base_tcp, numbers, asked, answer]) => {
      const { text, tone, isThere } = differenceInWords(
        robot,
        T_base_tcp,
        poseOf(robot, numbers),
        asked !== null,
        answer,
      );
      verdict.dataset.tone = tone;
      fill(verdict, tone === 'good' ? icon('checkCircle') : tone === 'bad' ? icon('slash') : null, h('span', {}, text));
      nearest.hidden = !answer || answer.isMet || isThere;
    },
  );
}
