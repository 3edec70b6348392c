/**
 * The timeline at the bottom of the page: the player of the motion program, its moves over their time, and, opened, the plots.
 * While nothing is played it does nothing.
 *
 * @import { Page } from '../page.js'
 * @import { PlayerAction } from './timelineStrip.js'
 * @import { Planned, Planning } from '../../model/program/planned.js'
 * @import { Workcells } from '../../model/workcell/workcell.js'
 */
import '../css/timeline.css';
import '../css/timelineNarrow.css';
import repeat from 'bootstrap-icons/icons/repeat.svg?raw';
import $ from 'jquery/slim';
import { planNow, playbackNow } from '../../model/program/planning.js';
import { atSpeed, marksOf, moveAt, pause, play, scrub, toNext, toPrevious } from '../../model/program/player.js';
import { shownProgram } from '../../model/program/shownProgram.js';
import { together } from '../../model/views.js';
import { fill, h } from '../parts/dom.js';
import { fixed } from '../parts/format.js';
import { icon, iconOf } from '../parts/icons.js';
import { createPathLegend } from './pathLegend.js';
import { createPlayerRun } from './playerRun.js';
import { createProgramPlanner } from './programPlanner.js';
import { nameOfStep } from './programStepName.js';
import { createRefusedButton } from './refusedMove.js';
import { createTimelineStrip } from './timelineStrip.js';
import { whenFirst } from '../parts/whenFirst.js';
import { TIMELINE } from '../words/timeline.js';

/** % */
const SPEEDS = [1, 5, 10, 25, 50, 75, 100, 150, 200, 300, 400];

const seconds = (/** @type {number} */ time) => fixed(time, 2);

/**
 * @param {Page} page
 * @param {HTMLElement} host  its room, hidden until there is a program
 * @param {HTMLElement} view
 * @param {() => Promise<Workcells>} cells
 * @returns the words that the scene needs
 */
