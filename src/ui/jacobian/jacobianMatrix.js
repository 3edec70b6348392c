/**
 * A matrix of six rows and a column for each joint, the linear part set apart from the angular one.
 */
import { fill, h, symbol } from '../parts/dom.js';
import { JACOBIAN } from '../words/jacobian.js';

/** @param {string} label */
export function createJacobianMatrix(label) {
  const caption = h('caption', {}, label);
  const table = h('table', { class: 'jacobian' }, caption);
  const element = h('div', { class: 'jacobian-box', tabindex: 0, role: 'region', 'aria-label': label }, table);
  /** @type {HTMLElement[]} row by row */
  let cells = [];
  let columns = 0;
  /** @type {string[]} */
  let shown = [];

  /** @param {number} count */
  function build(count) {
    columns = count;
    shown = [];
    cells = Array.from({ length: 6 * count }, (_, at) => h('td', { 'data-at': at }));
    fill(
      table,
      caption,
      h(
        'thead',
        {},
        h(
          'tr',
          {},
          h('td', {}),
          Array.from({ length: count }, (_, k) => h('th', { scope: 'col' }, JACOBIAN.joint(k + 1))),
        ),
      ),
      [0, 3].map((first) =>
        h(
          'tbody',
          {},
          [0, 1, 2].map((i) =>
            h(
              'tr',
              {},
              h('th', { scope: 'row' }, symbol(JACOBIAN.rows[first + i][0], JACOBIAN.rows[first + i][1])),
              cells.slice((first + i) * count, (first + i + 1) * count),
            ),
          ),
        ),
      ),
    );
  }

  return {
    element,
    /** @param {string} text */
    setLabel(text) {
      if (caption.textContent !== text) caption.textContent = text;
    },
    /** @param {readonly (readonly string[])[]} texts */
    draw(texts) {
      if (texts[0].length !== columns) build(texts[0].length);
      texts.flat().forEach((text, at) => {
        if (shown[at] === text) return;
        cells[at].textContent = shown[at] = text;
        cells[at].classList.toggle('zero', text === '0');
      });
    },
    /** The same entry is marked in every matrix. @param {string | undefined} at */
    mark(at) {
      for (const cell of cells) cell.classList.toggle('is-same', cell.dataset.at === at);
    },
  };
}
