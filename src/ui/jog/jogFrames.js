/**
 * In which frame the tool is jogged.
 *
 * @import { Page } from '../page.js'
 * @import { JogFrame } from '../../model/jog/jog.js'
 */
import { together } from '../../model/views.js';
import { h } from '../parts/dom.js';
import { PENDANT } from '../words/jogPendant.js';

/** @type {readonly JogFrame[]} */
const FRAMES = ['world', 'base', 'user', 'tool'];

/** @param {Page} page @returns {HTMLElement} */
export function createFrameChooser({ store, addView }) {
  const buttons = FRAMES.map((frame) => {
    const button = h('button', { type: 'button', title: PENDANT.frameNote[frame] }, PENDANT.frameName[frame]);
    button.addEventListener('click', () =>
      store.dispatch({ type: 'show', change: { jog: { ...store.state.session.jog, frame } } }),
    );
    return { frame, button };
  });
  const element = h(
    'div',
    { class: 'seg jog-frames', role: 'group', 'aria-label': PENDANT.frameLabel },
    buttons.map(({ button }) => button),
  );
  addView(
    together(({ doc, session }) => [session.jog.frame, session.jog.mode, doc.activeUser]),
    ([chosen, mode, user]) => {
      element.hidden = mode !== 'tool';
      for (const { frame, button } of buttons) {
        button.setAttribute('aria-pressed', String(frame === chosen));
        if (frame !== 'user') continue;
        button.hidden = user === undefined;
        button.title = `${PENDANT.frameNote.user} (${user})`;
      }
    },
  );
  return element;
}
