/**
 * The user frames of the document, each with its name; the active one is larger and has letters.
 *
 * @import { MarkSet, MarkTools } from './marks.js'
 * @import { Pose } from '../../kinematics/pose.js'
 */
import { Vector3 } from 'three';
import { createMarkSet } from './markSet.js';
import { createTriad } from './triad.js';

const ARROW = { active: 0.1, idle: 0.06 }; // in sizes of the arm
const ORDER = 22;

/** @typedef {{ id: string, T_world_frame: Pose, isActive: boolean }} UserFrame */

/**
 * @param {MarkTools} tools
 * @returns {MarkSet & { want: (frames: readonly UserFrame[]) => void }}
 */
export const createUserFrames = (tools) =>
  createMarkSet(tools, /** @type {readonly UserFrame[]} */ ([]), ({ parts }, frames, skin) => {
    const { scene, labels } = tools;
    const remove = frames.map(({ id, T_world_frame, isActive }) => {
      const triad = createTriad({
        ...{ skin, labels, letterCase: /** @type {const} */ ('upper'), gap: 3 },
        width: isActive ? 2.25 : 1.5,
        letters: isActive ? '' : 'hidden',
        order: ORDER,
      });
      triad.show(T_world_frame, (isActive ? ARROW.active : ARROW.idle) * parts.size);
      triad.setVisible(true, isActive);
      const name = labels.add(isActive ? 'target frame-name is-active' : 'target frame-name');
      name.at = new Vector3(...T_world_frame.subarray(12, 15));
      name.gap = 8;
      name.yields = true;
      name.write(id);
      scene.add(triad.group);
      return () => (triad.dispose(), name.remove());
    });
    return { remove: () => remove.forEach((each) => each()) };
  });
