/**
 * Presses on what is shown of the workspace: on one of its points, or anywhere while a point is being picked. Only a press that stays
 * where it is counts, so that the view is turned and the arm dragged as ever; who takes one says so by `preventDefault`.
 *
 * @import { State } from '../robotView.js'
 * @import { Stage } from '../stage.js'
 * @import { Sight } from '../sight.js'
 * @import { Probes, ReachHand } from '../../model/workspace/asked.js'
 */
import { together } from '../../model/views.js';
import { placeUnder } from '../../model/workspace/pickPlace.js';
import { createMarkSet } from '../marks/markSet.js';
import { sightOf } from '../sight.js';

/** A pointer that has moved no farther than this has only pressed; so far from its middle a point is pressed: pixels. */
const PRESS = { fine: 3, coarse: 8 };
const NEAR = { fine: 11, coarse: 22 };

/**
 * @param {Pick<State, 'store' | 'addView' | 'derived' | 'clock'>} state
 * @param {Stage} stage
 */
export function createReachPress({ store, addView, derived, clock }, stage) {
  const { canvas } = stage;
  const host = /** @type {HTMLElement} */ (canvas.parentElement);
  /** @type {Sight | null} */
  let sight = null;
  const marks = stage.addMarks(({ labels, ...tools }) => ({
    ...createMarkSet(tools, /** @type {readonly number[] | null} */ (null), (_, over) => {
      if (!over) return null;
      const label = labels.add('reach-point is-over');
      label.at.set(over[0], over[1], over[2]);
      return { remove: () => label.remove() };
    }),
    face: (eye) => void (sight = sightOf(eye)),
  }));
  /** @type {{ id: number, x: number, y: number, press: number } | null} */
  let pressed = null;
  /** @type {[number, number] | null} */
  let hovering = null;

  const session = () => store.state.session;
  /** @param {Partial<ReachHand>} change */
  const show = (change) =>
    store.dispatch({ type: 'show', change: { reachHand: { ...session().reachHand, ...change } } });

  /** @param {MouseEvent} event @returns {[number, number]} */
  function placeOf({ clientX, clientY }) {
    const { left, top } = canvas.getBoundingClientRect();
    return [clientX - left, clientY - top];
  }

  /** The point that is nearest, of those that are shown. @param {number} x @param {number} y @param {number} near */
  function pointAt(x, y, near) {
    const { probes, workspace } = session();
    /** @type {{ fold: keyof Probes, index: number } | null} */
    let best = null;
    let least = near;
    for (const fold of /** @type {const} */ (['points', 'teach'])) {
      if (!workspace?.open.includes(fold)) continue;
      for (const [index, { at }] of (probes[fold]?.points ?? []).entries()) {
        const [px, py] = sight?.project(at) ?? [Infinity, Infinity];
        const away = Math.hypot(px - x, py - y);
        if (away < least) [best, least] = [{ fold, index }, away];
      }
    }
    return best;
  }

  /** @param {number} x @param {number} y */
  function pickAt(x, y) {
    const { maps, reachHand } = session();
    if (!sight || !reachHand.pick) return null;
    const at = derived.tcp(store.state.doc).subarray(12, 15);
    return placeUnder(sight.ray(x, y), reachHand.pick, maps, { at, towards: sight.towards(Array.from(at)) });
  }

  function hover() {
    if (!hovering) return;
    const [x, y] = hovering;
    hovering = null;
    const isPicking = session().reachHand.pick !== null;
    host.classList.toggle('has-pressable', !isPicking && pointAt(x, y, NEAR.fine) !== null);
    if (isPicking) show({ over: pickAt(x, y) });
  }

  /** @param {PointerEvent} event */
  function onMove(event) {
    if (event.pointerType === 'touch' || event.buttons !== 0) return;
    if (event.target !== canvas) {
      if (session().reachHand.over) show({ over: null });
      return;
    }
    if (!hovering) clock.onFrame(hover);
    hovering = placeOf(event);
  }

  /** @param {PointerEvent} event */
  function onDown(event) {
    const isCoarse = event.pointerType === 'touch';
    const isFirst = event.target === canvas && event.button === 0 && event.isPrimary;
    const [x, y] = placeOf(event);
    // another finger makes it a gesture
    pressed = isFirst ? { id: event.pointerId, x, y, press: isCoarse ? PRESS.coarse : PRESS.fine } : null;
  }

  /** @param {PointerEvent} event */
  function onUp(event) {
    const press = pressed;
    pressed = null;
    const [x, y] = placeOf(event);
    if (press?.id !== event.pointerId || Math.hypot(x - press.x, y - press.y) > press.press) return;
    if (session().reachHand.pick) {
      const at = pickAt(x, y);
      event.preventDefault();
      if (at) show({ pressed: { at } });
      return;
    }
    const point = pointAt(x, y, press.press === PRESS.coarse ? NEAR.coarse : NEAR.fine);
    if (!point) return;
    event.preventDefault();
    show({ pressed: point });
  }

  // before anything in the view hears of it
  document.addEventListener('pointerdown', onDown, { capture: true });
  document.addEventListener('pointerup', onUp, { capture: true });
  document.addEventListener('pointercancel', () => void (pressed = null), { capture: true });
  document.addEventListener('pointermove', onMove, { capture: true });
  addView(
    ({ session: { reachHand } }) => reachHand.over,
    (over) => {
      marks.want(over);
      stage.touch();
    },
  );
  addView(
    together(({ session: { reachHand, probes } }) => [reachHand.pick !== null, probes]),
    ([isPicking]) => {
      host.classList.toggle('is-picking', isPicking);
      host.classList.remove('has-pressable');
    },
  );
}
