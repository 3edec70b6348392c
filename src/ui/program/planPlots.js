/**
 * The open timeline: what the program does to joints and tool over its time, as curves that share the timeline's head, or as
 * a table; and its ways out as files. Nothing is drawn while it is closed.
 *
 * @import { Page } from '../page.js'
 * @import { TimelineStrip } from './timelineStrip.js'
 * @import { Column, Group } from '../../model/program/planColumns.js'
 * @import { Planned } from '../../model/program/planned.js'
 * @import { PlanSeries } from '../../model/program/planSeries.js'
 */
import '../css/plots.css';
import { GROUPS, columnsOf, isOfJoints } from '../../model/program/planColumns.js';
import { playbackNow } from '../../model/program/planning.js';
import { valueAt } from '../../model/program/planSeries.js';
import { marksOf } from '../../model/program/player.js';
import { together } from '../../model/views.js';
import { fill, h } from '../parts/dom.js';
import { fixed } from '../parts/format.js';
import { EDGE, drawPlan, unitOfColumn } from './planDrawing.js';
import { createPlanExport } from './planExport.js';
import { createPlanGutter } from './planGutter.js';
import { createPlanTable } from './planTable.js';
import { segments } from '../parts/segments.js';
import { svg } from '../parts/svg.js';
import { PLOTS } from '../words/plots.js';

/** What a scale shows at least: in its unit, per second, … */
const LEAST = { deg: 10, rad: 0.2, mm: 10, cm: 1, m: 0.01 };

/** @param {Column['unit']} unit */
const smallest = ({ unit }) => (unit === '' ? 1e-6 : LEAST[unit]);

/**
 * @param {Page} page
 * @param {HTMLElement} host
 * @param {{ strip: TimelineStrip, stripRoom: HTMLElement, scrub: (time: number) => void }} given  `stripRoom`: where the strip
 *   is while this is closed; then the tools are there
 */
export function createPlanPlots(page, host, { strip, stripRoom }) {
  const { store, addView } = page;
  let isOpen = false;
  let isTable = false;
  let isStrips = true;
  /** @type {Group} */
  let group = 'values';
  /** @type {number | null} */
  let chosen = null;
  /** @type {{ planned: Planned, series: PlanSeries, columns: Column[], speed: Column } | null} */
  let shown = null;

  const quantity = h(
    'select',
    { class: 'form-select form-select-sm plot-quantity', 'aria-label': PLOTS.quantity },
    GROUPS.filter((one) => one !== 'speed').map((one) => h('option', { value: one }, PLOTS.groups[one])),
  );
  const layout = segments(PLOTS.layout.label, /** @type {const} */ (['strips', 'overlay']), PLOTS.layout, (value) => {
    isStrips = value === 'strips';
    redraw();
  });
  const tableButton = h(
    'button',
    { type: 'button', class: 'btn', 'aria-pressed': 'false', title: PLOTS.tableTitle },
    PLOTS.table,
  );
  const picture = svg('svg', { class: 'plan-plot', role: 'img' });
  const size = { width: 0, height: 0 };
  const tools = h(
    'div',
    { class: 'plot-tools', role: 'group', 'aria-label': PLOTS.title },
    quantity,
    layout.element,
    tableButton,
    createPlanExport(page, picture, size),
  );
  const gutter = createPlanGutter((joint) => {
    chosen = chosen === joint ? null : joint;
    redraw();
  });
  const head = h('div', { class: 'plan-head' });
  const lane = h('div', { class: 'plan-lane' }, picture, head);
  const stripLane = h('div', { class: 'strip-lane' });
  const plots = h('div', { class: 'plan-grid' }, gutter.element, lane);
  const table = createPlanTable();
  const element = h(
    'div',
    { class: 'lanes', hidden: true },
    h('div', { class: 'plan-grid strip-row' }, h('div', { class: 'gut b' }, PLOTS.moves), stripLane),
    plots,
    table.element,
  );
  for (const one of [stripLane, head]) one.style.marginInline = `${EDGE.left}px ${EDGE.right}px`;
  host.append(element);
  strip.scrubBy(lane, () => strip.element);

  quantity.addEventListener('change', () => {
    const value = GROUPS.find((one) => one === quantity.value);
    if (value) group = value;
    chosen = null;
    redraw();
  });
  tableButton.addEventListener('click', () => {
    isTable = !isTable;
    redraw();
  });

  function redraw() {
    if (!isOpen) return;
    const { planning } = store.state.session;
    const planned = planning?.planned ?? null;
    const series = planning?.series ?? null;
    const { robot } = store.state.doc;
    tableButton.setAttribute('aria-pressed', String(isTable));
    plots.hidden = isTable;
    table.element.hidden = !isTable;
    if (!planned || !series) return;
    const columns = columnsOf(robot, series, group, planned.limits);
    const [speed] = columnsOf(robot, series, 'speed', null);
    shown = { planned, series, columns, speed };
    const isMixed = columns.some(({ unit }) => unit.unit !== columns[0].unit.unit);
    const canChoose = columns.length > 1 && !isMixed;
    layout.element.hidden = !canChoose || isTable;
    const asStrips = isMixed || (isStrips && columns.length > 1);
    layout.draw(asStrips ? 'strips' : 'overlay');
    const what = PLOTS.groups[group];
    const marks = marksOf(planned.plan);
    if (isTable) {
      table.draw({ series, columns, speed, marks, steps: planned.steps, what });
      return;
    }
    const unit = isMixed ? '' : unitOfColumn(columns[0].unit);
    const note = group === 'place' || group === 'orientation' ? PLOTS.notes[group] : '';
    const title = [what, note, unit].filter(Boolean).join(' · ');
    gutter.build({
      ...{ columns, speed, isStrips: asStrips, chosen, isOfJoints: isOfJoints(group), title: what },
      unit: [unit, note].filter(Boolean).join(' · '),
    });
    size.width = Math.max(200, lane.clientWidth);
    size.height = drawPlan(picture, size.width, {
      ...{ columns, speed, marks, times: series.times, isStrips: asStrips, chosen: asStrips ? null : chosen, smallest },
      ...{ isOfJoints: isOfJoints(group), hasLimits: isOfJoints(group) && group !== 'values' },
      ...{ title, speedTitle: `${PLOTS.groups.speed} · ${unitOfColumn(speed.unit)}` },
    });
    for (const [name, value] of Object.entries({ ...size, viewBox: `0 0 ${size.width} ${size.height}` })) {
      picture.setAttribute(name, String(value));
    }
    picture.setAttribute('aria-label', PLOTS.picture(title, fixed(planned.plan.duration, 2), columns.length));
    drawTime();
  }

  function drawTime() {
    const playback = playbackNow(store.state);
    if (!isOpen || isTable || !shown || !playback) return;
    const { planned, series, columns, speed } = shown;
    const { duration } = planned.plan;
    const time = Math.min(playback.time, duration);
    head.style.setProperty('--share', String(duration > 0 ? time / duration : 0));
    gutter.draw([...columns, speed].map(({ values }) => valueAt(series.times, values, time)));
  }

  addView(
    together((state) => [state.session.planning?.series, state.doc.robot.units]),
    redraw,
  );
  addView((state) => playbackNow(state)?.time, drawTime);
  new ResizeObserver(() => {
    if (isOpen && lane.clientWidth !== size.width) redraw();
  }).observe(lane);

  return {
    /** @param {boolean} wanted */
    setOpen(wanted) {
      isOpen = wanted;
      element.hidden = !isOpen;
      fill(stripRoom, isOpen ? tools : strip.element);
      if (isOpen) stripLane.append(strip.element);
      redraw();
    },
  };
}
