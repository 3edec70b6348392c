/**
 * The moves of a program as a strip over its time, with the head that plays: a slider, for the pointer and for keys.
 *
 * @import { Planned } from '../../model/program/planned.js'
 *
 * @typedef {'previous' | 'toggle' | 'next' | 'begin' | 'end'} PlayerAction
 */
import { movesInTime } from '../../model/program/player.js';
import { fill, h } from '../parts/dom.js';
import { icon } from '../parts/icons.js';
import { TIMELINE } from '../words/timeline.js';

/** s, and with Shift. */
const STEP = 0.1;
const LONG_STEP = 1;

/** @type {Record<string, PlayerAction>} */
const KEYS = {
  PageUp: 'next',
  PageDown: 'previous',
  Home: 'begin',
  End: 'end',
  ' ': 'toggle',
  Enter: 'toggle',
};

/** @typedef {{ plan: Planned['plan'], names: readonly { number: number, name: string }[] }} Stripped  a name for each move */

/**
 * @param {{ scrub: (time: number) => void, act: (action: PlayerAction) => void }} player
 */
export function createTimelineStrip({ scrub, act }) {
  const moves = h('div', { class: 'strip-moves', 'aria-hidden': 'true' });
  const touches = h('div', { class: 'strip-touches', 'aria-hidden': 'true' });
  const head = h('div', { class: 'playhead' });
  const element = h(
    'div',
    { class: 'strip', role: 'slider', tabindex: 0, 'aria-label': TIMELINE.slider, 'aria-valuemin': 0 },
    moves,
    touches,
    head,
  );
  /** @type {Stripped | null} */
  let shown = null;
  let time = 0;
  /** @type {HTMLElement | undefined} */
  let lit;

  const duration = () => shown?.plan.duration ?? 0;
  const share = (/** @type {number} */ at) => `${duration() > 0 ? (100 * at) / duration() : 0}%`;

  /** @param {number} clientX @param {Element} [along]  something else that spans the same time */
  function scrubTo(clientX, along = element) {
    const { left, width } = along.getBoundingClientRect();
    if (width > 0) scrub(((clientX - left) / width) * duration());
  }

  /** Something over which a pointer goes through time. @param {HTMLElement} room @param {() => Element} along */
  function scrubBy(room, along) {
    room.addEventListener('pointerdown', (event) => {
      if (event.button !== 0) return;
      room.setPointerCapture(event.pointerId);
      scrubTo(event.clientX, along());
    });
    room.addEventListener('pointermove', (event) => {
      if (room.hasPointerCapture(event.pointerId)) scrubTo(event.clientX, along());
    });
  }
  scrubBy(element, () => element);

  element.addEventListener('keydown', (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const step = event.shiftKey ? LONG_STEP : STEP;
    const by = { ArrowRight: step, ArrowUp: step, ArrowLeft: -step, ArrowDown: -step }[event.key];
    const action = KEYS[event.key];
    if (by === undefined && !action) return;
    event.preventDefault();
    if (by !== undefined) scrub(time + by);
    else act(action);
  });

  return {
    element,
    scrubBy,

    /** @param {Stripped | null} next */
    setPlan(next) {
      shown = next;
      lit = undefined;
      fill(
        moves,
        (next ? movesInTime(next.plan) : []).map(({ move, kind, begin, end }) => {
          const { number, name } = /** @type {Stripped} */ (next).names[move];
          const part = h(
            'span',
            { 'data-move': move, 'data-kind': kind, title: TIMELINE.step(number, name) },
            h('b', {}, String(number)),
            name,
          );
          part.style.left = share(begin);
          part.style.width = share(end - begin);
          return part;
        }),
      );
      element.setAttribute('aria-valuemax', duration().toFixed(2));
    },

    /** Where steps first come too near to something. @param {readonly { time: number, title: string }[]} all */
    setTouches(all) {
      fill(
        touches,
        all.map(({ time: at, title }) => {
          const mark = h('span', { class: 'strip-touch', title }, icon('octagon'));
          mark.style.left = share(at);
          return mark;
        }),
      );
    },

    /** @param {number} now @param {number | null} move  that is under way @param {string} text  the same in words */
    draw(now, move, text) {
      time = now;
      head.style.left = share(now);
      element.setAttribute('aria-valuenow', now.toFixed(2));
      element.setAttribute('aria-valuetext', text);
      if (lit?.dataset.move === String(move)) return;
      lit?.classList.remove('is-now');
      const found = moves.querySelector(`[data-move="${move}"]`);
      lit = found instanceof HTMLElement ? found : undefined;
      lit?.classList.add('is-now');
    },
  };
}

/** @typedef {ReturnType<typeof createTimelineStrip>} TimelineStrip */
