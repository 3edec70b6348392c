/**
 * The ways out of the plots: every number of the program over its time as CSV, and what is drawn as SVG and PNG.
 *
 * @import { Page } from '../page.js'
 */
import { planCsv } from '../../model/program/planColumns.js';
import { planNow } from '../../model/program/planning.js';
import { seriesOf, steppedTimes } from '../../model/program/planSeries.js';
import { toMilliseconds } from '../../model/units.js';
import { withChoices } from '../parts/choices.js';
import { h } from '../parts/dom.js';
import { download } from '../parts/download.js';
import { plain } from '../parts/format.js';
import { icon } from '../parts/icons.js';
import { savePlot, standalone } from '../files/savePlot.js';
import { PLOTS } from '../words/plots.js';

/** s between rows. */
const STEPS = [0.01, 0.001];

/** A spreadsheet has no more than a million, and nobody waits for them. */
const MOST_ROWS = 200_000;

/**
 * @param {Page} page
 * @param {SVGElement} picture
 * @param {{ width: number, height: number }} size  of the picture now
 */
export function createPlanExport(page, picture, size) {
  const { store, derived, announce, clock } = page;
  const button = h('button', { type: 'button', class: 'btn' }, PLOTS.export, icon('caret', 'caret'));

  const drawn = () => standalone(picture, size);

  /** @param {number} step */
  function saveCsv(step) {
    const planned = planNow(store.state);
    const { planning } = store.state.session;
    if (!planned || !planning) return;
    const { doc } = store.state;
    const run = seriesOf(planned, derived.chain(doc), steppedTimes(planned.plan.duration, step));
    let last = run.next();
    while (!last.done) last = run.next();
    const stepOf = (/** @type {number} */ move) => String((planned.steps[move] ?? 0) + 1);
    const text = planCsv(doc.robot, last.value, stepOf, (group, name) => `${PLOTS.groups[group]} ${name}`);
    const file = `${PLOTS.file}.csv`;
    download(file, text, 'text/csv', clock);
    announce(PLOTS.saved(file));
  }

  return withChoices(button, () => {
    const planned = planNow(store.state);
    const csv = STEPS.map((step) => {
      const isTooLong = (planned?.plan.duration ?? 0) / step > MOST_ROWS;
      return {
        title: PLOTS.csv(plain(toMilliseconds(step))),
        detail: PLOTS.csvDetail,
        against: !planned ? PLOTS.none : isTooLong ? PLOTS.tooLong(String(MOST_ROWS)) : null,
        run: () => saveCsv(step),
      };
    });
    const against = planned ? null : PLOTS.none;
    return {
      groups: [
        csv,
        [
          {
            ...{ title: PLOTS.svg, detail: PLOTS.svgDetail, against },
            run: () => void savePlot(page, `${PLOTS.file}.svg`, drawn),
          },
          {
            ...{ title: PLOTS.png, detail: PLOTS.pngDetail, against },
            run: () => void savePlot(page, `${PLOTS.file}.png`, drawn),
          },
        ],
      ],
    };
  });
}
