/**
 * A pose that is wanted: a small frame there and, as long as the tool is elsewhere, a dashed line to it with what is missing.
 * The target is marked so, and what a drag asks for and the arm cannot do.
 *
 * @import { LabelLayer } from '../labels.js'
 * @import { Skin } from '../skins.js'
 */
import { Color, Group, Vector3 } from 'three';
import { disposeOf, movableLine, spanLine } from '../fatLines.js';
import { createTriad } from './triad.js';

const DASH = 0.006; // in sizes of the arm

/**
 * @param {object} options
 * @param {Skin} options.skin
 * @param {LabelLayer} options.labels
 * @param {(metres: number) => string} options.missing
 * @param {number} options.arrow  in sizes of the arm
 * @param {number} options.gap    from line to words, pixels
 * @param {number} options.order  later is drawn over earlier
 * @param {number} [options.least]  nearer than this no line is drawn; in sizes of the arm
 */
export function createWantedPose({ skin, labels, missing, arrow, gap, order, least = 0 }) {
  const group = new Group();
  const triad = createTriad({ skin, labels, width: 2, letters: 'strong', letterCase: 'upper', gap: 3, order });
  const way = movableLine({ color: skin.bad, width: 2.5, dash: 1, order: 44 });
  const words = Object.assign(labels.add('miss'), { from: new Vector3(), gap, aside: true, stays: true });
  group.add(triad.group, way);
  /** @type {ArrayLike<number> | null} */
  let T = null;
  let distance = NaN;
  let isMissed = false;

  /** @param {boolean} isSeen */
  const showWay = (isSeen) => (way.visible = words.visible = isSeen);
  triad.setVisible(false);
  showWay(false);

  return {
    group,

    /**
     * @param {ArrayLike<number> | null} T_world_wanted  null: nothing is wanted
     * @param {{ isMissed: boolean, hasLetters: boolean }} how
     */
    want(T_world_wanted, how) {
      T = T_world_wanted;
      isMissed = how.isMissed;
      triad.setVisible(T !== null, T !== null && how.hasLetters);
      if (!T || !isMissed) showWay(false);
    },

    /** @param {ArrayLike<number>} T_world_tcp @param {number} size  of the arm, m */
    measureFrom(T_world_tcp, size) {
      if (!T) return;
      triad.show(T, arrow * size);
      if (!isMissed) return;
      const [from, to] = [T_world_tcp, T].map((pose) => [pose[12], pose[13], pose[14]]);
      distance = Math.hypot(to[0] - from[0], to[1] - from[1], to[2] - from[2]);
      showWay(distance >= least * size);
      spanLine(way, from, to);
      way.material.dashSize = way.material.gapSize = DASH * size;
      way.material.dashScale = distance; // as built, the line is one metre long
      words.from.fromArray(from);
      words.at.fromArray(to).add(words.from).multiplyScalar(0.5);
      words.write(missing(distance));
    },

    /** Ask for the words again. */
    rewrite() {
      if (words.visible) words.write(missing(distance));
    },

    /** @param {Skin} next */
    setSkin(next) {
      triad.setSkin(next);
      way.material.color = new Color(next.bad);
    },

    dispose() {
      group.removeFromParent();
      triad.dispose();
      disposeOf(way);
      words.remove();
    },
  };
}

/** @typedef {ReturnType<typeof createWantedPose>} WantedPose */
