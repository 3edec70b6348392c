/**
 * The points of a user frame while they are taught: each with its number, the way along X and to the side of Y, and the frame
 * that they make as soon as they make one.
 *
 * @import { MarkSet, MarkTools } from './marks.js'
 * @import { Taught } from '../../model/frames/threePoints.js'
 */
import { Group } from 'three';
import { frameFromPoints } from '../../model/frames/threePoints.js';
import { disposeOf, fatLines } from '../fatLines.js';
import { createMarkSet } from './markSet.js';
import { createTriad } from './triad.js';

const ARROW = 0.1; // in sizes of the arm, as of an active user frame
const DASH = 0.01; // likewise
const ORDER = 24;

/**
 * @param {MarkTools} tools
 * @returns {MarkSet & { want: (taught: Taught | null) => void }}
 */
export const createTaughtPoints = ({ scene, labels, ...tools }) =>
  createMarkSet(tools, /** @type {Taught | null} */ (null), ({ parts }, taught, skin) => {
    if (!taught) return null;
    const [origin, onX, onPlane] = taught;
    const group = new Group();
    const ways = [
      { to: onX, color: skin.x },
      { to: onPlane, color: skin.y },
    ].flatMap(({ to, color }) =>
      origin && to ? [fatLines([...origin, ...to], { color, width: 2, dash: DASH * parts.size, order: ORDER })] : [],
    );
    const numbers = taught.flatMap((point, i) => {
      if (!point) return [];
      const label = labels.add('taught');
      label.at.set(point[0], point[1], point[2]);
      label.write(String(i + 1));
      return [label];
    });
    const made = origin && onX && onPlane ? frameFromPoints([origin, onX, onPlane]) : null;
    const isMade = made !== null && 'T_world_frame' in made;
    const triad = createTriad({
      skin,
      labels,
      width: 2.5,
      letters: 'strong',
      letterCase: 'upper',
      gap: 4,
      order: ORDER,
    });
    if (isMade) triad.show(made.T_world_frame, ARROW * parts.size);
    triad.setVisible(isMade);
    group.add(...ways, triad.group);
    scene.add(group);
    return {
      remove() {
        group.removeFromParent();
        ways.forEach(disposeOf);
        triad.dispose();
        numbers.forEach((label) => label.remove());
      },
    };
  });
