/**
 * A dialog over the page: in the document while it is open, and the focus goes back to where it was.
 *
 * @import { Child } from './dom.js'
 */
import '../css/dialogParts.css';
import Modal from 'bootstrap/js/src/modal.js';
import { h } from './dom.js';
import { icon } from './icons.js';
import { TEXT } from '../strings.js';

/** What is in a dialog and closes it. */
export const DISMISSES = { type: 'button', 'data-bs-dismiss': 'modal' };

/** The cross in a dialog's head. */
export const closeButton = () =>
  h('button', { ...DISMISSES, class: 'btn btn-icon', 'aria-label': TEXT.close }, icon('close'));

/**
 * A dialog's first line: what it is about, and the cross.
 * @param {string} id  of the heading
 * @param {string} title
 * @param {{ mark?: Child, below?: Child | readonly Child[] }} [more]  before the heading, and below it
 */
export const dialogHead = (id, title, { mark, below } = {}) =>
  h(
    'div',
    { class: 'row-flex dialog-head' },
    mark,
    h('div', { class: 'grow' }, h('h2', { id }, title), below),
    closeButton(),
  );

/** A dialog's last line: what can be done. @param {...Child} content */
export const dialogFoot = (...content) => h('div', { class: 'row-flex dialog-foot' }, content);

/**
 * @param {object} given
 * @param {string} given.name   its class
 * @param {string} given.title  the id of the heading that names it
 * @param {string} [given.fit]  further classes: how it stands on the page
 * @param {Parameters<typeof h>[2]} given.content
 * @param {() => void} [given.onShown]  where the focus goes, if not to the dialog itself
 * @returns {{ hide: () => void }}
 */
export function openDialog({ name, title, fit = 'modal-dialog-centered', content, onShown }) {
  const { activeElement: before } = document;
  const dialog = h(
    'div',
    { class: `modal ${name}`, tabindex: -1, 'aria-labelledby': title },
    h(
      'div',
      { class: `modal-dialog modal-dialog-scrollable ${fit}` },
      h('div', { class: 'modal-content dialog' }, content),
    ),
  );
  document.body.append(dialog);
  const modal = new Modal(dialog);
  if (onShown) dialog.addEventListener('shown.bs.modal', onShown);
  dialog.addEventListener('hidden.bs.modal', () => {
    modal.dispose();
    dialog.remove();
    if (before instanceof HTMLElement && before.isConnected) before.focus();
  });
  modal.show();
  return modal;
}
