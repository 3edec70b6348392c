/**
 * The Jacobian of the arm where it stands: by geometry and by difference, with their difference and what the step does to it;
 * how far the next singular posture is; singular values; static torques. Fetched when it is first opened.
 *
 * @import { Page } from '../page.js'
 * @import { JacobianView } from '../../model/numbers/jacobianView.js'
 */
import '../css/jacobian.css';
import { isSliding } from '../../model/document.js';
import { defaultStep, jacobiansAt, rowsInDocument, stepOf } from '../../model/numbers/jacobianNumbers.js';
import { errorCurves } from '../../model/numbers/quotients.js';
import { together } from '../../model/views.js';
import { h } from '../parts/dom.js';
import { createErrorPlot } from './errorPlot.js';
import { fixed, poseNumber, unitSign } from '../parts/format.js';
import { createJacobianCopy } from './jacobianCopy.js';
import { createJacobianMatrix } from './jacobianMatrix.js';
import { createMotionMeasures } from './motionMeasures.js';
import { stepText, tiny } from '../parts/scientific.js';
import { segments } from '../parts/segments.js';
import { createSingularityGauge } from './singularityGauge.js';
import { createStaticsForm } from './staticsForm.js';
import { createStepControl } from './stepControl.js';
import { JACOBIAN } from '../words/jacobian.js';

/** So long the arm has rested when the plot is computed anew: some thousand times forward kinematics. */
const REST_SECONDS = 0.12;

const PURE_DECIMALS = 4;

/** Nearer to a whole number than this is rounding, in a matrix whose largest entry is 1. */
const ROUNDING = 1e-14;

/**
 * @param {Page} page
 * @param {HTMLElement} host
 */
export function createJacobianPanel(page, host) {
  const { store, addView, derived, clock } = page;
  const frame = segments(JACOBIAN.frame.label, ['world', 'base', 'user', 'tool'], JACOBIAN.frame.name, (value) =>
    store.dispatch({ type: 'show', change: { jacobian: { ...store.state.session.jacobian, frame: value } } }),
  );
  const about = h('p', { class: 'sm soft' });
  const units = h('p', { class: 'sm soft' });
  const largest = h('p', { class: 'sm soft' });
  const matrices = {
    geometric: createJacobianMatrix(JACOBIAN.geometry),
    numeric: createJacobianMatrix(''),
    difference: createJacobianMatrix(JACOBIAN.difference),
  };
  const { geometric, numeric, difference } = matrices;
  const stepControl = createStepControl(page);
  const plot = createErrorPlot(page);
  const gauge = createSingularityGauge(page);
  const measures = createMotionMeasures(page);
  const statics = createStaticsForm(page);
  const all = h(
    'div',
    { class: 'jacobians' },
    h('div', {}, geometric.element, h('p', { class: 'sm soft' }, JACOBIAN.geometryFoot)),
    h('div', {}, numeric.element),
    h('div', {}, difference.element, largest),
  );
  host.append(
    gauge.element,
    h(
      'section',
      { class: 'sec' },
      h(
        'header',
        {},
        h('h2', {}, JACOBIAN.title),
        h('span', { class: 'grow' }),
        frame.element,
        createJacobianCopy(page),
      ),
      h('div', { class: 'body stack' }, h('div', {}, about, units), all, stepControl.element, plot.element),
    ),
    measures.element,
    statics.element,
  );

  const mark = (/** @type {Event} */ { target, type }) => {
    const cell = type === 'pointerover' && target instanceof Element ? target.closest('[data-at]') : null;
    const at = cell instanceof HTMLElement ? cell.dataset.at : undefined;
    for (const matrix of Object.values(matrices)) matrix.mark(at);
  };
  all.addEventListener('pointerover', mark);
  all.addEventListener('pointerleave', mark);

  /** @type {() => void} */
  let cancel = () => {};
  /** @param {JacobianView} view @param {number} error */
  function plotAtRest(view, error) {
    cancel();
    cancel = clock.after(REST_SECONDS, () => {
      const { doc } = store.state;
      const { method, quotient } = view;
      const curves = errorCurves(derived.chain(doc), derived.posture(doc), quotient);
      plot.draw(curves, { method, step: stepOf(view), own: defaultStep(method), error });
    });
  }

  addView(
    together(({ doc, session }) => [
      doc.robot,
      doc.posture,
      session.jacobian,
      session.tab === 'jacobian',
      doc.activeUser,
      derived.user(doc),
    ]),
    ([robot, , view, isOpen, activeUser, T_world_user]) => {
      if (!isOpen) return;
      const { doc } = store.state;
      const chain = derived.chain(doc);
      const q = derived.posture(doc);
      frame.draw(view.frame);
      frame.offer('user', activeUser !== undefined);
      about.textContent = JACOBIAN.about(JACOBIAN.frame.seen[view.frame](activeUser));
      const slides = robot.joints.map(isSliding);
      units.textContent = JACOBIAN.units(unitSign(robot.units.length), slides.includes(false), slides.includes(true));
      const found = jacobiansAt(chain, q, view, T_world_user);
      const [G, N] = [found.geometric, found.numeric].map((J) => rowsInDocument(robot, J));
      const rounding = ROUNDING * Math.max(1, ...G.flat().map(Math.abs));
      /** @param {number} value @param {number} i @param {number} k */
      const entry = (value, i, k) => {
        if (Math.abs(value - Math.round(value)) < rounding) return fixed(Math.round(value), 0);
        return i < 3 && !slides[k] ? poseNumber(value, robot.units.length) : fixed(value, PURE_DECIMALS);
      };
      const texts = (/** @type {number[][]} */ rows) => rows.map((row, i) => row.map((value, k) => entry(value, i, k)));
      geometric.draw(texts(G));
      numeric.setLabel(JACOBIAN.numeric(JACOBIAN.method[view.method].toLowerCase(), stepText(stepOf(view))));
      numeric.draw(texts(N));
      difference.draw(N.map((row, i) => row.map((value, k) => tiny(value - G[i][k]))));
      largest.textContent = JACOBIAN.largest(tiny(found.largest));
      stepControl.draw(view);
      measures.draw(q, view);
      statics.draw(q, view);
      plotAtRest(view, found.largest);
    },
  );
  addView(
    together(({ doc, session }) => [doc.robot, doc.posture, session.tab === 'jacobian']),
    ([, , isOpen]) => {
      if (isOpen) gauge.refresh();
    },
  );
}
