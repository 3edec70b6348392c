/**
 * A drag of the tool, from the moment that it moves until the arm has come to rest: one step of following in a frame, each
 * a command of one gesture. While the pointer rests the arm goes on until it is there; a tool that was let go of on its
 * way still arrives.
 *
 * @import { Clock } from '../../model/clock.js'
 * @import { Derived } from '../../model/derived.js'
 * @import { Following, Hindrance } from '../../model/aim/follow.js'
 * @import { Action, AppState } from '../../model/session.js'
 * @import { Store } from '../../model/store.js'
 */
import { followTo, hindranceOf, isOnItsWay, isThere, startFollowing } from '../../model/aim/follow.js';

/** So many frames on the way to one goal, and it is called enough: a still robot costs no frames. */
const MOST_FRAMES = 240;

/**
 * @param {object} given
 * @param {Store<AppState, Action>} given.store
 * @param {Clock} given.clock
 * @param {Derived} given.derived
 * @param {() => void} given.onStep  the arm has moved: show it in this very frame
 */
export function createDragRun({ store, clock, derived, onStep }) {
  /**
   * @typedef {object} Run
   * @property {string} gesture
   * @property {Following} following
   * @property {readonly number[]} posture  as the document has it, if nobody else has moved the arm
   * @property {Float64Array} goal
   * @property {Float64Array} lastMet       the last goal that was met, or where the tool stood
   * @property {boolean} isLetGo
   * @property {Hindrance | null} stoppedBy  what it was that the arm goes back from, once it is let go of
   * @property {number} frames
   */
  /** @type {Run | null} */
  let run = null;
  let count = 0;
  let isSpent = false; // a step was made in this frame
  let isDue = false;

  const isOurs = (/** @type {Run} */ { following, posture }) =>
    store.state.doc.robot === following.robot && store.state.doc.posture === posture;

  function finish() {
    if (!run) return;
    const { gesture, following } = run;
    const stoppedBy = run.stoppedBy ?? hindranceOf(following);
    run = null;
    if (store.state.gesture?.id === gesture) store.dispatch({ type: 'end-gesture' });
    const dragEnd = stoppedBy && { hindrance: stoppedBy, posture: store.state.doc.posture };
    store.dispatch({ type: 'show', change: { drag: null, dragEnd } });
  }

  function step() {
    if (!run) return;
    if (!isOurs(run)) {
      finish(); // someone else has moved the arm, or it is another
      return;
    }
    const { goal, gesture } = run;
    const following = followTo(run.following, goal);
    const hasMoved = following.q.some((value, i) => value !== run?.following.q[i]);
    store.dispatch({ type: 'set-posture', posture: following.posture, gesture });
    run = { ...run, following, posture: store.state.doc.posture, frames: run.frames + 1 };
    if (isThere(following)) run.lastMet = goal;
    const drag = { T_world_goal: goal, hindrance: hindranceOf(following), isHeld: !run.isLetGo };
    store.dispatch({ type: 'show', change: { drag } });
    onStep();
    isDue = isOnItsWay(following) && hasMoved && run.frames < MOST_FRAMES;
    if (!isDue && run.isLetGo) finish();
  }

  /** Now, if this frame has room for it; else in the next. */
  function ask() {
    if (isSpent) {
      isDue = true;
      return;
    }
    isSpent = true;
    clock.onFrame(() => {
      isSpent = false;
      if (run && isDue) ask();
    });
    isDue = false;
    step();
  }

  return {
    get isGoing() {
      return run !== null;
    },

    /** The pose to go on from by keys: what was met last, be the arm there or on its way. */
    get lastMet() {
      return run && isOurs(run) ? run.lastMet : null;
    },

    begin() {
      finish();
      const { doc, session } = store.state;
      const goal = derived.tcp(doc);
      const following = startFollowing(doc, derived.chain(doc), session.numbers.keepsLimits);
      const gesture = `drag-${++count}`;
      run = {
        gesture,
        following,
        posture: doc.posture,
        goal,
        lastMet: goal,
        isLetGo: false,
        stoppedBy: null,
        frames: 0,
      };
    },

    /** @param {Float64Array} T_world_goal */
    aimAt(T_world_goal) {
      if (!run) return;
      Object.assign(run, { goal: T_world_goal, frames: 0 });
      ask();
    },

    /** The hand is off. @param {Hindrance | null} [stoppedBy]  what is still to be said of it when the arm has come to rest */
    letGo(stoppedBy = null) {
      if (!run) return;
      Object.assign(run, { isLetGo: true, stoppedBy });
      if (!isDue) finish();
    },

    /** As if it had never begun. */
    cancel() {
      if (!run) return;
      const isWhole = isOurs(run) && store.state.gesture?.id === run.gesture;
      run = null;
      if (isWhole) store.dispatch({ type: 'cancel-gesture' });
      store.dispatch({ type: 'show', change: { drag: null } });
    },
  };
}

/** @typedef {ReturnType<typeof createDragRun>} DragRun */
