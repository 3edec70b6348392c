/**
 * What a press takes hold of: a part of the handle, or else a link; and what moving it then does.
 *
 * @import { DragRun } from './dragRun.js'
 * @import { createJointDrag } from './dragLink.js'
 * @import { GoalAt } from './dragGoal.js'
 * @import { HandleMarks } from './handle.js'
 * @import { HandlePart } from './handleParts.js'
 * @import { State } from '../robotView.js'
 * @import { Stage } from '../stage.js'
 *
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
import { Raycaster, Vector3 } from 'three';
import { handleStep } from '../../model/aim/handleAxes.js';
import { beginGoal } from './dragGoal.js';
import { partAt } from './handleParts.js';

/** A pointer that has moved no farther than this has only pressed: pixels. */
const PRESS = { fine: 3, coarse: 8 };

const FARTHEST = 4; // in sizes of the arm

/**
 * @param {State} state
 * @param {object} given
 * @param {Stage} given.stage
 * @param {HandleMarks} given.handle
 * @param {DragRun} given.run
 * @param {ReturnType<typeof createJointDrag>} given.links
 * @param {() => boolean} given.isVisible  the handle
 */
export function createHolds({ store, derived }, { stage, handle, run, links, isVisible }) {
  const { canvas } = stage;
  const raycaster = new Raycaster();

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
  const doesSnap = (event) => event.shiftKey !== store.state.session.handle.snaps;

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
        const step = handleStep(derived.chain(doc));
        goalAt = beginGoal({ part, T_world_tcp, axes: placed.axes, point: held, farthest, step, sight, x, y });
      },
      move(event) {
        const goal = handle.sight && goalAt?.(handle.sight, ...placeOf(event), doesSnap(event));
        if (goal) run.aimAt(goal);
      },
      end: () => run.letGo(),
      cancel: run.cancel,
    };
  }

  return { holdOf, linkAt, placeOf };
}
