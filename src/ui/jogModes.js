/**
 * What the jog panel holds: sliders for the joints, or the pendant's buttons for joints or tool, which are fetched when they
 * are first asked for.
 *
 * @import { Page } from './page.js'
 * @import { JogChoices } from '../model/jogChoices.js'
 */
import { h } from './dom.js';
import { lazyPanel } from './lazyPanel.js';
import { TEXT } from './strings.js';

/**
 * @param {Page} page
 * @param {HTMLElement} sliders
 */
export function createJogModes(page, sliders) {
  const { store, addView } = page;
  /** At once, not in the next frame: what was just shown takes the focus of a quick Tab. @param {JogChoices['mode']} mode */
  function go(mode) {
    store.dispatch({ type: 'show', change: { jog: { ...store.state.session.jog, mode } } });
    show(mode);
  }
  const joints = h('button', { type: 'button', title: TEXT.jog.jointsTitle }, TEXT.jog.joints);
  const tool = h('button', { type: 'button', title: TEXT.jog.toolTitle }, TEXT.jog.tool);
  const hasButtons = h('input', { type: 'checkbox', role: 'switch' });
  const buttonsRow = h('label', { class: 'switch' }, hasButtons, TEXT.jog.buttons);
  const pendant = h('div', { hidden: true });
  const jointsMode = () => (hasButtons.checked ? 'joints' : 'sliders');
  joints.addEventListener('click', () => go(jointsMode()));
  tool.addEventListener('click', () => go('tool'));
  hasButtons.addEventListener('change', () => go(jointsMode()));

  lazyPanel(
    page,
    pendant,
    ({ jog }) => jog.mode !== 'sliders',
    async () => {
      const { createJogPendant } = await import('./jogPendant.js');
      return (host) => createJogPendant(page, host);
    },
  );
  /** @param {JogChoices['mode']} mode */
  function show(mode) {
    joints.setAttribute('aria-pressed', String(mode !== 'tool'));
    tool.setAttribute('aria-pressed', String(mode === 'tool'));
    if (mode !== 'tool') hasButtons.checked = mode === 'joints';
    buttonsRow.hidden = mode === 'tool';
    sliders.hidden = mode !== 'sliders';
    pendant.hidden = mode === 'sliders';
  }
  addView(({ session }) => session.jog.mode, show);
  const switcher = h('div', { class: 'seg', role: 'group', 'aria-label': TEXT.jog.mode }, joints, tool);
  return { switcher, pendant, buttonsRow };
}
