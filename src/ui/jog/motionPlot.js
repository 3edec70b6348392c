/**
 * The last seconds of motion as curves, and in a table that is their legend: each row switches its curve and says what it is
 * now, its least and its greatest. Nothing is recorded while it is closed or paused, and nothing is drawn while nothing moves.
 *
 * @import { Page } from '../page.js'
 * @import { JointNumbers } from '../../model/numbers/jointNumbers.js'
 * @import { Recording } from '../../model/jog/motionLog.js'
 */
import '../css/motion.css';
import { isSliding } from '../../model/document.js';
import { createMotionLog, extremes, motionCsv } from '../../model/jog/motionLog.js';
import { fromKernel } from '../../model/units.js';
import { together } from '../../model/views.js';
import { copyText } from '../parts/clipboard.js';
import { fill, h } from '../parts/dom.js';
import { jointNumber, unitOf, unitSign, withUnit } from '../parts/format.js';
import { jointNumbers } from './jointNumbers.js';
import { styleOf } from '../parts/curveStyle.js';
import { createMotionCurves } from './motionCurves.js';
import { TEXT } from '../strings.js';
import { svg } from '../parts/svg.js';
import { plotSavers } from '../files/savePlot.js';
import { MOTION } from '../words/motion.js';
import { PLOT } from '../words/plot.js';

/** Seconds of motion that are kept and drawn. */
const WINDOW = 20;

/** What a scale shows at least, of values that hardly change. */
const LEAST = { radians: 0.35, metres: 0.02 };

