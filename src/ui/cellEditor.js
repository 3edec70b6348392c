/**
 * The life of a number while it is typed, for every field that changes the document. While it has focus the field keeps
 * the person's own text and the document follows each text that is a number; a text that is none leaves the document as it
 * was before. Leaving the field or Enter makes it one undo step; Escape makes it as if it had never begun.
 *
 * While a text is being typed the field carries `data-editing`, and Ctrl+Z is the browser's own.
 *
 * @import { Page } from './page.js'
 * @import { Command } from '../model/commands.js'
 */
import { attempt, newGesture } from './page.js';
import { readNumber } from './numberText.js';

/**
 * @param {Page} page
 * @param {HTMLInputElement} input
 * @param {object} behaviour
 * @param {(value: number) => Command} behaviour.command  what a typed number does
 * @param {(value: number) => string | null} [behaviour.check]  a reason against it beyond the command's own
 * @param {(value: number) => string} behaviour.onDone  the outcome in words, for a screen reader
 * @param {(reason: string | null) => void} behaviour.onReason  the text is refused, or is good again
 * @param {() => string} behaviour.text    the document's number, to be edited
 * @param {() => string} behaviour.resting the document's number, as shown while nobody edits
 */
export function editCell(page, input, { command, check, onDone, onReason, text, resting }) {
  const { store, announce } = page;
  /** @type {string | null} */
  let gesture = null;
  let begun = '';

  /** @param {string | null} reason */
  function mark(reason) {
    if (reason) input.setAttribute('aria-invalid', 'true');
    else input.removeAttribute('aria-invalid');
    onReason(reason);
  }

  /** @returns {{ value: number, reason: null } | { value: null, reason: string }} */
  function carryOut() {
    const read = readNumber(input.value);
    if (read.reason !== null) return read;
    gesture ??= newGesture();
    const reason = check?.(read.value) ?? attempt(page, { ...command(read.value), gesture });
    return reason === null ? read : { value: null, reason };
  }

  function restore() {
    delete input.dataset.editing;
    if (gesture) store.dispatch({ type: 'cancel-gesture' });
    gesture = null;
  }

  function begin() {
    if (input.getAttribute('aria-invalid') === 'true') return; // the refused text is still there to be mended
    input.value = begun = text();
    input.select();
  }

  function typed() {
    input.dataset.editing = '';
    const { reason } = carryOut();
    if (reason !== null) restore();
    else mark(null);
  }

  function commit() {
    if (input.value === begun) {
      restore();
      mark(null);
      return;
    }
    const { value, reason } = carryOut();
    if (reason !== null) {
      restore();
      mark(reason);
      announce(reason);
      return;
    }
    gesture = null;
    delete input.dataset.editing;
    store.dispatch({ type: 'end-gesture' });
    begun = input.value;
    mark(null);
    announce(onDone(value));
  }

  input.addEventListener('focus', begin);
  input.addEventListener('input', typed);
  input.addEventListener('blur', () => {
    commit();
    if (input.getAttribute('aria-invalid') !== 'true') input.value = resting();
  });
  input.addEventListener('keydown', (event) => {
    if (event.key === 'Enter') commit();
    if (event.key === 'Escape') {
      event.stopPropagation();
      restore();
      mark(null);
      input.value = begun = text();
      input.select();
    }
  });

  return {
    input,
    /** As if a person had typed it. @param {string} wanted */
    type(wanted) {
      input.value = wanted;
      typed();
    },
    /** The document was exchanged for another: a text that was typed for the old one goes. */
    forget() {
      gesture = null;
      delete input.dataset.editing;
      if (input.getAttribute('aria-invalid') === 'true') mark(null);
    },
    /** The document changed: show its number, unless a person is typing or a refused text is still to be mended. */
    refresh() {
      if ('editing' in input.dataset || input.getAttribute('aria-invalid') === 'true') return;
      if (document.activeElement === input) input.value = begun = text();
      else input.value = resting();
    },
  };
}

/** @typedef {ReturnType<typeof editCell>} CellEditor */
