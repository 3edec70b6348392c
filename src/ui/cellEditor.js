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
 * @template {number | undefined} Value
 * @param {Page} page
 * @param {HTMLInputElement} input
 * @param {object} behaviour
 * @param {(value: Value) => Command} behaviour.command  what a typed number does
 * @param {(text: string) => { value: Value, reason: null } | { value: null, reason: string }} [behaviour.read]
 * @param {(value: Value) => string | null} [behaviour.check]  a reason against it beyond the command's own
 * @param {(value: Value) => string} behaviour.onDone  the outcome in words, for a screen reader
 * @param {(reason: string | null) => void} behaviour.onReason  the text is refused, or is good again
 * @param {(reason: string | null) => void} [behaviour.onTyped]  why the text will be refused as it stands, quietly
 * @param {() => string} behaviour.text    the document's number, to be edited
 * @param {() => string} behaviour.resting the document's number, as shown while nobody edits it
 */
export function editCell(page, input, { command, check, onDone, onReason, text, resting, ...behaviour }) {
  const read = behaviour.read ?? /** @type {NonNullable<typeof behaviour.read>} */ (readNumber);
  const { store, announce } = page;
  /** @type {string | null} of the change that the typing has made so far */
  let gesture = null;
  let begun = '';

  const isRefused = () => input.getAttribute('aria-invalid') === 'true';

  /** @param {string | null} reason */
  function mark(reason) {
    if (reason) input.setAttribute('aria-invalid', 'true');
    else input.removeAttribute('aria-invalid');
    onReason(reason);
  }

  /** @param {string} typed */
  function carryOut(typed) {
    const answer = read(typed);
    if (answer.reason !== null) return answer;
    const reason = check?.(answer.value) ?? null;
    if (reason !== null) return { value: null, reason };
    const next = gesture ?? newGesture();
    const against = attempt(page, { ...command(answer.value), gesture: next });
    if (against !== null) return { value: null, reason: against };
    gesture = next;
    return answer;
  }

  /** The document as it was before the typing, even if something else has changed it in between. */
  function takeBack() {
    if (!gesture) return;
    const isRunning = store.state.gesture?.id === gesture;
    gesture = null;
    if (isRunning) store.dispatch({ type: 'cancel-gesture' });
    else carryOut(begun);
    gesture = null;
  }

  function begin() {
    begun = text();
    if (isRefused()) return; // the refused text is still there to be mended
    input.value = begun;
    input.select();
  }

  function onInput() {
    input.dataset.editing = '';
    const { reason } = carryOut(input.value);
    if (reason !== null) takeBack();
    else mark(null);
    behaviour.onTyped?.(reason);
  }

  function commit() {
    if (input.value === begun) {
      takeBack();
      delete input.dataset.editing;
      mark(null);
      return;
    }
    const { value, reason } = carryOut(input.value);
    if (reason !== null) {
      mark(reason);
      takeBack();
      delete input.dataset.editing;
      announce(reason);
      return;
    }
    gesture = null;
    begun = input.value;
    delete input.dataset.editing;
    mark(null);
    store.dispatch({ type: 'end-gesture' });
    announce(onDone(value));
  }

  function restore() {
    takeBack();
    delete input.dataset.editing;
    mark(null);
    input.value = begun = text();
    input.select();
  }

  input.addEventListener('focus', begin);
  input.addEventListener('input', onInput);
  input.addEventListener('blur', () => {
    commit();
    if (!isRefused()) input.value = resting();
  });
  input.addEventListener('keydown', (event) => {
    if (event.key === 'Enter') commit();
    if (event.key !== 'Escape') return;
    event.stopPropagation();
    restore();
  });

  return {
    input,

    /** As if a person had typed it. @param {string} wanted */
    type(wanted) {
      input.value = wanted;
      onInput();
    },

    /** The document was exchanged for another: what was typed for the old one must not reach it. */
    forget() {
      gesture = null;
      begun = input.value;
      delete input.dataset.editing;
      if (isRefused()) mark(null);
    },

    /** The document changed: show its number, unless a person is typing or a refused text is still to be mended. */
    refresh() {
      if ('editing' in input.dataset || isRefused()) return;
      if (document.activeElement === input) input.value = begun = text();
      else input.value = resting();
    },
  };
}

/** @typedef {{ input: HTMLInputElement, type: (wanted: string) => void, forget: () => void, refresh: () => void }} CellEditor */
