/**
 * Which orientations of the tool count: any, one, or a cone of them about one.
 *
 * @import { Page } from '../page.js'
 */
import { xyzwprOf } from '../../model/aim/aim.js';
import { toDegrees, toKernel, fromKernel } from '../../model/units.js';
import { TOOLS, WIDEST_CONE } from '../../model/workspace/workspaceView.js';
import { captioned } from '../parts/captioned.js';
import { fill, h } from '../parts/dom.js';
import { unitSign } from '../parts/format.js';
import { numberField } from '../parts/numberField.js';
import { createReasons } from '../parts/reasons.js';
import { segments } from '../parts/segments.js';
import { TEXT } from '../strings.js';
import { WORKSPACE } from '../words/workspace.js';
import { look, lookChange, viewNow } from './look.js';

const WORDS = WORKSPACE.volume;

/** @param {Page} page */
export function createToolFields(page) {
  const { store, derived, addView } = page;
  const reasons = createReasons('reach-tool-reason');
  const units = () => store.state.doc.robot.units;
  const inDocument = (/** @type {number} */ radians) => Number(fromKernel('angle', radians, units()).toPrecision(12));
  const inKernel = (/** @type {number} */ value) => toKernel('angle', value, units());
  const kind = segments(WORDS.tool.label, TOOLS, WORDS.tool.name, (tool) => look(page, { tool }));
  const fields = h('div', { class: 'captioned-row' });
  const asNow = h('button', { type: 'button', class: 'btn btn-small btn-outline' }, WORDS.asNow);
  const note = h('p', { class: 'sm soft' });
  const more = h('div', { class: 'tool-more' }, fields, reasons.element, h('p', {}, asNow), note);
  asNow.addEventListener('click', () => {
    const { doc } = store.state;
    const [, , , ...angles] = xyzwprOf(doc.robot, derived.tcp(doc));
    look(page, { wpr: angles.map(inKernel) });
  });

  /** @param {number} k */
  const angle = (k) => {
    const sign = TEXT.table.unitName[units().angle];
    return numberField(page, reasons, {
      quantity: 'angle',
      label: WORDS.angleLabel(WORDS.angles[k], sign),
      value: () => inDocument(viewNow(page).wpr[k]),
      command: (value) => lookChange(page, { wpr: viewNow(page).wpr.with(k, inKernel(value)) }),
      again: () => lookChange(page, {}),
      done: WORKSPACE.set,
    });
  };
  const half = () =>
    numberField(page, reasons, {
      quantity: 'angle',
      label: WORDS.halfAngleLabel(TEXT.table.unitName[units().angle]),
      value: () => inDocument(viewNow(page).halfAngle),
      command: (value) => lookChange(page, { halfAngle: inKernel(value) }),
      again: () => lookChange(page, {}),
      done: WORKSPACE.set,
      check: (value) =>
        value > 0 && toDegrees(inKernel(value)) <= toDegrees(WIDEST_CONE) ? null : WORDS.halfAngleWrong,
    });

  /** @type {{ refresh: () => void }[]} */
  let editors = [];
  let shape = '';
  addView(
    ({ doc, session }) => (session.workspace ? `${doc.robot.units.angle} ${session.workspace.tool} ${session.workspace.wpr.join()} ${session.workspace.halfAngle}` : ''), // prettier-ignore
    () => {
      const { tool } = viewNow(page);
      const sign = unitSign(units().angle);
      kind.draw(tool);
      more.hidden = tool === 'any';
      note.textContent = tool === 'cone' ? WORDS.coneNote : WORDS.fixedNote;
      if (shape !== `${sign} ${tool}`) {
        shape = `${sign} ${tool}`;
        const made = [0, 1, 2].map(angle);
        const cone = tool === 'cone' ? half() : null;
        editors = [...made, ...(cone ? [cone] : [])].map(({ editor }) => editor);
        fill(
          fields,
          made.map(({ input }, k) => captioned(WORDS.angles[k], input, sign)),
          cone && captioned(WORDS.halfAngle, cone.input, sign),
        );
      }
      for (const editor of editors) editor.refresh();
    },
  );
  return h(
    'div',
    {},
    h('div', { class: 'row-flex reach-row' }, h('span', { class: 'grow soft' }, WORDS.tool.label), kind.element),
    more,
  );
}
