/**
 * The target: six numbers, "move there", and what inverse kinematics said. Until someone types, the fields follow the tool.
 *
 * @import { Page } from './page.js'
 * @import { AppState } from '../model/session.js'
 */
import $ from 'jquery/slim';
import { aim, isAtAnswer, poseFromXyzwpr } from '../model/aim.js';
import { memo } from '../model/memo.js';
import { together } from '../model/views.js';
import { differenceInWords, verdictInWords } from './verdict.js';
import { fill, h } from './dom.js';
import { foldMaker } from './fold.js';
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
  const reasonLine = h('p', { class: 'reason sm', id: 'aim-reason', hidden: true });
  const verdict = h('p', { class: 'verdict-line sm' });
  const move = h('button', { type: 'submit', class: 'btn btn-primary' }, TEXT.aim.move);
  const nearest = h('button', { type: 'button', class: 'btn btn-outline' }, TEXT.aim.nearest);
  const fields = POSE_NAMES.map(() =>
    h('input', {
      type: 'text',
      inputmode: 'text',
      autocomplete: 'off',
      spellcheck: 'false',
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
  const fold = foldMaker(page.clock, page.messages.fault);
  const solutions = fold('fold-solutions', async (body) => {
    const [{ createSolutionsPanel }, { SOLUTIONS }] = await Promise.all([
      import('./solutionsPanel.js'),
      import('./words/solutions.js'),
    ]);
    createSolutionsPanel(page, body, (...counts) =>
      solutions.setHead(TEXT.aim.solutions, SOLUTIONS.summary(...counts)),
    );
  });
  solutions.setHead(TEXT.aim.solutions, TEXT.aim.solutionsDetail);
  const named = fold('fold-targets', async (body) =>
    (await import('./targetsPanel.js')).createTargetsPanel(page, body),
  );
  addView(
    ({ doc }) => doc.targets.length,
    (count) => named.setHead(TEXT.aim.named, count === 0 ? TEXT.aim.noneNamed : String(count)),
  );
  host.append(solutions.element, named.element);

  const poseOf = memo(poseFromXyzwpr);
  /** What the fields say: the target someone asked for, or the tool while nobody aims. @param {AppState} state */
  const target = ({ doc, session }) => session.target ?? derived.xyzwpr(doc);
  const unitOfField = (/** @type {number} */ k) => store.state.doc.robot.units[k < 3 ? 'length' : 'angle'];

  /** @param {HTMLInputElement} field @param {string | null} reason */
  function mark(field, reason) {
    if (reason) field.setAttribute('aria-invalid', 'true');
    else field.removeAttribute('aria-invalid');
    field.parentElement?.classList.toggle('is-invalid', reason !== null);
    const [first] = fields.flatMap((other) => (isRefused(other) ? [readNumber(other.value).reason ?? ''] : []));
    reasonLine.textContent = first ?? '';
    reasonLine.hidden = first === undefined;
  }
  const isRefused = (/** @type {HTMLInputElement} */ field) => field.getAttribute('aria-invalid') === 'true';

  /** The target, unless a field holds no number: that one is then marked. @returns {readonly number[] | null} */
  function read() {
    for (const field of fields) delete field.dataset.editing;
    for (const field of fields) {
      const { reason } = readNumber(field.value);
      if (reason === null) continue;
      mark(field, reason);
      announce(reason);
      field.focus();
      return null;
    }
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
  $(form).on('input', 'input', ({ currentTarget: field }) => {
    field.dataset.editing = '';
    const { value, reason } = readNumber(field.value);
    if (reason !== null) return; // said when the person leaves the field
    mark(field, null);
    ask(fields.indexOf(field), value);
  });
  $(form).on('focusout', 'input', ({ currentTarget: field }) => {
    const wasEdited = 'editing' in field.dataset;
    delete field.dataset.editing;
    const { reason } = readNumber(field.value);
    if (wasEdited && reason !== null) announce(reason);
    mark(field, reason);
    show(field, fields.indexOf(field));
  });
  $(follow).on('click', () => {
    store.dispatch({ type: 'show', change: { target: null, answer: null } });
    forget();
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
    if ('editing' in field.dataset || isRefused(field)) return;
    const value = target(store.state)[k];
    field.value = store.state.session.target ? editable(value) : poseNumber(value, unitOfField(k));
  }

  /** What stands in the fields was meant for another target. */
  function forget() {
    fields.forEach((field, k) => {
      delete field.dataset.editing;
      mark(field, null);
      show(field, k);
      units[k].textContent = unitSign(unitOfField(k));
      field.setAttribute('aria-label', TEXT.aim.field(POSE_NAMES[k], TEXT.table.unitName[unitOfField(k)]));
    });
  }

  let edition = -1;
  addView(
    together((state) => [target(state), state.session.edition]),
    ([, now]) => {
      if (now !== edition) forget();
      else fields.forEach(show);
      edition = now;
    },
  );
  addView(
    together((state) => [
      state.doc.robot,
      derived.tcp(state.doc),
      target(state),
      state.session.target,
      state.session.answer,
      state.doc.posture,
    ]),
    ([robot, T_world_tcp, numbers, asked, answer, posture]) => {
      const { text, tone, isThere } = differenceInWords(
        robot,
        T_world_tcp,
        poseOf(robot, numbers),
        asked !== null,
        answer,
        posture,
      );
      verdict.dataset.tone = tone;
      fill(verdict, tone === 'good' ? icon('checkCircle') : tone === 'bad' ? icon('slash') : null, h('span', {}, text));
      nearest.hidden = !answer || answer.isMet || isThere || isAtAnswer(answer, posture);
    },
  );
}
