/**
 * The difference from the geometry against the step, both by powers of ten, where truncation and rounding are straight lines of
 * their own slopes; the same in a sentence and in a table.
 *
 * @import { DifferenceMethod } from '../../model/numbers/jacobianView.js'
 * @import { Page } from '../page.js'
 * @import { errorCurves } from '../../model/numbers/quotients.js'
 */
import { PLOTTED } from '../../model/numbers/quotients.js';
import { fill, h } from '../parts/dom.js';
import { plotSavers, standalone } from '../files/savePlot.js';
import { powerOfTen, stepText, tiny } from '../parts/scientific.js';
import { svg } from '../parts/svg.js';
import { JACOBIAN } from '../words/jacobian.js';
import { PLOT } from '../words/plot.js';

const SIZE = { width: 372, height: 224 };
const ROOM = { left: 42, right: 10, top: 10, bottom: 38 };
/** Powers of ten of the differences; what is less is drawn at the lower edge. */
const LEAST = -17;
const MOST = 1;
const METHODS = /** @type {const} */ (['forward', 'central']);

/** @param {number} exponent of the step */
const across = (exponent) =>
  ROOM.left + ((exponent - PLOTTED.least) / (PLOTTED.most - PLOTTED.least)) * (SIZE.width - ROOM.left - ROOM.right);

/** @param {number} exponent of the difference */
const down = (exponent) =>
  ROOM.top + ((MOST - Math.min(MOST, exponent)) / (MOST - LEAST)) * (SIZE.height - ROOM.top - ROOM.bottom);

/** @param {number} error */
const heightOf = (error) => down(error > 10 ** LEAST ? Math.log10(error) : LEAST);

const short = (/** @type {number} */ value) => value.toFixed(1);

/** @typedef {ReturnType<typeof errorCurves>} Curves */

