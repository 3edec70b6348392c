/**
 * The hand in the scene: it drags the tool by its handle, and links about their joints. Fetched when a pointer or the
 * keyboard first comes to the view.
 *
 * @import { HandleMarks } from './handle.js'
 * @import { HandlePart } from './handleParts.js'
 * @import { Hold } from './dragHold.js'
 * @import { State } from '../robotView.js'
 * @import { Stage } from '../stage.js'
 *
 * @typedef {object} DragOptions
 * @property {Stage} stage
 * @property {HTMLElement} room       the view, with all that floats over the picture
 * @property {() => boolean} isWide   whether the screen has room for the handle at all times
 * @property {(metres: number) => string} missing
 * @property {() => Float64Array | null} [userFrame]  seen from the world, for handles in its axes
 * @property {(error: unknown) => void} onError
 */
import { poseOfAxes } from '../../model/aim/handleAxes.js';
import { isHandleShown } from '../../model/aim/handleShown.js';
import { together } from '../../model/views.js';
import { createJointDrag } from './dragLink.js';
import { createToolKeys } from './dragByKeys.js';
import { createHolds } from './dragHold.js';
import { createDragRun } from './dragRun.js';
import { isSame, partAt } from './handleParts.js';
import { createHandle } from './handle.js';

/**
 * @param {State} state
 * @param {DragOptions & { isOver: boolean }} options  `isOver`: a pointer is over the view already
 */
