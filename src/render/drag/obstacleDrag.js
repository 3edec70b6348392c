/**
 * The hand on obstacles: one that is pressed is chosen, and the chosen one is dragged by a handle, along the world's axes and about them;
 * each drag is one step to undo. It listens before the tool and the camera do, and they hear nothing of what it takes.
 *
 * @import { HandleMarks } from './handle.js'
 * @import { GoalAt } from './dragGoal.js'
 * @import { HandlePart } from './handleParts.js'
 * @import { Label } from '../labels.js'
 * @import { State } from '../robotView.js'
 * @import { Stage } from '../stage.js'
 *
 * @typedef {{ id: number, x: number, y: number, press: number, hasMoved: boolean, part: HandlePart, point: readonly number[] }} Held
 */
import { Raycaster, Vector3 } from 'three';
import { identity } from '../../kinematics/pose.js';
import { handleStep } from '../../model/aim/handleAxes.js';
import { chosenObstacle } from '../../model/aim/handleShown.js';
import { compilePose } from '../../model/compile.js';
import { together } from '../../model/views.js';
import { obstacleMoved } from '../../model/workcell/obstacleMoved.js';
import { beginGoal } from './dragGoal.js';
import { createHandle } from './handle.js';
import { isSame, partAt } from './handleParts.js';

/** A pointer that has moved no farther than this has only pressed: pixels. */
const PRESS = { fine: 3, coarse: 8 };

const FARTHEST = 4; // in sizes of the arm

const AXES = [
  [1, 0, 0],
  [0, 1, 0],
  [0, 0, 1],
];

/**
 * @param {Pick<State, 'store' | 'addView' | 'derived'>} state
 * @param {object} given
 * @param {Stage} given.stage
 * @param {HTMLElement} given.room    the view, with all that floats over the picture
 * @param {(metres: number) => string} given.missing
 * @param {(ray: { from: readonly number[], along: readonly number[] }) => { id: string, distance: number } | null} given.obstacleAt
 */
