/**
 * Turning a joint by its dial. A dial is the joint's slider bent into an arc (css/dials.css), so that keys, Escape, undo and
 * what is heard are the slider's; only the hand is other: it turns about the middle, and nothing leaps where it takes hold.
 */
import '../css/dials.css';
import { toRadians } from '../../model/units.js';

/** From one end of a dial to the other, as in css/dials.css. */
const SWEEP = toRadians(270);

/** @param {HTMLElement} list  of the joints' rows */
export function runJogDials(list) {
  /** @type {{ slider: HTMLInputElement, pointer: number, angle: number, value: number } | null} */
  let held = null;

  /** @param {Event} event @returns {HTMLInputElement | null} */
  const dialAt = ({ target }) =>
    target instanceof HTMLInputElement && target.matches('.dials .jog:not(.slides) .track input') ? target : null;

  /** @param {HTMLInputElement} slider @param {PointerEvent} event */
  function angleOf(slider, { clientX, clientY }) {
    const { left, top, width, height } = slider.getBoundingClientRect();
    return Math.atan2(clientY - top - height / 2, clientX - left - width / 2);
  }

  // The browser's own drag goes from left to right.
  list.addEventListener('touchstart', (event) => dialAt(event) && event.preventDefault(), { passive: false });
  list.addEventListener('pointerdown', (event) => {
    const slider = dialAt(event);
    if (!slider || event.button !== 0 || held) return;
    event.preventDefault();
    slider.focus();
    slider.setPointerCapture(event.pointerId);
    held = { slider, pointer: event.pointerId, angle: angleOf(slider, event), value: Number(slider.value) };
  });
  list.addEventListener('pointermove', (event) => {
    if (!held || event.pointerId !== held.pointer) return;
    const { slider } = held;
    const angle = angleOf(slider, event);
    const turned = Math.atan2(Math.sin(angle - held.angle), Math.cos(angle - held.angle));
    const [least, most] = [Number(slider.min), Number(slider.max)];
    const wanted = held.value + (turned / SWEEP) * (most - least);
    Object.assign(held, { angle, value: Math.min(most, Math.max(least, wanted)) });
    slider.value = String(held.value);
    slider.dispatchEvent(new Event('input'));
  });
  for (const name of ['pointerup', 'pointercancel', 'lostpointercapture']) {
    list.addEventListener(name, () => (held = null));
  }
}
