/**
 * The tool moved by keys: taken and given back, moved along or turned about the axes step by step. Two arrows held at once move
 * it in their plane, as a drag of the small plane does. The part of the handle that the last key meant is lit, as the part under
 * a pointer is.
 *
 * @import { DragRun } from './dragRun.js'
 * @import { HandlePart } from './handleParts.js'
 * @import { ToolStep } from './dragKeys.js'
 * @import { State } from '../robotView.js'
 */
import { handleStep, poseOfAxes } from '../../model/aim/handleAxes.js';
import { isHandleShown } from '../../model/aim/handleShown.js';
import { turned } from './dragGoal.js';
import { nextPlane, toolStep } from './dragKeys.js';
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
  /** Keys that are down, and what each does. @type {Map<string, ToolStep>} */
  const down = new Map();

  /** @param {'move' | 'turn' | null} toolKeys @param {number | null} [across]  the plane to move in, where one was chosen */
  function take(toolKeys, across = null) {
    const isHidden = toolKeys !== null && !isHandleShown(store.state, isWide());
    const handle = { ...session().handle, ...(isHidden && { isShown: true }), ...(across !== null && { across }) };
    chosen = across === null ? null : { kind: 'plane', axis: across };
    down.clear();
    store.dispatch({ type: 'show', change: { toolKeys, ...((isHidden || across !== null) && { handle }) } });
    onChange();
  }

  /** @param {KeyboardEvent} event */
  function onKey(event) {
    const { toolKeys } = session();
    const isPlain = !event.ctrlKey && !event.altKey && !event.metaKey;
    const key = event.key.toLowerCase();
    if (event.target !== canvas || session().build) return;
    const step = toolKeys && toolStep(event, toolKeys, session().handle.across);
    if (step) press(event.key, step);
    else if (!isPlain) return;
    else if (key === 't' || key === 'enter') take(toolKeys ? null : 'move');
    else if (toolKeys && key === 'r') take(toolKeys === 'turn' ? 'move' : 'turn');
    else if (toolKeys === 'move' && key === 'p') take('move', nextPlane(session().handle.across));
    else if (toolKeys && key === 'escape') take(null);
    else return;
    event.preventDefault();
    event.stopPropagation();
  }

  /**
   * A step by key, with those of the other keys that are held, from the last place that the arm could take.
   * @param {string} key
   * @param {ToolStep} step
   */
  function press(key, step) {
    if (isHeld()) return;
    if (!run.lastMet) run.begin();
    const from = run.lastMet;
    if (!from) return;
    const { doc, session: now } = store.state;
    const isTurn = now.toolKeys === 'turn';
    down.set(key, step);
    const steps = isTurn ? [step] : [...new Map([...down.values(), step].map((each) => [each.axis, each])).values()];
    const across = [0, 1, 2].find((axis) => steps.every((each) => each.axis !== axis)) ?? step.axis;
    chosen = steps.length === 2 ? { kind: 'plane', axis: across } : { kind: isTurn ? 'turn' : 'move', axis: step.axis };
    onChange();
    const chain = derived.chain(doc);
    const { metres, radians } = handleStep(chain);
    const axes = poseOfAxes(now.handle.axes, chain, from, userFrame());
    const axisOf = (/** @type {ToolStep} */ { axis }) => [...axes.subarray(4 * axis, 4 * axis + 3)];
    if (isTurn) {
      run.aimAt(turned(from, axisOf(step), step.steps * radians));
      return;
    }
    const place = steps.reduce((sum, each) => plus(sum, each.steps * metres, axisOf(each)), [...from.subarray(12, 15)]);
    const goal = from.slice();
    goal.set(place, 12);
    run.aimAt(goal);
  }

  /** What a key asked for and the arm cannot do is taken back, so that steps do not add up to somewhere else. */
  function rest() {
    down.clear();
    if (isHeld() || !run.isGoing) return;
    const { drag } = session();
    const stoppedBy = drag?.hindrance && drag.hindrance.kind !== 'part' ? drag.hindrance : null;
    if (stoppedBy && run.lastMet) run.aimAt(run.lastMet);
    run.letGo(stoppedBy);
  }

  /** While another of its keys is down, the tool is still being moved. @param {KeyboardEvent} event */
  function onKeyUp({ key }) {
    down.delete(key);
    if (down.size === 0) rest();
  }

  /** @param {FocusEvent} event */
  function onFocusOut({ relatedTarget }) {
    if (relatedTarget instanceof Node && room.contains(relatedTarget)) return;
    rest();
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
