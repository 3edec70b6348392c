/**
 * The line between the two points where the arm is nearest to something, with the distance beside it; where they touch, a dot
 * that says so.
 *
 * @import { MarkSet, MarkTools } from './marks.js'
 *
 * @typedef {{ readonly points: readonly [Float64Array, Float64Array], readonly text: string, readonly isTouching: boolean } | null} ClearanceWanted
 */
import { Group } from 'three';
import { createMarkSet } from './markSet.js';
import { disposeOf, fatLines } from '../fatLines.js';

const WIDTH = { apart: 2, touching: 12 };
const ORDER = 44;
const NEXT_TO_NOTHING = 1e-4; // of the arm's size: a dot is a line of next to no length, which has round ends

/**
 * @param {MarkTools} tools
 * @returns {MarkSet & { want: (wanted: ClearanceWanted) => void }}
 */
export function createClearanceMark(tools) {
  const { scene, labels } = tools;
  return createMarkSet(tools, /** @type {ClearanceWanted} */ (null), (arm, wanted, skin) => {
    if (!wanted) return null;
    const { points, text, isTouching } = wanted;
    const [from, to] = points;
    const color = isTouching ? skin.bad : skin.ink;
    const dot = (/** @type {Float64Array} */ at) => [...at, at[0], at[1], at[2] + NEXT_TO_NOTHING * arm.parts.size];
    const lines = isTouching
      ? [fatLines(dot(to), { color, width: WIDTH.touching, order: ORDER })]
      : [
          fatLines([...from, ...to], { color, width: WIDTH.apart, order: ORDER }),
          fatLines([...dot(from), ...dot(to)], { color, width: 3 * WIDTH.apart, order: ORDER }),
        ];
    const group = new Group();
    group.add(...lines);
    scene.add(group);
    const label = Object.assign(labels.add(isTouching ? 'miss' : 'clearance'), { gap: 10, yields: true, stays: true });
    label.at.set(...middle(from, to));
    label.write(text);
    return {
      remove() {
        group.removeFromParent();
        lines.forEach(disposeOf);
        label.remove();
      },
    };
  });
}

/** @param {Float64Array} a @param {Float64Array} b @returns {[number, number, number]} */
const middle = (a, b) => [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2];
