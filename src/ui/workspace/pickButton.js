/**
 * The button that begins and ends picking points in the view, and what becomes of a press there.
 *
 * @import { Page } from '../page.js'
 */
import { pickGrounds } from '../../model/workspace/pickPlace.js';
import { h } from '../parts/dom.js';
import { POINTS } from '../words/workspacePoints.js';
import { takePress, whenPressed } from './probes.js';

/**
 * @param {Page} page
 * @param {{ add: (place: readonly number[]) => void, choose: (index: number) => void }} given  places in m
 * @returns {HTMLButtonElement}
 */
export function createPickButton(page, { add, choose }) {
  const { store, addView, announce } = page;
  const button = h('button', { type: 'button', class: 'btn btn-outline', 'aria-pressed': 'false' }, POINTS.inView);
  button.addEventListener('click', () => {
    const { session } = store.state;
    const isOn = session.reachHand.pick !== null;
    const pick = isOn ? null : pickGrounds(session)[0];
    store.dispatch({ type: 'show', change: { reachHand: { ...session.reachHand, pick, over: null } } });
    announce(isOn ? POINTS.picking.left : POINTS.picking.begun);
  });
  addView(
    ({ session }) => session.reachHand.pick !== null,
    (isOn) => button.setAttribute('aria-pressed', String(isOn)),
  );
  takePress(page, (pressed) => {
    if ('at' in pressed) add(pressed.at);
    return 'at' in pressed;
  });
  whenPressed(page, 'points', choose);
  return button;
}
