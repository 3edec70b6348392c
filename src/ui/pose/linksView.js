/**
 * A_i, one link at a time: how its row makes it, in numbers or in symbols. The link whose joint is held or whose cell is
 * edited comes forward by itself.
 *
 * @import { Page } from '../page.js'
 * @import { LinkRow } from '../../model/robot/linkTransforms.js'
 */
import { LINK_MOTIONS, LINK_SYMBOLS, linkRows, linkTransform } from '../../model/robot/linkTransforms.js';
import { rowsOf } from '../../model/numbers/poseRows.js';
import { fromKernel } from '../../model/units.js';
import { together } from '../../model/views.js';
import { fill, h, spoken, symbol } from '../parts/dom.js';
import { poseNumber, unitSign, withUnit } from '../parts/format.js';
import { createMatrix, matrixTexts } from './matrixView.js';
import { NUMBERS } from '../words/numbers.js';

const LETTER = { theta: 'θ', d: 'd', a: 'a', alpha: 'α' };
const QUANTITY = /** @type {const} */ ({ theta: 'angle', d: 'length', a: 'length', alpha: 'angle' });

/** @param {Page} page */
export function createLinksView({ store, addView, derived }) {
  let chosen = 0;
  let isSymbolic = false;
  const picker = h('div', { class: 'seg', role: 'group', 'aria-label': NUMBERS.links });
  const symbols = h('button', { type: 'button', class: 'btn sm', 'aria-pressed': 'false' }, NUMBERS.symbols);
  const head = h('p', { class: 'link-head' });
  const values = h('dl', { class: 'link-values' });
  const matrix = createMatrix();
  const foot = h('p', { class: 'sm soft' });

  /** @returns {{ rows: LinkRow[], A: (index: number) => Float64Array }} */
  function links() {
    const { doc } = store.state;
    const rows = linkRows(derived.chain(doc), derived.posture(doc));
    return { rows, A: (index) => linkTransform(doc.robot.convention, rows[index]) };
  }

  /** @type {HTMLButtonElement[]} */
  let buttons = [];
  function draw() {
    const { robot } = store.state.doc;
    const { units, convention, joints } = robot;
    if (buttons.length !== joints.length) {
      buttons = joints.map((_, i) => h('button', { type: 'button', 'aria-pressed': 'false' }, symbol('A', i + 1)));
      fill(picker, buttons);
    }
    chosen = Math.min(chosen, joints.length - 1);
    buttons.forEach((button, i) => button.setAttribute('aria-pressed', String(i === chosen)));
    symbols.setAttribute('aria-pressed', String(isSymbolic));
    const { rows, A } = links();
    const row = rows[chosen];
    const index = chosen + 1;
    const from = chosen === 0 ? NUMBERS.frameName.base : NUMBERS.frame(chosen);
    fill(
      head,
      spoken(NUMBERS.linkOf(index, from)),
      h(
        'span',
        { 'aria-hidden': 'true' },
        symbol('A', index),
        ' = ',
        LINK_MOTIONS[convention]
          .map(([field, motion]) => [
            h('span', { class: 'm' }, motion[0], h('sub', {}, h('i', {}, motion[1]))),
            '(',
            symbol(LETTER[field], index),
            ') ',
          ])
          .flat(),
      ),
    );
    fill(
      values,
      LINK_MOTIONS[convention].map(([field]) => {
        const quantity = QUANTITY[field];
        const value = fromKernel(quantity, row[field], units);
        const text = value === 0 ? '0' : poseNumber(value, units[quantity]);
        return h('div', {}, h('dt', {}, symbol(LETTER[field], index)), h('dd', {}, withUnit(text, units[quantity])));
      }),
    );
    const numbers = rowsOf(A(chosen)).map((line, i) =>
      line.map((value, j) => (j === 3 && i < 3 ? fromKernel('length', value, units) : value)),
    );
    matrix.draw(NUMBERS.linkMatrix(index), isSymbolic ? LINK_SYMBOLS[convention] : matrixTexts(numbers, units.length));
    foot.textContent = isSymbolic ? NUMBERS.legend : NUMBERS.lengths(unitSign(units.length));
  }

  picker.addEventListener('click', ({ target }) => {
    const index = buttons.findIndex((button) => target instanceof Node && button.contains(target));
    if (index < 0) return;
    chosen = index;
    draw();
  });
  symbols.addEventListener('click', () => {
    isSymbolic = !isSymbolic;
    draw();
  });

  let isOpen = false;
  addView(
    together(({ doc, session }) => [
      isOpenIn(session),
      ...(isOpenIn(session) ? [doc.robot, doc.posture, session.heldJoint ?? session.cell?.joint] : []),
    ]),
    ([open, , , pointed]) => {
      isOpen = Boolean(open);
      if (!isOpen) return;
      if (typeof pointed === 'number') chosen = pointed;
      draw();
    },
  );

  return {
    element: h(
      'div',
      { class: 'links' },
      h('div', { class: 'row-flex' }, picker, h('span', { class: 'grow' }), symbols),
      head,
      values,
      matrix.element,
      foot,
    ),
    /** The one that is shown. */
    shown: () => [{ index: chosen, A: links().A(chosen) }],
    all: () => links().rows.map((_, index) => ({ index, A: links().A(index) })),
  };
}

/** @param {{ numbers: { tab: string } }} session */
const isOpenIn = ({ numbers }) => numbers.tab === 'links';
