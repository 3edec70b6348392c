/**
 * How wide the left panel may be, without a page.
 * @import { Tab } from '../model/session.js'
 */

const LEAST = 340;
const MOST = 720;
const SHARE_OF_VIEW = 0.38;
const STEP = 16;

/** @type {readonly Tab[]} */
const TABS = ['robot', 'program', 'code', 'workspace', 'jacobian'];

/**
 * @param {number} page   px, likewise all that follows
 * @param {number} right  the width of the right panel
 */
export const withinEdge = (page, right) => ({
  least: LEAST,
  most: Math.round(Math.min(MOST, Math.max(LEAST, page * (1 - SHARE_OF_VIEW) - right))),
});

/**
 * @param {Pick<KeyboardEvent, 'key' | 'shiftKey'>} pressed
 * @param {number} width
 * @param {{ least: number, most: number }} limits
 * @returns {number | null | undefined} null: its own width; undefined: the key is not for the edge
 */
export function widthAfterKey({ key, shiftKey }, width, { least, most }) {
  const step = shiftKey ? 4 * STEP : STEP;
  switch (key) {
    case 'ArrowLeft':
      return width - step;
    case 'ArrowRight':
      return width + step;
    case 'Home':
      return least;
    case 'End':
      return most;
    case 'Enter':
      return null;
    default:
      return undefined;
  }
}

/**
 * What was remembered; anything may stand there.
 * @param {string | null} text
 * @returns {Partial<Record<Tab, number>>}
 */
export function readWidths(text) {
  /** @type {unknown} */
  let kept = null;
  try {
    kept = JSON.parse(text ?? 'null');
  } catch {
    // not ours
  }
  if (typeof kept !== 'object' || kept === null) return {};
  const entries = Object.entries(kept).filter(
    ([tab, width]) => TABS.some((name) => name === tab) && typeof width === 'number' && width >= LEAST && width <= MOST,
  );
  return Object.fromEntries(entries);
}
