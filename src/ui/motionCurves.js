/**
 * Two plots over one time: the joints, turning ones by the left scale and sliding ones by the right, and the speed of the
 * tool. Curves differ by colour, by dash and by the name at their end.
 *
 * @import { MotionLog } from '../model/motionLog.js'
 */
import uPlot from 'uplot';
import 'uplot/dist/uPlot.min.css';
import { plain } from './format.js';

const HEIGHT = { joints: 170, speed: 104 };
const NAME_ROOM = 26; // px, at the right
const NAME_STEP = 12; // px from name to name
const DASHES = [[], [], [8, 3], [7, 4], [2, 3], [9, 3, 2, 3]];

const token = (/** @type {string} */ name) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();
const font = (/** @type {number} */ weight = 400) => `${weight} 11px ${token('--font-ui')}`;

/** What draws the line of joint `i`: its token and its dashes. @param {number} i */
export const styleOf = (i) => ({ token: `--j${(i % 6) + 1}`, dash: DASHES[i % DASHES.length] });

/**
 * @param {HTMLElement} host
 * @param {{ names: readonly string[], slides: readonly boolean[], window: number, least: { turn: number, slide: number }, words: { seconds: string } }} given
 *   `least`: how much a scale shows at least of what hardly changes, in document units
 */
export function createMotionCurves(host, { names, slides, window, least: smallest, words }) {
  /** @param {object} [more] @returns {uPlot.Axis} */
  const axis = (more) => ({
    stroke: () => token('--ink-2'),
    font: font(),
    grid: { stroke: () => token('--line'), width: 1 },
    ticks: { show: false },
    values: (_, splits) => splits.map((value) => plain(Number(value.toPrecision(9)))),
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
        axis({ size: 18, values: () => [] }),
        axis({ scale: slides.every(Boolean) ? 'slide' : 'turn', size: 44 }),
        ...(hasRight ? [axis({ scale: 'slide', side: 1, size: 52, grid: { show: false } })] : []),
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
      padding: [6, NAME_ROOM, 0, 0],
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

  /** At the end of each curve its name, as near to it as its neighbours leave room. @param {uPlot} plot */
  function writeNames(plot) {
    const { ctx, bbox, data } = plot;
    const ratio = uPlot.pxRatio;
    const ends = names
      .flatMap((name, i) => {
        const column = /** @type {(number | null)[]} */ (data[i + 1]);
        const value = column.findLast((one) => one !== null && one !== undefined) ?? null;
        if (value === null || !plot.series[i + 1].show) return [];
        return [{ name, y: plot.valToPos(value, slides[i] ? 'slide' : 'turn', true) }];
      })
      .sort((one, other) => one.y - other.y);
    const step = NAME_STEP * ratio;
    ends.forEach((end, i) => (end.y = Math.max(end.y, i > 0 ? ends[i - 1].y + step : bbox.top + step / 2)));
    ends.reverse().forEach((end, i) => {
      end.y = Math.min(end.y, i > 0 ? ends[i - 1].y - step : bbox.top + bbox.height - step / 2);
    });
    ctx.save();
    ctx.font = `600 ${11 * ratio}px ${token('--font-ui')}`;
    ctx.fillStyle = token('--ink');
    ctx.textBaseline = 'middle';
    const inside = hasRight ? -20 : 5;
    for (const { name, y } of ends) ctx.fillText(name, bbox.left + bbox.width + inside * ratio, y);
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
    dispose() {
      for (const plot of both) plot.destroy();
    },
  };
}
