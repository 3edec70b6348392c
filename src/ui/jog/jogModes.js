/**
 * What the jog panel holds: sliders or dials for the joints, or the pendant's buttons for joints or tool. All but the sliders
 * is fetched when it is first asked for.
 *
 * @import { Page } from '../page.js'
 * @import { JogChoices } from '../../model/jog/jogChoices.js'
 */
import { hasJogButtons } from '../../model/jog/jogChoices.js';
import { h } from '../parts/dom.js';
import { lazyPanel } from '../parts/lazyPanel.js';
import { TEXT } from '../strings.js';
import { whenFirst } from '../parts/whenFirst.js';

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
  const hasDials = h('input', { type: 'checkbox', role: 'switch' });
  const buttonsRow = h('label', { class: 'switch' }, hasButtons, TEXT.jog.buttons);
  const dialsRow = h('label', { class: 'switch' }, hasDials, TEXT.jog.dials);
  const pendant = h('div', { hidden: true });
  const jointsMode = () => (hasButtons.checked ? 'joints' : hasDials.checked ? 'dials' : 'sliders');
  joints.addEventListener('click', () => go(jointsMode()));
  tool.addEventListener('click', () => go('tool'));
  hasButtons.addEventListener('change', () => go(jointsMode()));
  hasDials.addEventListener('change', () => go(hasDials.checked ? 'dials' : 'sliders'));

  lazyPanel(
    page,
    pendant,
    ({ jog }) => hasJogButtons(jog),
    async () => {
      const { createJogPendant } = await import('./jogPendant.js');
      return (host) => createJogPendant(page, host);
    },
  );
  whenFirst(
    page,
    ({ session }) => session.jog.mode === 'dials',
    async () => (await import('./jogDials.js')).runJogDials(sliders),
  );
  /** @param {JogChoices['mode']} mode */
  function show(mode) {
    const isTool = mode === 'tool';
    joints.setAttribute('aria-pressed', String(!isTool));
    tool.setAttribute('aria-pressed', String(isTool));
    if (!isTool) hasButtons.checked = mode === 'joints';
    if (!isTool && mode !== 'joints') hasDials.checked = mode === 'dials';
    buttonsRow.hidden = isTool;
    dialsRow.hidden = isTool || mode === 'joints';
    sliders.hidden = isTool || mode === 'joints';
    sliders.classList.toggle('dials', mode === 'dials');
    pendant.hidden = !sliders.hidden;
  }
  addView(({ session }) => session.jog.mode, show);
  const switcher = h('div', { class: 'seg', role: 'group', 'aria-label': TEXT.jog.mode }, joints, tool);
  return { switcher, pendant, buttonsRow, dialsRow };
}
