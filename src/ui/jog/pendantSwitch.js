/**
 * Whether joints are shown as the table counts them or as the controller's pendant does. It is offered where a controller would
 * have numbers or a configuration for the arm; what belongs to it is fetched when it is first used.
 *
 * @import { Page } from '../page.js'
 */
import { hasPendant } from '../../model/controller/controllerData.js';
import { together } from '../../model/views.js';
import { h } from '../parts/dom.js';
import { fetchPendantNumbers } from './jointNumbers.js';
import { TEXT } from '../strings.js';

/** @param {Page} page */
export function createPendantSwitch(page) {
  const input = h('input', { type: 'checkbox', role: 'switch' });
  const row = h('label', { class: 'switch' }, input, TEXT.jog.pendant);
  const note = h('div', { hidden: true });
  let hasNote = false;

  input.addEventListener('change', async () => {
    try {
      const { createPendantNote, showPendant } = await fetchPendantNumbers();
      if (!hasNote) createPendantNote(page, note);
      hasNote = true;
      showPendant(page, input.checked);
    } catch (error) {
      input.checked = false;
      page.messages.fault(error);
    }
  });
  page.addView(
    together(({ doc, session }) => [hasPendant(doc.robot), session.numbers.isPendant]),
    ([isOffered, isPendant]) => {
      row.hidden = !isOffered;
      note.hidden = !isOffered || !isPendant;
    },
  );
  return { row, note };
}