/** @param {Page} page @param {HTMLElement} host */
export function createMotionPlot(page, host) {
  const { store, addView, clock, derived, announce, messages } = page;
  const button = (/** @type {string} */ text) => h('button', { type: 'button', class: 'btn btn-outline' }, text);
  const [pause, clear, copy] = [MOTION.pause, MOTION.clear, MOTION.copy].map(button);
  pause.setAttribute('aria-pressed', 'false');
  pause.title = MOTION.pauseTitle;
  const empty = h('p', { class: 'soft sm' }, MOTION.empty);
  const stage = h('div', { class: 'motion-stage', role: 'img', 'aria-label': MOTION.picture(String(WINDOW)) });
  const body = h('tbody', {});
  const head = Object.values(MOTION.columns).map((name) => h('th', { scope: 'col' }, name));
  const table = h(
    'table',
    { class: 'motion-table' },
    h('caption', { class: 'visually-hidden' }, MOTION.table),
    h('thead', {}, h('tr', {}, head)),
    body,
  );
  const full = h('div', {}, stage, table);
  const savers = plotSavers(page, PLOT.motionFile, () => {
    const { joints, speedUnit } = curvesOf();
    const units = [...new Set(joints.map(({ unit }) => unitSign(unit)))].join(', ');
    const captions = { joints: MOTION.axis(units), speed: MOTION.csvColumn(MOTION.speedName, speedUnit) };
    if (!curves) throw new Error('Nothing is drawn yet.'); // the buttons are off until then
    return curves.drawing(captions);
  });
  fill(host, empty, full, h('div', { class: 'motion-buttons' }, pause, clear, copy, savers));

  let isOpen = false;
  let isPaused = false;
  let isAsked = false;
  /** @type {Recording | null} */
  let recording = null;
  /** @type {ReturnType<typeof createMotionCurves> | null} */
  let curves = null;
  /** What the curves are of. @type {{ joints: JointNumbers, shape: string } | null} */
  let then = null;
  /** @type {((log: Recording['log']) => void) | null} */
  let write = null;

  const place = () => [...derived.tcp(store.state.doc).subarray(12, 15)];
  /** @type {{ values: readonly number[], place: readonly number[] } | null} as it was seen last */
  let seen = null;
  const now = () => {
    const { doc } = store.state;
    return { values: jointNumbers(store.state).values(doc), place: place() };
  };
  const speedOf = (/** @type {number} */ metres) => fromKernel('length', metres, store.state.doc.robot.units);

  /** The curves that there are: one for each joint and that of the tool. */
  function curvesOf() {
    const { robot } = store.state.doc;
    const joints = robot.joints.map((joint, i) => ({ name: `J${i + 1}`, unit: unitOf(joint, robot.units) }));
    return { joints, speedUnit: MOTION.perSecond(unitSign(robot.units.length)) };
  }

  /** Everything anew: another arm, other units or numbers, or what there was is to go. */
  function begin() {
    const { doc } = store.state;
    const { joints, speedUnit } = curvesOf();
    recording = createMotionLog(joints.length, WINDOW);
    curves?.dispose();
    curves = null;
    seen = now();
    const cells = [...joints.map(({ name }) => name), MOTION.speed].map((name, i) => {
      const isSpeed = i === joints.length;
      const { token, dash } = isSpeed ? { token: '--trace', dash: [] } : styleOf(i);
      const sample = svg('svg', { class: 'motion-sample', viewBox: '0 0 22 4', 'aria-hidden': 'true' });
      sample.append(
        svg('path', { d: 'M0 2h22', stroke: `var(${token})`, 'stroke-width': 2.5, 'stroke-dasharray': dash.join(' ') }),
      );
      const toggle = h(
        'button',
        { type: 'button', class: 'motion-curve', 'aria-pressed': 'true', title: MOTION.curve(name) },
        /** @type {Node} */ (sample),
        name,
      );
      toggle.addEventListener('click', () => {
        const isShown = toggle.getAttribute('aria-pressed') !== 'true';
        toggle.setAttribute('aria-pressed', String(isShown));
        curves?.show(i, isShown);
      });
      const numbers = [0, 1, 2].map(() => h('td', {}));
      return { toggle, numbers, row: h('tr', {}, h('th', { scope: 'row' }, toggle), numbers) };
    });
    fill(
      body,
      cells.map(({ row }) => row),
    );
    write = ({ values, speed }) => {
      const columns = [...values, speed.map((one) => (one === null ? null : speedOf(one)))];
      columns.forEach((column, i) => {
        const found = extremes(column);
        const unit = i < joints.length ? joints[i].unit : doc.robot.units.length;
        const text = (/** @type {number | null} */ value) =>
          value === null ? '–' : i < joints.length ? withUnit(jointNumber(value, unit), unit) : speedText(value);
        const three = found ? [found.now, found.least, found.most] : [null, null, null];
        cells[i].numbers.forEach((cell, k) => (cell.textContent = text(three[k])));
      });
    };
    const speedText = (/** @type {number} */ value) => `${jointNumber(value, doc.robot.units.length)} ${speedUnit}`;
    showEmpty();
  }

  function showEmpty() {
    const isEmpty = !recording || recording.log.time.length === 0;
    empty.hidden = !isEmpty;
    full.hidden = isEmpty;
    for (const each of [clear, copy, ...savers]) each.disabled = isEmpty;
  }

  function draw() {
    if (!recording) return;
    const { log } = recording;
    showEmpty();
    if (log.time.length === 0) return;
    if (!curves) {
      const { robot } = store.state.doc;
      const slides = robot.joints.map(isSliding);
      const names = curvesOf().joints.map(({ name }) => name);
      curves = createMotionCurves(stage, {
        ...{ names, slides, window: WINDOW, words: MOTION },
        least: { turn: fromKernel('angle', LEAST.radians, robot.units), slide: speedOf(LEAST.metres) },
      });
      [...body.querySelectorAll('button')].forEach((toggle, i) => {
        if (toggle.getAttribute('aria-pressed') === 'false') curves?.show(i, false);
      });
    }
    curves.draw(log, speedOf);
    write?.(log);
  }

  /** In each frame from a change until the arm has come to rest. */
  function look() {
    isAsked = false;
    if (!isOpen || isPaused || isOther() || !recording || !seen) return;
    const next = now();
    const isMoved = next.values.some((value, i) => value !== seen?.values[i]);
    let isAtRest = false;
    if (isMoved) recording.move(clock.now(), seen.values, next.values, seen.place, next.place);
    else isAtRest = recording.still(clock.now());
    if (isMoved || isAtRest) draw();
    seen = next;
    if (!isAtRest) ask();
  }
  function ask() {
    if (isAsked) return;
    isAsked = true;
    clock.onFrame(look);
  }

  /** What happens meanwhile is not recorded. @param {boolean} isOn */
  function setRecording(isOn) {
    recording?.stop();
    if (isOn) seen = now();
  }

  pause.addEventListener('click', () => {
    isPaused = !isPaused;
    pause.setAttribute('aria-pressed', String(isPaused));
    setRecording(!isPaused);
    announce(isPaused ? MOTION.paused : MOTION.goesOn);
  });
  clear.addEventListener('click', () => {
    begin();
    announce(MOTION.cleared);
    pause.focus();
  });
  copy.addEventListener('click', async () => {
    if (!recording) return;
    const { joints, speedUnit } = curvesOf();
    const names = [
      MOTION.csvTime,
      ...joints.map(({ name, unit }) => MOTION.csvColumn(name, unit)),
      MOTION.csvColumn(MOTION.speedName, speedUnit),
    ];
    if (await copyText(motionCsv(recording.log, names, speedOf))) announce(MOTION.copied);
    else messages.warn(TEXT.pose.copyFailed);
  });

  /** Whether the curves had to be begun anew, being of another arm or in other numbers. */
  function isOther() {
    const { robot } = store.state.doc;
    const joints = jointNumbers(store.state);
    const parts = robot.joints.map(({ type, controller }) => [type, controller]);
    const shape = JSON.stringify([robot.name, robot.units, parts]);
    if (then?.shape === shape && then.joints === joints) return false;
    then = { joints, shape };
    begin();
    return true;
  }

  addView(
    together(({ doc, session }) => [doc.robot, doc.posture, session.numbers.isPendant]),
    () => {
      if (isOpen && !isOther()) ask();
    },
  );

  return {
    /** @param {boolean} isOpenNow */
    setOpen(isOpenNow) {
      isOpen = isOpenNow;
      if (isOpen) isOther();
      setRecording(isOpen && !isPaused);
    },
  };
}
