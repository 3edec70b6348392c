/**
 * The part of a plane that a drawing shows: its middle, in metres, and how many pixels a metre is.
 *
 * @import { SectionPlane, TracedSection } from './mapped.js'
 *
 * @typedef {{ u: number, v: number, scale: number }} Window
 * @typedef {{ u: readonly [number, number], v: readonly [number, number] }} Box
 */
import { isCellReached, isWithin } from './sectionShape.js';

/** About what is shown, as a share of it. */
const MARGIN = 0.06;

/** Pixels of a metre: from a drawing of a kilometre to one of a hundredth of a millimetre. */
const SCALE = { least: 0.1, most: 1e8 };

/** @param {number} scale */
const within = (scale) => Math.min(SCALE.most, Math.max(SCALE.least, scale));

/** All of a box. @param {Box} box @param {{ width: number, height: number }} size  pixels @returns {Window} */
export function windowAround({ u, v }, { width, height }) {
  const scale = Math.min(width / (u[1] - u[0]), height / (v[1] - v[0])) * (1 - MARGIN);
  return { u: (u[0] + u[1]) / 2, v: (v[0] + v[1]) / 2, scale: within(Number.isFinite(scale) ? scale : 1) };
}

/** What is at a place stays there. @param {Window} window @param {number} factor @param {{ u: number, v: number }} about @returns {Window} */
export function zoomWindow({ u, v, scale }, factor, about) {
  const next = within(scale * factor);
  const share = scale / next;
  return { u: about.u + (u - about.u) * share, v: about.v + (v - about.v) * share, scale: next };
}

/** What was at one place is at another then. @param {Window} window @param {{ u: number, v: number }} from @param {{ u: number, v: number }} to @returns {Window} */
export const moveWindow = ({ u, v, scale }, from, to) => ({ u: u + from.u - to.u, v: v + from.v - to.v, scale });

/** Multiples of a step. @param {number} middle @param {number} width @param {number} step */
export function ticksWithin(middle, width, step) {
  const first = Math.ceil((middle - width / 2) / step);
  const last = Math.floor((middle + width / 2) / step);
  return Array.from({ length: Math.max(0, last - first + 1) }, (_, i) => (first + i) * step + 0); // no −0
}

/**
 * Whether a place is reached: by the outlines, which know it best, and as the cells say where there are none.
 * @param {SectionPlane & Partial<Pick<TracedSection, 'outlines'>>} section
 * @param {number} u
 * @param {number} v
 */
export function isInside({ cells, outlines }, u, v) {
  if (!outlines) return isCellReached(cells, u, v);
  return outlines.filter(({ places }) => isWithin(places, u, v)).length % 2 === 1;
}
