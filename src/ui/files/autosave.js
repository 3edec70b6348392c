/**
 * The work is kept in this browser while it is done, and offered at the next visit. A lock with the visit's name, which the
 * browser lets go when the page ends in whatever way, tells work that somebody left from work in another tab.
 *
 * @import { Page } from '../page.js'
 */
import { KEPT } from '../../io/keptWork.js';
import { createKeeper } from '../../io/keepWork.js';
import { writeLook } from '../../io/look.js';
import { forget, keysFrom, remember } from '../browserStorage.js';

/**
 * @param {Page} page
 * @param {object} given
 * @param {string} given.visit  a name that no other visit has
 * @param {() => string} given.today
 * @param {Promise<void>} given.ready
 */
export function startAutosave(page, { visit, today, ready }) {
  const { store } = page;
  const offers = () => import('./keptOffers.js');
  const keep = createKeeper({
    ...page,
    storage: { remember, forget },
    visit,
    today,
    look() {
      const { session } = store.state;
      return writeLook({ panels: session, view: session, camera: page.camera.where({ isChosen: true }) });
    },
    onFail: async () => (await offers()).sayNotKept(page),
  });

  let release = () => {};
  async function hold() {
    try {
      await navigator.locks.request(KEPT + visit, () => new Promise((resolve) => (release = () => resolve(null))));
    } catch {
      // no locks here: work in another tab is offered, too, and stays its own
    }
  }
  hold();
  addEventListener('pageshow', ({ persisted }) => void (persisted && hold()));
  addEventListener('pagehide', () => {
    keep();
    release(); // with a lock a page could not be gone back to
  });
  document.addEventListener('visibilitychange', keep);

  if (keysFrom(KEPT).length > 0) ready.then(async () => (await offers()).offerKeptWork(page, keep));
}
