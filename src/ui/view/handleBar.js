/**
 * What belongs to the handle on the tool beside the picture: the axes that it has and whether it snaps. What a drag or keys have
 * to say is fetched with the first of them (handleLine.js).
 *
 * @import { Page } from '../page.js'
 * @import { HandleAxes } from '../../model/aim/handleAxes.js'
 * @import { Session } from '../../model/session.js'
 */
import $ from 'jquery/slim';
import { handleStep } from '../../model/aim/handleAxes.js';
import { isHandleShown } from '../../model/aim/handleShown.js';
import { fromKernel } from '../../model/units.js';
import { together } from '../../model/views.js';
import { h } from '../parts/dom.js';
import { plain, withUnit } from '../parts/format.js';
import { icon } from '../parts/icons.js';
import { TEXT } from '../strings.js';
import { whenFirst } from '../parts/whenFirst.js';

const words = TEXT.drag;

/** @type {readonly HandleAxes[]} */
const AXES = ['base', 'tool', 'world', 'user'];

/**
 * @param {Page} page
 * @param {HTMLElement} host
 * @param {{ isWide: () => boolean, poseInWords: () => string }} given
 */
export function createHandleBar(page, host, { isWide, poseInWords }) {
  const { store, addView, derived } = page;
  const axisButtons = AXES.map((axes) => h('button', { type: 'button', 'data-axes': axes }, words.axes[axes]));
  const snap = h('button', { type: 'button', class: 'btn snap', title: words.snapTitle });
  const bar = h(
    'div',
    { class: 'float', role: 'toolbar', 'aria-label': words.bar },
    h('div', { class: 'seg', role: 'group', 'aria-label': words.axesLabel }, axisButtons),
    snap,
  );
  host.append(h('div', { class: 'handle-bar' }, bar));

  /** @param {Partial<Session['handle']>} change */
  const change = (change) =>
    store.dispatch({ type: 'show', change: { handle: { ...store.state.session.handle, ...change } } });
  $(bar).on('click', '[data-axes]', ({ currentTarget }) => change({ axes: currentTarget.dataset.axes }));
  $(snap).on('click', () => change({ snaps: !store.state.session.handle.snaps }));

  addView(
    (state) => isHandleShown(state, isWide()),
    (isShown) => (bar.hidden = !isShown),
  );
  addView(
    together(({ doc, session }) => [session.handle, doc.robot, doc.activeUser]),
    ([{ axes, snaps }, { units }, user]) => {
      for (const button of axisButtons) {
        button.setAttribute('aria-pressed', String(button.dataset.axes === axes));
        if (button.dataset.axes === 'user') button.hidden = user === undefined;
      }
      const step = (/** @type {'length' | 'angle'} */ quantity, /** @type {number} */ value) =>
        withUnit(plain(Number(fromKernel(quantity, value, units).toPrecision(3))), units[quantity]);
      const { metres, radians } = handleStep(derived.chain(store.state.doc));
      snap.textContent = words.snap(step('length', metres), step('angle', radians));
      snap.setAttribute('aria-pressed', String(snaps));
    },
  );

  whenFirst(
    page,
    ({ session }) => session.drag !== null || session.toolKeys !== null,
    async () => (await import('./handleLine.js')).createHandleLine(page, bar, poseInWords),
  );
}

/**
 * @param {Page} page
 * @param {() => boolean} isWide
 */
export function createHandleButton({ store, addView }, isWide) {
  const button = h(
    'button',
    { type: 'button', class: 'btn btn-icon handle-toggle', 'aria-label': words.handle, title: words.handle },
    icon('handle'),
  );
  const isShown = (/** @type {Session} */ { handle }) => handle.isShown ?? isWide();
  $(button).on('click', () => {
    const { session } = store.state;
    store.dispatch({ type: 'show', change: { handle: { ...session.handle, isShown: !isShown(session) } } });
  });
  addView(
    ({ session }) => isShown(session),
    (isOn) => button.setAttribute('aria-pressed', String(isOn)),
  );
  return button;
}
