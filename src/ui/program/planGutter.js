/**
 * Left of the curves: what each is called and where it is at the head of the timeline. Where all share a scale, a press shows
 * the limits of one.
 *
 * @import { Column } from '../../model/program/planColumns.js'
 */
import { fill, h } from '../parts/dom.js';
import { fixed } from '../parts/format.js';
import { styleOf } from '../parts/curveStyle.js';
import { rowHeights, unitOfColumn } from './planDrawing.js';
import { significant } from '../parts/scientific.js';
import { svg } from '../parts/svg.js';
import { PLOTS } from '../words/plots.js';

/** Digits after the point of a number in a unit; where there is no unit, as many as it needs. */
const DECIMALS = { deg: 1, rad: 3, mm: 1, cm: 2, m: 4 };

/** @param {number} value @param {Column['unit']} unit */
export const numberIn = (value, { unit, power }) =>
  unit === '' || power !== 1 ? significant(value, 4) : fixed(value, DECIMALS[unit]);

/** @param {(joint: number) => void} onChoose */
export function createPlanGutter(onChoose) {
  const element = h('div', { class: 'gut' });
  /** @type {{ output: HTMLElement, unit: Column['unit'] }[]} */
  let rows = [];

  return {
    element,
    /** @param {{ columns: readonly Column[], speed: Column, isStrips: boolean, chosen: number | null, isOfJoints: boolean, title: string, unit: string }} given */
    build({ columns, speed, isStrips, chosen, isOfJoints, title, unit }) {
      const heights = rowHeights({ columns, isStrips });
      rows = [...columns, speed].map((column) => ({ output: h('output', {}), unit: column.unit }));
      const curves = columns.map(({ name }, i) => {
        const content = [isOfJoints && swatch(i), h('b', {}, name), rows[i].output];
        if (isStrips || columns.length === 1) return h('div', { class: 'gut-row' }, content);
        const button = h(
          'button',
          { type: 'button', class: 'gut-row', 'aria-pressed': String(chosen === i), title: PLOTS.choose(name) },
          content,
        );
        button.addEventListener('click', () => onChoose(i));
        return button;
      });
      const last = rows[rows.length - 1].output;
      const speedRow = h(
        'div',
        { class: 'gut-row gut-speed' },
        h('b', {}, PLOTS.groups.speed),
        last,
        h('span', { class: 'unit' }, unitOfColumn(speed.unit)),
      );
      speedRow.style.height = `${heights.speed}px`;
      if (isStrips) {
        for (const [i, row] of curves.entries()) row.style.height = `${heights.rows[i]}px`;
        fill(element, curves, speedRow);
        return;
      }
      const block = h(
        'div',
        { class: 'gut-block' },
        h('h3', {}, title, ' ', h('span', { class: 'unit' }, unit)),
        h('div', { class: 'gut-values' }, curves),
      );
      block.style.height = `${heights.rows[0]}px`;
      fill(element, block, speedRow);
    },
    /** @param {readonly number[]} values  of the columns, then of the speed */
    draw(values) {
      rows.forEach(({ output, unit }, i) => {
        const sign = unit.unit === 'deg' && unit.per === 0 ? '°' : '';
        output.textContent = numberIn(values[i], unit) + sign;
      });
    },
  };
}

/** The line of a joint, as it is drawn. @param {number} i */
function swatch(i) {
  const { token, dash } = styleOf(i);
  const line = svg('line', { x1: 0, x2: 16, y1: 2, y2: 2, 'stroke-width': 2.5 });
  line.style.stroke = `var(${token})`;
  if (dash.length > 0) line.style.strokeDasharray = dash.join(' ');
  return svg('svg', { class: 'curve-key', width: 16, height: 4, 'aria-hidden': 'true' }, line);
}
