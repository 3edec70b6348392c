/**
 * The move at which a program stops: why, in words, and the way to its step, with the arm where it would stop as a ghost.
 *
 * @import { Page } from '../page.js'
 * @import { Planned } from '../../model/program/planned.js'
 */
import $ from 'jquery/slim';
import { postureFromKernel } from '../../model/compile.js';
import { shownProgram } from '../../model/program/shownProgram.js';
import { fill, h } from '../parts/dom.js';
import { fixed } from '../parts/format.js';
import { icon } from '../parts/icons.js';
import { openPanel } from '../page.js';
import { TIMELINE } from '../words/timeline.js';

/**
 * @param {NonNullable<Planned['plan']['refused']>} refused
 * @param {number} step  from 1
 */
export function refusedInWords({ reason, joint, share }, step) {
  const name = `J${(joint ?? 0) + 1}`;
  const percent = fixed(100 * share, 0);
  if (reason === 'limit') return { short: TIMELINE.refused.limit(step, name), why: TIMELINE.why.limit(name, percent) };
  if (reason === 'start' || reason === 'arc') {
    return { short: TIMELINE.refused[reason](step), why: TIMELINE.why[reason] };
  }
  return { short: TIMELINE.refused[reason](step), why: TIMELINE.why[reason](percent) };
}

/** @param {Page} page */
export function createRefusedButton(page) {
  const { store, announce } = page;
  const words = h('span', {});
  const element = h('button', { type: 'button', class: 'btn refused-move', hidden: true }, icon('exclamation'), words);
  /** @type {Planned | null} */
  let shown = null;

  /** @param {Planned} planned */
  const stepOf = ({ plan: { refused }, steps }) => (refused ? steps[refused.move] : -1);

  $(element).on('click', () => {
    const refused = shown?.plan.refused;
    if (!shown || !refused) return;
    const step = stepOf(shown);
    const { program } = shownProgram(store.state);
    openPanel(page, 'program');
    store.dispatch({
      type: 'show',
      change: {
        step: program?.steps[step]?.id ?? null,
        ghost: { posture: postureFromKernel(store.state.doc.robot, refused.posture), label: TIMELINE.refusedGhost },
      },
    });
    announce(`${refusedInWords(refused, step + 1).short}. ${refusedInWords(refused, step + 1).why}`);
    page.clock.onFrame(() => {
      document.querySelector(`[data-room=program] [data-row="${step}"]`)?.scrollIntoView({ block: 'nearest' });
    });
  });

  return {
    element,
    /** @param {Planned | null} planned */
    set(planned) {
      shown = planned;
      const refused = planned?.plan.refused ?? null;
      element.hidden = refused === null;
      if (!planned || !refused) return;
      const { short, why } = refusedInWords(refused, stepOf(planned) + 1);
      fill(words, short);
      element.title = `${why} ${TIMELINE.show}`;
      element.setAttribute('aria-label', `${short}. ${why} ${TIMELINE.show}`);
      announce(`${short}. ${why}`);
    },
  };
}
