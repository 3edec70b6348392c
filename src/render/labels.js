/**
 * Words and letters over the scene, as HTML in the page's own fonts: sharp at any size, and not for screen readers, which
 * hear the same from the panels. The page's stylesheet dresses them: `.scene-labels` holds `.tag`s with a class for what
 * they say: `axis axis-x`, `axis axis-x strong` (and y, z), `dim`, `tick`, `miss`, `target`, `dot`.
 *
 * @import { Camera, Object3D } from 'three'
 */
import { Vector3 } from 'three';

/**
 * @typedef {object} Label
 * @property {Vector3} at      where, in the frame of `parent`
 * @property {Object3D | null} parent
 * @property {Vector3 | null} from    if there is one, the label's edge is `gap` pixels beyond `at`, seen from there
 * @property {number} gap
 * @property {boolean} aside          not beyond `at` but beside it, on the upper side
 * @property {boolean} visible
 * @property {(text: string, subscript?: string) => void} write
 * @property {() => void} remove
 */

/** @typedef {{ add: (className: string) => Label }} LabelLayer  all that marks need to know of it */

/**
 * @param {HTMLElement} host
 * @returns {LabelLayer & { place: (camera: Camera, width: number, height: number) => void, dispose: () => void }}
 */
export function createLabels(host) {
  const layer = document.createElement('div');
  layer.className = 'scene-labels';
  layer.setAttribute('aria-hidden', 'true');
  Object.assign(layer.style, { position: 'absolute', inset: '0', overflow: 'hidden', pointerEvents: 'none' });
  host.append(layer);
  /** @type {Map<Label, HTMLElement>} */
  const elements = new Map();
  const point = new Vector3();
  const away = new Vector3();

  /** @param {Vector3} local @param {Object3D | null} parent @param {Camera} camera @param {Vector3} out */
  function project(local, parent, camera, out) {
    out.copy(local);
    if (parent) out.applyMatrix4(parent.matrixWorld);
    return out.project(camera);
  }

  return {
    add(className) {
      const element = document.createElement('span');
      element.className = `tag ${className}`;
      Object.assign(element.style, { position: 'absolute', left: '0', top: '0', whiteSpace: 'nowrap' });
      layer.append(element);
      let written = '';
      /** @type {Label} */
      const label = {
        at: new Vector3(),
        parent: null,
        from: null,
        gap: 0,
        aside: false,
        visible: true,
        write(text, subscript) {
          if (written === `${text}_${subscript}`) return;
          written = `${text}_${subscript}`;
          if (subscript === undefined) {
            element.textContent = text;
            return;
          }
          const letter = document.createElement('i');
          const below = document.createElement('sub');
          letter.textContent = text;
          below.textContent = subscript;
          element.replaceChildren(letter, below);
        },
        remove() {
          element.remove();
          elements.delete(label);
        },
      };
      elements.set(label, element);
      return label;
    },

    place(camera, width, height) {
      for (const [{ at, parent, from, gap, aside, visible }, { style }] of elements) {
        project(at, parent, camera, point);
        const isSeen = visible && point.z < 1;
        const display = isSeen ? '' : 'none';
        if (style.display !== display) style.display = display;
        if (!isSeen) continue;
        const x = ((point.x + 1) / 2) * width;
        const y = ((1 - point.y) / 2) * height;
        let [east, south] = [0, 0];
        if (from) {
          project(from, parent, camera, away);
          const [dx, dy] = [x - ((away.x + 1) / 2) * width, y - ((1 - away.y) / 2) * height];
          const distance = Math.hypot(dx, dy) || 1;
          [east, south] = aside ? [dy / distance, -Math.abs(dx) / distance] : [dx / distance, dy / distance];
          if (aside && dx < 0) east = -east;
        }
        // percentages are of the label's own size: its centre, moved half its size in the direction it keeps away
        const [left, top] = [(x + gap * east).toFixed(1), (y + gap * south).toFixed(1)];
        style.transform = `translate(${left}px, ${top}px) translate(${(50 * (east - 1)).toFixed(0)}%, ${(50 * (south - 1)).toFixed(0)}%)`;
      }
    },

    dispose: () => layer.remove(),
  };
}