export function createToolDrag(state, { stage, room, isWide, missing, userFrame = () => null, ...options }) {
  const { store, addView, derived, clock } = state;
  const { canvas } = stage;
  const host = /** @type {HTMLElement} */ (canvas.parentElement);
  const noHover = matchMedia('(hover: none)');
  /** @type {HandleMarks} */
  const handle = stage.addMarks((tools) => createHandle({ ...tools, missing }));
  const run = createDragRun({ store, clock, derived, onStep: showNow });
  const links = createJointDrag(state, { onStep: showNow });
  const { holdOf, linkAt, placeOf } = createHolds(state, { stage, handle, run, links, isVisible });
  const keys = createToolKeys(state, {
    ...{ canvas, room, run, isWide, userFrame },
    isHeld: () => hold !== null,
    onChange: redraw,
  });
  let isOver = options.isOver;
  /** @type {HandlePart | null} */
  let pointed = null;
  /** @type {Hold | null} */
  let hold = null;
  /** Pointers that are down. @type {Set<number>} */
  const down = new Set();

  const session = () => store.state.session;
  function isVisible() {
    const { toolKeys, drag } = session();
    const isWanted = isOver || noHover.matches || hold !== null || toolKeys !== null || drag !== null;
    return isWanted && isHandleShown(store.state, isWide());
  }

  /** What was drawn last, not to ask for another picture of the same. */
  let drawn = '';

  function redraw() {
    const { doc, session: now } = store.state;
    const { drag } = now;
    const isShown = isVisible();
    stage.showHandle(isShown);
    const T_world_tcp = derived.tcp(doc);
    const T_world_wanted = drag?.T_world_goal ?? T_world_tcp;
    const T_world_handle = poseOfAxes(now.handle.axes, derived.chain(doc), T_world_wanted, userFrame()).slice();
    T_world_handle.set(T_world_wanted.subarray(12, 15), 12);
    const isMissed = Boolean(drag?.T_world_goal && drag.hindrance && drag.hindrance.kind !== 'part');
    const next = {
      T_world_handle,
      lit: hold?.part ?? pointed ?? keys.lit,
      isHeld: hold !== null && hold.hasMoved && hold.part !== null,
      T_world_ghost: isMissed ? T_world_wanted : null,
    };
    const all = isShown ? JSON.stringify([...T_world_handle, next.lit, next.isHeld, isMissed]) : '';
    if (all === drawn) return;
    drawn = all;
    handle.place(isShown ? next : null);
    stage.touch();
  }

  /** The arm as it now is, in the picture that is due, not one later. */
  function showNow() {
    stage.showPosture(derived.posture(store.state.doc));
    redraw();
  }

  /** @param {HandlePart | null} part @param {number | null} joint */
  function point(part, joint) {
    canvas.style.cursor = part || joint !== null ? 'grab' : '';
    if (session().pointedLink !== joint) store.dispatch({ type: 'show', change: { pointedLink: joint } });
    if (isSame(part, pointed)) return;
    pointed = part;
    redraw();
  }

  /** @type {[number, number] | null} */
  let hovering = null;
  function hover() {
    if (!hovering || hold || down.size > 0) return;
    const [x, y] = hovering;
    hovering = null;
    const { seen } = handle;
    const part = seen && isVisible() ? partAt(seen.placed, seen.sight, x, y, false) : null;
    point(part?.part ?? null, part ? null : (linkAt(x, y)?.joint ?? null));
  }

  /** @param {PointerEvent} event */
  function onDown(event) {
    const isSecond = down.size > 0;
    down.add(event.pointerId);
    if (hold) {
      event.stopPropagation(); // another finger neither orbits nor zooms while one drags
      return;
    }
    if (isSecond || event.button !== 0) return;
    hold = holdOf(event);
    if (!hold) return;
    event.stopPropagation();
    canvas.setPointerCapture(event.pointerId);
    canvas.style.cursor = 'grabbing';
    redraw();
  }

  /** @param {PointerEvent} event */
  function onMove(event) {
    if (!hold) {
      if (event.pointerType === 'touch' || event.target !== canvas || down.size > 0) return;
      if (!hovering) clock.onFrame(hover);
      hovering = placeOf(event);
      return;
    }
    if (event.pointerId !== hold.id) return;
    const [x, y] = placeOf(event);
    if (!hold.hasMoved) {
      if (Math.hypot(x - hold.x, y - hold.y) <= hold.press) return;
      hold.hasMoved = true;
      hold.begin(event);
    }
    hold.move(event);
  }

  /** @param {PointerEvent} event */
  function onUp(event) {
    down.delete(event.pointerId);
    if (hold?.id !== event.pointerId) return;
    const was = hold;
    hold = null;
    canvas.style.cursor = was.part ? 'grab' : '';
    if (was.hasMoved) was.end();
    else if (was.part && !event.defaultPrevented) {
      const { kind, axis } = was.part;
      keys.take(kind === 'turn' ? 'turn' : 'move', kind === 'plane' ? axis : null);
    }
    redraw();
  }

  /** Escape, wherever the focus is, while something is being dragged. @param {KeyboardEvent} event */
  function onEscape(event) {
    if (event.key !== 'Escape' || !(hold?.hasMoved || run.isGoing)) return;
    event.preventDefault();
    event.stopPropagation();
    if (hold) {
      hold.cancel();
      // the pointer is still down: it does nothing more until it is let go of
      hold = { ...hold, hasMoved: true, part: null, move: () => {}, end: () => {}, cancel: () => {} };
    } else run.cancel();
    redraw();
  }

  host.addEventListener('pointerdown', onDown, { capture: true });
  host.addEventListener('pointermove', onMove);
  for (const name of /** @type {const} */ (['pointerup', 'pointercancel', 'lostpointercapture'])) {
    host.addEventListener(name, onUp);
  }
  room.addEventListener('pointerenter', () => {
    isOver = true;
    redraw();
  });
  room.addEventListener('pointerleave', () => {
    isOver = false;
    hovering = null;
    if (!hold) point(null, null);
    redraw();
  });
  document.addEventListener('keydown', onEscape, { capture: true });
  noHover.addEventListener('change', redraw);
  addView(
    together(({ doc, session: now }) => [
      doc.robot,
      doc.posture,
      derived.user(doc),
      now.handle,
      now.drag,
      now.toolKeys,
      now.build,
      now.workcell,
    ]),
    redraw,
  );
}
