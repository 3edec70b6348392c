/**
 * The ghost of a pose that is wanted and not reached: a small frame there, and a dashed line from the tool with what is missing.
 *
 * @import { LabelLayer } from './labels.js'
 * @import { Skin } from './skins.js'
 * @import { Scene } from 'three'
 */
import { Color, Vector3 } from 'three';
import { movableLine, spanLine } from './fatLines.js';
import { createTriad } from './triad.js';

const ARROW = 0.045; // in sizes of the arm
const DASH = 0.006;
const LEAST = 0.004; // nearer than this no line is drawn

/** @param {{ scene: Scene, skin: Skin, labels: LabelLayer, missing: (metres: number) => string }} options */
export function createHandleGhost({ scene, skin, labels, missing }) {
  const triad = createTriad({ skin, labels, width: 2, letters: 'strong', letterCase: 'upper', gap: 3, order: 46 });
  const way = movableLine({ color: skin.bad, width: 2.5, dash: 1, order: 44 });
  const words = Object.assign(labels.add('miss'), { from: new Vector3(), gap: 8, aside: true, visible: false });
  scene.add(triad.group, way);
  triad.setVisible(false);
  way.visible = false;
  /** @type {Float64Array | null} */
  let T = null;
  let distance = NaN;

  return {
    /** @param {Float64Array | null} T_world_goal  null: no ghost */
    want(T_world_goal) {
      T = T_world_goal;
      triad.setVisible(T !== null, false);
      if (!T) way.visible = words.visible = false;
    },

    /** @param {Float64Array} T_world_tcp @param {number} size  of the arm, m */
    measureFrom(T_world_tcp, size) {
      if (!T) return;
      triad.show(T, ARROW * size);
      const [from, to] = [T_world_tcp, T].map((pose) => [...pose.subarray(12, 15)]);
      distance = Math.hypot(to[0] - from[0], to[1] - from[1], to[2] - from[2]);
      way.visible = words.visible = distance > LEAST * size;
      if (!way.visible) return;
      spanLine(way, from, to);
      way.material.dashSize = way.material.gapSize = DASH * size;
      way.material.dashScale = distance; // as built, the line is one metre long
      words.from.fromArray(from);
      words.at.fromArray(to).add(words.from).multiplyScalar(0.5);
      words.write(missing(distance));
    },

    rewrite() {
      if (words.visible) words.write(missing(distance));
    },

    /** @param {Skin} next */
    setSkin(next) {
      triad.setSkin(next);
      way.material.color = new Color(next.bad);
    },
  };
}
