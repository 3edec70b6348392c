/**
 * The hand on a joint's slider. A pull is one undo step, and so is a key however long it is held; Escape during either
 * leaves no trace. The range input's own steps count from its lower end, so that one that begins at −89.954° never meets
 * zero: here they count from zero, and the ends can be reached.
 *
 * @import { Page } from '../page.js'
 * @import { Command } from '../../model/commands.js'
 * @import { Range } from '../../model/jog/jogRange.js'
 */
import { stepsOf } from './jogKeys.js';
import { attempt, newGesture } from '../page.js';

/**
 * @param {Page} page
 * @param {HTMLInputElement} slider
 * @param {number} index
 * @param {object} given
 * @param {() => number} given.home
 * @param {number} given.step
 * @param {() => number} given.now
 * @param {(value: number) => Command} given.command
 * @param {() => Range} given.range
 * @param {(value: number) => number} given.hold  a value brought inside what may be reached
 * @param {() => void} given.onRest  a pull or a key has ended
 */
export function watchSlider(page, slider, index, { home, step, now, command, range, hold, onRest }) {
  const { store, announce } = page;
  /** @type {string | null} */
  let gesture = null;
  let isGivenUp = false; // by Escape; the browser goes on dragging until the hand is off
  const take = (/** @type {boolean} */ isHeld) =>
    store.dispatch({ type: 'show', change: { heldJoint: isHeld ? index : null } });

  /** @param {number} value */
  function go(value) {
    gesture ??= newGesture();
    take(true);
    const reason = attempt(page, { ...command(hold(value)), gesture });
    if (reason) announce(reason);
  }
  /** @param {number} value */
  const onStep = (value) => Number((Math.round(value / step) * step).toPrecision(12));

  function end() {
    if (gesture) store.dispatch({ type: 'end-gesture' });
    gesture = null;
    onRest();
  }

  slider.addEventListener('pointerdown', () => {
    isGivenUp = false;
    take(true);
  });
  slider.addEventListener('input', () => {
    if (isGivenUp) {
      slider.value = String(now());
      return;
    }
    const value = Number(slider.value);
    const { least, most } = range();
    go(value <= least || value >= most ? value : onStep(value));
  });
  slider.addEventListener('change', end);
  for (const name of ['pointerup', 'pointercancel', 'blur']) {
    slider.addEventListener(name, () => {
      isGivenUp = false;
      end();
      take(false);
    });
  }
  slider.addEventListener('dblclick', () => {
    go(home());
    end();
    take(false);
  });
  slider.addEventListener('keydown', (event) => {
    if (event.key === 'Escape' && gesture) {
      gesture = null;
      isGivenUp = true;
      store.dispatch({ type: 'cancel-gesture' });
    }
    const steps = stepsOf(event);
    const isPlain = !event.ctrlKey && !event.altKey && !event.metaKey;
    if (steps !== null) go(onStep(now() + steps * step));
    else if (event.key === 'Home' && isPlain) go(event.shiftKey ? range().least : home());
    else if (event.key === 'End' && isPlain) go(range().most);
    else return;
    event.preventDefault();
  });
  slider.addEventListener('keyup', end); // however long a key is held, it is one step to undo
}
