/**
 * A way around for a joint move: looked for in a worker, seeded, with progress and a way to cancel; what is found is put in as
 * moves, in one step to undo. Where none is found, that is all that is said: never that there is none.
 *
 * @import { Page } from '../page.js'
 * @import { PlanAroundAnswer, PlanAroundQuestion } from '../../workers/planAround.js'
 * @import { Workcells } from '../../model/workcell/workcell.js'
 */
import { planNow } from '../../model/program/planning.js';
import { shownProgram } from '../../model/program/shownProgram.js';
import { aroundRequest, endsOfMove, waySteps } from '../../model/workcell/programCheck.js';
import { named } from '../../model/workcell/workcell.js';
import { together } from '../../model/views.js';
import { fill, h } from '../parts/dom.js';
import { fixed } from '../parts/format.js';
import { createLastQuestion } from '../parts/lastQuestion.js';
import { attempt } from '../page.js';
import { COLLISIONS } from '../words/collisions.js';
import { bodiesText } from './closenessText.js';

/** Of one search; whoever wants goes on with another seed. */
const ITERATIONS = 10_000;

const grouped = (/** @type {number} */ count) => String(count).replace(/\B(?=(\d{3})+$)/g, ' ');

/** @param {Page} page @param {Workcells} cells */
export function createWayFinder(page, cells) {
  const { store, addView, derived, clock, announce, messages } = page;
  const apart = createLastQuestion(
    'planAround',
    (error) => {
      tell();
      messages.fault(error);
    },
    (/** @type {PlanAroundAnswer} */ answer) => 'found' in answer,
  );
  const text = h('p', {});
  const bar = h('progress', { max: ITERATIONS, 'aria-label': COLLISIONS.progress });
  const acts = h('div', { class: 'obstacle-acts' });
  const element = h('div', { class: 'way-finder sm', hidden: true }, text, bar, acts);
  /** @type {() => void} */
  let changed = () => {};
  /** The steps are others because of what was found. */
  let isOwn = false;

  /** @param {string} [words] @param {HTMLElement[]} [buttons] @param {number | null} [iterations]  null: nothing is under way */
  function tell(words = '', buttons = [], iterations = null) {
    text.textContent = words;
    element.hidden = words === '';
    bar.hidden = iterations === null;
    bar.value = iterations ?? 0;
    if (acts.childElementCount !== buttons.length || iterations === null) fill(acts, ...buttons);
    changed();
  }

  /** @param {string} label @param {() => void} run */
  function button(label, run) {
    const made = h('button', { type: 'button', class: 'btn btn-small btn-outline' }, label);
    made.addEventListener('click', run);
    return made;
  }

  /** What is said at the end. @param {string} words @param {HTMLElement[]} [buttons] */
  function end(words, buttons) {
    tell(words, buttons);
    announce(words);
  }

  /** @param {number} step @param {number} seed @param {{ iterations: number, seconds: number }} spent  by searches before */
  function find(step, seed = 1, spent = { iterations: 0, seconds: 0 }) {
    const { program, index } = shownProgram(store.state);
    const planned = planNow(store.state);
    const ends = planned && endsOfMove(planned, step);
    if (!program || !ends) return;
    const begun = clock.now();
    const { doc } = store.state;
    /** @type {Omit<PlanAroundQuestion, 'id'>} */
    const question = aroundRequest(store.state, derived.chain(doc), cells, ends, { seed, iterations: ITERATIONS });
    const seconds = () => spent.seconds + clock.now() - begun;
    const cancel = button(COLLISIONS.cancel, () => {
      apart.cancel();
      end(COLLISIONS.stopped);
    });
    const looking = (/** @type {number} */ iterations) =>
      tell(COLLISIONS.looking(grouped(spent.iterations + iterations), fixed(seconds(), 1)), [cancel], iterations);
    looking(0);
    announce(COLLISIONS.looking('0', '0'));
    apart.ask(question, (answer) => {
      if ('iterations' in answer) return looking(answer.iterations);
      const { found } = answer;
      if (found.status === 'found') {
        const steps = waySteps(doc, index, step, found.way);
        if (steps.length === 0) return end(COLLISIONS.straight);
        isOwn = true;
        const against = attempt(page, { type: 'insert-steps', program: index, at: step, steps });
        return end(against ?? COLLISIONS.found(steps.length, step + 1 + steps.length, fixed(seconds(), 1)));
      }
      if (found.status === 'not-found') {
        const all = { iterations: spent.iterations + found.iterations, seconds: seconds() };
        const on = button(COLLISIONS.tryOn, () => find(step, seed + 1, all));
        return end(COLLISIONS.notFound(fixed(all.seconds, 1), grouped(all.iterations)), [on]);
      }
      end(COLLISIONS[found.status](...bodiesText(named(doc, found.touch))));
    });
  }

  // what is looked for is a way for this program among these obstacles; what was told is of the step that is chosen
  addView(
    together(({ doc, session }) => [
      doc.obstacles,
      doc.robot,
      session.step,
      shownProgram({ doc, session }).program?.steps.length,
      session.workcell.margin,
    ]),
    () => {
      if (isOwn) isOwn = false;
      else if (apart.isBusy) {
        apart.cancel();
        end(COLLISIONS.stopped);
      } else tell();
    },
  );

  return {
    element,
    find: (/** @type {number} */ step) => find(step),
    get isBusy() {
      return apart.isBusy;
    },
    /** Something is under way, or was found out. */
    get isTelling() {
      return !element.hidden;
    },
    /** @param {() => void} told */
    onChange(told) {
      changed = told;
    },
  };
}