export function createObstacleDrag({ store, addView, derived }, { stage, room, missing, obstacleAt }) {
  const { canvas } = stage;
  /** @type {Label | null} */
  let dot = null;
  /** @type {HandleMarks} */
  const handle = stage.addMarks((tools) => {
    dot = Object.assign(tools.labels.add('dot of-obstacle'), { visible: false });
    return createHandle({ ...tools, missing });
  });
  /** @type {Held | null} */
  let held = null;
  /** Pressed on nothing of the handle: if it goes no farther, what is there is chosen. @type {{ id: number, x: number, y: number, press: number } | null} */
  let pressed = null;
  /** @type {HandlePart | null} */
  let pointed = null;
  /** @type {GoalAt | null} */
  let goalAt = null;
  let gestures = 0;
  let gesture = '';

  const chosen = () => chosenObstacle(store.state);

  function redraw() {
    const obstacle = chosen();
    const T = identity();
    if (obstacle) T.set(compilePose(obstacle, store.state.doc.robot.units).subarray(12, 15), 12);
    const lit = held?.part ?? pointed;
    const isHeld = held !== null && held.hasMoved;
    handle.place(obstacle ? { T_world_handle: T, lit, isHeld, T_world_ghost: null } : null);
    if (dot) {
      dot.visible = obstacle !== null;
      dot.at.set(T[12], T[13], T[14]);
    }
    stage.touch();
  }

  /** @param {PointerEvent} event @returns {[number, number]} */
  function placeOf({ clientX, clientY }) {
    const { left, top } = canvas.getBoundingClientRect();
    return [clientX - left, clientY - top];
  }

  /** @param {number} x @param {number} y @param {boolean} isCoarse */
  const hitAt = (x, y, isCoarse) =>
    handle.seen && chosen() ? partAt(handle.seen.placed, handle.seen.sight, x, y, isCoarse) : null;

  /** @param {PointerEvent} event */
  function onDown(event) {
    if (event.target !== canvas) return;
    if (held) return event.stopPropagation(); // another finger does nothing while one drags
    if (event.button !== 0) return;
    const [x, y] = placeOf(event);
    const isCoarse = event.pointerType === 'touch';
    const at = { id: event.pointerId, x, y, press: isCoarse ? PRESS.coarse : PRESS.fine };
    const hit = hitAt(x, y, isCoarse);
    pressed = hit || pressed ? null : at;
    if (!hit) return;
    held = { ...at, hasMoved: false, ...hit };
    event.stopPropagation();
    canvas.setPointerCapture(event.pointerId);
    canvas.style.cursor = 'grabbing';
    redraw();
  }

  /** @param {Held} now */
  function begin({ part, point, x, y }) {
    const obstacle = chosen();
    const { seen } = handle;
    if (!obstacle || !seen) return;
    gesture = `obstacle-${++gestures}`;
    const { doc } = store.state;
    goalAt = beginGoal({
      ...{ part, point, axes: AXES, x, y, sight: seen.sight, farthest: FARTHEST * handle.size },
      T_world_tcp: compilePose(obstacle, doc.robot.units),
      step: handleStep(derived.chain(doc)),
    });
  }

  /** @param {PointerEvent} event */
  function onMove(event) {
    const [x, y] = placeOf(event);
    if (!held) {
      if (event.pointerType === 'touch' || event.target !== canvas || event.buttons !== 0) return;
      const part = hitAt(x, y, false)?.part ?? null;
      if (part) {
        event.stopPropagation(); // the link behind it is not meant
        canvas.style.cursor = 'grab';
      } else if (pointed) canvas.style.cursor = '';
      if (isSame(part, pointed)) return;
      pointed = part;
      redraw();
      return;
    }
    if (event.pointerId !== held.id) return;
    event.stopPropagation();
    if (!held.hasMoved) {
      if (Math.hypot(x - held.x, y - held.y) <= held.press) return;
      held.hasMoved = true;
      begin(held);
    }
    const { doc, session } = store.state;
    const obstacle = chosen();
    const goal = handle.sight && goalAt?.(handle.sight, x, y, event.shiftKey !== session.handle.snaps);
    if (!obstacle || !goal) return;
    const moved = obstacleMoved(obstacle, goal, doc.robot.units, handleStep(derived.chain(doc)));
    const index = doc.obstacles.indexOf(obstacle);
    store.dispatch({ type: 'edit-obstacle', index, obstacle: moved, gesture });
  }

  /** @param {boolean} isKept */
  function letGo(isKept) {
    if (!held) return;
    if (held.hasMoved && store.state.gesture?.id === gesture)
      store.dispatch({ type: isKept ? 'end-gesture' : 'cancel-gesture' });
    held = null;
    goalAt = null;
    canvas.style.cursor = '';
    redraw();
  }

  /** @param {PointerEvent} event */
  function onUp(event) {
    if (held && event.pointerId === held.id) {
      event.stopPropagation();
      letGo(true);
      return;
    }
    const press = pressed;
    pressed = null;
    if (!press || event.type !== 'pointerup' || event.defaultPrevented || press.id !== event.pointerId) return;
    const [x, y] = placeOf(event);
    if (Math.hypot(x - press.x, y - press.y) <= press.press) choose(x, y);
  }

  /** What is pressed, unless the arm is before it. @param {number} x @param {number} y */
  function choose(x, y) {
    const ray = handle.sight?.ray(x, y);
    const found = ray && obstacleAt(ray);
    if (!ray || !found) return;
    const link = stage.linkAt(new Raycaster(new Vector3(...ray.from), new Vector3(...ray.along)));
    if (link && link.point.distanceTo(new Vector3(...ray.from)) < found.distance) return;
    const { workcell } = store.state.session;
    store.dispatch({ type: 'show', change: { workcell: { ...workcell, isOpen: true, chosen: found.id } } });
  }

  /** Escape, wherever the focus is, while something is being dragged. @param {KeyboardEvent} event */
  function onEscape(event) {
    if (event.key !== 'Escape' || !held?.hasMoved) return;
    event.preventDefault();
    event.stopPropagation();
    letGo(false);
  }

  room.addEventListener('pointerdown', onDown, { capture: true });
  room.addEventListener('pointermove', onMove, { capture: true });
  for (const name of /** @type {const} */ (['pointerup', 'pointercancel', 'lostpointercapture'])) {
    room.addEventListener(name, onUp, { capture: true });
  }
  document.addEventListener('keydown', onEscape, { capture: true });
  addView(
    together((now) => [chosenObstacle(now), now.doc.robot.units]),
    redraw,
  );
}
