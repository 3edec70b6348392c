/**
 * Opens and closes the player that shows how a row of the table makes a frame. The player is fetched when it is first wanted.
 *
 * @import { Page } from '../page.js'
 */
import $ from 'jquery/slim';
import { buildOf } from '../../model/robot/buildUp.js';
import { h } from '../parts/dom.js';
import { icon } from '../parts/icons.js';
import { TEXT } from '../strings.js';

/**
 * @param {Page} page
 * @param {HTMLElement} host  of the player
 * @param {() => boolean} isCalm
 */
export function createBuildButton(page, host, isCalm) {
  const { store, addView, messages } = page;
  const button = h(
    'button',
    { type: 'button', class: 'btn build-it', title: TEXT.view.buildTitle, 'aria-expanded': 'false' },
    icon('play'),
    h('span', {}, TEXT.view.build),
  );
  /** The row that was chosen last: the table has lost it by the time that the button is pressed. */
  let row = 0;
  /** @type {Promise<unknown> | null} */
  let player = null;

  async function fetchPlayer() {
    const { createBuildPlayer } = await import('./buildPlayer.js');
    createBuildPlayer(page, host, { isCalm, onClose: () => button.focus() });
  }

  addView(
    ({ session }) => session.cell?.joint ?? null,
    (chosen) => (row = chosen ?? row),
  );
  addView(
    ({ session }) => session.build !== null,
    (isOpen) => button.setAttribute('aria-expanded', String(isOpen)),
  );
  $(button).on('click', async () => {
    const { build } = store.state.session;
    if (build) {
      store.dispatch({ type: 'show', change: { build: null } });
      return;
    }
    try {
      await (player ??= fetchPlayer());
      const last = store.state.doc.robot.joints.length - 1;
      store.dispatch({ type: 'show', change: { build: buildOf(Math.min(row, last)) } });
    } catch (error) {
      player = null;
      messages.fault(error);
    }
  });
  return button;
}
