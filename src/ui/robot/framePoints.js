/**
 * A user frame by three points, as on a pendant: the TCP is brought to each and taken there. The session has them, so that the
 * scene shows what was taken.
 *
 * @import { Page } from '../page.js'
 * @import { PoseDoc } from '../../model/document.js'
 * @import { Taught } from '../../model/frames/threePoints.js'
 */
import { NOT_TAUGHT, frameFromPoints } from '../../model/frames/threePoints.js';
import { poseInUnits } from '../../model/numbers/poseNumbers.js';
import { fromKernel } from '../../model/units.js';
import { together } from '../../model/views.js';
import { fill, h } from '../parts/dom.js';
import { poseNumber } from '../parts/format.js';
import { FRAMES } from '../words/frames.js';

/**
 * @param {Page} page
 * @param {object} on
 * @param {(pose: PoseDoc) => string | null} on.make  the reason why not
 * @param {() => void} on.cancel
 */
export function createFramePoints({ store, addView, derived, announce }, on) {
  const points = () => store.state.session.taught ?? NOT_TAUGHT;
  const reason = h('p', { class: 'reason sm', role: 'status', hidden: true });
  const places = FRAMES.point.map(() => h('output', { class: 'soft sm' }));

  /** @param {string | null} text */
  function say(text) {
    reason.textContent = text ?? '';
    reason.hidden = text === null;
  }

  /** @param {readonly number[] | null} point */
  function inWords(point) {
    const { units } = store.state.doc.robot;
    if (!point) return FRAMES.notTaken;
    return `${point.map((value) => poseNumber(fromKernel('length', value, units), units.length)).join('  ')} ${units.length}`;
  }

  /** @param {Taught | null} taught */
  const teach = (taught) => store.dispatch({ type: 'show', change: { taught } });
  const draw = () => places.forEach((place, i) => (place.textContent = inWords(points()[i])));

  const rows = FRAMES.point.map((name, i) => {
    const take = h(
      'button',
      { type: 'button', class: 'btn btn-small btn-outline', 'aria-label': FRAMES.takeLabel(name) },
      FRAMES.take,
    );
    take.addEventListener('click', () => {
      const T = derived.tcp(store.state.doc);
      teach(points().with(i, [T[12], T[13], T[14]]));
      say(null);
      announce(FRAMES.taken(name, inWords(points()[i])));
    });
    return h('li', {}, h('span', {}, `${i + 1} ${name}`), places[i], take);
  });

  function make() {
    const [origin, onX, onPlane] = points();
    if (!origin || !onX || !onPlane) return FRAMES.missing(FRAMES.point[points().indexOf(null)]);
    const found = frameFromPoints([origin, onX, onPlane]);
    if ('fault' in found) return FRAMES.fault[found.fault];
    return on.make(poseInUnits(found.T_world_frame, store.state.doc.robot.units));
  }
  const makeButton = h('button', { type: 'button', class: 'btn btn-outline' }, FRAMES.make);
  const cancel = h('button', { type: 'button', class: 'btn' }, FRAMES.cancel);
  makeButton.addEventListener('click', () => {
    const against = make();
    say(against);
    if (against) announce(against);
    else teach(null);
  });
  cancel.addEventListener('click', () => {
    teach(null);
    on.cancel();
  });

  const element = h('div', { class: 'frame-points', role: 'group', 'aria-label': FRAMES.points, hidden: true });
  fill(
    element,
    h('p', { class: 'sm' }, FRAMES.pointsIntro),
    h('ol', {}, rows),
    reason,
    h('div', { class: 'actions' }, makeButton, cancel),
  );
  addView(
    together(({ doc, session }) => [session.taught, doc.robot.units]),
    ([taught]) => {
      element.hidden = taught === null;
      draw();
    },
  );
  return {
    element,
    open() {
      teach(NOT_TAUGHT);
      say(null);
      element.hidden = false; // at once, for the focus
      element.querySelector('button')?.focus();
    },
  };
}
