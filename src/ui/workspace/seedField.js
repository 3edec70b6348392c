/**
 * The seed of all sampling.
 *
 * @import { Page } from '../page.js'
 */
import { LARGEST_SEED } from '../../model/workspace/workspaceView.js';
import { captioned, textInput } from '../parts/captioned.js';
import { h } from '../parts/dom.js';
import { createReasons } from '../parts/reasons.js';
import { severalField } from '../parts/severalField.js';
import { WORKSPACE } from '../words/workspace.js';
import { lookChange, viewNow } from './look.js';
import { grouped } from './measures.js';

let fields = 0;

/** @param {Page} page */
export function createSeedField(page) {
  const reasons = createReasons(`reach-seed-reason-${++fields}`);
  const input = textInput({ 'aria-label': WORKSPACE.seedLabel, inputmode: 'numeric' });
  const wrong = { reason: WORKSPACE.seedWrong(grouped(LARGEST_SEED)) };
  const { editor } = severalField(page, reasons, input, {
    counts: [1],
    wrongCount: () => wrong.reason,
    text: () => String(viewNow(page).seed),
    take: ([seed]) =>
      Number.isInteger(seed) && seed >= 0 && seed <= LARGEST_SEED ? { command: lookChange(page, { seed }) } : wrong,
    mend: () => null,
    mendLabel: '',
    done: () => WORKSPACE.set(WORKSPACE.seed, String(viewNow(page).seed)),
  });
  page.addView(
    ({ session }) => session.workspace?.seed,
    () => editor.refresh(),
  );
  return h(
    'details',
    { class: 'plot-table reach-seed' },
    h('summary', {}, WORKSPACE.more),
    h('p', { class: 'sm soft' }, WORKSPACE.seedNote),
    captioned(WORKSPACE.seed, input),
    reasons.element,
  );
}
