/**
 * Where the tool is wanted: a small frame and, as long as the tool is elsewhere, a dashed line to it with what is missing.
 *
 * @import { LabelLayer } from './labels.js'
 * @import { Skin } from './skins.js'
 */
import { Group, Vector3 } from 'three';
import { disposeOf, movableLine, spanLine } from './fatLines.js';
import { createTriad } from './triad.js';

/** @typedef {ReturnType<typeof createTargetMark>} TargetMark */

/**
 * @param {object} options
 * @param {Skin} options.skin
 * @param {LabelLayer} options.labels
 * @param {(metres: number) => string} options.missing
 */
export function createTargetMark({ skin, labels, missing }) {
  const group = new Group();
  const triad = createTriad({ skin, labels, width: 2, letters: 'strong', letterCase: 'upper', gap: 3, order: 30 });
  const way = movableLine({ color: skin.bad, width: 2.5, dash: 1, order: 44 });
  const words = Object.assign(labels.add('miss'), { from: new Vector3(), gap: 6, aside: true });
  group.add(triad.group, way);

  return {
    group,
    /** @param {Skin} next */
    setSkin(next) {
      triad.setSkin(next);
      way.material.color.set(next.bad);
    },
    /** @param {Float64Array} T_base_target @param {number} size  of the arm */
    place(T_base_target, size) {
      triad.show(T_base_target, 0.05 * size);
      way.material.dashSize = way.material.gapSize = 0.006 * size;
    },
    /**
     * @param {Float64Array} T_base_target
     * @param {Float64Array} T_base_tcp
     * @param {boolean} reached
     */
    measure(T_base_target, T_base_tcp, reached) {
      const [from, to] = [T_base_tcp.subarray(12, 15), T_base_target.subarray(12, 15)];
      const distance = Math.hypot(to[0] - from[0], to[1] - from[1], to[2] - from[2]);
      way.visible = words.visible = !reached;
      triad.setVisible(true, !reached); // the tool's own letters are there then
      if (reached) return;
      spanLine(way, from, to);
      way.material.dashScale = distance; // as built, the line is one metre long
      words.at.set((from[0] + to[0]) / 2, (from[1] + to[1]) / 2, (from[2] + to[2]) / 2);
      words.from.fromArray(from);
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
