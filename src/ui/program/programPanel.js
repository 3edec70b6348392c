/**
 * Motion programs: recorded, put in order, edited; and, folded away, the recorded postures. Fetched when it is first opened.
 *
 * @import { Files } from '../files/files.js'
 * @import { Page } from '../page.js'
 * @import { StepAct } from './stepCard.js'
 * @import { Workcells } from '../../model/workcell/workcell.js'
 * @import { MoveStep, PoseTarget } from '../../model/document.js'
 */
import { isMove } from '../../model/program/motionProgram.js';
import { postureAt } from '../../model/program/motionPlan.js';
import { poseHere, postureHere, recordedStep } from '../../model/program/newSteps.js';
import { firstPlayback } from '../../model/program/player.js';
import { planNow } from '../../model/program/planning.js';
import { shownProgram } from '../../model/program/shownProgram.js';
import { chosenSteps } from '../../model/program/stepRange.js';
import { travelBetween } from '../../model/aim/solutions.js';
import { together } from '../../model/views.js';
import '../css/program.css';
import '../css/motionProgram.css';
import { fill, h } from '../parts/dom.js';
import { emptyState } from '../parts/emptyState.js';
import { foldMaker } from '../parts/fold.js';
import { icon } from '../parts/icons.js';
import { planNotes } from './planNotes.js';
import { createPosturesList } from './posturesList.js';
import { createProgramHead } from './programHead.js';
import { createProgramName } from './programName.js';
import { createStepTable } from './programTable.js';
import { createReasons } from '../parts/reasons.js';
import { createRangeCard } from './rangeCard.js';
import { createStepActs } from './stepActs.js';
import { createStepCard } from './stepCard.js';
import { stepFaults, stepTouchWords } from './stepFaults.js';
import { emptyPicture } from './stepText.js';
import { travelTo } from '../travel.js';
import { whenFirst } from '../parts/whenFirst.js';
import { PLAN_NOTES } from '../words/planNotes.js';
import { POSTURES, PROGRAM } from '../words/program.js';

/**
 * @param {Page} page
 * @param {HTMLElement} host
 * @param {Files} files
 * @param {() => Promise<Workcells>} cells
 */
