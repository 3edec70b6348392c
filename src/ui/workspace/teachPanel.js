/**
 * The teaching view: what one joint at a time does to the tool point, and what the boundary of the section is made of: its critical
 * postures, which the arm can be sent to.
 *
 * @import { Page } from '../page.js'
 * @import { CriticalOne } from '../../model/workspace/criticalOnes.js'
 * @import { ReachShown } from '../../model/workspace/asked.js'
 */
import '../css/workspacePoints.css';
import { compilePosture, postureFromKernel } from '../../model/compile.js';
import { isSliding } from '../../model/document.js';
import { together } from '../../model/views.js';
import { criticalOnes } from '../../model/workspace/criticalOnes.js';
import { angleInSection, seenInSection, sweptPlaces, toolPlace } from '../../model/workspace/sweep.js';
import { newGesture } from '../page.js';
import { fill, h } from '../parts/dom.js';
import { jointNumber, jointStep, unitOf, unitSign, withUnit } from '../parts/format.js';
import { travelTo } from '../travel.js';
import { TEACH } from '../words/workspacePoints.js';
import { isFoldOpen } from './look.js';
import { sectionNow, showProbe, whenPressed } from './probes.js';
import { createReachFigure } from './reachFigure.js';

/** A joint without limits is swept a full turn, half of it each way. */
const HALF_TURN = Math.PI;

/** So many traces are kept; the oldest goes first. */
const MOST_TRACES = 40;

