/**
 * Two plots over one time: the joints, turning ones by the left scale and sliding ones by the right, and the speed of the
 * tool. Curves differ by colour, by dash and by the name at their end.
 *
 * @import { MotionLog } from '../../model/jog/motionLog.js'
 * @import { Marks } from './motionDrawing.js'
 */
import uPlot from 'uplot';
import 'uplot/dist/uPlot.min.css';
import { styleOf } from '../parts/curveStyle.js';
import { plain } from '../parts/format.js';
import { motionDrawing } from './motionDrawing.js';

const HEIGHT = { joints: 170, speed: 104 };
const NAME_ROOM = 26; // px, at the right
const RIGHT_AXIS = 52; // px
const NAME_STEP = 12; // px from name to name

const token = (/** @type {string} */ name) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();
const font = (/** @type {number} */ weight = 400) => `${weight} 11px ${token('--font-ui')}`;

/**
 * @param {HTMLElement} host
 * @param {{ names: readonly string[], slides: readonly boolean[], window: number, least: { turn: number, slide: number }, words: { seconds: string } }} given
 *   `least`: how much a scale shows at least of what hardly changes, in document units
 */
export function createMotionCurves(host, { names, slides, window, least: smallest, words }) {
  /** What each axis was drawn with. @type {WeakMap<uPlot, Marks[]>} */
  const marks = new WeakMap();
  /** @param {object} [more] @param {boolean} [hasTexts] @returns {uPlot.Axis} */
  const axis = (more, hasTexts = true) => ({
    stroke: () => token('--ink-2'),
    font: font(),
    grid: { stroke: () => token('--line'), width: 1 },
    ticks: { show: false },
    values(plot, splits, i) {
      const texts = hasTexts ? splits.map((value) => plain(Number(value.toPrecision(9)))) : [];
      const all = marks.get(plot) ?? [];
      all[i] = { splits: [...splits], texts };
      marks.set(plot, all);
      return texts;
    },
    ...more,
  });
  const shared = {
    cursor: { y: false, drag: { x: false, y: false }, sync: { key: 'motion' }, points: { show: false } },
    legend: { show: false },
  };
  const hasRight = slides.includes(true) && slides.includes(false);
  /** @type {uPlot.Range.Function} */
  const rangeX = (plot, least, most) => {
    const end = Math.max(window, most || 0);
    return [end - window, end];
  };
  /** @param {number} size @returns {uPlot.Range.Function} */
  const rangeY = (size) => (plot, least, most) => {
    if (least === null || !Number.isFinite(least)) return [-size / 2, size / 2];
    const room = Math.max(0.06 * (most - least), (size - (most - least)) / 2);
    return [least - room, most + room];
  };

  const joints = new uPlot(
    {
      ...shared,
      width: 100,
      height: HEIGHT.joints,
      padding: [8, hasRight ? 0 : NAME_ROOM, 0, 0],
      scales: {
        x: { time: false, range: rangeX },
        turn: { range: rangeY(smallest.turn) },
        slide: { range: rangeY(smallest.slide) },
      },
      axes: [
        axis({ size: 18 }, false),
        axis({ scale: slides.every(Boolean) ? 'slide' : 'turn', size: 44 }),
        ...(hasRight ? [axis({ scale: 'slide', side: 1, size: RIGHT_AXIS, grid: { show: false } })] : []),
      ],
      series: [
        {},
        ...names.map((label, i) => ({
          ...{ label, scale: slides[i] ? 'slide' : 'turn', width: 1.75, dash: styleOf(i).dash, spanGaps: false },
          stroke: () => token(styleOf(i).token),
          points: { show: false },
        })),
      ],
      hooks: { draw: [writeNames] },
    },
    [[], ...names.map(() => [])],
    host,
  );
  const speed = new uPlot(
    {
      ...shared,
      width: 100,
      height: HEIGHT.speed,
      padding: [6, hasRight ? RIGHT_AXIS : NAME_ROOM, 0, 0], // one time, one scale
      scales: { x: { time: false, range: rangeX }, y: { range: (plot, least, most) => [0, 1.1 * (most || 1)] } },
      axes: [
        axis({ size: 17, gap: 2, space: 40, label: words.seconds, labelSize: 14, labelGap: 0, labelFont: font() }),
        axis({ size: 44, space: 24 }),
      ],
      series: [
        {},
        {
          ...{ width: 1.75, points: { show: false } },
          stroke: () => token('--trace'),
          fill: () => `color-mix(in srgb, ${token('--trace')} 16%, transparent)`,
        },
      ],
    },
    [[], []],
    host,
  );

  /** Where the names of the curves stand: at their ends, as near as their neighbours leave room. @param {uPlot} plot */
  function namesOf(plot) {
    const { bbox, data } = plot;
    const ends = names
      .flatMap((name, i) => {
        const column = /** @type {(number | null)[]} */ (data[i + 1]);
        const value = column.findLast((one) => one !== null && one !== undefined) ?? null;
        if (value === null || !plot.series[i + 1].show) return [];
        return [{ name, y: plot.valToPos(value, slides[i] ? 'slide' : 'turn', true) }];
      })
      .sort((one, other) => one.y - other.y);
    const step = NAME_STEP * uPlot.pxRatio;
    ends.forEach((end, i) => (end.y = Math.max(end.y, i > 0 ? ends[i - 1].y + step : bbox.top + step / 2)));
    ends.reverse().forEach((end, i) => {
      end.y = Math.min(end.y, i > 0 ? ends[i - 1].y - step : bbox.top + bbox.height - step / 2);
    });
    return ends;
  }

  /** @param {uPlot} plot */
  function writeNames(plot) {
    const { ctx, bbox } = plot;
    const ratio = uPlot.pxRatio;
    ctx.save();
    ctx.font = `600 ${11 * ratio}px ${token('--font-ui')}`;
    ctx.fillStyle = token('--ink');
    ctx.textBaseline = 'middle';
    const inside = hasRight ? -20 : 5;
    for (const { name, y } of namesOf(plot)) ctx.fillText(name, bbox.left + bbox.width + inside * ratio, y);
    ctx.restore();
  }

  const both = [joints, speed];
  const fit = () => {
    const width = host.clientWidth;
    if (width > 0 && width !== joints.width)
      both.forEach((plot, i) => plot.setSize({ width, height: Object.values(HEIGHT)[i] }));
  };
  new ResizeObserver(fit).observe(host);
  fit();
  new MutationObserver(() => both.forEach((plot) => plot.redraw(false, true))).observe(document.documentElement, {
    attributeFilter: ['data-bs-theme'],
  });

  return {
    /** @param {MotionLog} log @param {(metresPerSecond: number) => number} speedOf */
    draw({ time, values, speed: fast }, speedOf) {
      joints.setData(/** @type {uPlot.AlignedData} */ ([time, ...values]));
      speed.setData(/** @type {uPlot.AlignedData} */ ([time, fast.map((one) => (one === null ? null : speedOf(one)))]));
    },
    /** @param {number} curve @param {boolean} isShown */
    show(curve, isShown) {
      if (curve < names.length) joints.setSeries(curve + 1, { show: isShown });
      else speed.setSeries(1, { show: isShown });
    },
    /** The same as an SVG. @param {{ joints: string, speed: string }} captions */
    drawing: (captions) =>
      motionDrawing(
        [
          { plot: joints, marks: marks.get(joints) ?? [], names: namesOf(joints), caption: captions.joints },
          { plot: speed, marks: marks.get(speed) ?? [], names: [], caption: captions.speed, below: words.seconds },
        ],
        token,
      ),
    dispose() {
      for (const plot of both) plot.destroy();
    },
  };
}
