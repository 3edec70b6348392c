/**
 * A frame as three arrows, always on top, with letters beyond their tips.
 *
 * @import { LabelLayer } from '../labels.js'
 * @import { Skin } from '../skins.js'
 */
import { BufferGeometry, Color, Float32BufferAttribute, Group, Mesh, MeshBasicMaterial, Vector3 } from 'three';
import { disposeOf, fatLines } from '../fatLines.js';
import { cone, solidOf } from '../arm/solid.js';

const AXES = /** @type {const} */ (['x', 'y', 'z']);
const HEAD = { length: 0.17, radius: 0.05 };

/** The head of the x arrow; the others are the same with the coordinates moved on. */
const ARROW = solidOf(cone(HEAD.radius, 0, 1 - HEAD.length, 1));

/**
 * @param {object} options
 * @param {Skin} options.skin
 * @param {LabelLayer} options.labels
 * @param {number} options.width    of the shafts, pixels
 * @param {string} options.letters  class names of the letters
 * @param {'lower' | 'upper'} options.letterCase
 * @param {string} [options.subscript]
 * @param {number} options.gap      from arrow tip to letter, pixels
 * @param {number} options.order    later is drawn over earlier
 */
export function createTriad({ skin, labels, width, letters, letterCase, subscript, gap, order }) {
  const group = new Group();
  group.matrixAutoUpdate = false;
  const shafts = AXES.flatMap((_, k) => [0, 0, 0, ...unit(k, 1 - HEAD.length * 0.9)]);
  const lines = fatLines(shafts, { colors: Array.from({ length: 18 }, () => 1), width, order });
  const heads = new Mesh(
    headGeometry(),
    new MeshBasicMaterial({ vertexColors: true, depthTest: false, depthWrite: false, transparent: true }),
  );
  heads.renderOrder = order + 1;
  heads.frustumCulled = false;
  group.add(lines, heads);
  const names = AXES.map((name, k) => {
    const label = labels.add(`axis axis-${name} ${letters}`.trim());
    const letter = letterCase === 'upper' ? name.toUpperCase() : name;
    label.write(subscript === undefined ? letter : [[letter, subscript]]);
    label.yields = true;
    label.parent = group;
    label.at.fromArray(unit(k, 1));
    label.from = new Vector3();
    label.gap = gap;
    return label;
  });

  /** @param {Skin} next */
  function setSkin(next) {
    const colours = AXES.map((name) => new Color(next[name]).toArray());
    lines.geometry.setColors(colours.flatMap((colour) => [...colour, ...colour]));
    const each = ARROW.positions.length / 3;
    const all = colours.flatMap((colour) => Array.from({ length: each }, () => colour).flat());
    heads.geometry.setAttribute('color', new Float32BufferAttribute(all, 3));
  }
  setSkin(skin);

  return {
    group,
    setSkin,
    /** @param {ArrayLike<number>} T  pose in the frame of the parent @param {number} length of the arrows */
    show(T, length) {
      group.matrix.fromArray(T).scale(new Vector3(length, length, length));
      group.matrixWorldNeedsUpdate = true;
    },
    /** @param {boolean} isVisible @param {boolean} [withLetters] */
    setVisible(isVisible, withLetters = isVisible) {
      group.visible = isVisible;
      for (const label of names) label.visible = withLetters;
    },
    /** The ends of the arrows. @returns {Vector3[]} */
    tips: () => AXES.map((_, k) => new Vector3().fromArray(unit(k, 1)).applyMatrix4(group.matrix)),
    dispose() {
      group.removeFromParent();
      disposeOf(lines);
      disposeOf(heads);
      for (const label of names) label.remove();
    },
  };
}

/** @param {number} k @param {number} length */
const unit = (k, length) => [0, 1, 2].map((i) => (i === k ? length : 0));

function headGeometry() {
  const { positions, indices } = ARROW;
  const each = positions.length / 3;
  const all = AXES.flatMap((_, k) => positions.map((_value, i) => positions[i - (i % 3) + ((i - (k + 1) + 6) % 3)]));
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new Float32BufferAttribute(all, 3));
  geometry.setIndex(AXES.flatMap((_, k) => indices.map((index) => index + k * each)));
  return geometry;
}
