/**
 * The life of a number while it is typed, for every field that changes the document. While it has focus the field keeps
 * the person's own text and the document follows each text that is a number; a text that is none leaves the document as it
 * was before. Leaving the field or Enter makes it one undo step; Escape makes it as if it had never begun.
 *
 * While a text is being typed the field carries `data-editing`, and Ctrl+Z is the browser's own. While a text waits for what
 * reads expressions it carries `aria-busy`; the event `settled` says that the wait is over. One that takes expressions
 * carries `data-takes`: `length` or `angle`.
 *
 * @import { Change, Page } from '../page.js'
 * @import { Answer, Measure, Refused } from '../parts/numberText.js'
 */
import { attempt, newGesture } from '../page.js';
import { readNumber } from '../parts/numberText.js';
import { readTyped } from '../parts/typedNumber.js';

/**
 * @template {number | undefined} Value
 * @param {Page} page
 * @param {HTMLInputElement} input
 * @param {object} behaviour
 * @param {(value: Value, text?: string) => Change} behaviour.command  what a typed number does; text: the expression it was
 * @param {() => Measure} [behaviour.measure]  of a field that takes expressions, too
 * @param {(text: string) => Answer<Value>} [behaviour.read]  instead of plain numbers or, with a measure, expressions
 * @param {(value: Value) => string | null} [behaviour.check]  a reason against it beyond the command's own
 * @param {(value: Value) => string} behaviour.onDone  the outcome in words, for a screen reader
 * @param {(reason: string | null, refused: Refused | null) => void} behaviour.onReason  the text is refused, or is good again
 * @param {(reason: string | null, answer: Answer<Value> | null) => void} [behaviour.onTyped]  what the text comes to as it
 *   stands, and quietly why it will be refused; null when the typing is over
 * @param {() => string} behaviour.text    the document's number, to be edited
 * @param {() => string} behaviour.resting the document's number, as shown while nobody edits it
 * @param {() => Change} [behaviour.again]  what brings back what the document has now, where its text may be an expression
 */
export function editCell(page, input, { command, check, onDone, onReason, text, resting, ...behaviour }) {
  const read = behaviour.read ?? /** @type {NonNullable<typeof behaviour.read>} */ (reader(behaviour.measure));
  const { store, announce } = page;
  if (behaviour.measure) input.dataset.takes = behaviour.measure().quantity;
  /** @type {string | null} of the change that the typing has made so far */
  let gesture = null;
  let begun = '';
  /** @type {Change | null} */
  let back = null;
  /** What waits for its answer; another thing waits when the text is another. @type {object | null} */
  let waiting = null;

  const isRefused = () => input.getAttribute('aria-invalid') === 'true';
  const isStanding = () => isRefused() || input.hasAttribute('aria-busy');

  /** @param {Refused | null} refused */
  function mark(refused) {
    if (refused) input.setAttribute('aria-invalid', 'true');
    else input.removeAttribute('aria-invalid');
    onReason(refused?.reason ?? null, refused);
  }

  function endTyping() {
    delete input.dataset.editing;
    behaviour.onTyped?.(null, null);
  }

  function stopWaiting() {
    waiting = null;
    input.removeAttribute('aria-busy');
  }

  /** @param {string} typed @returns {Answer<Value>} */
  function carryOut(typed) {
    const answer = read(typed);
    if ('ready' in answer || answer.reason !== null) return answer;
    const reason = check?.(answer.value) ?? null;
    if (reason !== null) return { value: null, reason };
    const next = gesture ?? newGesture();
    const against = attempt(page, { ...command(answer.value, answer.text), gesture: next });
    if (against !== null) return { value: null, reason: against };
    gesture = next;
    return answer;
  }

  /** The document as it was before the typing, even if something else has changed it in between. */
  function takeBack() {
    if (!gesture) return;
    const isRunning = store.state.gesture?.id === gesture;
    if (isRunning) store.dispatch({ type: 'cancel-gesture' });
    else if (back) attempt(page, { ...back, gesture: newGesture() });
    else {
      gesture = null;
      carryOut(begun);
    }
    gesture = null;
  }

  function begin() {
    begun = text();
    back = behaviour.again?.() ?? null;
    if (isStanding()) return; // the text is still there to be mended
    input.value = begun;
    input.select();
  }

  /** @param {Promise<void>} ready */
  function wait(ready) {
    const mine = (waiting = {});
    input.setAttribute('aria-busy', 'true');
    ready.then(() => {
      if (waiting !== mine) return;
      stopWaiting();
      if ('editing' in input.dataset) onInput();
      else commit();
      if (document.activeElement !== input && !isStanding()) input.value = resting();
      input.dispatchEvent(new CustomEvent('settled'));
    });
  }

  function onInput() {
    input.dataset.editing = '';
    stopWaiting();
    const answer = carryOut(input.value);
    if ('ready' in answer) {
      takeBack();
      wait(answer.ready);
    } else if (answer.reason !== null) takeBack();
    else mark(null);
    behaviour.onTyped?.(answer.reason, answer);
  }

  function commit() {
    stopWaiting();
    if (input.value === begun) {
      takeBack();
      endTyping();
      mark(null);
      return;
    }
    const answer = carryOut(input.value);
    if ('ready' in answer) {
      takeBack();
      delete input.dataset.editing;
      wait(answer.ready);
      return;
    }
    if (answer.reason !== null) {
      mark(answer);
      takeBack();
      endTyping();
      announce(answer.reason);
      return;
    }
    gesture = null;
    begun = input.value;
    back = behaviour.again?.() ?? null;
    endTyping();
    mark(null);
    store.dispatch({ type: 'end-gesture' });
    announce(onDone(answer.value));
  }

  function restore() {
    stopWaiting();
    takeBack();
    endTyping();
    mark(null);
    input.value = begun = text();
    input.select();
  }

  input.addEventListener('focus', begin);
  input.addEventListener('input', onInput);
  input.addEventListener('blur', () => {
    commit();
    if (!isStanding()) input.value = resting();
  });
  input.addEventListener('keydown', (event) => {
    if (event.key === 'Enter') commit();
    if (event.key !== 'Escape') return;
    event.stopPropagation();
    restore();
  });

  return {
    input,
    restore,

    /** As if a person had typed it. @param {string} wanted */
    type(wanted) {
      input.value = wanted;
      onInput();
    },

    /** As if a person had typed it and pressed Enter. @param {string} wanted */
    settle(wanted) {
      input.focus();
      input.value = wanted;
      onInput();
      commit();
      input.select();
    },

    /** The document was exchanged for another: what was typed for the old one must not reach it. */
    forget() {
      gesture = null;
      stopWaiting();
      begun = input.value;
      endTyping();
      if (isRefused()) mark(null);
    },

    /** The document changed: show its number, unless a person is typing or a refused text is still to be mended. */
    refresh() {
      if ('editing' in input.dataset || isStanding()) return;
      if (document.activeElement === input) {
        input.value = begun = text();
        back = behaviour.again?.() ?? null;
      } else input.value = resting();
    },
  };
}

/** @param {(() => Measure) | undefined} measure @returns {(text: string) => Answer<number>} */
const reader = (measure) => (measure ? (text) => readTyped(text, measure()) : readNumber);

/** @typedef {{ input: HTMLInputElement, restore: () => void, type: (wanted: string) => void, settle: (wanted: string) => void, forget: () => void, refresh: () => void }} CellEditor */