/** @param {Page} page */
export function createErrorPlot(page) {
  const picture = svg('svg', {
    viewBox: `0 0 ${SIZE.width} ${SIZE.height}`,
    class: 'error-plot',
    role: 'img',
    'aria-label': JACOBIAN.plot.caption, // until there is something to say of it
  });
  const sentence = h('p', { class: 'sm' });
  const body = h('tbody', {});
  const table = h(
    'details',
    { class: 'plot-table' },
    h('summary', {}, JACOBIAN.plot.table),
    h(
      'table',
      {},
      h(
        'thead',
        {},
        h(
          'tr',
          {},
          JACOBIAN.plot.columns.map((name) => h('th', { scope: 'col' }, name)),
        ),
      ),
      body,
    ),
  );

  const ticks = Array.from({ length: (PLOTTED.most - PLOTTED.least) / 2 + 1 }, (_, i) => PLOTTED.least + 2 * i);
  const heights = [-16, -12, -8, -4, 0];
  const grid = svg(
    'g',
    { class: 'plot-grid' },
    ...ticks.flatMap((exponent) => [
      svg('path', { d: `M${short(across(exponent))} ${ROOM.top}V${SIZE.height - ROOM.bottom}` }),
      svg(
        'text',
        { x: short(across(exponent)), y: SIZE.height - ROOM.bottom + 14, 'text-anchor': 'middle' },
        powerOfTen(exponent),
      ),
    ]),
    ...heights.flatMap((exponent) => [
      svg('path', { d: `M${ROOM.left} ${short(down(exponent))}H${SIZE.width - ROOM.right}` }),
      svg('text', { x: ROOM.left - 5, y: short(down(exponent) + 3.5), 'text-anchor': 'end' }, powerOfTen(exponent)),
    ]),
    svg(
      'text',
      { class: 'axis-name', x: SIZE.width - ROOM.right, y: SIZE.height - 4, 'text-anchor': 'end' },
      JACOBIAN.plot.x,
    ),
    svg(
      'text',
      {
        class: 'axis-name',
        transform: `translate(9 ${ROOM.top + (SIZE.height - ROOM.top - ROOM.bottom) / 2}) rotate(-90)`,
        'text-anchor': 'middle',
      },
      JACOBIAN.plot.y,
    ),
  );

  /** The name of a line, beside the part of it that has its slope. @param {Curves} curves @param {DifferenceMethod} method */
  function nameOf({ steps, ...errors }, method) {
    const at = steps.findIndex((step) => step > (method === 'forward' ? 0.9e-3 : 0.9e-2));
    const error = errors[method][at];
    if (!(error > 10 ** LEAST)) return [];
    const isForward = method === 'forward';
    const [x, y] = [across(Math.log10(steps[at])), heightOf(error)];
    return [
      svg(
        'text',
        isForward
          ? { class: 'line-name', x: short(x - 6), y: short(y - 4), 'text-anchor': 'end' }
          : { class: 'line-name', x: short(SIZE.width - ROOM.right - 2), y: short(y + 22), 'text-anchor': 'end' },
        JACOBIAN.plot.slope[method],
      ),
    ];
  }

  /** Where rounding grows as the step shrinks, if it does. @param {Curves} curves */
  function nameOfRounding({ steps, forward }) {
    const at = steps.findIndex((step) => step > 0.9e-12);
    if (!(forward[at] > 1e-6)) return [];
    const [x, y] = [across(Math.log10(steps[at])), heightOf(forward[at])];
    return [svg('text', { class: 'line-name', x: short(x + 4), y: short(y - 6) }, JACOBIAN.plot.rounding)];
  }

  return {
    element: h(
      'figure',
      { class: 'error-figure' },
      /** @type {Node} */ (picture),
      sentence,
      table,
      h(
        'div',
        { class: 'row-flex' },
        plotSavers(page, PLOT.errorFile, () => standalone(picture, SIZE)),
      ),
    ),
    /**
     * @param {Curves} curves
     * @param {{ method: DifferenceMethod, step: number, own: number, error: number }} now  own: the default step
     */
    draw(curves, { method, step, own, error }) {
      const { steps } = curves;
      const x = across(Math.min(PLOTTED.most, Math.max(PLOTTED.least, Math.log10(step))));
      const bottom = SIZE.height - ROOM.bottom;
      const home = across(Math.log10(own));
      fill(
        picture,
        grid,
        svg('path', { class: 'plot-default', d: `M${short(home)} ${bottom}v-7` }),
        svg('text', { class: 'plot-default-name', x: short(home + 4), y: bottom - 4 }, JACOBIAN.plot.default),
        svg('path', { class: 'plot-now', d: `M${short(x)} ${ROOM.top}V${bottom}` }),
        ...METHODS.map((each) =>
          svg('polyline', {
            class: `plot-line ${each}${each === method ? ' is-chosen' : ''}`,
            points: steps
              .map((at, i) => `${short(across(Math.log10(at)))},${short(heightOf(curves[each][i]))}`)
              .join(' '),
          }),
        ),
        ...METHODS.flatMap((each) => nameOf(curves, each)),
        ...nameOfRounding(curves),
        svg('circle', { class: 'plot-point', cx: short(x), cy: short(heightOf(error)), r: 4.5 }),
      );
      const text = JACOBIAN.plot.inWords(
        stepText(step),
        tiny(error),
        METHODS.map((each) => bestOf(curves, each)),
      );
      picture.setAttribute('aria-label', `${JACOBIAN.plot.caption}. ${text}`);
      sentence.textContent = text;
      const decades = steps.flatMap((at, i) => (i % PLOTTED.perDecade === 0 ? [i] : []));
      fill(
        body,
        decades.map((i) =>
          h(
            'tr',
            {},
            h('th', { scope: 'row' }, powerOfTen(Math.round(Math.log10(steps[i])))),
            METHODS.map((each) => h('td', {}, tiny(curves[each][i]))),
          ),
        ),
      );
    },
  };
}

/** @param {Curves} curves @param {DifferenceMethod} method */
function bestOf(curves, method) {
  const errors = curves[method];
  const name = JACOBIAN.method[method];
  const least = Math.min(...errors);
  if (least === 0) return JACOBIAN.plot.exact(name);
  return JACOBIAN.plot.best(name, stepText(Number(curves.steps[errors.indexOf(least)].toPrecision(1))), tiny(least));
}
