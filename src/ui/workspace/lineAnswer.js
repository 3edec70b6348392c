/**
 * Whether the straight line between two of the points can be travelled, and if not, where it stops and why.
 *
 * @import { Page } from '../page.js'
 * @import { LineRow, PointRow } from '../../model/workspace/pointAnswers.js'
 */
import { fill, h } from '../parts/dom.js';
import { fixed } from '../parts/format.js';
import { travelTo } from '../travel.js';
import { POINTS, TEACH } from '../words/workspacePoints.js';
import { placeText } from './probes.js';

const WORDS = POINTS.line;

/**
 * @param {Page} page
 * @param {(from: number, to: number) => void} onAsk  indices of points
 */
export function createLineAnswer(page, onAsk) {
  const [from, to] = [WORDS.fromLabel, WORDS.toLabel].map((label) =>
    h('select', { class: 'choice-box', 'aria-label': label }),
  );
  const words = h('p', { role: 'status' });
  const [start, end] = [0, 1].map(() => h('button', { type: 'button', class: 'btn btn-small btn-outline' }));
  start.textContent = WORDS.start;
  /** @type {LineRow | null} */
  let shown = null;
  start.addEventListener('click', () => shown?.start && travelTo(page, shown.start));
  end.addEventListener('click', () => shown?.end && travelTo(page, shown.end));
  const element = h(
    'div',
    { class: 'reach-result', role: 'group', 'aria-label': WORDS.title },
    h('div', { class: 'points-line' }, h('span', { class: 'b' }, WORDS.title), WORDS.from, from, WORDS.to, to),
    words,
    h('div', { class: 'points-line' }, start, end),
  );
  const ask = () => {
    if (from.value !== to.value) onAsk(Number(from.value), Number(to.value));
    else draw(null, WORDS.same);
  };
  for (const choice of [from, to]) choice.addEventListener('change', ask);

  /** @param {LineRow | null} row @param {string} [instead] */
  function draw(row, instead = '') {
    shown = row;
    start.hidden = !row?.start;
    end.hidden = !row?.end;
    words.textContent = row ? sentence(row) : instead;
    end.textContent = row?.isTravelled ? WORDS.done : WORDS.end;
  }

  /** @param {LineRow} row */
  function sentence({ share, stopsAt, why, held }) {
    if (why === null) return WORDS.travelled;
    const names = TEACH.heldAll(held.map(({ joint, bound }) => TEACH.held(`J${joint + 1}`, TEACH.at[bound])));
    const reason = WORDS.why[why](names);
    if (!stopsAt) return reason;
    return WORDS.stops(fixed(100 * share, 1), placeText(page.store.state.doc.robot, stopsAt)) + reason;
  }

  return {
    element,
    draw,
    /** @param {readonly PointRow[]} rows @param {(index: number) => string} nameOf */
    offer(rows, nameOf) {
      element.hidden = rows.length < 2;
      for (const [i, choice] of [from, to].entries()) {
        fill(
          choice,
          rows.map((_, k) => h('option', { value: k }, nameOf(k))),
        );
        choice.value = String(Math.min(i, rows.length - 1));
      }
      if (rows.length > 1) ask();
    },
  };
}
