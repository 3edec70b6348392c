/** A 4 × 4 matrix as it is printed: brackets, the position set apart, exact zeros and ones without decimals. */
import { fixed, poseNumber } from '../parts/format.js';
import { h } from '../parts/dom.js';

/** @import { Units } from '../../model/document.js' */

const ROTATION_DECIMALS = 4;
/** What is nearer to 0, 1 or −1 than this is rounding: no table and no posture makes it. */
const ROUNDING = 1e-14;

/** @param {number} value */
function rotationNumber(value) {
  const whole = Math.round(value);
  return Math.abs(value - whole) < ROUNDING ? fixed(whole, 0) : fixed(value, ROTATION_DECIMALS);
}

/** @param {number} value in document units @param {Units['length']} unit */
const lengthNumber = (value, unit) => (value === 0 ? '0' : poseNumber(value, unit));

/**
 * @param {readonly (readonly number[])[]} rows  lengths in the document's units
 * @param {Units['length']} unit
 */
export const matrixTexts = (rows, unit) =>
  rows.map((row, i) => row.map((value, j) => (j === 3 && i < 3 ? lengthNumber(value, unit) : rotationNumber(value))));

export function createMatrix() {
  const cells = Array.from({ length: 4 }, () => Array.from({ length: 4 }, () => h('td', {})));
  const table = h(
    'table',
    { class: 'matrix' },
    h(
      'tbody',
      {},
      cells.map((row) => h('tr', {}, row)),
    ),
  );
  /** @type {string[]} */
  const shown = [];
  return {
    element: h('div', { class: 'matrix-box' }, table),
    /** @param {string} label @param {readonly (readonly string[])[]} texts */
    draw(label, texts) {
      if (table.getAttribute('aria-label') !== label) table.setAttribute('aria-label', label);
      texts.flat().forEach((text, k) => {
        if (shown[k] === text) return;
        const cell = cells[k >> 2][k & 3];
        cell.textContent = shown[k] = text;
        cell.classList.toggle('zero', text === '0');
      });
    },
  };
}
