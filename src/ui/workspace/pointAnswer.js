/**
 * The answer for one point: reached or not, in which postures and with how much room to the limits, or what is the nearest place.
 *
 * @import { Page } from '../page.js'
 * @import { PointRow, ReachPosture } from '../../model/workspace/pointAnswers.js'
 */
import { fill, h } from '../parts/dom.js';
import { fixed, poseNumber, withUnit } from '../parts/format.js';
import { travelTo } from '../travel.js';
import { POINTS } from '../words/workspacePoints.js';
import { placeText, postureText } from './probes.js';

/** @param {ReachPosture['margin']} margin */
export const marginText = (margin) =>
  margin ? POINTS.marginPercent(fixed(100 * margin.share, 0), `J${margin.joint + 1}`) : POINTS.noMargin;

/** @param {Page} page */
export function createPointAnswer(page) {
  const { store, announce } = page;
  const words = h('p', { role: 'status' });
  const list = h('ul', { class: 'posture-buttons' });
  const nearest = h('button', { type: 'button', class: 'btn btn-small btn-outline' }, POINTS.goNearest);
  /** @type {PointRow | null} */
  let shown = null;
  const robot = () => store.state.doc.robot;
  nearest.addEventListener('click', () => {
    const posture = shown?.nearestPosture;
    if (posture) travelTo(page, posture, () => announce(POINTS.wentNearest));
  });

  /** @param {ReachPosture | null} given @param {number} number */
  function look(given, number) {
    const ghost = given && { posture: given.posture, label: POINTS.ghost(number) };
    store.dispatch({ type: 'show', change: { ghost } });
  }

  /** @param {ReachPosture} given @param {number} index */
  function button(given, index) {
    const values = postureText(robot(), given.posture);
    const margin = marginText(given.margin);
    const made = h(
      'button',
      { type: 'button', class: 'btn', 'aria-label': POINTS.goLabel(index + 1, values, margin) },
      h('span', { class: 'b' }, String(index + 1)),
      h('span', { class: 'values' }, values),
      h('span', { class: 'sm' }, margin),
    );
    made.addEventListener('click', () => {
      look(null, 0);
      travelTo(page, given.posture, () => announce(POINTS.went(index + 1)));
    });
    for (const event of ['pointerenter', 'focus']) made.addEventListener(event, () => look(given, index + 1));
    for (const event of ['pointerleave', 'blur']) made.addEventListener(event, () => look(null, 0));
    return h('li', {}, made);
  }

  return {
    element: h('div', { class: 'reach-result' }, words, nearest, list),
    /** @param {PointRow | null} row @param {string} name */
    draw(row, name) {
      shown = row;
      nearest.hidden = row === null || row.verdict === 'reached' || row.nearestPosture === null;
      words.hidden = row === null;
      fill(list, row ? row.postures.map(button) : []);
      if (!row) return;
      const { units } = robot();
      words.textContent =
        row.verdict === 'reached'
          ? POINTS.reached(name, row.postures.length, row.areAll)
          : [
              POINTS[row.verdict](name, withUnit(poseNumber(row.distance, units.length), units.length)),
              row.nearestPosture && POINTS.nearest(placeText(robot(), row.nearest)),
            ]
              .filter(Boolean)
              .join(' ');
    },
  };
}
