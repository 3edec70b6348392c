/**
 * Words and letters over the scene, as HTML in the page's own fonts: sharp at any size, and not for screen readers, which
 * hear the same from the panels. The page's stylesheet dresses them: `.scene-labels` holds `.tag`s with a class for what
 * they say: `axis axis-x`, `axis axis-x strong` (and y, z), `dim`, `tick`, `miss`, `target`, `dot`.
 *
 * @import { Camera, Object3D } from 'three'
 */
import { Vector3 } from 'three';
import { inside, roomFor, withinPicture } from './labelRoom.js';

const SAME_PLACE = 48; // pixels

/**
 * Text, and symbols as a letter with its index.
 * @typedef {readonly (string | readonly [letter: string, index: string])[]} LabelText
 *
 * @typedef {object} Label
 * @property {Vector3} at      where, in the frame of `parent`
 * @property {Object3D | null} parent
 * @property {Vector3 | null} from    if there is one, the label's edge is `gap` pixels beyond `at`, seen from there
 * @property {number} gap
 * @property {boolean} aside          not beyond `at` but beside it, on the upper side
 * @property {boolean} visible
 * @property {boolean} yields         it may go farther out or aside, not to lie on another
 * @property {boolean} stays          inside what is free of the picture; beside a line that leaves it, where the line does
 * @property {(text: string | LabelText) => void} write
 * @property {() => void} remove
 */

/** @typedef {{ add: (className: string) => Label }} LabelLayer  all that marks need to know of it */

/** @typedef {{ left: number, top: number, width: number, height: number }} Free  of the picture, from its left upper corner on */

/**
 * @param {HTMLElement} host
 * @returns {LabelLayer & { place: (camera: Camera, width: number, height: number, free?: Free | null) => void, dispose: () => void }}
 */
export function createLabels(host) {
  const layer = document.createElement('div');
  layer.className = 'scene-labels';
  layer.setAttribute('aria-hidden', 'true');
  Object.assign(layer.style, { position: 'absolute', inset: '0', overflow: 'hidden', pointerEvents: 'none' });
  host.append(layer);
  /** @type {Map<Label, { element: HTMLElement, text: string, width: number, height: number }>} sizes are 0 until asked for */
  const tags = new Map();
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
      // not to be seen before it has its place, which it gets with the next picture
      Object.assign(element.style, {
        position: 'absolute',
        left: '0',
        top: '0',
        whiteSpace: 'nowrap',
        display: 'none',
      });
      layer.append(element);
      const tag = { element, text: '', width: 0, height: 0 };
      /** @type {Label} */
      const label = {
        at: new Vector3(),
        parent: null,
        from: null,
        gap: 0,
        aside: false,
        visible: true,
        yields: false,
        stays: false,
        write(text) {
          const all = JSON.stringify(text);
          if (tag.text === all) return;
          tag.text = all;
          tag.width = 0;
          const parts = typeof text === 'string' ? [text] : text;
          element.replaceChildren(...parts.flatMap(nodesOf));
        },
        remove() {
          element.remove();
          tags.delete(label);
        },
      };
      tags.set(label, tag);
      return label;
    },

    place(camera, width, height, free = null) {
      const room = free ? [free.left + free.width, free.top + free.height] : [width, height];
      const seen = [...tags].filter(([{ visible, at, parent }, { element }]) => {
        const isSeen = visible && Math.abs(project(at, parent, camera, point).z) < 1;
        const display = isSeen ? '' : 'none';
        if (element.style.display !== display) element.style.display = display;
        return isSeen;
      });
      // all that is measured before anything is moved, or the browser would lay out the page for each
      for (const [, tag] of seen) {
        if (tag.width === 0) [tag.width, tag.height] = [tag.element.offsetWidth, tag.element.offsetHeight];
      }
      const places = seen.map(([{ at, parent, from, gap, aside, yields, stays }, size]) => {
        project(at, parent, camera, point);
        let x = ((point.x + 1) / 2) * width;
        let y = ((1 - point.y) / 2) * height;
        let [east, south] = [0, 0];
        if (from) {
          project(from, parent, camera, away);
          const [fromX, fromY] = [((away.x + 1) / 2) * width, ((1 - away.y) / 2) * height];
          if (aside && stays) [x, y] = withinPicture(fromX, fromY, x, y, room[0], room[1]);
          const [dx, dy] = [x - fromX, y - fromY];
          const distance = Math.hypot(dx, dy) || 1;
          [east, south] = aside ? [dy / distance, -Math.abs(dx) / distance] : [dx / distance, dy / distance];
          if (aside && dx < 0) east = -east;
        }
        return { x, y, east, south, gap, yields, width: size.width, height: size.height };
      });
      roomFor(places).forEach((box, i) => {
        const [{ stays }, { element, text }] = seen[i];
        // the same name twice in one place, of a frame and of an axis of it, is said once
        const isSaid =
          places[i].yields && seen.some(([, other], k) => k < i && other.text === text && near(places[k], places[i]));
        element.style.display = isSaid ? 'none' : '';
        const { left, top } = stays ? inside(box, room[0], room[1]) : box;
        element.style.transform = `translate(${left.toFixed(1)}px, ${top.toFixed(1)}px)`;
      });
    },

    dispose: () => layer.remove(),
  };
}

/** @param {{ x: number, y: number }} a @param {{ x: number, y: number }} b */
const near = (a, b) => Math.hypot(a.x - b.x, a.y - b.y) < SAME_PLACE;

/** @param {LabelText[number]} part @returns {(string | HTMLElement)[]} */
function nodesOf(part) {
  if (typeof part === 'string') return [part];
  const letter = document.createElement('i');
  const below = document.createElement('sub');
  [letter.textContent, below.textContent] = part;
  return [letter, below];
}
