/**
 * In the view while there is a program: what the colours and the dots of its path mean, and the switches of path and ghosts.
 *
 * @import { Page } from '../page.js'
 * @import { PlayerRun } from './playerRun.js'
 */
import $ from 'jquery/slim';
import { codePathShown } from '../../model/code/codePathShown.js';
import { playbackNow } from '../../model/program/planning.js';
import { toolPathShown } from '../../model/program/toolPathShown.js';
import { fromKernel } from '../../model/units.js';
import { together } from '../../model/views.js';
import { h } from '../parts/dom.js';
import { fixed, plain } from '../parts/format.js';
import { TIMELINE } from '../words/timeline.js';

const WORDS = TIMELINE.path;
const DECIMALS = { mm: 0, cm: 1, m: 3 };

/** @param {Page} page @param {HTMLElement} view @param {PlayerRun} run */
export function createPathLegend({ addView }, view, run) {
  const button = (/** @type {string} */ action, /** @type {string} */ name, /** @type {string} */ title) =>
    h('button', { type: 'button', class: 'btn', 'data-action': action, title }, name);
  const [path, ghosts] = [
    button('hasPath', WORDS.show, WORDS.showTitle),
    button('hasGhosts', WORDS.ghosts, WORDS.ghostsTitle),
  ];
  const most = h('span', {});
  const dots = h('span', { class: 'soft' });
  const scale = h(
    'p',
    { class: 'path-scale' },
    h('span', {}, '0'),
    h('i', { class: 'path-ramp', 'aria-hidden': 'true' }),
    most,
    dots,
  );
  const element = h(
    'div',
    { class: 'float path-legend', role: 'group', 'aria-label': WORDS.label },
    path,
    ghosts,
    scale,
  );
  view.append(element);

  $(element).on('click', '[data-action]', ({ currentTarget }) => {
    const name = /** @type {'hasPath' | 'hasGhosts'} */ (currentTarget.dataset.action);
    run.set((playback) => ({ ...playback, [name]: !playback[name] }));
  });

  addView(
    together((state) => {
      // the path of code is no path in time
      const playback = codePathShown(state) ? null : playbackNow(state);
      return [playback?.hasPath ?? null, playback?.hasGhosts ?? null];
    }),
    ([hasPath, hasGhosts]) => {
      element.hidden = hasPath === null;
      path.setAttribute('aria-pressed', String(hasPath));
      ghosts.setAttribute('aria-pressed', String(hasGhosts));
    },
  );
  addView(
    together((state) => [toolPathShown(state), state.doc.robot.units]),
    ([shown, units]) => {
      scale.hidden = !shown || shown.most === 0;
      if (!shown) return;
      const speed = fixed(fromKernel('length', shown.most, units), DECIMALS[units.length]);
      most.textContent = `${speed} ${units.length}/s`;
      dots.textContent = WORDS.dots(plain(shown.dotEvery));
    },
  );
}
