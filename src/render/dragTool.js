/**
 * The hand in the scene: it drags the tool by its handle, and links about their joints. Fetched when a pointer or the
 * keyboard first comes to the view.
 *
 * @import { HandleMarks } from './handle.js'
 * @import { HandlePart } from './handleParts.js'
 * @import { GoalAt } from './dragGoal.js'
 * @import { State } from './robotView.js'
 * @import { Stage } from './stage.js'
 *
 * @typedef {object} DragOptions
 * @property {Stage} stage
 * @property {HTMLElement} room       the view, with all that floats over the picture
 * @property {() => boolean} isWide   whether the screen has room for the handle at all times
 * @property {(metres: number) => string} missing
 * @property {() => Float64Array | null} [userFrame]  seen from the world, for handles in its axes
 * @property {(error: unknown) => void} onError
 */
import { Raycaster, Vector3 } from 'three';
import { HANDLE_STEP, poseOfAxes } from '../model/handleAxes.js';
import { isHandleShown } from '../model/handleShown.js';
import { together } from '../model/views.js';
import { beginGoal, turned } from './dragGoal.js';
import { createJointDrag } from './dragLink.js';
import { toolStep } from './dragKeys.js';
import { createDragRun } from './dragRun.js';
import { plus } from './dragRays.js';
import { isSame, partAt } from './handleParts.js';
import { createHandle } from './handle.js';

/** A pointer that has moved no farther than this has only pressed: pixels. */
const PRESS = { fine: 3, coarse: 8 };

