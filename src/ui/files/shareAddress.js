/**
 * The address that opens what is open now.
 * @import { Page } from '../page.js'
 */
import { libraryQuery } from '../../io/libraryLink.js';
import { writeLook } from '../../io/look.js';
import { writeShareLink } from '../../io/shareLink.js';

/**
 * @param {Page} page
 * @param {{ view: boolean, panels: boolean }} what  camera, frames and projection; what is open
 * @returns {string | null} null when the document is too large for a link
 */
export function shareAddress({ store, camera }, { view, panels }) {
  const { doc, session } = store.state;
  const look = writeLook({
    panels: panels ? session : null,
    view: view ? session : null,
    camera: view ? camera.where() : null,
  });
  const page = location.href.replace(/[?#].*$/s, '');
  const query = libraryQuery(doc);
  const model = query === null ? writeShareLink(doc) : '';
  if (model === null) return null;
  const fragment = [model, look].filter(Boolean).join('&');
  return `${page}${query === null ? '' : `?${query}`}${fragment && `#${fragment}`}`;
}
