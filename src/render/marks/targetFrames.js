/**
 * The named targets of the document as small frames with their names.
 *
 * @import { MarkTools } from './marks.js'
 * @import { Pose } from '../../kinematics/pose.js'
 */
import { Vector3 } from 'three';
import { createMarkSet } from './markSet.js';
import { createTriad } from './triad.js';

const ARROW = 0.035; // in sizes of the arm
const ORDER = 18;

/** @typedef {{ id: string, T_base_target: Pose }} NamedFrame */

/** @param {MarkTools} tools */
export function createTargetFrames(tools) {
  const { scene, labels } = tools;
  const style = /** @type {const} */ ({ width: 1.5, letters: 'hidden', letterCase: 'upper', gap: 3, order: ORDER });
  return createMarkSet(tools, /** @type {readonly NamedFrame[]} */ ([]), (arm, wanted, skin) => {
    const drawn = wanted.map(({ id, T_base_target }) => {
      const triad = createTriad({ skin, labels, ...style });
      triad.show(T_base_target, ARROW * arm.parts.size);
      triad.setVisible(true, false);
      const name = labels.add('target');
      name.at = new Vector3(...T_base_target.subarray(12, 15));
      name.gap = 6;
      name.yields = true;
      name.write(id);
      scene.add(triad.group);
      return { triad, name };
    });
    return {
      remove() {
        for (const { triad, name } of drawn) {
          triad.dispose();
          name.remove();
        }
      },
    };
  });
}
