/**
 * The named targets of the document as small frames with their names.
 *
 * @import { ArmNow, MarkSet, MarkTools } from './marks.js'
 * @import { Pose } from '../kinematics/pose.js'
 */
import { Vector3 } from 'three';
import { createTriad } from './triad.js';

const ARROW = 0.035; // in sizes of the arm
const ORDER = 18;

/** @typedef {{ id: string, T_base_target: Pose }} NamedFrame */

/**
 * @param {MarkTools} tools
 * @returns {MarkSet & { want: (frames: readonly NamedFrame[]) => void }}
 */
export function createTargetFrames({ scene, skin, labels }) {
  /** @type {ArmNow | null} */
  let arm = null;
  /** @type {readonly NamedFrame[]} */
  let wanted = [];
  /** @type {(() => void)[]} */
  let remove = [];

  function clear() {
    for (const each of remove) each();
    remove = [];
  }

  function build() {
    clear();
    if (!arm) return;
    for (const { id, T_base_target } of wanted) {
      const triad = createTriad({
        skin,
        labels,
        width: 1.5,
        letters: 'hidden',
        letterCase: 'upper',
        gap: 3,
        order: ORDER,
      });
      triad.show(T_base_target, ARROW * arm.parts.size);
      triad.setVisible(true, false);
      const name = labels.add('target');
      name.at = new Vector3(...T_base_target.subarray(12, 15));
      name.gap = 6;
      name.yields = true;
      name.write(id);
      scene.add(triad.group);
      remove.push(() => (triad.dispose(), triad.group.removeFromParent(), name.remove()));
    }
  }

  return {
    show(next) {
      arm = next;
      build();
    },
    follow() {},
    clear,
    build,
    setSkin(next) {
      skin = next;
      build();
    },
    want(frames) {
      wanted = frames;
      build();
    },
  };
}
