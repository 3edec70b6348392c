/**
 * Where the tool is wanted: a small frame and, as long as the tool is elsewhere, a dashed line to it with what is missing.
 *
 * @import { LabelLayer } from './labels.js'
 * @import { Skin } from './skins.js'
 * @import { Pose } from '../kinematics/pose.js'
 */
import { Group, Vector3 } from 'three';
import { disposeOf, movableLine, spanLine } from './fatLines.js';
import { createTriad } from './triad.js';

const ARROW = 0.05; // in sizes of the arm
const DASH = 0.006;

/**
 * @param {object} options
 * @param {Pose} options.T_base_target
 * @param {boolean} options.reached
 * @param {number} options.size  of the arm
 * @param {Skin} options.skin
 * @param {LabelLayer} options.labels
 * @param {(metres: number) => string} options.missing
 */
export function createTargetMark({ T_base_target, reached, size, skin, labels, missing }) {
  const group = new Group();
  const triad = createTriad({ skin, labels, width: 2, letters: 'strong', letterCase: 'upper', gap: 3, order: 30 });
  triad.show(T_base_target, ARROW * size);
  triad.setVisible(true, !reached); // the tool's own letters are there then
  const way = movableLine({ color: skin.bad, width: 2.5, dash: DASH * size, order: 44 });
  const words = Object.assign(labels.add('miss'), { from: new Vector3(), gap: 6, aside: true });
  way.visible = words.visible = !reached;
  group.add(triad.group, way);
  const to = T_base_target.subarray(12, 15);

  return {
    group,
    /** @param {Pose} T_base_tcp */
    measureFrom(T_base_tcp) {
      if (reached) return;
      const from = T_base_tcp.subarray(12, 15);
      const distance = Math.hypot(to[0] - from[0], to[1] - from[1], to[2] - from[2]);
      spanLine(way, from, to);
      way.material.dashScale = distance; // as built, the line is one metre long
      words.from.fromArray(from);
      words.at.fromArray(to).add(words.from).multiplyScalar(0.5);
      words.write(missing(distance));
    },
    dispose() {
      group.removeFromParent();
      triad.dispose();
      disposeOf(way);
      words.remove();
    },
  };
}

/** @typedef {ReturnType<typeof createTargetMark>} TargetMark */
