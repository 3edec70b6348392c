/**
 * What is pressed stands until it is let go: a button that is drawn anew between press and release has not been pressed.
 *
 * @import { Clock } from '../../model/clock.js'
 */
import { createFrameLoop } from '../../model/clock.js';

/** A list of choices is none of them: letting it go is nothing that a page is told of. */
const PRESSED = 'button, summary, label, [type=checkbox], [data-at-line], .is-live';

/**
 * @param {EventTarget} host
 * @param {Clock} clock
 * @param {EventTarget} [everywhere]  where it may be let go
 * @returns {(draw: () => void) => void} draws now, or else in the frame after what is pressed in the host is let go
 */
export function createPressGate(host, clock, everywhere = window) {
  /** @type {Set<() => void>} */
  const waiting = new Set();
  let isPressed = false;
  const drawWaiting = createFrameLoop(clock, () => {
    if (isPressed) return;
    const draws = [...waiting];
    waiting.clear();
    for (const draw of draws) draw();
  });
  /** @param {Event} event */
  const press = (event) => {
    const { target } = event;
    if (('key' in event && event.key !== ' ') || ('button' in event && event.button !== 0)) return;
    isPressed = Boolean(/** @type {Partial<Element> | null} */ (target)?.closest?.(PRESSED));
  };
  const letGo = () => {
    isPressed = false;
    if (waiting.size > 0) drawWaiting();
  };
  for (const type of ['pointerdown', 'keydown']) host.addEventListener(type, press, true);
  for (const type of ['pointerup', 'pointercancel', 'keyup']) everywhere.addEventListener(type, letGo, true);
  return (draw) => {
    if (isPressed) return void waiting.add(draw);
    waiting.delete(draw);
    draw();
  };
}
