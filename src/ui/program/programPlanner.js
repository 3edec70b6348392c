/**
 * Keeps the plan of the motion program to what the program is: asks for it anew whenever the answer may be another, once
 * nobody has a hand on the arm, and tells the session how far it is.
 *
 * @import { Page } from '../page.js'
 * @import { Planned, Planning, Question } from '../../model/program/planned.js'
 */
import { inSlices } from '../../model/inSlices.js';
import { isSameQuestion, questionNow } from '../../model/program/planning.js';
import { planRequest } from '../../model/program/planRequest.js';
import { seriesOf } from '../../model/program/planSeries.js';
import { together } from '../../model/views.js';
import { createPlanApart } from './planApart.js';

/** s; what takes less is not worth a word. */
const PATIENCE = 0.3;

/** s of work between two pictures. */
const SLICE = 0.006;

/** @type {Pick<Planning, 'progress' | 'planned' | 'series' | 'issues' | 'isGivenUp'>} */
const NOTHING = { progress: null, planned: null, series: null, issues: [], isGivenUp: false };

/** @param {Page} page */
export function createProgramPlanner({ store, addView, derived, clock, messages }) {
  const apart = createPlanApart((error) => {
    show({ progress: null });
    messages.fault(error);
  });
  /** @type {Question | null} that was asked last */
  let asked = null;
  let stopWaiting = () => {};
  let stopMaking = () => {};

  /** @param {Partial<Planning>} change */
  function show(change) {
    const { planning } = store.state.session;
    const question = planning?.question ?? asked;
    if (!question) return;
    const now = planning ?? { question, ...NOTHING };
    store.dispatch({ type: 'show', change: { planning: { ...now, ...change } } });
  }

  /** @param {Question} question */
  function ask(question) {
    giveUp();
    asked = question;
    const chain = derived.chain(question.doc);
    let progress = 0;
    stopWaiting = clock.after(PATIENCE, () => show({ progress }));
    stopMaking = inSlices(planRequest(question, chain), clock, {
      onDone({ request, issues, ...found }) {
        if (issues.length === 0) apart.ask(request, onProgress, (plan) => onPlan({ plan, ...found }));
        else {
          stopWaiting();
          show({ question, ...NOTHING, issues });
        }
      },
      onFault(error) {
        giveUp();
        show({ progress: null });
        messages.fault(error);
      },
    });

    /** @param {number} share */
    function onProgress(share) {
      const isSeen = store.state.session.planning?.progress ?? null;
      progress = share;
      if (isSeen !== null) show({ progress });
    }

    /** @param {Planned} planned */
    function onPlan(planned) {
      stopWaiting();
      show({ question, ...NOTHING, planned });
      sample(planned, seriesOf(planned, chain));
    }
  }

  /** Whatever is under way. */
  function giveUp() {
    stopWaiting();
    stopMaking();
    apart.cancel();
  }

  /** Whoever draws it waits for it, and nobody else. @param {Planned} planned @param {ReturnType<typeof seriesOf>} run */
  function sample(planned, run) {
    const goOn = () => {
      if (store.state.session.planning?.planned !== planned) return;
      const begun = clock.now();
      for (;;) {
        const { done, value } = run.next();
        if (done) return show({ series: value });
        if (clock.now() - begun > SLICE) return clock.onFrame(goOn);
      }
    };
    goOn();
  }

  addView(
    together((state) => [questionNow(state), state.gesture === null]),
    ([question, isAtRest]) => {
      if (!isAtRest || isSameQuestion(question, asked)) return;
      if (question)
        clock.onFrame(() => ask(question)); // not while views are drawn
      else asked = null;
    },
  );

  return {
    cancel() {
      giveUp();
      if (asked) show({ question: asked, ...NOTHING, isGivenUp: true });
    },
    again() {
      if (asked) ask(asked);
    },
  };
}
