/**
 * The tool moved by keys: taken and given back, moved along or turned about the axes step by step. The part of the handle
 * that the last key meant is lit, as the part under a pointer is.
 *
 * @import { DragRun } from './dragRun.js'
 * @import { HandlePart } from './handleParts.js'
 * @import { State } from './robotView.js'
 */
import { HANDLE_STEP, poseOfAxes } from '../model/handleAxes.js';
import { isHandleShown } from '../model/handleShown.js';
import { turned } from './dragGoal.js';
import { toolStep } from './dragKeys.js';
import { plus } from './dragRays.js';

/**
 * @param {State} state
 * @param {object} given
 * @param {HTMLElement} given.canvas
 * @param {HTMLElement} given.room    the view, with all that floats over the picture
 * @param {DragRun} given.run
 * @param {() => boolean} given.isWide
 * @param {() => boolean} given.isHeld   a pointer has something in the hand
 * @param {() => Float64Array | null} given.userFrame
 * @param {() => void} given.onChange
 */
export function createToolKeys({ store, derived }, { canvas, room, run, isWide, isHeld, userFrame, onChange }) {
  const session = () => store.state.session;
  /** @type {HandlePart | null} */
  let chosen = null;

  /** @param {'move' | 'turn' | null} toolKeys */
  function take(toolKeys) {
    const { handle: shown } = session();
    const change = toolKeys && !isHandleShown(session(), isWide()) ? { handle: { ...shown, isShown: true } } : {};
    chosen = null;
    store.dispatch({ type: 'show', change: { toolKeys, ...change } });
    onChange();
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
    if (isHeld()) return;
    if (!run.lastMet) run.begin();
    const from = run.lastMet;
    if (!from) return;
    const { doc, session: now } = store.state;
    chosen = { kind: now.toolKeys === 'turn' ? 'turn' : 'move', axis: k };
    onChange();
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
    if (isHeld() || !run.isGoing) return;
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

  /** @type {HTMLElement} */ (canvas.parentElement).addEventListener('keydown', onKey, { capture: true });
  /** @type {HTMLElement} */ (canvas.parentElement).addEventListener('keyup', onKeyUp);
  canvas.addEventListener('focusout', onFocusOut);

  return {
    take,
    /** The part that the last key meant, as long as the tool is taken. */
    get lit() {
      return session().toolKeys ? chosen : null;
    },
  };
}
