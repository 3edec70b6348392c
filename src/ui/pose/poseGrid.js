/**
 * Named numbers in two columns, position left and orientation right: read across, X W, Y P, Z R.
 *
 * @typedef {{ label: string, unit: string }} NumberHead
 */
import { h } from '../parts/dom.js';

const POSITION = 3;

/**
 * @param {readonly NumberHead[]} heads  three of the position, then those of the orientation
 */
export function createPoseGrid(heads) {
  const outputs = heads.map(() => h('output', { 'aria-live': 'off' })); // spoken when the arm rests, not while it moves
  const cells = heads.map(({ label, unit }, k) =>
    h(
      'div',
      { class: k < POSITION ? 'at' : 'turn' },
      h('b', { class: k < POSITION ? `axis-${'xyz'[k]}` : 'soft' }, label),
      outputs[k],
      h('span', { class: 'unit' }, unit),
    ),
  );
  const rows = Math.max(POSITION, heads.length - POSITION);
  const pairs = Array.from({ length: rows }, (_, k) => [
    cells[k < POSITION ? k : -1] ?? h('div', { class: 'blank' }),
    cells[POSITION + k] ?? h('div', { class: 'blank' }),
  ]);
  /** @type {string[]} what stands there: a text that stays the same is not touched */
  const shown = [];
  return {
    element: h('div', { class: 'pose' }, pairs.flat()),
    /** @param {readonly string[]} texts */
    draw(texts) {
      texts.forEach((text, k) => {
        if (shown[k] !== text) outputs[k].value = shown[k] = text;
      });
    },
  };
}
