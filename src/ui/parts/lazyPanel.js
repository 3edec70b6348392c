/**
 * A panel that is fetched when it is first opened. Until then its room says so, and when it cannot be fetched, that, with a
 * way to try again.
 *
 * @import { Page } from '../page.js'
 * @import { Session } from '../../model/session.js'
 */
import { emptyState } from './emptyState.js';
import { fill, h } from './dom.js';
import { TEXT } from '../strings.js';

/**
 * @param {Page} page
 * @param {HTMLElement} host
 * @param {(session: Session) => boolean} isOpen
 * @param {() => Promise<(host: HTMLElement) => void>} fetchPanel  the answer puts the panel into its empty room
 */
export function lazyPanel({ addView, messages }, host, isOpen, fetchPanel) {
  let isWanted = false;

  async function start() {
    fill(host, h('p', { class: 'inset soft', role: 'status' }, TEXT.fetching));
    host.setAttribute('aria-busy', 'true');
    try {
      const create = await fetchPanel();
      fill(host);
      create(host);
    } catch (error) {
      messages.log(error);
      const again = h('button', { type: 'button', class: 'btn btn-outline' }, TEXT.tryAgain);
      again.addEventListener('click', start);
      fill(host, emptyState(TEXT.notFetched, TEXT.notFetchedDetail, again));
    }
    host.removeAttribute('aria-busy');
  }

  addView(
    ({ session }) => isOpen(session),
    (isOpenNow) => {
      if (!isOpenNow || isWanted) return;
      isWanted = true;
      start();
    },
  );
}
