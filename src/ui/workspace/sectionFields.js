/**
 * Where the section is cut, and how finely it is looked at.
 *
 * @import { Page } from '../page.js'
 */
import { fromKernel, toKernel } from '../../model/units.js';
import { cellSize, leastCell } from '../../model/workspace/mapQuestions.js';
import { CELL, CUTS, FARTHEST } from '../../model/workspace/workspaceView.js';
import { captioned, textInput } from '../parts/captioned.js';
import { fill, h } from '../parts/dom.js';
import { copyable, unitSign } from '../parts/format.js';
import { numberField } from '../parts/numberField.js';
import { createReasons } from '../parts/reasons.js';
import { segments } from '../parts/segments.js';
import { severalField } from '../parts/severalField.js';
import { TEXT } from '../strings.js';
import { WORKSPACE } from '../words/workspace.js';
import { SECTION } from '../words/workspaceSection.js';
import { look, lookChange, viewNow } from './look.js';
import { shortLength } from './measures.js';

/** What is offered as a finer cell, m. */
const FINE = 5e-4;

/** @param {Page} page */
export function createSectionFields(page) {
  const { store, derived, addView } = page;
  const reasons = createReasons('reach-section-reason');
  const units = () => store.state.doc.robot.units;
  const chain = () => derived.chain(store.state.doc);
  const cut = segments(SECTION.cut.label, CUTS, SECTION.cut.name, (value) => look(page, { cut: value }));
  const fields = h('div', { class: 'captioned-row' });
  const finer = h('button', { type: 'button', class: 'btn btn-small btn-outline' });
  finer.addEventListener('click', () => look(page, { cell: Math.max(FINE, leastCell(chain())) }));
  const precise = h('input', { type: 'checkbox', role: 'switch' });
  precise.addEventListener('change', () => look(page, { isPrecise: precise.checked }));

  /**
   * @param {'angle' | 'offset' | 'cell'} name
   * @param {'angle' | 'length'} quantity
   * @param {string} label
   * @param {(kernel: number) => string | null} check
   */
  const number = (name, quantity, label, check) =>
    numberField(page, reasons, {
      quantity,
      label,
      value: () =>
        Number(
          fromKernel(
            quantity,
            name === 'cell' ? cellSize(chain(), viewNow(page)) : viewNow(page)[name],
            units(),
          ).toPrecision(12),
        ),
      command: (value) => lookChange(page, { [name]: toKernel(quantity, value, units()) }),
      again: () => lookChange(page, {}),
      done: WORKSPACE.set,
      check: (value) => check(toKernel(quantity, value, units())),
    });

  function normalField() {
    const input = textInput({ 'aria-label': SECTION.normalLabel });
    const { editor } = severalField(page, reasons, input, {
      counts: [3],
      wrongCount: SECTION.threeNumbers,
      text: () => copyable(viewNow(page).normal),
      take: (normal) =>
        normal.some((value) => value !== 0) && normal.every((value) => Math.abs(value) <= FARTHEST)
          ? { command: lookChange(page, { normal }) }
          : { reason: SECTION.normalWrong },
      mend: () => null,
      mendLabel: '',
      done: () => WORKSPACE.set(SECTION.normal, copyable(viewNow(page).normal)),
    });
    return { input, editor };
  }

  /** @type {{ refresh: () => void }[]} */
  let editors = [];
  let shape = '';
  addView(
    ({ doc, session }) => JSON.stringify([doc.robot.units, session.workspace, derived.chain(doc).reach]),
    () => {
      const view = viewNow(page);
      const now = units();
      const [length, angle] = [TEXT.table.unitName[now.length], TEXT.table.unitName[now.angle]];
      cut.draw(view.cut);
      precise.checked = view.isPrecise;
      const least = leastCell(chain());
      finer.textContent = SECTION.finer(shortLength(Math.max(FINE, least), now));
      finer.hidden = cellSize(chain(), view) <= Math.max(FINE, least);
      if (shape !== `${now.length} ${now.angle} ${view.cut}`) {
        shape = `${now.length} ${now.angle} ${view.cut}`;
        const cell = number('cell', 'length', SECTION.cellLabel(length), (metres) =>
          metres >= leastCell(chain()) && metres <= CELL.most
            ? null
            : SECTION.cellWrong(shortLength(leastCell(chain()), units()), shortLength(CELL.most, units())),
        );
        const inCut =
          view.cut === 'angle'
            ? [
                captionedNumber(
                  SECTION.angle,
                  number('angle', 'angle', SECTION.angleLabel(angle), () => null),
                  now.angle,
                ),
              ]
            : view.cut === 'plane'
              ? [
                  { ...normalField(), caption: SECTION.normal, sign: '' },
                  captionedNumber(
                    SECTION.offset,
                    number('offset', 'length', SECTION.offsetLabel(length), (metres) =>
                      Math.abs(metres) <= FARTHEST ? null : SECTION.offsetWrong,
                    ),
                    now.length,
                  ),
                ]
              : [];
        const all = [...inCut, captionedNumber(SECTION.cell, cell, now.length)];
        editors = all.map(({ editor }) => editor);
        fill(
          fields,
          all.map(({ input, caption, sign }) => captioned(caption, input, sign)),
        );
      }
      for (const editor of editors) editor.refresh();
    },
  );

  /** @param {string} caption @param {ReturnType<typeof number>} field @param {'mm' | 'cm' | 'm' | 'deg' | 'rad'} unit */
  function captionedNumber(caption, field, unit) {
    return { ...field, caption, sign: unitSign(unit) };
  }

  return h(
    'div',
    {},
    h('div', { class: 'row-flex reach-row' }, cut.element),
    fields,
    reasons.element,
    h(
      'div',
      { class: 'row-flex reach-row' },
      h('label', { class: 'switch' }, precise, SECTION.precise),
      h('span', { class: 'grow' }),
      finer,
    ),
  );
}