/** @param {Page} page @param {HTMLElement} body @param {(summary: string) => void} say @param {(draw: () => void) => void} afterPress  when nothing is pressed */
export function createTeachPanel(page, body, say, afterPress) {
  const { store, addView, derived, announce } = page;
  const robot = () => store.state.doc.robot;
  const chainNow = () => derived.chain(store.state.doc);
  const postureNow = () => Array.from(compilePosture(robot(), store.state.doc.posture));
  /** @type {ReachShown['lines']} */
  let traces = [];
  /** @type {readonly CriticalOne[]} */
  let ones = [];
  const rows = h('div', { class: 'teach-rows', role: 'group', 'aria-label': TEACH.joints });
  const clear = h('button', { type: 'button', class: 'btn btn-small btn-outline' }, TEACH.clear);
  const figure = createReachFigure(TEACH.drawing, null, announce);
  const none = h('p', { class: 'sm soft' }, TEACH.none);
  const list = h('ol', { class: 'posture-buttons', 'aria-label': TEACH.boundary });
  clear.addEventListener('click', () => {
    traces = [];
    show();
  });
  body.append(
    h(
      'div',
      { class: 'reach-body' },
      h('p', { class: 'sm soft' }, TEACH.about),
      rows,
      h('div', { class: 'row-flex' }, h('span', { class: 'grow' }), clear),
      figure.element,
      h('div', {}, h('h3', { class: 'b sm' }, TEACH.boundary), h('p', { class: 'sm soft' }, TEACH.boundaryAbout), none, list),
    ),
  ); // prettier-ignore

  const jointName = (/** @type {number} */ joint) => `J${joint + 1}`;

  /** @param {CriticalOne} one */
  function nameOf({ kind, held, free, shape }) {
    const at = TEACH.heldAll(held.map(({ joint, bound }) => TEACH.held(jointName(joint), TEACH.at[bound])));
    if (kind === 'limit') return at;
    const turning = free.map(jointName);
    const how = shape ? TEACH[shape](turning) : TEACH.lined(turning);
    return at ? TEACH.with(at, how) : how;
  }

  /** Where a joint may be, rad or m. @param {number} joint */
  function rangeOf(joint) {
    const { lower, upper, type } = chainNow().joints[joint];
    const here = postureNow()[joint];
    const isBound = Number.isFinite(lower) && Number.isFinite(upper);
    if (isBound) return [Number(lower), Number(upper)];
    return type === 'prismatic' ? [here, here] : [here - HALF_TURN, here + HALF_TURN];
  }

  /** @param {number} joint @param {readonly number[]} q @param {number} from @param {number} to */
  function leaveTrace(joint, q, from, to) {
    if (from === to) return;
    const points = sweptPlaces(chainNow(), q, joint, from, to);
    traces = [...traces, { points, kind: /** @type {const} */ ('trace') }].slice(-MOST_TRACES);
    show();
  }

  /** What goes on with a slider is one trace, drawn anew as far as it has been. @type {{ joint: number, q: readonly number[], low: number, high: number, gesture: string, before: ReachShown['lines'] } | null} */
  let held = null;

  /** @param {number} joint */
  function row(joint) {
    const unit = unitOf(robot().joints[joint], robot().units);
    const name = jointName(joint);
    const slider = h('input', {
      type: 'range',
      step: 'any',
      'aria-label': TEACH.joint(name, unitSign(unit)),
      'data-index': joint,
    });
    const value = h('output', {});
    const sweep = h(
      'button',
      { type: 'button', class: 'btn btn-small btn-outline', 'aria-label': TEACH.sweepLabel(name) },
      TEACH.sweep,
    );
    slider.addEventListener('input', () => {
      const q = postureNow();
      if (held?.joint !== joint) {
        held = { joint, q, low: q[joint], high: q[joint], gesture: newGesture(), before: traces };
      }
      const posture = store.state.doc.posture.with(joint, Number(slider.value));
      store.dispatch({ type: 'set-posture', posture, gesture: held.gesture });
      const now = postureNow()[joint];
      held.low = Math.min(held.low, now);
      held.high = Math.max(held.high, now);
      traces = held.before;
      leaveTrace(joint, held.q, held.low, held.high);
    });
    slider.addEventListener('change', () => {
      held = null;
      store.dispatch({ type: 'end-gesture' });
    });
    slider.addEventListener('keydown', (event) => {
      const way = { ArrowLeft: -1, ArrowDown: -1, ArrowRight: 1, ArrowUp: 1 }[event.key];
      if (!way) return;
      event.preventDefault();
      slider.value = String(Number(slider.value) + way * (event.shiftKey ? 10 : 1) * (unit === 'deg' ? 1 : 10 * jointStep(unit)));
      slider.dispatchEvent(new Event('input'));
    }); // prettier-ignore
    slider.addEventListener('blur', () => {
      if (held) store.dispatch({ type: 'end-gesture' });
      held = null;
    });
    sweep.addEventListener('click', () => {
      const [from, to] = rangeOf(joint);
      leaveTrace(joint, postureNow(), from, to);
      announce(TEACH.swept(name));
    });
    return {
      element: h('div', { class: 'teach-row' }, h('span', { class: 'b sm' }, name), slider, value, sweep),
      draw() {
        const [low, high] = postureFromKernelRange(joint);
        slider.min = String(low);
        slider.max = String(high);
        const now = store.state.doc.posture[joint];
        slider.value = String(now);
        value.textContent = withUnit(jointNumber(now, unit), unit);
        slider.setAttribute('aria-valuetext', value.textContent);
      },
    };
  }

  /** In the document's units. @param {number} joint */
  function postureFromKernelRange(joint) {
    const { lower, upper } = robot().joints[joint];
    if (typeof lower === 'number' && typeof upper === 'number' && Number.isFinite(upper - lower)) return [lower, upper];
    const q = postureNow();
    const turned = [-HALF_TURN, HALF_TURN].map((value) => postureFromKernel(robot(), q.with(joint, value))[joint]);
    const now = store.state.doc.posture[joint];
    return isSliding(robot().joints[joint]) ? [now, now] : [Math.min(turned[0], now), Math.max(turned[1], now)];
  }

  function show() {
    const points = ones.map(({ q }, i) => ({ at: toolPlace(chainNow(), q), text: String(i + 1), isReached: true }));
    showProbe(page, 'teach', points.length > 0 || traces.length > 0 ? { points, lines: traces } : null);
    clear.disabled = traces.length === 0;
    drawFigure();
  }

  function drawFigure() {
    const section = sectionNow(store);
    figure.element.hidden = section === null;
    if (!section) return;
    figure.draw(
      {
        section,
        units: robot().units,
        lines: traces.map(({ points, kind }) => {
          const seen = [];
          for (let k = 0; k < points.length; k += 3) seen.push(...seenInSection(section, points, k));
          return { points: seen, kind };
        }),
        dots: ones.map((one, i) => ({ ...one, text: String(i + 1), isReached: true, press: () => go(one) })),
        tool: seenInSection(section, toolPlace(chainNow(), postureNow())),
      },
      `${TEACH.drawing}. ${TEACH.drawingWords(ones.length)}`,
    );
  }

  /** @param {CriticalOne} one */
  function go(one) {
    const name = nameOf(one);
    travelTo(page, postureFromKernel(robot(), one.q), () => announce(TEACH.went(name)));
  }

  function drawOnes() {
    const section = sectionNow(store);
    const isOpen = isFoldOpen(store.state.session, 'teach');
    ones = section && isOpen ? withOwnFirst(criticalOnes(chainNow(), section)) : [];
    drawList();
    page.clock.onFrame(show); // not while views are drawn
  }

  function drawList() {
    none.hidden = ones.length > 0;
    fill(
      list,
      ones.map((one, i) => {
        const name = nameOf(one);
        const button = h(
          'button',
          { type: 'button', class: 'btn', 'aria-label': TEACH.go(i + 1, name) },
          h('span', { class: 'b' }, String(i + 1)),
          h('span', { class: 'values' }, name),
        );
        button.addEventListener('click', () => go(one));
        return h('li', {}, button);
      }),
    );
    say(ones.length > 0 ? TEACH.summary(ones.length) : '');
  }

  /** Those of this robot. @type {ReturnType<typeof row>[]} */
  let drawnRows = [];
  function drawRows() {
    drawnRows = robot().joints.map((_, joint) => row(joint));
    fill(
      rows,
      drawnRows.map(({ element }) => element),
    );
    for (const each of drawnRows) each.draw();
  }
  addView(
    ({ doc }) => doc.robot,
    () => {
      held = null;
      traces = [];
      drawnRows = [];
      afterPress(drawRows);
    },
  );
  addView(
    ({ doc }) => doc.posture,
    () => {
      for (const each of drawnRows) each.draw();
    },
  );
  addView(
    together(({ session }) => [session.maps.section, isFoldOpen(session, 'teach')]),
    () => afterPress(drawOnes),
  );
  whenPressed(page, 'teach', (index) => {
    if (index < ones.length) go(ones[index]);
  });
  addView(
    together(({ doc, session }) => [doc.posture, isFoldOpen(session, 'teach')]),
    ([, isOpen]) => {
      if (isOpen) afterPress(drawFigure);
    },
  );

  /** Of a half-plane at any angle the first joint that turns brings the arm into the one that is drawn, or stays as it is. @param {readonly CriticalOne[]} found */
  function withOwnFirst(found) {
    const section = sectionNow(store);
    if (section?.kind !== 'meridian' || !section.isAnyAngle) return found;
    const first = robot().joints.findIndex((joint) => !isSliding(joint));
    const { lower, upper } = chainNow().joints[first];
    const now = postureNow()[first];
    return found.map((one) => {
      const q = one.q.with(first, now);
      const turned = now - angleInSection(section, toolPlace(chainNow(), q));
      const value = [0, 2 * HALF_TURN, -2 * HALF_TURN]
        .map((round) => turned + round)
        .find((each) => each >= lower && each <= upper);
      return { ...one, q: q.with(first, value ?? now) };
    });
  }
}
