/**
 * What is seen while a file is held over the page: that it may be dropped, and what will come of it. It lies over everything
 * and takes no pointer, so that the page beneath hears of the drop. Fetched with the first file that is held over the page.
 */
import '../css/dropTarget.css';
import { fill, h } from '../parts/dom.js';
import { icon } from '../parts/icons.js';
import { DROP } from '../words/arrival.js';

/** @type {HTMLElement | null} */
let target = null;

/** @param {'here' | 'several' | 'barred'} state */
export function showDropTarget(state) {
  target ??= h('div', { class: 'drop-target' });
  const [title, detail] =
    state === 'here'
      ? [DROP.here, DROP.formats]
      : state === 'several'
        ? [DROP.several, DROP.severalDetail]
        : [DROP.barred, DROP.barredDetail];
  fill(
    target,
    h(
      'div',
      { class: 'drop-card' },
      icon(state === 'here' ? 'folder' : 'slash', state === 'here' ? 'i-l' : 'i-l warn'),
      h('div', {}, h('p', { class: 'b' }, title), h('p', { class: 'soft' }, detail)),
    ),
  );
  document.body.append(target);
}

export const hideDropTarget = () => target?.remove();
