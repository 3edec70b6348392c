/**
 * The direction that a singularity takes, at the tool: a double arrow along which it cannot move, a ring about the axis about
 * which it cannot turn, and a word about each.
 *
 * @import { MarkSet, MarkTools } from './marks.js'
 * @import { Skin } from '../skins.js'
 */
import { Group, Vector3 } from 'three';
import { lostDirectionAt } from '../../model/aim/lostDirection.js';
import { disposeOf, fatLines, segmentsThrough } from '../fatLines.js';
import { createMarkSet } from './markSet.js';

const HALF = 0.17; // in sizes of the arm
const HEAD = { length: 0.035, width: 0.014 };
const RING = 0.085;
const CORNERS = 48;
const ORDER = 47;

/** @typedef {'stopped' | 'near' | null} LostWanted */

/**
 * @param {MarkTools & { text: { along: string, about: string } }} tools
 * @returns {MarkSet & { want: (wanted: LostWanted) => void }}
 */
export function createLostMark({ scene, labels, text, ...tools }) {
  /** @param {{ segments: number[], tip: Vector3 }} shape @param {Vector3} from @param {string} word @param {Skin} skin */
  function draw({ segments, tip }, from, word, skin) {
    const lines = fatLines(segments, { color: skin.bad, width: 3, order: ORDER });
    const group = new Group();
    group.add(lines);
    scene.add(group);
    const label = Object.assign(labels.add('miss'), { at: tip, from, gap: 8 });
    label.write(word);
    return () => (group.removeFromParent(), disposeOf(lines), label.remove());
  }

  return createMarkSet(
    tools,
    /** @type {LostWanted} */ (null),
    ({ chain, posture, T_base_tcp, parts }, wanted, skin) => {
      if (!wanted) return null;
      /** @type {(() => void)[]} */
      let drawn = [];
      function remove() {
        for (const each of drawn) each();
        drawn = [];
      }
      return {
        remove,
        /** Where the arm stands now, another direction may be lost, or none. */
        follow() {
          remove();
          const lost = lostDirectionAt(chain, posture, wanted === 'stopped');
          if (!lost) return;
          const at = new Vector3().fromArray(T_base_tcp, 12);
          if (lost.along) drawn.push(draw(arrow(at, new Vector3(...lost.along), parts.size), at, text.along, skin));
          if (lost.about) drawn.push(draw(ring(at, new Vector3(...lost.about), parts.size), at, text.about, skin));
        },
      };
    },
  );
}

/** Two unit vectors square to one. @param {Vector3} axis */
function across(axis) {
  const sizes = axis.toArray().map(Math.abs);
  const least = sizes.indexOf(Math.min(...sizes));
  const u = new Vector3().setComponent(least, 1).cross(axis).normalize();
  return [u, axis.clone().cross(u)];
}

/** Heads at both ends: it is lost to and fro. @param {Vector3} at @param {Vector3} along @param {number} size */
function arrow(at, along, size) {
  const point = (/** @type {number} */ far) => at.clone().addScaledVector(along, far * size);
  const segments = [...point(-HALF), ...point(HALF)];
  for (const side of across(along)) {
    for (const end of [-1, 1]) {
      for (const way of [-1, 1]) {
        const barb = point(end * (HALF - HEAD.length)).addScaledVector(side, way * HEAD.width * size);
        segments.push(...point(end * HALF), ...barb);
      }
    }
  }
  // the word stands at the end that is nearer to the arm, and so to the middle of the picture
  const ends = [point(HALF), point(-HALF)].sort((a, b) => a.length() - b.length());
  return { segments, tip: ends[0] };
}

/** The axis, and a ring about it. @param {Vector3} at @param {Vector3} about @param {number} size */
function ring(at, about, size) {
  const [u, v] = across(about);
  const points = Array.from({ length: CORNERS + 1 }, (_, i) => {
    const angle = (2 * Math.PI * i) / CORNERS;
    return at
      .clone()
      .addScaledVector(u, RING * size * Math.cos(angle))
      .addScaledVector(v, RING * size * Math.sin(angle))
      .toArray();
  });
  const ends = [-1, 1].map((end) => at.clone().addScaledVector(about, end * RING * size));
  return { segments: [...segmentsThrough(points), ...ends[0], ...ends[1]], tip: ends[1] };
}