export function createProgramPanel(page, host, files, cells) {
  const { store, addView, derived, announce, clock, messages } = page;
  const reasons = createReasons('step-reason');
  const against = h('p', { class: 'reason sm', role: 'note', hidden: true });

  /** @param {string | null} reason */
  function refuse(reason) {
    against.textContent = reason ?? '';
    against.hidden = reason === null;
    if (reason !== null) announce(reason);
  }

  const acts = createStepActs(page, {
    refuse,
    focus: (step) => clock.onFrame(() => clock.onFrame(() => table.focus(step))), // once it is drawn
  });

  function record() {
    const { doc, session } = store.state;
    const { program, step } = shownProgram(store.state);
    const { recording } = session;
    const chain = derived.chain(doc);
    if (recording.kind === 'circular' && recording.via === null) {
      const via = /** @type {PoseTarget} */ (poseHere(doc, chain));
      store.dispatch({ type: 'show', change: { recording: { ...recording, via } } });
      announce(PROGRAM.recordedVia);
      return;
    }
    const before = program?.steps.slice(0, step < 0 ? undefined : step + 1) ?? [];
    const number = acts.insertOne(recordedStep(doc, chain, recording, before));
    if (number === null) return;
    if (recording.via) store.dispatch({ type: 'show', change: { recording: { ...recording, via: null } } });
    announce(PROGRAM.recorded(number));
  }

  /** Where a step ends is drawn as a ghost. @param {number | null} index */
  function look(index) {
    const { program } = shownProgram(store.state);
    const step = index === null ? undefined : program?.steps[index];
    const { doc, session } = store.state;
    const found = step && isMove(step) ? postureAt(doc, step) : null;
    const isElsewhere =
      found && 'posture' in found && !travelBetween(doc.robot, derived.chain(doc), doc.posture, found.posture).isHere;
    const ghost = isElsewhere ? { posture: found.posture, label: PROGRAM.ghost((index ?? 0) + 1) } : null;
    if (ghost || session.ghost) store.dispatch({ type: 'show', change: { ghost } });
  }

  /** @param {StepAct} act */
  function carryOutOn(act) {
    const { program, index, step: at } = shownProgram(store.state);
    const step = program?.steps[at];
    if (!program || !step) return;
    const { doc } = store.state;
    const edit = (/** @type {object} */ change, /** @type {string} */ done) =>
      acts.carryOut({ type: 'edit-step', program: index, step: at, to: { ...step, ...change } }, () => done);
    if (act === 'go' && isMove(step)) go(step, at + 1);
    else if (act === 'again' && isMove(step)) {
      const isPosture = step.target.kind === 'posture' || (step.kind === 'joint' && step.target.kind !== 'pose');
      const target = isPosture ? postureHere(doc) : poseHere(doc, derived.chain(doc));
      const frame = isPosture ? {} : { frame: doc.activeUser };
      edit({ target, ...frame }, PROGRAM.done.again(at + 1));
    } else if (act === 'duplicate' || act === 'disable' || act === 'remove') acts[act]();
  }

  /** @param {MoveStep} step @param {number} number */
  function go(step, number) {
    const found = postureAt(store.state.doc, step);
    if ('message' in found) return refuse(found.message);
    refuse(null);
    travelTo(page, found.posture);
    announce(PROGRAM.went(number));
  }

  /** @param {string} id */
  function chooseProgram(id) {
    const { doc, session } = store.state;
    store.dispatch({
      type: 'show',
      change: { playback: firstPlayback(id, doc.posture, session.playback), step: null },
    });
  }

  const head = createProgramHead(page, {
    record,
    add(step) {
      const number = acts.insertOne(step);
      if (number !== null) announce(PROGRAM.added(number));
    },
    copy: () => void acts.copy(),
    paste: () => void acts.pasteCopied(),
    choose: chooseProgram,
    rename: () => name.focus(),
    say: announce,
    refuse,
  });
  const table = createStepTable(page, reasons, {
    ...acts,
    choose: (index) => acts.choose(shownProgram(store.state).program?.steps[index]?.id ?? null),
    copy: acts.copyBy,
    look,
  });
  const card = createStepCard(page, reasons, carryOutOn);
  const rangeCard = createRangeCard((act) => void acts[act]());
  const name = createProgramName(page, reasons);
  const recordFirst = h(
    'button',
    { type: 'button', class: 'btn btn-primary', 'data-action': 'record' },
    icon('record'),
    PROGRAM.record,
  );
  recordFirst.addEventListener('click', record);
  const empty = emptyState(
    PROGRAM.empty,
    PROGRAM.emptyDetail,
    h('div', { class: 'actions' }, recordFirst, head.examples),
  );

  empty.prepend(emptyPicture());

  const fold = foldMaker(clock, messages.fault)('postures', async (body) => createPosturesList(page, body, files));
  fold.element.classList.add('postures');
  fold.setHead(POSTURES.title); // from the first moment: how many there are is drawn with the rest
  const list = h('ul', { class: 'plan-notes sm' });
  const notes = foldMaker(clock, messages.fault)('plan-notes', async (body) => void fill(body, list));
  // until the first drawing knows which of them are called for
  for (const part of [head.element, table.element, notes.element, empty]) part.hidden = true;
  fill(
    host,
    head.element,
    table.element,
    against,
    reasons.element,
    name.element,
    card.element,
    rangeCard.element,
    notes.element,
    empty,
    fold.element,
  );
  if (store.state.doc.postures.length > 0) fold.set(true);

  addView(
    together((state) => [
      ...[state.doc.robot, state.doc.frames, state.doc.targets, state.doc.motionPrograms, state.doc.postures],
      ...[state.session.step, state.session.stepRange, state.session.recording, state.session.playback?.program],
      ...[stepFaults(state), stepTouchWords(state)],
    ]),
    () => {
      const { doc } = store.state;
      const { program, index, step } = shownProgram(store.state);
      const isEmpty = program === null || program.steps.length === 0;
      const faults = stepFaults(store.state);
      head.draw();
      empty.hidden = !isEmpty;
      table.element.hidden = isEmpty;
      if (program) table.draw(doc, index, step, chosenSteps(store.state), faults, stepTouchWords(store.state));
      const range = chosenSteps(store.state);
      const isAlone = range?.count === 1;
      card.draw(doc, index, isAlone ? step : -1);
      rangeCard.draw(doc, index, range);
      name.draw(program, index, step < 0 && !isEmpty);
      const [fault] = faults.values();
      if (fault !== undefined) refuse(null);
      fill(issue, fault ?? '');
      issue.hidden = fault === undefined;
      fold.setHead(POSTURES.title, POSTURES.count(doc.postures.length));
    },
  );
  addView(
    together((state) => [planNow(state), state.doc.robot.units]),
    ([planned, units]) => {
      const said = planned ? planNotes(planned, units) : [];
      notes.element.hidden = said.length === 0;
      notes.setHead(PLAN_NOTES.title, PLAN_NOTES.count(said.length));
      fill(
        list,
        said.map((text) => h('li', {}, text)),
      );
    },
  );
  whenFirst(
    page,
    (state) => planNow(state) !== null,
    async () => {
      const [{ createCheckPanel }, loaded] = await Promise.all([import('../workcell/checkPanel.js'), cells()]);
      against.after(createCheckPanel(page, loaded, (index) => table.focus(index)));
    },
  );
  const issue = h('p', { class: 'reason sm', role: 'note', hidden: true });
  table.element.after(issue);
  addView(
    ({ session }) => session.edition,
    () => {
      table.forget();
      card.forget();
      refuse(null);
    },
  );
}
