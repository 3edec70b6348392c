/**
 * Fields with a caption above them, as they stand in the sections below the table.
 * @import { Child } from './dom.js'
 */
import { h } from './dom.js';
import { icon } from './icons.js';

/** @param {Record<string, string | number | boolean | null | undefined>} attributes */
export const textInput = (attributes) =>
  h('input', { type: 'text', inputmode: 'text', autocomplete: 'off', spellcheck: 'false', ...attributes });

/**
 * @param {Child} caption  for the eye; the control has its own, longer name
 * @param {HTMLElement} control
 * @param {Child} [unit]
 * @param {string} [className]
 */
export const captioned = (caption, control, unit, className = '') =>
  h(
    'label',
    { class: `captioned ${className}`.trim() },
    h('span', { class: 'caption', 'aria-hidden': 'true' }, caption),
    h('span', { class: 'field' }, control, unit && h('span', { class: 'unit', 'aria-hidden': 'true' }, unit)),
  );

/**
 * @template {string} Value
 * @param {string} label
 * @param {readonly Value[]} values
 * @param {Record<Value, string>} names
 * @param {(value: Value) => void} onChange
 */
export function select(label, values, names, onChange) {
  const control = h(
    'select',
    { 'aria-label': label },
    values.map((value) => h('option', { value }, names[value])),
  );
  control.addEventListener('change', () => onChange(/** @type {Value} */ (control.value)));
  return control;
}

/** @param {HTMLSelectElement} control @param {Child} caption */
export const captionedSelect = (control, caption) => captioned(caption, control, icon('caret', 'caret'), 'has-select');