const FARTHEST = 4; // in sizes of the arm

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
  const raycaster = new Raycaster();
  let isOver = options.isOver;
  /** @type {HandlePart | null} */
  let pointed = null;
  /**
   * @typedef {object} Hold
   * @property {number} id         of the pointer
   * @property {number} x
   * @property {number} y
   * @property {number} press      within so many pixels nothing has begun
   * @property {boolean} hasMoved
   * @property {HandlePart | null} part  null: a link
   * @property {(event: PointerEvent) => void} begin
   * @property {(event: PointerEvent) => void} move
   * @property {() => void} end
   * @property {() => void} cancel
   */
  /** @type {Hold | null} */
  let hold = null;
  /** Pointers that are down. @type {Set<number>} */
  const down = new Set();

  const session = () => store.state.session;
  const isVisible = () =>
    isHandleShown(session(), isWide()) &&
    (isOver || noHover.matches || hold !== null || session().toolKeys !== null || session().drag !== null);

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
      lit: hold?.part ?? pointed,
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

  /** @param {PointerEvent} event @returns {[number, number]} */
  function placeOf({ clientX, clientY }) {
    const { left, top } = canvas.getBoundingClientRect();
    return [clientX - left, clientY - top];
  }

  /** @param {number} x @param {number} y */
  function linkAt(x, y) {
    const ray = handle.sight?.ray(x, y);
    if (!ray) return null;
    raycaster.set(new Vector3(...ray.from), new Vector3(...ray.along));
    const found = stage.linkAt(raycaster);
    return found && found.link > 0 ? { joint: found.link - 1, point: found.point.toArray() } : null;
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

  /** @param {PointerEvent} event @returns {Hold | null} */
  function holdOf(event) {
    const [x, y] = placeOf(event);
    const isCoarse = event.pointerType === 'touch';
    const at = { id: event.pointerId, x, y, press: isCoarse ? PRESS.coarse : PRESS.fine, hasMoved: false };
    const { seen } = handle;
    const hit = seen && isVisible() ? partAt(seen.placed, seen.sight, x, y, isCoarse) : null;
    if (seen && hit) return { ...at, ...holdHandle(seen, hit, x, y) };
    const isPlain = !event.shiftKey && !event.ctrlKey && !event.metaKey;
    const link = !isCoarse && isPlain ? linkAt(x, y) : null;
    const { sight } = handle;
    const moves = link && sight && links.hold({ ...link, sight, x, y });
    if (!moves) return null;
    return {
      ...at,
      part: null,
      begin: moves.begin,
      move: (now) => handle.sight && moves.move(handle.sight, ...placeOf(now), doesSnap(now)),
      end: moves.end,
      cancel: moves.cancel,
    };
  }

  /** @param {PointerEvent} event */
  const doesSnap = (event) => event.shiftKey !== session().handle.snaps;

  /**
   * @param {NonNullable<HandleMarks['seen']>} seen
   * @param {NonNullable<ReturnType<typeof partAt>>} hit
   * @param {number} x
   * @param {number} y
   * @returns {Pick<Hold, 'part' | 'begin' | 'move' | 'end' | 'cancel'>}
   */
  function holdHandle({ placed, sight }, { part, point: held }, x, y) {
    /** @type {GoalAt | null} */
    let goalAt = null;
    return {
      part,
      begin() {
        run.begin();
        const { doc } = store.state;
        const T_world_tcp = derived.tcp(doc);
        const farthest = FARTHEST * handle.size;
        goalAt = beginGoal({ part, T_world_tcp, axes: placed.axes, point: held, farthest, sight, x, y });
      },
      move(event) {
        const goal = handle.sight && goalAt?.(handle.sight, ...placeOf(event), doesSnap(event));
        if (goal) run.aimAt(goal);
      },
      end: run.letGo,
      cancel: run.cancel,
    };
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
    else if (was.part) take(was.part.kind === 'turn' ? 'turn' : 'move');
    redraw();
  }

  /** @param {'move' | 'turn' | null} toolKeys */
  function take(toolKeys) {
    const { handle: shown } = session();
    const change = toolKeys && !isHandleShown(session(), isWide()) ? { handle: { ...shown, isShown: true } } : {};
    store.dispatch({ type: 'show', change: { toolKeys, ...change } });
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

  /** @param {KeyboardEvent} event */
  function onKey(event) {
    const { toolKeys } = session();
    const isPlain = !event.ctrlKey && !event.altKey && !event.metaKey;
    const key = event.key.toLowerCase();
    if (event.target !== canvas || session().build) return;
    const step = toolKeys && toolStep(event, toolKeys);
    if (step) nudge(step.axis, step.steps);
    else if (!isPlain) return;
    else if (key === 't' || key === 'enter') take(toolKeys ? null : 'move');
    else if (toolKeys && key === 'r') take(toolKeys === 'turn' ? 'move' : 'turn');
    else if (toolKeys && key === 'escape') take(null);
    else return;
    event.preventDefault();
    event.stopPropagation();
  }

  /** A step by key, from the last place that the arm could take. @param {number} k @param {number} steps */
  function nudge(k, steps) {
    if (hold) return;
    if (!run.lastMet) run.begin();
    const from = run.lastMet;
    if (!from) return;
    const { doc, session: now } = store.state;
    const axes = poseOfAxes(now.handle.axes, derived.chain(doc), from, userFrame());
    const axis = [...axes.subarray(4 * k, 4 * k + 3)];
    if (now.toolKeys === 'turn') {
      run.aimAt(turned(from, axis, steps * HANDLE_STEP.radians));
      return;
    }
    const goal = from.slice();
    goal.set(plus([...from.subarray(12, 15)], steps * HANDLE_STEP.metres, axis), 12);
    run.aimAt(goal);
  }

  /** What a key asked for and the arm cannot do is taken back, so that steps do not add up to somewhere else. */
  function onKeyUp() {
    if (hold || !run.isGoing) return;
    const { drag } = session();
    if (drag?.hindrance && drag.hindrance.kind !== 'part' && run.lastMet) run.aimAt(run.lastMet);
    run.letGo();
  }

  /** @param {FocusEvent} event */
  function onFocusOut({ relatedTarget }) {
    if (relatedTarget instanceof Node && room.contains(relatedTarget)) return;
    onKeyUp();
    if (session().toolKeys && document.hasFocus()) take(null);
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
  host.addEventListener('keydown', onKey, { capture: true });
  host.addEventListener('keyup', onKeyUp);
  canvas.addEventListener('focusout', onFocusOut);
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
    ]),
    redraw,
  );
}
