/**
 * The life of a text while it is typed: nothing follows before it is done. Enter or leaving the field makes it one undo
 * step, Escape restores it, a refused text stays to be mended.
 *
 * @import { Change, Page } from '../page.js'
 */
import { attempt } from '../page.js';

/**
 * @param {Page} page
 * @param {HTMLInputElement | HTMLTextAreaElement} input
 * @param {object} behaviour
 * @param {() => string} behaviour.text  the document's
 * @param {() => string} [behaviour.resting]  while nobody edits it, where that is another
 * @param {(text: string) => { command: Change } | { reason: string }} behaviour.read
 * @param {(reason: string | null) => void} behaviour.onReason
 * @param {() => string} behaviour.onDone  the outcome in words, for a screen reader
 */
export function editText(page, input, { text, resting = text, read, onReason, onDone }) {
  const isRefused = () => input.getAttribute('aria-invalid') === 'true';

  /** @param {string | null} reason */
  function mark(reason) {
    if (reason === null) input.removeAttribute('aria-invalid');
    else input.setAttribute('aria-invalid', 'true');
    onReason(reason);
  }

  function commit() {
    delete input.dataset.editing;
    if (input.value === text()) return void mark(null);
    const answer = read(input.value.trim());
    const reason = 'reason' in answer ? answer.reason : attempt(page, answer.command);
    mark(reason);
    page.announce(reason ?? onDone());
    if (reason === null) input.value = text();
  }

  /** What stands there unless a person is typing: all of it where the focus is. */
  function show() {
    const wanted = document.activeElement === input ? text() : resting();
    if (input.value !== wanted) input.value = wanted;
  }

  input.addEventListener('focus', () => {
    if ('editing' in input.dataset || isRefused() || input.value === text()) return;
    input.value = text();
    input.select();
  });
  input.addEventListener('input', () => void (input.dataset.editing = ''));
  input.addEventListener('blur', () => {
    commit();
    if (!isRefused()) input.value = resting();
  });
  input.addEventListener('keydown', (event) => {
    if (!(event instanceof KeyboardEvent)) return;
    if (event.key === 'Enter' && !(input instanceof HTMLTextAreaElement)) commit();
    if (event.key !== 'Escape') return;
    event.stopPropagation();
    delete input.dataset.editing;
    mark(null);
    input.value = text();
  });

  return {
    /** The document changed: show its text, unless a person is typing or a refused text is still to be mended. */
    refresh() {
      if ('editing' in input.dataset || isRefused()) return;
      show();
    },
    /** The document was exchanged for another. */
    forget() {
      delete input.dataset.editing;
      if (isRefused()) mark(null);
    },
    /** As if a person had typed it and left. @param {string} wanted */
    type(wanted) {
      input.value = wanted;
      commit();
    },
  };
}