export function createTimeline(page, host, view, cells) {
  const { store, addView, announce, messages } = page;
  const run = createPlayerRun(page);
  const planner = createProgramPlanner(page);

  /** @param {string} name @param {Parameters<typeof icon>[0] | null} drawing @param {string} action */
  const button = (name, drawing, action, look = '') =>
    h(
      'button',
      { type: 'button', class: `btn btn-icon ${look}`, 'aria-label': name, title: name, 'data-action': action },
      drawing && icon(drawing),
    );
  const toggle = button(TIMELINE.play, 'play', 'toggle', 'btn-primary');
  const loop = button(TIMELINE.loop, null, 'loop');
  loop.append(iconOf(repeat));
  const clock = h('span', { class: 'clock' });
  const whole = h('span', { class: 'unit' });
  const strip = createTimelineStrip({ scrub: (time) => act('scrub', time), act });
  const middle = h('div', { class: 'time-strip' }, strip.element);
  const note = h('div', { class: 'time-note', hidden: true });
  const refused = createRefusedButton(page);
  const speed = h(
    'select',
    { class: 'form-select form-select-sm time-speed', 'aria-label': TIMELINE.speed, title: TIMELINE.speed },
    SPEEDS.map((percent) => h('option', { value: percent }, TIMELINE.speedOption(percent))),
  );
  const plots = h(
    'button',
    { type: 'button', class: 'btn time-plots', 'aria-expanded': 'false', title: TIMELINE.plotsTitle },
    TIMELINE.plots,
    icon('caret', 'caret'),
  );
  const bar = h(
    'div',
    { class: 'time-bar' },
    h(
      'div',
      { class: 'time-controls', role: 'group', 'aria-label': TIMELINE.controls },
      button(TIMELINE.previous, 'skipBack', 'previous'),
      toggle,
      button(TIMELINE.next, 'skipForward', 'next'),
      loop,
    ),
    h('span', { class: 'time-clock' }, clock, whole),
    middle,
    note,
    refused.element,
    speed,
    plots,
  );
  createPathLegend(page, view, run);
  host.setAttribute('aria-label', TIMELINE.title);
  host.append(bar);

  /** @param {PlayerAction | 'scrub'} action @param {number} [time] */
  function act(action, time = 0) {
    const wasPlaying = playbackNow(store.state)?.isPlaying ?? false;
    run.act((playback, { plan }) => {
      const { duration } = plan;
      switch (action) {
        case 'toggle':
          return wasPlaying ? pause(playback) : play(playback, duration);
        case 'next':
          return toNext(playback, marksOf(plan));
        case 'previous':
          return toPrevious(playback, marksOf(plan));
        case 'begin':
          return scrub(playback, 0, duration);
        case 'end':
          return scrub(playback, duration, duration);
        default:
          return scrub(playback, time, duration);
      }
    });
    const playback = playbackNow(store.state);
    if (!playback || (action === 'scrub' && !wasPlaying)) return;
    if (playback.isPlaying) announce(TIMELINE.played);
    else if (wasPlaying) announce(TIMELINE.paused(inWords()));
    else if (document.activeElement !== strip.element) announce(inWords());
  }

  /** Where it is. */
  function inWords() {
    const playback = playbackNow(store.state);
    if (!playback || !shown) return '';
    const move = moveAt(shown.plan, playback.time);
    const { number, name } = names[move ?? 0] ?? { number: 0, name: '' };
    return TIMELINE.at(
      seconds(playback.time),
      seconds(shown.plan.duration),
      move === null ? '' : TIMELINE.step(number, name),
    );
  }

  $(bar).on('click', '[data-action]', ({ currentTarget }) => {
    const { action } = currentTarget.dataset;
    if (action === 'loop') run.set((playback) => ({ ...playback, isLoop: !playback.isLoop }));
    else act(action);
  });
  $(speed).on('change', () => run.set((playback) => atSpeed(playback, Number(speed.value) / 100)));
  document.addEventListener('keydown', (event) => {
    if (event.key !== 'Escape' || event.defaultPrevented) return;
    if (playbackNow(store.state)?.isPlaying) act('toggle');
  });

  /** @type {{ setOpen: (isOpen: boolean) => void } | null} */
  let drawer = null;
  let isOpen = false;
  $(plots).on('click', async () => {
    isOpen = !isOpen;
    plots.setAttribute('aria-expanded', String(isOpen));
    try {
      const { createPlanPlots } = await import('./planPlots.js');
      drawer ??= createPlanPlots(page, host, { strip, stripRoom: middle, scrub: (time) => act('scrub', time) });
      drawer.setOpen(isOpen);
    } catch (error) {
      isOpen = false;
      plots.setAttribute('aria-expanded', 'false');
      messages.fault(error);
    }
  });

  addView(
    (state) => (shownProgram(state).program?.steps.length ?? 0) > 0,
    (isShown) => (host.hidden = !isShown),
  );

  /** The plan that is seen, while the next one is on its way, too. @type {Planned | null} */
  let shown = null;
  /** @type {readonly { number: number, name: string }[]} */
  let names = [];
  addView(
    together((state) => [state.session.planning, planNow(state) !== null]),
    ([planning, isFresh]) => {
      const planned = planning?.planned ?? null;
      bar.classList.toggle('is-stale', !isFresh);
      for (const one of bar.querySelectorAll('[data-action]')) {
        if (one !== loop) one.setAttribute('aria-disabled', String(!isFresh));
      }
      sayState(planning);
      if (planned === shown) return;
      shown = planned;
      const { steps } = planning?.question.program ?? { steps: [] };
      names =
        planned?.steps.map((step) => ({ number: step + 1, name: nameOfStep(store.state.doc, steps[step]) })) ?? [];
      strip.setPlan(planned && { plan: planned.plan, names });
      refused.set(planned);
      drawTime();
    },
  );

  /** What there is instead of a plan, or on the way to one. @param {Planning | null} planning */
  function sayState(planning) {
    const progress = planning?.progress ?? null;
    const [issue] = planning?.issues ?? [];
    const isEmpty = planning?.planned?.plan.parts.length === 0 && !planning.planned.plan.refused;
    const words =
      progress !== null
        ? TIMELINE.planning(fixed(100 * progress, 0))
        : issue
          ? TIMELINE.issue(issue.message)
          : planning?.isGivenUp
            ? TIMELINE.cancelled
            : isEmpty
              ? TIMELINE.empty
              : '';
    note.hidden = words === '';
    middle.hidden = words !== '' && progress === null;
    if (words === '') return;
    const isUnderWay = progress !== null;
    const way = h(
      'button',
      { type: 'button', class: 'btn btn-outline' },
      isUnderWay ? TIMELINE.cancel : TIMELINE.again,
    );
    way.addEventListener('click', isUnderWay ? planner.cancel : planner.again);
    way.hidden = !isUnderWay && !planning?.isGivenUp;
    fill(note, issue && !isUnderWay && icon('exclamation'), h('span', {}, words), way);
    note.classList.toggle('bad', issue !== undefined && progress === null);
  }

  function drawTime() {
    const playback = playbackNow(store.state);
    if (!playback || !shown) return;
    const time = Math.min(playback.time, shown.plan.duration);
    clock.textContent = seconds(time);
    whole.textContent = TIMELINE.of(seconds(shown.plan.duration));
    strip.draw(time, moveAt(shown.plan, time), inWords());
  }
  addView(
    together((state) => [playbackNow(state)?.time, state.session.planning]),
    drawTime,
  );
  addView(
    together((state) => {
      const playback = playbackNow(state);
      return [playback?.isPlaying ?? false, playback?.isLoop ?? false, playback?.speed ?? 1];
    }),
    ([isPlaying, isLoop, share]) => {
      const name = isPlaying ? TIMELINE.pause : TIMELINE.play;
      if (toggle.getAttribute('aria-label') !== name) {
        toggle.setAttribute('aria-label', name);
        toggle.title = name;
        fill(toggle, icon(isPlaying ? 'pause' : 'play'));
      }
      loop.setAttribute('aria-pressed', String(isLoop));
      speed.value = String(Math.round(100 * share));
    },
  );
  whenFirst(
    page,
    (state) => planNow(state) !== null,
    async () => (await import('../workcell/timelineTouches.js')).createTimelineTouches(page, strip, await cells()),
  );
  return { text: { ghosts: TIMELINE.ghosts } };
}
