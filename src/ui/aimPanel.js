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
import { editable, unitSign } from './format.js';
import { icon } from './icons.js';
import { readNumber } from './numberText.js';
import { POSE_NAMES } from './posePanel.js';
import { TEXT } from './strings.js';

/** Decimals that a target taken from the tool begins with: more than the eye needs, less than noise. */
const TAKEN_DIGITS = 8;

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
  const verdict = h('p', { class: 'verdict-line sm', role: 'status' });
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
  /** What the fields say: the typed target, or the tool while nobody aims. @param {AppState} state */
  const target = ({ doc, session }) => session.target ?? toolNow(doc.robot, derived.tcp(doc));
  const poseOf = memo(poseFromXyzwpr);

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

  /** All six fields as numbers, or null after marking the first that is none. @returns {readonly number[] | null} */
  function read() {
    /** @type {number[]} */
    const numbers = [];
    for (const [k, field] of fields.entries()) {
      // A field that still shows what was put there keeps all its digits.
      const { value, reason } =
        field.value === field.dataset.shown ? { value: target(store.state)[k], reason: null } : readNumber(field.value);
      if (reason !== null) {
        mark(reason, field);
        announce(reason);
        field.focus();
        return null;
      }
      numbers.push(value);
    }
    mark(null);
    return numbers;
  }

  function aimThere() {
    const numbers = read();
    if (!numbers) return;
    const { doc } = store.state;
    const answer = aim(doc, derived.chain(doc), poseOf(doc.robot, numbers));
    if (answer.isMet) store.dispatch({ type: 'set-posture', posture: answer.posture });
    store.dispatch({ type: 'show', change: { target: numbers, answer } });
    announce(verdictInWords(store.state.doc.robot, answer));
  }

  $(form).on('submit', (event) => {
    event.preventDefault();
    aimThere();
  });
  $(form).on('input', 'input', ({ currentTarget }) => {
    const k = Number(currentTarget.dataset.index);
    const { value, reason } = readNumber(currentTarget.value);
    if (reason !== null) return; // said when the person asks to move
    mark(null);
    store.dispatch({ type: 'show', change: { target: roundOthers(target(store.state), k, value), answer: null } });
  });
  $(follow).on('click', () => {
    mark(null);
    store.dispatch({ type: 'show', change: { target: null, answer: null } });
    for (const field of fields) field.dataset.shown = '';
    announce(TEXT.aim.following);
  });
  $(nearest).on('click', () => {
    const { answer } = store.state.session;
    if (!answer) return;
    store.dispatch({ type: 'set-posture', posture: answer.posture });
    announce(TEXT.aim.wentNearest);
  });

  addView(
    together((state) => [target(state), state.doc.robot]),
    ([numbers, robot]) =>
      numbers.forEach((value, k) => {
        const unit = robot.units[k < 3 ? 'length' : 'angle'];
        units[k].textContent = unitSign(unit);
        fields[k].setAttribute('aria-label', TEXT.aim.field(POSE_NAMES[k], TEXT.table.unitName[unit]));
        const text = editable(Number(value.toPrecision(TAKEN_DIGITS)));
        const isBusy = document.activeElement === fields[k] || fields[k].getAttribute('aria-invalid') === 'true';
        if (isBusy || fields[k].dataset.shown === text) return;
        fields[k].value = fields[k].dataset.shown = text;
      }),
  );
  addView(
    together((state) => [state.doc.robot, derived.tcp(state.doc), target(state), state.session]),
    ([robot, T_base_tcp, numbers, { target: asked, answer }]) => {
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

/** The typed number, beside the others rounded to what their fields show. @param {readonly number[]} numbers @param {number} k @param {number} value */
const roundOthers = (numbers, k, value) =>
  numbers.map((other, i) => (i === k ? value : Number(other.toPrecision(TAKEN_DIGITS))));
