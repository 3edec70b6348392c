/**
 * What a drawing is made of, in sizes of the screen: lines from here to there, dash-dot axes with their names, arrowheads and
 * dots. Each is built once and laid anew before every picture.
 *
 * @import { Eye } from '../eye.js'
 * @import { Label } from '../labels.js'
 * @import { MarkTools } from './marks.js'
 * @import { Skin } from '../skins.js'
 */
import { Group, Matrix4, Mesh, MeshBasicMaterial, SphereGeometry, ConeGeometry, Vector3 } from 'three';
import { disposeOf, movableLine, spanLine } from '../fatLines.js';

const ORDER = 40;
const LONG = 15; // of a dash, pixels
const DOT = 2.5;
const GAP = 4;
const PERIOD = LONG + DOT + 2 * GAP;

/** @typedef {'x' | 'z' | 'accent'} Ink */

/** @param {MarkTools} tools */
export function createDrafting({ scene, skin, labels }) {
  const group = new Group();
  group.matrixAutoUpdate = false;
  scene.add(group);
  /** @type {(Mesh)[]} */
  const drawn = [];
  /** @type {Label[]} */
  const words = [];

  /** @template {Mesh} T @param {T} mesh @returns {T} */
  function add(mesh) {
    mesh.matrixAutoUpdate = false;
    mesh.frustumCulled = false;
    drawn.push(mesh);
    group.add(mesh);
    return mesh;
  }

  /** @param {string} color @param {number} order */
  const flat = (color, order) => {
    const mesh = add(
      new Mesh(undefined, new MeshBasicMaterial({ color, depthTest: false, depthWrite: false, transparent: true })),
    );
    mesh.renderOrder = order;
    return mesh;
  };

  return {
    group,
    add,

    /** @param {number} width @param {number} [opacity] */
    line(width, opacity = 1) {
      const line = add(movableLine({ color: skin.accent, width, opacity, order: ORDER }));
      return {
        line,
        /** @param {Vector3} from @param {Vector3} to */
        lay: (from, to) => spanLine(line, from.toArray(), to.toArray()),
      };
    },

    /** A centre line, dash and dot, with its name beyond its far end. @param {'x' | 'z'} name */
    axis(name) {
      const style = { color: skin[name], width: 1.4, order: ORDER - 6, dash: 1 };
      const lines = [movableLine(style), movableLine(style)].map(add);
      lines.forEach(({ material }, i) => {
        material.dashSize = i === 0 ? LONG : DOT;
        material.gapSize = PERIOD - material.dashSize;
        material.dashOffset = i === 0 ? 0 : -(LONG + GAP);
      });
      const label = labels.add(`axis axis-${name}`);
      Object.assign(label, { from: new Vector3(), gap: 4, yields: true });
      words.push(label);
      return {
        /** @param {Vector3} from @param {Vector3} to @param {number} perPixel @param {string} number */
        lay(from, to, perPixel, number) {
          const pixels = from.distanceTo(to) / perPixel;
          for (const line of lines) {
            spanLine(line, from.toArray(), to.toArray());
            line.material.dashScale = pixels; // as built, the line is one metre long
          }
          label.from?.copy(from);
          label.at.copy(to);
          label.visible = number !== '';
          label.write([[name, number]]);
        },
        /** @param {boolean} isVisible */
        show(isVisible) {
          for (const line of lines) line.visible = isVisible;
          if (!isVisible) label.visible = false;
        },
      };
    },

    arrowhead() {
      const mesh = flat(skin.accent, ORDER + 1);
      mesh.geometry = new ConeGeometry(0.27, 1, 20).translate(0, -0.5, 0).rotateX(Math.PI / 2); // its tip at nothing, along z
      const [x, y, turned] = [new Vector3(), new Vector3(), new Matrix4()];
      return {
        mesh,
        /** @param {Vector3} tip @param {Vector3} along  a unit vector @param {number} length metres */
        lay(tip, along, length) {
          x.set(-along.z, along.x, along.y).cross(along).normalize();
          y.crossVectors(along, x);
          turned.makeBasis(x, y, along);
          mesh.matrix
            .copy(turned)
            .scale(new Vector3(length, length, length))
            .setPosition(tip);
          mesh.matrixWorldNeedsUpdate = true;
        },
      };
    },

    /** @param {Ink} [ink] */
    dot(ink = 'accent') {
      const mesh = flat(skin[ink], ORDER + 1);
      mesh.geometry = new SphereGeometry(1, 16, 12);
      return {
        mesh,
        /** @param {Vector3} at @param {number} radius metres */
        lay(at, radius) {
          mesh.matrix.makeScale(radius, radius, radius).setPosition(at);
          mesh.matrixWorldNeedsUpdate = true;
        },
      };
    },

    words() {
      const label = Object.assign(labels.add('dim'), { from: new Vector3(), gap: 9, stays: true });
      words.push(label);
      return label;
    },

    dispose() {
      group.removeFromParent();
      drawn.forEach(disposeOf);
      words.forEach((label) => label.remove());
    },
  };
}

/** @typedef {ReturnType<typeof createDrafting>} Drafting */

/**
 * A length on the screen, in metres there, kept between two bounds in pixels.
 * @param {number} metres
 * @param {number} perPixel
 * @param {[number, number]} pixels
 */
export const within = (metres, perPixel, [least, most]) =>
  Math.max(least * perPixel, Math.min(most * perPixel, metres));

/** @param {Eye} eye @param {Vector3} axis @param {Vector3} at @returns {Vector3} square to the axis, and flat to the eye */
export function besideAxis(eye, axis, at) {
  const out = new Vector3().crossVectors(axis, eye.towards(at, new Vector3()));
  if (out.lengthSq() < 1e-6) out.set(-axis.z, axis.x, axis.y).cross(axis); // seen from its end, any side will do
  return out.normalize();
}
