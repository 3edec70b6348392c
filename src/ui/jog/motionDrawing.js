/**
 * What plots on canvases show, as one SVG that stands by itself: the same scales, curves and names, with captions that say the
 * units, one plot below the other.
 *
 * @typedef {{ splits: readonly number[], texts: readonly string[] }} Marks  of an axis, as it was drawn last
 *
 * @typedef {object} DrawnPlot
 * @property {uPlot} plot
 * @property {readonly Marks[]} marks  of each of its axes
 * @property {readonly { name: string, y: number }[]} names  at the ends of curves; y in pixels of the canvas
 * @property {string} caption
 * @property {string} [below]   what its time is called
 */
import uPlot from 'uplot';
import { svg } from '../parts/svg.js';

const CAPTION = 18;
const BASELINE = 4; // from the middle of a text of 11 px to where it stands
const GAP = 5;
const TOP = 0;
const BOTTOM = 2;
const RIGHT = 1;

const short = (/** @type {number} */ value) => String(Number(value.toFixed(1)));

/**
 * @param {readonly DrawnPlot[]} drawn
 * @param {(name: string) => string} token  what a colour or a font is called in the page's tokens, now
 */
export function motionDrawing(drawn, token) {
  const width = Math.max(...drawn.map(({ plot }) => plot.width));
  const heights = drawn.map(({ plot }) => plot.height + CAPTION);
  const height = heights.reduce((sum, one) => sum + one, 0);
  return svg(
    'svg',
    { width, height, viewBox: `0 0 ${width} ${height}`, 'font-family': token('--font-ui'), 'font-size': 11 },
    svg('rect', { width, height, fill: token('--panel') }),
    ...drawn.map((each, i) => {
      const top = heights.slice(0, i).reduce((sum, one) => sum + one, 0);
      return svg('g', { transform: `translate(0 ${top})`, fill: token('--ink-2') }, ...partsOf(each, token));
    }),
  );
}

/** @param {DrawnPlot} drawn @param {(name: string) => string} token */
function partsOf({ plot, marks, names, caption, below }, token) {
  const ratio = uPlot.pxRatio;
  const box = {
    left: plot.bbox.left / ratio,
    top: plot.bbox.top / ratio + CAPTION,
    right: (plot.bbox.left + plot.bbox.width) / ratio,
    bottom: (plot.bbox.top + plot.bbox.height) / ratio + CAPTION,
  };
  const x = (/** @type {number} */ value) => plot.valToPos(value, 'x', true) / ratio;
  const y = (/** @type {number} */ value, /** @type {string} */ scale) =>
    plot.valToPos(value, scale, true) / ratio + CAPTION;

  /** @param {uPlot.Axis} axis @param {number} i */
  function axisOf({ scale = 'x', side = TOP, grid }, i) {
    const line = (/** @type {string} */ d) =>
      grid?.show === false ? [] : [svg('path', { d, stroke: token('--line'), fill: 'none' })];
    const { splits, texts } = marks[i] ?? { splits: [], texts: [] };
    return splits.flatMap((value, k) => {
      const text = texts[k] ?? '';
      if (side === BOTTOM) {
        const at = short(x(value));
        const label = { x: at, y: short(box.bottom + 2 * GAP + BASELINE), 'text-anchor': 'middle' };
        return [...line(`M${at} ${short(box.top)}V${short(box.bottom)}`), ...labelled(label, text)];
      }
      const at = y(value, scale);
      const isRight = side === RIGHT;
      const label = {
        ...{ x: short(isRight ? box.right + GAP : box.left - GAP), y: short(at + BASELINE) },
        'text-anchor': isRight ? 'start' : 'end',
      };
      return [...line(`M${short(box.left)} ${short(at)}H${short(box.right)}`), ...labelled(label, text)];
    });
  }

  /** @param {Record<string, string>} place @param {string} text */
  const labelled = (place, text) => (text === '' ? [] : [svg('text', place, text)]);

  /** @param {uPlot.Series} series @param {number} i */
  function curveOf({ show, scale = 'y', stroke, fill, width, dash, label }, i) {
    if (!show || i === 0) return [];
    const [times, values] = [plot.data[0], plot.data[i]];
    const colour = (/** @type {uPlot.Series.Stroke | undefined} */ of) =>
      String(typeof of === 'function' ? of(plot, i) : of);
    const filled = typeof fill === 'function' ? fill(plot, i) : fill;
    /** @type {string[][]} what has no gap in it */
    const runs = [[]];
    for (const [k, time] of times.entries()) {
      const value = values[k];
      if (value === null || value === undefined) runs.push([]);
      else runs[runs.length - 1].push(`${short(x(time))} ${short(y(value, scale))}`);
    }
    return runs
      .filter(({ length }) => length > 0)
      .flatMap((points) => {
        const d = `M${points.join('L')}`;
        const [from, to] = [points[0], points[points.length - 1]].map((point) => point.split(' ')[0]);
        const ground = `${d}L${to} ${short(box.bottom)}L${from} ${short(box.bottom)}Z`;
        const lines = {
          ...{ fill: 'none', stroke: colour(stroke), 'stroke-width': width ?? 1, 'stroke-linejoin': 'round' },
          ...{ 'stroke-linecap': 'round', 'stroke-dasharray': dash?.length ? dash.join(' ') : null },
        };
        return [
          ...(filled ? [svg('path', { d: ground, fill: colour(stroke), 'fill-opacity': 0.16 })] : []),
          svg('path', { d, 'data-curve': typeof label === 'string' ? label : null, ...lines }),
        ];
      });
  }

  const hasRight = plot.axes.some(({ side }) => side === RIGHT);
  return [
    svg('text', { x: short(box.left), y: 13, fill: token('--ink'), 'font-weight': 600 }, caption),
    ...plot.axes.flatMap(axisOf),
    ...plot.series.flatMap(curveOf),
    ...names.map(({ name, y: at }) => {
      const place = { x: short(box.right + (hasRight ? -20 : GAP)), y: short(at / ratio + CAPTION + BASELINE) };
      return svg('text', { ...place, fill: token('--ink'), 'font-weight': 600 }, name);
    }),
    ...(below
      ? [svg('text', { x: short(box.right), y: short(plot.height + CAPTION - 3), 'text-anchor': 'end' }, below)]
      : []),
  ];
}
