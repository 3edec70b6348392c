/**
 * What the curves show, as a table: where steps meet, and in between evenly.
 *
 * @import { Column } from '../../model/program/planColumns.js'
 * @import { PlanSeries } from '../../model/program/planSeries.js'
 */
import { indexAt, valueAt } from '../../model/program/planSeries.js';
import { fill, h } from '../parts/dom.js';
import { fixed } from '../parts/format.js';
import { numberIn } from './planGutter.js';
import { unitOfColumn } from './planDrawing.js';
import { PLOTS } from '../words/plots.js';

/** s between rows; the least that makes no more than so many. */
const EVERY = [0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10, 30, 60, 300];
const MOST = 60;

/** @param {number} duration @param {readonly number[]} marks */
export function rowTimes(duration, marks) {
  const every = EVERY.find((one) => duration / one <= MOST) ?? Math.max(duration, 1);
  const even = Array.from({ length: Math.floor(duration / every) + 1 }, (_, i) => i * every);
  const far = even.filter((time) => marks.every((mark) => Math.abs(mark - time) > 1e-6));
  return [...far, ...marks].sort((a, b) => a - b);
}

export function createPlanTable() {
  const caption = h('caption', { class: 'visually-hidden' });
  const head = h('thead', {});
  const body = h('tbody', {});
  const element = h(
    'div',
    { class: 'plan-table', role: 'region', tabindex: 0, hidden: true },
    h('table', {}, caption, head, body),
  );
  return {
    element,
    /** @param {{ series: PlanSeries, columns: readonly Column[], speed: Column, marks: readonly number[], steps: readonly number[], what: string }} given */
    draw({ series, columns, speed, marks, steps, what }) {
      const { times, moves } = series;
      caption.textContent = PLOTS.tableOf(what);
      element.setAttribute('aria-label', PLOTS.tableOf(what));
      const all = [...columns, speed];
      const unit = (/** @type {Column} */ column) => h('span', { class: 'unit' }, ` ${unitOfColumn(column.unit)}`);
      fill(
        head,
        h(
          'tr',
          {},
          h('th', { scope: 'col' }, PLOTS.time, h('span', { class: 'unit' }, ` ${PLOTS.seconds}`)),
          h('th', { scope: 'col' }, PLOTS.step),
          columns.map((column) => h('th', { scope: 'col' }, column.name, unit(column))),
          h('th', { scope: 'col' }, PLOTS.groups.speed, unit(speed)),
        ),
      );
      fill(
        body,
        rowTimes(times[times.length - 1], marks).map((time) =>
          h(
            'tr',
            { class: marks.includes(time) ? 'is-mark' : null },
            h('th', { scope: 'row' }, fixed(time, 2)),
            h('td', {}, String((steps[moves[indexAt(times, time)]] ?? 0) + 1)),
            all.map(({ values, unit: own }) => h('td', {}, numberIn(valueAt(times, values, time), own))),
          ),
        ),
      );
    },
  };
}
