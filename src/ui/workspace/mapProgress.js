/**
 * How far a map is: what is done now, how long it takes, and a way to give it up; why there is none, where there cannot be one.
 *
 * @import { Page } from '../page.js'
 * @import { MapState, WorkspaceMaps } from '../../model/workspace/mapped.js'
 */
import { fill, h } from '../parts/dom.js';
import { fixed } from '../parts/format.js';
import { icon } from '../parts/icons.js';
import { WORKSPACE } from '../words/workspace.js';
import { whyText } from './mapText.js';

/** Longer than this (s), and tenths of a second say nothing. */
const LONG = 10;

/**
 * @param {Page} page
 * @param {keyof WorkspaceMaps} name
 */
export function createMapProgress({ store, announce }, name) {
  const bar = h('progress', { max: 1, 'aria-label': WORKSPACE.progress });
  const stage = h('span', { class: 'grow' });
  const words = h('p', { class: 'map-words sm' });
  const cancel = h('button', { type: 'button', class: 'btn btn-small btn-outline' }, WORKSPACE.cancel);
  const again = h('button', { type: 'button', class: 'btn btn-small btn-outline' }, WORKSPACE.again);
  const working = h('div', { class: 'map-working' }, bar, h('p', { class: 'sm soft row-flex' }, stage, cancel));
  const element = h('div', { class: 'map-progress' }, working, words);
  /** @param {MapState | null} map */
  const put = (map) => store.dispatch({ type: 'show', change: { maps: { ...store.state.session.maps, [name]: map } } });
  cancel.addEventListener('click', () => {
    const map = store.state.session.maps[name];
    if (map?.status !== 'working') return; // it was done while the button was pressed
    put({ ...map, status: 'cancelled' });
    announce(map.isStale ? WORKSPACE.cancelledNone : WORKSPACE.cancelled);
  });
  again.addEventListener('click', () => put(null));

  return {
    element,
    /** @param {MapState | null} map */
    draw(map) {
      const isWorking = map?.status === 'working';
      working.hidden = !isWorking;
      if (isWorking) {
        bar.value = map.share;
        const name = /** @type {Record<string, string>} */ (WORKSPACE.stage)[map.stage] ?? WORKSPACE.working;
        const { secondsLeft } = map;
        const left = secondsLeft !== null && WORKSPACE.left(fixed(secondsLeft, secondsLeft < LONG ? 1 : 0));
        stage.textContent = [name, left].filter(Boolean).join(' · ');
      }
      const { why } = map ?? {};
      const text = why
        ? whyText(why)
        : map?.status === 'failed'
          ? WORKSPACE.failed
          : map?.status === 'cancelled'
            ? map.isStale
              ? WORKSPACE.cancelledNone
              : WORKSPACE.cancelled
            : '';
      words.hidden = text === '';
      element.hidden = !isWorking && words.hidden;
      const isOver = map?.status === 'failed' || map?.status === 'cancelled';
      fill(words, why ? icon('exclamation', 'warn') : null, h('span', { class: 'grow' }, text), isOver ? again : null);
    },
  };
}

/**
 * What stands in the head of a fold.
 * @param {MapState | null} map
 * @param {() => string} found
 */
export function headText(map, found) {
  if (!map || map.why || map.status === 'failed') return '';
  if (map.status === 'working') return `${fixed(100 * map.share, 0)} %`;
  return map.isStale ? '' : found();
}
