/**
 * Below the steps of a program: whether it keeps clear of obstacles and of itself, what the chosen step touches and where, and the
 * way around it. Nothing of it is seen of an arm that has nothing to touch.
 *
 * @import { Page } from '../page.js'
 * @import { StepTouch } from '../../model/workcell/checked.js'
 * @import { Workcells } from '../../model/workcell/workcell.js'
 */
import { postureFromKernel } from '../../model/compile.js';
import { shownProgram } from '../../model/program/shownProgram.js';
import { checkNow } from '../../model/workcell/programCheck.js';
import { marginNow } from '../../model/workcell/workcellView.js';
import { together } from '../../model/views.js';
import { fill, h } from '../parts/dom.js';
import { fixed } from '../parts/format.js';
import { icon } from '../parts/icons.js';
import { COLLISIONS } from '../words/collisions.js';
import { marginText, touchSentence } from './touchText.js';
import { createWayFinder } from './wayFinder.js';

/** s; what takes less is not worth a word. */
const PATIENCE = 0.3;

/**
 * @param {Page} page
 * @param {Workcells} cells
 * @param {(index: number) => void} choose   a step
 */
export function createCheckPanel(page, cells, choose) {
  const { store, addView, derived, announce, clock } = page;
  const finder = createWayFinder(page, cells);
  const state = h('p', { class: 'check-state sm' });
  const touch = h('p', {});
  const hint = h('p', { class: 'soft sm' }, COLLISIONS.onlyJoint);
  const show = button(COLLISIONS.show, () => shown && showWhere(shown));
  show.addEventListener('blur', () => {
    if (store.state.session.ghost) store.dispatch({ type: 'show', change: { ghost: null } });
  });
  const around = button(COLLISIONS.around, () => shown && finder.find(shown.step));
  around.prepend(icon('plus'));
  const card = h(
    'div',
    { class: 'check-touch' },
    h('div', { class: 'check-words' }, icon('exclamation'), touch),
    h('div', { class: 'obstacle-acts' }, show, around),
    hint,
    finder.element,
  );
  const element = h('section', { class: 'check', 'aria-label': COLLISIONS.section, hidden: true }, state, card);
  /** Of the chosen step. @type {StepTouch | null} */
  let shown = null;

  /** @param {string} text @param {() => void} run */
  function button(text, run) {
    const made = h('button', { type: 'button', class: 'btn btn-small btn-outline' }, text);
    made.addEventListener('click', run);
    return made;
  }

  const again = () => store.dispatch({ type: 'show', change: { check: null } });
  function giveUp() {
    const { check } = store.state.session;
    if (check) store.dispatch({ type: 'show', change: { check: { ...check, progress: null } } });
  }

  /** The arm, there, as a ghost. @param {StepTouch} where */
  function showWhere(where) {
    const { doc } = store.state;
    const posture = postureFromKernel(doc.robot, where.posture);
    store.dispatch({ type: 'show', change: { ghost: { posture, label: COLLISIONS.ghost } } });
    announce(touch.textContent ?? '');
  }

  /** @param {readonly StepTouch[]} touches */
  const links = (touches) =>
    touches.map(({ step }) => {
      const link = button(String(step + 1), () => choose(step));
      link.setAttribute('aria-label', COLLISIONS.toStep(step + 1));
      return link;
    });

  /** Said once, when it is known. @type {readonly StepTouch[] | null} */
  let said = null;
  /** That is looked at, and since when. @type {{ planned: unknown, since: number }} */
  let under = { planned: null, since: 0 };
  addView(
    together((now) => [
      checkNow(now),
      now.session.step,
      now.session.workcell.margin,
      now.doc.robot,
      now.doc.motionPrograms,
    ]),
    ([check, , , { units }]) => {
      const { doc, session } = store.state;
      const { step: chosen, program } = shownProgram(store.state);
      const margin = marginNow(session.workcell, derived.chain(doc));
      const hasNothing = doc.obstacles.length === 0 && !cells.canTouchItself(doc);
      const isEmpty = (program?.steps.length ?? 0) === 0;
      element.hidden = (hasNothing || isEmpty || (check === null && element.hidden)) && !finder.isTelling;
      element.classList.toggle('is-due', check === null && !finder.isTelling);
      if (check && check.planned !== under.planned) under = { planned: check.planned, since: clock.now() };
      shown = check?.touches?.find(({ step }) => step === chosen) ?? null;
      card.hidden = shown === null && !finder.isTelling;
      card.classList.toggle('is-near', shown !== null && !shown.isTouch);
      card.classList.toggle('is-told', shown === null);
      for (const part of [touch.parentElement, show]) if (part) part.hidden = shown === null;
      around.hidden = shown === null || program?.steps[chosen]?.kind !== 'joint';
      hint.hidden = shown === null || !around.hidden;
      touch.textContent = shown ? touchSentence(shown, margin, units) : '';
      // what was said stays in its room until more is known, so that nothing jumps
      if (!check || (check.progress !== null && clock.now() - under.since < PATIENCE)) return;
      state.classList.remove('is-clear', 'is-touching');
      if (check.progress !== null) {
        fill(state, COLLISIONS.checking(fixed(100 * check.progress, 0)), ' ', button(COLLISIONS.cancel, giveUp));
      } else if (!check.touches) fill(state, COLLISIONS.given, ' ', button(COLLISIONS.again, again));
      else if (check.touches.length === 0) {
        state.classList.add('is-clear');
        const isWhole = check.planned.plan.refused === null;
        const text = clearText(marginText(margin, units), doc.obstacles.length, isWhole);
        fill(state, icon('checkCircle'), h('span', {}, text));
      } else {
        state.classList.add('is-touching');
        fill(state, icon('octagon'), h('span', {}, COLLISIONS.notClear), ...links(check.touches));
      }
      if (!check.touches || check.touches === said) return;
      said = check.touches;
      if (said.length > 0) announce(said.map((one) => touchSentence(one, margin, units)).join(' '));
      else if (doc.obstacles.length > 0) announce(state.textContent ?? ''); // that it does not touch itself goes without saying
    },
  );
  finder.onChange(() => {
    card.hidden = shown === null && !finder.isTelling;
    around.disabled = finder.isBusy;
    if (!finder.isTelling) return;
    element.hidden = false;
    element.classList.remove('is-due');
  });
  return element;
}

/** @param {string} margin @param {number} count  of obstacles @param {boolean} isWhole  whether all of the program can be moved */
const clearText = (margin, count, isWhole) =>
  count === 0 ? COLLISIONS.clearOfItself(isWhole) : COLLISIONS.clear(margin, count, isWhole);
