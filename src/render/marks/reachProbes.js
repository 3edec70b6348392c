/**
 * Places that were asked for, with what they are called, the lines between them, and traces of single joints.
 *
 * @import { MarkSet, MarkTools } from './marks.js'
 * @import { ReachShown } from '../../model/workspace/asked.js'
 */
import { Group } from 'three';
import { disposeOf, fatLines } from '../fatLines.js';
import { createMarkSet } from './markSet.js';

const ORDER = 22;
const WIDTH = { trace: 2.5, way: 3, missing: 2 };
const DASH = 0.012; // in sizes of the arm

/** Labels of more places would be a cloud. */
const MOST_LABELS = 60;

/**
 * @param {MarkTools} tools
 * @returns {MarkSet & { want: (shown: readonly (ReachShown | null)[]) => void }}
 */
export const createReachProbes = ({ scene, labels, ...tools }) =>
  createMarkSet(tools, /** @type {readonly (ReachShown | null)[]} */ ([]), ({ parts }, wanted, skin) => {
    const shown = wanted.filter((one) => one !== null);
    if (shown.length === 0) return null;
    const color = { trace: skin.trace, way: skin.accent, missing: skin.accent };
    const group = new Group();
    const lines = shown
      .flatMap((one) => one.lines)
      .filter(({ points }) => points.length > 3)
      .map(({ points, kind }) => {
        const dash = kind === 'missing' ? DASH * parts.size : 0;
        return fatLines(segments(points), { color: color[kind], width: WIDTH[kind], dash, order: ORDER });
      });
    const tags = shown
      .flatMap((one) => one.points)
      .slice(0, MOST_LABELS)
      .map(({ at, text, isReached }) => {
        const label = labels.add(isReached ? 'reach-point' : 'reach-point is-out');
        label.at.set(at[0], at[1], at[2]);
        label.write(text);
        return label;
      });
    if (lines.length > 0) group.add(...lines);
    scene.add(group);
    return {
      remove() {
        group.removeFromParent();
        lines.forEach(disposeOf);
        tags.forEach((label) => label.remove());
      },
    };
  });

/** A line through points as the segments that make it. @param {Float64Array} points */
function segments(points) {
  const ends = [];
  for (let k = 3; k < points.length; k += 3) ends.push(...points.subarray(k - 3, k), ...points.subarray(k, k + 3));
  return ends;
}
