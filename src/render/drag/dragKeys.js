/**
 * What a key does to a tool that is taken: arrows move it in a plane of the axes and page keys across that plane; or they turn
 * it about the axes.
 *
 * @typedef {{ axis: number, steps: number }} ToolStep  in steps of a drag that snaps
 */

/** Of the plane across axis k: the axis of the arrows to the right and left, then of those up and down. */
export const IN_PLANE = /** @type {const} */ ([
  [1, 2],
  [0, 2],
  [0, 1],
]);

/** The plane after this one: XY, YZ, XZ. @param {number} across */
export const nextPlane = (across) => (across + 1) % 3;

/** @type {Record<string, readonly [way: 0 | 1 | 'across', sign: number]>} */
const KEYS = {
  ArrowRight: [0, 1],
  ArrowLeft: [0, -1],
  ArrowUp: [1, 1],
  ArrowDown: [1, -1],
  PageUp: ['across', 1],
  PageDown: ['across', -1],
};

/** Turns are about X, Y and Z whatever plane the arrows move in. */
const OF_TURNS = 2;

const COARSE = 5;
const FINE = { move: 0.1, turn: 0.2 }; // 1 mm, 1°

/**
 * @param {{ key: string, shiftKey: boolean, altKey: boolean, ctrlKey: boolean, metaKey: boolean }} event
 * @param {'move' | 'turn'} does
 * @param {number} across  the axis across the plane of the arrows
 * @returns {ToolStep | null} null if the key is none of these
 */
export function toolStep({ key, shiftKey, altKey, ctrlKey, metaKey }, does, across) {
  if (!Object.hasOwn(KEYS, key) || metaKey) return null;
  const [way, sign] = KEYS[key];
  const plane = does === 'turn' ? OF_TURNS : across;
  const size = altKey || ctrlKey ? FINE[does] : shiftKey ? COARSE : 1;
  return { axis: way === 'across' ? plane : IN_PLANE[plane][way], steps: sign * size };
}
