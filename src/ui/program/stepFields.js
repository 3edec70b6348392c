/**
 * The fields of a step: a number, a text, a choice, each with its caption, its own change of the step, and its refreshing.
 *
 * @import { CellEditor } from '../robot/cellEditor.js'
 * @import { Page } from '../page.js'
 * @import { Reasons } from '../parts/reasons.js'
 * @import { MotionCommand } from '../../model/program/motionCommands.js'
 */
import { captioned, captionedSelect, select, textInput } from '../parts/captioned.js';
import { editCell } from '../robot/cellEditor.js';
import { h } from '../parts/dom.js';
import { compact, editable } from '../parts/format.js';
import { attempt } from '../page.js';
import { PROGRAM } from '../words/program.js';

const WIDEST = 8;

/**
 * @param {Page} page
 * @param {Reasons} reasons
 * @param {(change: object) => MotionCommand} changed  the step with some of its fields others
 */
export function createStepFields(page, reasons, changed) {
  const { announce } = page;
  /** @type {(() => void)[]} */
  const refreshers = [];
  /** @type {CellEditor[]} */
  const editors = [];

  /** @param {string} label @param {object} change @param {string} value  in words */
  function set(label, change, value) {
    const against = attempt(page, changed(change));
    announce(against ?? PROGRAM.done.field(label, value));
  }

  /**
   * @param {string} label
   * @param {() => number} value
   * @param {(value: number) => object} change
   * @param {() => string} [unit]
   * @param {string} [caption]  for the eye, where the label says more than there is room for
   */
  function numberField(label, value, change, unit = () => '', caption = label) {
    const input = textInput({ 'aria-label': label, 'data-action': label });
    const sign = h('span', {});
    const editor = editCell(page, input, {
      command: (/** @type {number} */ typed) => changed(change(typed)),
      onDone: (typed) => PROGRAM.done.field(label, editable(typed)),
      onReason: (reason, refused) => reasons.set(input, reason, refused),
      text: () => editable(value()),
      resting: () => compact(value(), WIDEST).text,
    });
    editors.push(editor);
    refreshers.push(() => {
      editor.refresh();
      sign.textContent = unit();
    });
    return captioned(caption, input, sign);
  }

  /**
   * @param {string} label
   * @param {() => string} value
   * @param {(text: string) => object} change
   * @param {string} [className]
   */
  function textField(label, value, change, className = '') {
    const input = textInput({ 'aria-label': label, 'data-action': label });
    const reset = () => void (input.value = value());
    input.addEventListener('input', () => void (input.dataset.editing = ''));
    input.addEventListener('change', () => {
      delete input.dataset.editing;
      const against = attempt(page, changed(change(input.value.trim())));
      reasons.set(input, against);
      if (against === null) input.removeAttribute('aria-invalid');
      else input.setAttribute('aria-invalid', 'true');
      announce(against ?? PROGRAM.done.field(label, input.value));
    });
    input.addEventListener('keydown', (event) => {
      if (event.key !== 'Escape') return;
      event.stopPropagation();
      delete input.dataset.editing;
      input.removeAttribute('aria-invalid');
      reasons.set(input, null);
      reset();
    });
    refreshers.push(() => {
      if (!('editing' in input.dataset) && !input.hasAttribute('aria-invalid')) reset();
    });
    return captioned(label, input, null, `is-words ${className}`.trim());
  }

  /**
   * @param {string} label
   * @param {Record<string, string>} names
   * @param {() => string} value
   * @param {(value: string) => object} change
   */
  function choice(label, names, value, change) {
    const control = select(label, Object.keys(names), names, (chosen) => set(label, change(chosen), names[chosen]));
    control.dataset.action = label;
    refreshers.push(() => void (control.value = value()));
    return captionedSelect(control, label);
  }

  return {
    ...{ number: numberField, text: textField, choice },
    refresh: () => refreshers.forEach((refresh) => refresh()),
    forget: () => editors.forEach((editor) => editor.forget()),
  };
}

/** @typedef {ReturnType<typeof createStepFields>} StepFields */
