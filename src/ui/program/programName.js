/**
 * The name of the motion program that is shown, as a field below its steps while none of them is chosen.
 *
 * @import { Page } from '../page.js'
 * @import { Reasons } from '../parts/reasons.js'
 * @import { MotionProgramDoc } from '../../model/document.js'
 */
import { captioned, textInput } from '../parts/captioned.js';
import '../css/robotDetails.css';
import { h } from '../parts/dom.js';
import { attempt } from '../page.js';
import { PROGRAM } from '../words/program.js';

/** @param {Page} page @param {Reasons} reasons */
export function createProgramName(page, reasons) {
  const input = textInput({ 'aria-label': PROGRAM.name, maxlength: 200 });
  const element = h('section', { class: 'step-card', hidden: true }, captioned(PROGRAM.name, input, null, 'is-words'));
  /** @type {MotionProgramDoc | null} */
  let shown = null;
  let program = 0;
  const reset = () => void (input.value = shown?.name ?? '');

  input.addEventListener('change', () => {
    const against = attempt(page, { type: 'rename-motion-program', program, name: input.value.trim() });
    reasons.set(input, against);
  });
  input.addEventListener('keydown', ({ key }) => {
    if (key === 'Escape') reset();
  });

  return {
    element,
    focus() {
      page.store.dispatch({ type: 'show', change: { step: null } });
      page.clock.onFrame(() =>
        page.clock.onFrame(() => {
          element.hidden = false;
          input.focus();
          input.select();
        }),
      );
    },
    /** @param {MotionProgramDoc | null} now @param {number} index @param {boolean} isShown */
    draw(now, index, isShown) {
      [shown, program] = [now, index];
      element.hidden = !isShown;
      if (document.activeElement !== input) reset();
    },
  };
}
