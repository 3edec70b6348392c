/**
 * What a key does to a tool that is taken: arrows and page keys move it along the axes, or turn it about them.
 *
 * @typedef {{ axis: number, steps: number }} ToolStep  in steps of a drag that snaps
 */

/** @type {Record<string, readonly [axis: number, sign: number]>} */
const KEYS = {
  ArrowRight: [0, 1],
  ArrowLeft: [0, -1],
  ArrowUp: [1, 1],
  ArrowDown: [1, -1],
  PageUp: [2, 1],
  PageDown: [2, -1],
};

const COARSE = 5;
const FINE = { move: 0.1, turn: 0.2 }; // 1 mm, 1°

/**
 * @param {{ key: string, shiftKey: boolean, altKey: boolean, ctrlKey: boolean, metaKey: boolean }} event
 * @param {'move' | 'turn'} does
 * @returns {ToolStep | null} null if the key is none of these
 */
export function toolStep({ key, shiftKey, altKey, ctrlKey, metaKey }, does) {
  if (!Object.hasOwn(KEYS, key) || metaKey) return null;
  const [axis, sign] = KEYS[key];
  const size = altKey || ctrlKey ? FINE[does] : shiftKey ? COARSE : 1;
  return { axis, steps: sign * size };
}
