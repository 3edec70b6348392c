/**
 * The points that were asked for, as a table: one of them is chosen; all of them can be copied and saved.
 *
 * @import { Page } from '../page.js'
 * @import { PointRow } from '../../model/workspace/pointAnswers.js'
 */
import { writeCsv } from '../../io/csv.js';
import { pointCells } from '../../model/workspace/pointAnswers.js';
import { fileNameOf } from '../files/files.js';
import { copyText } from '../parts/clipboard.js';
import { fill, h } from '../parts/dom.js';
import { download } from '../parts/download.js';
import { poseNumber, withUnit } from '../parts/format.js';
import { TEXT } from '../strings.js';
import { POINTS } from '../words/workspacePoints.js';
import { marginText } from './pointAnswer.js';

/** Longer names do not fit into a drawing, where the point's number stands instead. */
export const SHORT_NAME = 2;

/**
 * @param {Page} page
 * @param {(index: number) => void} onChoose
 * @param {() => void} onClear
 */
export function createPointsTable({ store, announce, clock }, onChoose, onClear) {
  const head = h('tr', {});
  const body = h('tbody', {});
  const act = (/** @type {string} */ text, /** @type {() => void} */ run) => {
    const made = h('button', { type: 'button', class: 'btn btn-small' }, text);
    made.addEventListener('click', run);
    return made;
  };
  /** @type {readonly PointRow[]} */
  let shown = [];
  const units = () => store.state.doc.robot.units;
  const cells = () =>
    pointCells(shown, POINTS.csv(units().length), {
      verdict: ({ verdict }) => POINTS.verdict[verdict],
      postures: ({ postures, areAll }) => POINTS.postures(postures.length, areAll),
    });
  const copy = act(POINTS.copy, async () => {
    const text = cells().map((row) => row.join('\t')).join('\n'); // prettier-ignore
    announce((await copyText(text)) ? POINTS.copied : POINTS.notCopied);
  });
  const save = act(POINTS.save, () => {
    const file = `${fileNameOf(store.state.doc.robot.name)}-points.csv`;
    download(file, writeCsv(cells()), 'text/csv', clock);
    announce(TEXT.files.saved(file));
  });
  const element = h(
    'div',
    {},
    h(
      'div',
      { class: 'points-scroll', role: 'region', tabindex: 0, 'aria-label': POINTS.list },
      h('table', { class: 'points-table', 'aria-label': POINTS.list }, h('thead', {}, head), body),
    ),
    h('div', { class: 'row-flex points-acts' }, copy, save, h('span', { class: 'grow' }), act(POINTS.clear, onClear)),
  );

  return {
    element,
    /** @param {readonly PointRow[]} rows @param {number} chosen @param {(index: number) => string} nameOf */
    draw(rows, chosen, nameOf) {
      shown = rows;
      element.hidden = rows.length === 0;
      const { length } = units();
      fill(
        head,
        POINTS.head.map((name, i) => h('th', { scope: 'col', class: i === 4 ? 'verdict' : null }, name)),
      );
      fill(
        body,
        rows.map((row, i) => {
          const choose = h(
            'button',
            { type: 'button', class: 'btn btn-small', 'aria-label': POINTS.choose(nameOf(i)), 'aria-pressed': String(i === chosen) },
            row.name.length > SHORT_NAME ? `${i + 1} ${row.name}` : nameOf(i),
          ); // prettier-ignore
          choose.addEventListener('click', () => onChoose(i));
          const isReached = row.verdict === 'reached';
          return h(
            'tr',
            { 'aria-current': i === chosen ? 'true' : null },
            h('td', {}, choose),
            row.at.map((value) => h('td', {}, poseNumber(value, length))),
            h('td', { class: 'verdict' }, POINTS.verdict[row.verdict]),
            isReached
              ? [
                  h('td', {}, POINTS.postures(row.postures.length, row.areAll)),
                  h('td', {}, marginText(row.postures[0].margin)),
                ]
              : h('td', { colspan: 2 }, POINTS.short(withUnit(poseNumber(row.distance, length), length))),
          );
        }),
      );
    },
  };
}
