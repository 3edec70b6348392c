/**
 * What a key asks of the view.
 * @import { ViewName } from './viewpoint.js'
 *
 * @typedef {{ look: ViewName | null } | { zoom: number } | { turn: [number, number] } | { pan: [number, number] }} ViewAct
 *   `look` null: the whole arm, from where it is seen; `turn` in radians; `pan` in half heights of the picture
 */
import { toRadians } from '../model/units.js';

const TURN = toRadians(5);
const ZOOM = 1.15;
const PAN = 0.1;

/** @type {Record<string, [number, number]>} */
const ARROWS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };

/** @type {Record<string, ViewName | null>} */
const LOOKS = {
  ...{ f: null, F: null, Home: 'home', 0: 'home' },
  ...{ 1: 'front', 2: 'back', 3: 'left', 4: 'right', 5: 'top', 6: 'bottom' },
};

/** @param {{ key: string, shiftKey: boolean }} event @returns {ViewAct | null} */
export function viewKey({ key, shiftKey }) {
  if (Object.hasOwn(LOOKS, key)) return { look: LOOKS[key] };
  if (key === '+' || key === '=') return { zoom: ZOOM };
  if (key === '-') return { zoom: 1 / ZOOM };
  if (!Object.hasOwn(ARROWS, key)) return null;
  const [x, y] = ARROWS[key];
  return shiftKey ? { pan: [x * PAN, y * PAN] } : { turn: [x * TURN, y * TURN] };
}
