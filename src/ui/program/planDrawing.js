/**
 * Curves over the time of a program, as one drawing: strips with a scale of their own or all over one another, the speed of the
 * tool below, lines where moves meet, and what lies past a limit tinted.
 *
 * @import { Column } from '../../model/program/planColumns.js'
 */
import { unitText } from '../../model/program/planColumns.js';
import { styleOf } from '../parts/curveStyle.js';
import { fixed, plain } from '../parts/format.js';
import { rangeOf, ticksOf } from './planScale.js';
import { svg } from '../parts/svg.js';

/** px; left: numbers of the scales; right: names of the curves. */
export const EDGE = { left: 62, right: 40 };
const HEIGHT = { strip: 26, overlay: 132, speed: 56, axis: 20, gap: 6 };
/** Characters of an extent that have room beside its strip. */
const WIDEST = 8;

const TICK_ROOM = { time: 64, value: 34 };
const NAME_STEP = 12;

/**
 * @typedef {object} Plotted
 * @property {readonly Column[]} columns
 * @property {Column} speed
 * @property {string} title          of what is above the speed, with its unit
 * @property {string} speedTitle
 * @property {Float64Array} times
 * @property {readonly number[]} marks
 * @property {boolean} isStrips
 * @property {boolean} isOfJoints    drawn in the joints' own colours
 * @property {boolean} hasLimits     shown however far they are
 * @property {number | null} chosen  the curve whose limits are shown where all share a scale
 * @property {(unit: Column['unit']) => number} smallest
 */

/** How high each row is, in the order of the rows. @param {Pick<Plotted, 'columns' | 'isStrips'>} plotted */
export const rowHeights = ({ columns, isStrips }) => ({
  rows: isStrips ? columns.map(() => HEIGHT.strip) : [HEIGHT.overlay],
  speed: HEIGHT.speed,
  axis: HEIGHT.axis,
});

/** @param {SVGElement} picture  emptied and drawn anew @param {number} width @param {Plotted} plotted @returns {number} its height */
export function drawPlan(picture, width, plotted) {
  const { columns, speed, times, marks, isStrips } = plotted;
  const heights = rowHeights(plotted);
  const duration = times[times.length - 1];
  const inner = Math.max(1, width - EDGE.left - EDGE.right);
  const x = (/** @type {number} */ time) => EDGE.left + (duration > 0 ? (time / duration) * inner : 0);
  const whole = [...heights.rows, heights.speed].reduce((sum, each) => sum + each, 0);
  /** @type {SVGElement[]} */
  const parts = marks
    .slice(1, -1)
    .map((mark) => svg('line', { class: 'grid', x1: round(x(mark)), x2: round(x(mark)), y1: 0, y2: whole }));
  let top = 0;
  const groups = isStrips ? columns.map((column, i) => [[column, i]]) : [columns.map((column, i) => [column, i])];
  for (const [row, group] of /** @type {[Column, number][][]} */ (groups).entries()) {
    const own = group.map(([column]) => column);
    const height = heights.rows[row];
    const range = rangeOf(own, plotted.hasLimits, plotted.smallest(own[0].unit));
    const y = scaleOf(range, top, height);
    parts.push(...frameOf(top, width, height, range, y, isStrips ? own[0].values : null));
    const bounded = isStrips ? own[0] : plotted.chosen !== null ? columns[plotted.chosen] : sharedLimits(own);
    if (bounded) parts.push(...bandsOf(bounded, top, height, y, inner));
    for (const [column, i] of group) parts.push(curveOf(column, i, times, x, y, plotted));
    parts.push(...namesOf(group, y, top, height, width));
    top += height;
  }
  const range = /** @type {const} */ ([0, Math.max(...rangeOf([speed], false, plotted.smallest(speed.unit)))]);
  const y = scaleOf(range, top, heights.speed);
  parts.push(...frameOf(top, width, heights.speed, range, y, null));
  const line = pathOf(times, speed.values, x, y);
  const floor = round(y(0));
  parts.push(
    svg('path', { class: 'speed-area', d: `${line}L${round(x(duration))} ${floor}L${round(x(0))} ${floor}Z` }),
    svg('path', { class: 'curve speed-line', d: line }),
  );
  top += heights.speed;
  for (const tick of ticksOf([0, duration], inner / TICK_ROOM.time)) {
    parts.push(svg('text', { class: 'number middle', x: round(x(tick)), y: top + 14 }, `${plain(tick)} s`));
  }
  parts.push(
    ...titlesOf(
      plotted,
      heights.rows.reduce((sum, each) => sum + each, 0),
    ),
  );
  picture.replaceChildren(...parts);
  return top + heights.axis;
}

const round = (/** @type {number} */ value) => Math.round(10 * value) / 10;

/** @param {readonly [number, number]} range @param {number} top @param {number} height */
const scaleOf =
  ([least, most], top, height) =>
  (/** @type {number} */ value) =>
    top + HEIGHT.gap / 2 + ((most - value) / (most - least)) * (height - HEIGHT.gap);

/** Lines and numbers of a scale. @param {number} top @param {number} width @param {number} height @param {readonly [number, number]} range @param {(value: number) => number} y @param {Float64Array | null} extent  of a strip: the curve
 */
