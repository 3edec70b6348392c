/** One of a few, as buttons side by side; the chosen one is pressed. */
import { h } from './dom.js';

/**
 * @template {string} Value
 * @param {string} label
 * @param {readonly Value[]} values
 * @param {Record<Value, string>} names
 * @param {(value: Value) => void} onChoose
 */
export function segments(label, values, names, onChoose) {
  const buttons = values.map((value) => {
    const button = h('button', { type: 'button', 'aria-pressed': 'false' }, names[value]);
    button.addEventListener('click', () => onChoose(value));
    return button;
  });
  return {
    element: h('div', { class: 'seg', role: 'group', 'aria-label': label }, buttons),
    /** One that there is at times only. @param {Value} value @param {boolean} isThere */
    offer(value, isThere) {
      buttons[values.indexOf(value)].hidden = !isThere;
    },
    /** @param {Value} chosen */
    draw(chosen) {
      buttons.forEach((button, i) => button.setAttribute('aria-pressed', String(values[i] === chosen)));
    },
  };
}
