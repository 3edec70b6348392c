/**
 * Keeps what is known of the program's clearances to what program and obstacles are: asks anew whenever the answer may be
 * another, once nobody has a hand on anything, and tells the session how far it is. Whoever makes `check` null asks again; whoever
 * ends its progress gives it up.
 *
 * @import { Page } from '../page.js'
 * @import { CheckPlanAnswer, CheckPlanQuestion } from '../../workers/checkPlan.js'
 * @import { ProgramCheck } from '../../model/workcell/checked.js'
 * @import { Workcells } from '../../model/workcell/workcell.js'
 */
import { checkNow, checkRequest, checkWanted, isSameCheck, stepTouches } from '../../model/workcell/programCheck.js';
import { together } from '../../model/views.js';
import { createLastQuestion } from '../parts/lastQuestion.js';

/** @param {Page} page @param {Workcells} cells */
export function createProgramChecker({ store, addView, derived, clock, messages }, cells) {
  const apart = createLastQuestion(
    'checkPlan',
    (error) => {
      show({ progress: null });
      messages.fault(error);
    },
    (/** @type {CheckPlanAnswer} */ answer) => 'found' in answer,
  );
  /** @type {ReturnType<typeof checkWanted>} that was asked last */
  let asked = null;

  /** @param {Partial<ProgramCheck>} change */
  function show(change) {
    if (!asked) return;
    const now = checkNow(store.state) ?? { ...asked, progress: 0, touches: null };
    store.dispatch({ type: 'show', change: { check: { ...now, ...change } } });
  }

  function ask() {
    const wanted = checkWanted(store.state);
    asked = wanted;
    apart.cancel();
    if (!wanted) return;
    const { planned } = wanted;
    show({ progress: 0, touches: null });
    /** @type {CheckPlanQuestion} */
    const question = checkRequest(store.state, derived.chain(store.state.doc), cells, planned);
    apart.ask(question, (answer) => {
      if (!isSameCheck(wanted, checkWanted(store.state))) return;
      if ('progress' in answer) return show({ progress: answer.progress });
      const touches = stepTouches(answer.found, planned, store.state.doc);
      show({ progress: null, touches });
    });
  }

  /** @type {ReturnType<typeof checkWanted>} */
  let due = null;
  addView(
    together((state) => [
      ...Object.values(checkWanted(state) ?? {}),
      state.gesture === null,
      state.session.check === null,
      state.session.check?.progress === null,
    ]),
    () => {
      const wanted = checkWanted(store.state);
      const { check } = store.state.session;
      if (apart.isBusy && isSameCheck(wanted, asked) && check?.progress === null) return apart.cancel(); // given up
      if (store.state.gesture !== null || (isSameCheck(wanted, due) && check !== null)) return;
      due = wanted;
      clock.onFrame(ask); // not while views are drawn
    },
  );
}
