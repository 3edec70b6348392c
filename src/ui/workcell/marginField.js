/**
 * What programs are to keep to obstacles: of the session, not of the file.
 *
 * @import { Page } from '../page.js'
 */
import { marginNow } from '../../model/workcell/workcellView.js';
import { fromKernel, toKernel } from '../../model/units.js';
import { together } from '../../model/views.js';
import { captioned } from '../parts/captioned.js';
import { fill, h } from '../parts/dom.js';
import { compact, unitSign } from '../parts/format.js';
import { numberField } from '../parts/numberField.js';
import { createReasons } from '../parts/reasons.js';
import { TEXT } from '../strings.js';
import { OBSTACLES } from '../words/obstacles.js';

const WIDEST = 7;

/** @param {Page} page */
export function createMarginField(page) {
  const { store, addView, derived } = page;
  const reasons = createReasons('margin-reason');
  const units = () => store.state.doc.robot.units;
  const metres = () => marginNow(store.state.session.workcell, derived.chain(store.state.doc));
  const value = () => Number(fromKernel('length', metres(), units()).toPrecision(12));
  /** @param {number} margin  m */
  const show = (margin) =>
    /** @type {const} */ ({ type: 'show', change: { workcell: { ...store.state.session.workcell, margin } } });
  const box = h('div', { class: 'captioned-row', title: OBSTACLES.marginTitle });
  const element = h('div', {}, box, reasons.element);
  /** @type {{ refresh: () => void }} */
  let editor = { refresh() {} };
  let shape = '';
  addView(
    together(({ doc, session }) => [doc.robot, session.workcell.margin]),
    ([{ units: now }]) => {
      if (now.length !== shape) {
        shape = now.length;
        const made = numberField(page, reasons, {
          quantity: 'length',
          label: OBSTACLES.marginLabel(TEXT.table.unitName[now.length]),
          value,
          command: (typed) => show(toKernel('length', typed, units())),
          again: () => show(metres()),
          done: OBSTACLES.set,
          resting: () => compact(value(), WIDEST).text,
          check: (typed) => (typed >= 0 ? null : OBSTACLES.marginWrong),
        });
        editor = made.editor;
        fill(
          box,
          captioned(OBSTACLES.margin, made.input, unitSign(now.length)),
          h('span', { class: 'soft sm is-beside' }, OBSTACLES.marginDetail),
        );
      }
      editor.refresh();
    },
  );
  return { element };
}