function frameOf(top, width, height, range, y, extent) {
  const isStrip = extent !== null;
  const line = (/** @type {number} */ at) =>
    svg('line', {
      class: 'grid',
      x1: isStrip ? 0 : EDGE.left,
      x2: isStrip ? width : width - EDGE.right,
      y1: at,
      y2: at,
    });
  const number = (/** @type {string} */ text, /** @type {number} */ at) =>
    svg('text', { class: 'number end', x: EDGE.left - 6, y: round(at + 3.5) }, text);
  if (isStrip) {
    // too low for ticks: a line at nought, and in words how far the curve goes
    return [
      line(top),
      ...(range[0] < 0 && range[1] > 0 ? [zeroLine(y(0), width)] : []),
      ...linesOf(extentOf(extent)).map((text, i, { length }) => number(text, top + ((i + 1 / 2) * height) / length)),
    ];
  }
  return [
    line(top),
    ...ticksOf(range, height / TICK_ROOM.value).flatMap((tick) => [line(round(y(tick))), number(plain(tick), y(tick))]),
  ];
}

/** What has room beside a strip: more is the largest above the least, so that no digit is lost at the edge. @param {string} extent @returns {string[]} */
export const linesOf = (extent) => (extent.length > WIDEST ? extent.split('…').reverse() : [extent]);

/** "−32…58", with the digits that tell its ends apart. @param {Float64Array} values */
export function extentOf(values) {
  const [least, most] = [Math.min(...values), Math.max(...values)];
  const digits = Math.min(3, Math.max(0, Math.ceil(1 - Math.log10(Math.max(most - least, 1e-9)))));
  const [low, high] = [least, most].map((value) => fixed(value, most - least < 1e-3 ? 1 : digits));
  return low === high ? low : `${low}…${high}`;
}

/** @param {number} at @param {number} width */
const zeroLine = (at, width) =>
  svg('line', { class: 'grid', x1: EDGE.left, x2: width - EDGE.right, y1: round(at), y2: round(at) });

/** What lies past the limits. @param {Column} column @param {number} top @param {number} height @param {(value: number) => number} y @param {number} inner */
function bandsOf({ least, most }, top, height, y, inner) {
  const bands = [
    [top, y(most)],
    [y(least), top + height],
  ];
  return bands.flatMap(([from, to], i) => {
    if (!Number.isFinite(from) || !Number.isFinite(to)) return [];
    const [upper, lower] = [Math.max(top, from), Math.min(top + height, to)];
    if (!(lower > upper)) return [];
    const edge = round(i === 0 ? lower : upper);
    return [
      svg('rect', { class: 'past-limit', x: EDGE.left, y: round(upper), width: inner, height: round(lower - upper) }),
      svg('line', { class: 'limit-line', x1: EDGE.left, x2: EDGE.left + inner, y1: edge, y2: edge }),
    ];
  });
}

/** The limits of several, if they are the same. @param {readonly Column[]} columns @returns {Column | null} */
const sharedLimits = (columns) =>
  columns.every(({ least, most }) => least === columns[0].least && most === columns[0].most) ? columns[0] : null;

/** @param {Column} column @param {number} i @param {Float64Array} times @param {(time: number) => number} x @param {(value: number) => number} y @param {Plotted} plotted */
function curveOf({ values }, i, times, x, y, { isOfJoints, chosen }) {
  const style = isOfJoints ? styleOf(i) : { token: ['--axis-x', '--axis-y', '--axis-z'][i % 3], dash: [] };
  const curve = svg('path', { class: 'curve', 'data-curve': i, d: pathOf(times, values, x, y) });
  curve.style.stroke = `var(${style.token})`;
  if (style.dash.length > 0) curve.style.strokeDasharray = style.dash.join(' ');
  if (chosen === i) curve.style.strokeWidth = '3px';
  return curve;
}

/** @param {Float64Array} times @param {Float64Array} values @param {(time: number) => number} x @param {(value: number) => number} y */
function pathOf(times, values, x, y) {
  let text = '';
  for (let k = 0; k < times.length; k++) text += `${k === 0 ? 'M' : 'L'}${round(x(times[k]))} ${round(y(values[k]))}`;
  return text;
}

/** At the end of each curve its name, as near to it as its neighbours leave room. @param {readonly [Column, number][]} group @param {(value: number) => number} y @param {number} top @param {number} height @param {number} width */
function namesOf(group, y, top, height, width) {
  const half = NAME_STEP / 2;
  const ends = group
    .map(([{ name, values }]) => ({ name, at: y(values[values.length - 1]) }))
    .sort((one, other) => one.at - other.at);
  ends.forEach((end, i) => (end.at = Math.max(end.at, i > 0 ? ends[i - 1].at + NAME_STEP : top + half)));
  ends.reverse().forEach((end, i) => {
    end.at = Math.min(end.at, i > 0 ? ends[i - 1].at - NAME_STEP : top + height - half);
  });
  return ends.map(({ name, at }) =>
    svg('text', { class: 'curve-name', x: width - EDGE.right + 6, y: round(at + 3.5) }, name),
  );
}

/** What the curves are, for whoever has the picture alone. @param {Plotted} plotted @param {number} speedTop */
function titlesOf({ title, speedTitle }, speedTop) {
  return [
    svg('text', { class: 'plot-title', x: EDGE.left + 4, y: 11 }, title),
    svg('text', { class: 'plot-title', x: EDGE.left + 4, y: speedTop + 11 }, speedTitle),
  ];
}

/** A unit as it is written in a title. @param {Column['unit']} unit */
export const unitOfColumn = (unit) => unitText(unit, (one) => (one === 'deg' ? '°' : one));
