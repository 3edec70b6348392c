/**
 * The target: its numbers, "move there", and what inverse kinematics said. Until someone types, the fields follow the tool.
 * Other forms of the same target, pasting, copying and the helpers are fetched when they are first asked for
 * (targetMenus.js).
 *
 * @import { Page } from '../page.js'
 */
import $ from 'jquery/slim';
import { aim, isAtAnswer, poseFromXyzwpr } from '../../model/aim/aim.js';
import { memo } from '../../model/memo.js';
import { together } from '../../model/views.js';
import { differenceInWords, verdictInWords } from './verdict.js';
import { fill, h } from '../parts/dom.js';
import { foldMaker } from '../parts/fold.js';
import { icon } from '../parts/icons.js';
import { createTargetFields } from './targetFields.js';
import { createTargetParts } from './targetParts.js';
import { TEXT } from '../strings.js';

/**
 * @param {Page} page
 * @param {HTMLElement} host
 */
export function createAimPanel(page, host) {
  const { store, addView, derived, announce } = page;
  const parts = createTargetParts();
  const verdict = h('p', { class: 'verdict-line sm' });
  const move = h('button', { type: 'submit', class: 'btn btn-primary' }, TEXT.aim.move);
  const nearest = h('button', { type: 'button', class: 'btn btn-outline' }, TEXT.aim.nearest);
  const numbers = h('div', {});
  const form = h(
    'form',
    { class: 'body', novalidate: true },
    parts.apart,
    numbers,
    h('div', { class: 'aim-foot' }, verdict, h('div', { class: 'actions' }, nearest, move)),
  );
  fill(host, parts.header, parts.bar, form);
  const fields = createTargetFields(page, numbers);
  const fetchMenus = whenAsked(page, host, async () => {
    const { runTargetMenus } = await import('./targetMenus.js');
    return runTargetMenus(page, parts, fields);
  });
  // A whole pose that is pasted into one of the fields is looked at first.
  numbers.addEventListener('paste', async (event) => {
    const text = event.clipboardData?.getData('text') ?? '';
    if (!isWholePose(text, event.target)) return;
    event.preventDefault();
    try {
      (await fetchMenus()).openPaste(text);
    } catch (error) {
      page.messages.fault(error);
    }
  });
  // There is a choice where a user frame is active.
  addView(
    ({ doc }) => doc.activeUser !== undefined,
    (isChoice) => ([parts.world.hidden, parts.from.hidden] = [isChoice, !isChoice]),
  );
  const fold = foldMaker(page.clock, page.messages.fault);
  const solutions = fold('fold-solutions', async (body) => {
    const [{ createSolutionsPanel }, { SOLUTIONS }] = await Promise.all([
      import('./solutionsPanel.js'),
      import('../words/solutions.js'),
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

  function aimThere() {
    if (!fields.areReady(aimThere)) return;
    const { doc } = store.state;
    const wanted = fields.target(store.state);
    const answer = aim(doc, derived.chain(doc), poseOf(doc.robot, wanted));
    if (answer.isMet) store.dispatch({ type: 'set-posture', posture: answer.posture });
    store.dispatch({ type: 'show', change: { target: wanted, answer } });
    announce(verdictInWords(doc.robot, answer));
  }

  $(form).on('submit', (event) => {
    event.preventDefault();
    aimThere();
  });
  $(parts.follow).on('click', () => {
    store.dispatch({ type: 'show', change: { target: null, answer: null } });
    fields.forget();
    announce(TEXT.aim.following);
  });
  $(nearest).on('click', () => {
    const { answer } = store.state.session;
    if (!answer) return;
    store.dispatch({ type: 'set-posture', posture: answer.posture });
    announce(TEXT.aim.wentNearest);
  });

  addView(
    together((state) => [
      state.doc.robot,
      derived.tcp(state.doc),
      fields.target(state),
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
      fill(
        verdict,
        tone === 'good' || tone === 'part' ? icon('checkCircle') : tone === 'bad' ? icon('slash') : null,
        h('span', {}, text),
      );
      nearest.hidden = !answer || answer.isMet || isThere || isAtAnswer(answer, posture);
    },
  );
}

/** More than the field itself can take. @param {string} text @param {EventTarget | null} field */
function isWholePose(text, field) {
  const takesSeveral = field instanceof HTMLElement && field.closest('.aim-several') && /^[-−+\d\s.,;e]+$/.test(text);
  return !takesSeveral && text.split(/[\s,;:=]+/).filter((part) => /\d/.test(part)).length >= 3;
}

/**
 * What a button asks for is fetched when the hand comes near it; the first press of one waits for it and is then made again.
 * @template Tools
 * @param {Page} page
 * @param {HTMLElement} host
 * @param {() => Promise<Tools>} fetchIt
 * @returns {() => Promise<Tools>}
 */
function whenAsked({ messages }, host, fetchIt) {
  /** @type {Promise<Tools> | null} */
  let fetched = null;
  let isHere = false;
  /** What failed to come once may come the next time. */
  const start = () =>
    (fetched ??= fetchIt().then(
      (tools) => {
        isHere = true;
        return tools;
      },
      (error) => {
        fetched = null;
        throw error;
      },
    ));
  // What is under the hand may be wanted next; if it does not come, that is said when it is asked for.
  $(host).on('pointerover focusin', '[data-ask]', () => void start().catch(() => {}));
  $(host).on('click', '[data-ask]', async ({ currentTarget }) => {
    if (isHere) return;
    try {
      await start();
      currentTarget.click();
    } catch (error) {
      messages.fault(error);
    }
  });
  return start;
}
