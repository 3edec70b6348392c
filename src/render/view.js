/**
 * Where the picture is taken from. Pointer, wheel, touch and keys turn, move and zoom it; nothing moves by itself.
 *
 * @import { Vector3 as Vector } from 'three'
 */
import { PerspectiveCamera, Vector3 } from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { toRadians } from '../model/units.js';
import { fitCamera } from './fit.js';

const LENS = 24; // degrees, from top to bottom
const HALF_HEIGHT = Math.tan(toRadians(LENS / 2));
const FROM_FRONT_RIGHT = toRadians(-68); // azimuth, from x
const SLIGHTLY_ABOVE = toRadians(19);
const STEEPEST = toRadians(89.5);
const FILL_HEIGHT = 0.65;
const FILL_WIDTH = 0.8;
const KEY_TURN = toRadians(5);
const KEY_ZOOM = 1.15;
const LEAST_IN_VIEW = 0.4; // of the arm's size: a folded arm is not blown up beyond this

/** @typedef {{ left: number, top: number, width: number, height: number }} Rectangle  pixels, within the host */

/**
 * @param {HTMLElement} element  that hears pointer and keys
 * @param {{ onChange: () => void, onFit: () => void }} on
 */
export function createView(element, { onChange, onFit }) {
  const camera = new PerspectiveCamera(LENS, 1, 0.01, 100);
  camera.up.set(0, 0, 1);
  camera.position.set(1, -3, 1.2);
  const controls = new OrbitControls(camera, element);
  controls.enableDamping = false;
  controls.update();
  let width = 1;
  let height = 1;
  /** @type {Rectangle | null} */
  let free = null;
  let isUntouched = true; // since it was last fitted
  controls.addEventListener('change', onChange);
  controls.addEventListener('start', () => (isUntouched = false));
  element.addEventListener('keydown', onKey);

  /** Shift the picture so that what the camera looks at is in the middle of the free part. */
  function aim() {
    camera.aspect = width / height;
    if (free) {
      const [x, y] = [free.left + free.width / 2 - width / 2, free.top + free.height / 2 - height / 2];
      camera.setViewOffset(width, height, -x, -y, width, height);
    } else camera.clearViewOffset();
    camera.updateProjectionMatrix();
  }

  /** @returns {{ azimuth: number, elevation: number, distance: number }} */
  function direction() {
    const { x, y, z } = camera.position.clone().sub(controls.target);
    return { azimuth: Math.atan2(y, x), elevation: Math.atan2(z, Math.hypot(x, y)), distance: Math.hypot(x, y, z) };
  }

  /** @param {{ azimuth: number, elevation: number, distance: number }} from */
  function lookFrom({ azimuth, elevation, distance }) {
    const steepness = Math.max(-STEEPEST, Math.min(STEEPEST, elevation));
    camera.position.copy(backwards(azimuth, steepness)).multiplyScalar(distance).add(controls.target);
    controls.update();
  }

  /** @param {KeyboardEvent} event */
  function onKey(event) {
    if (event.ctrlKey || event.altKey || event.metaKey) return;
    const { azimuth, elevation, distance } = direction();
    const [x, y] = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[event.key] ?? [0, 0];
    if (event.key === 'f' || event.key === 'F' || event.key === 'Home') onFit();
    else if (event.key === '+' || event.key === '=') view.zoomBy(KEY_ZOOM);
    else if (event.key === '-') view.zoomBy(1 / KEY_ZOOM);
    else if ((x || y) && event.shiftKey) pan(x, y, distance);
    else if (x || y) lookFrom({ azimuth: azimuth + x * KEY_TURN, elevation: elevation + y * KEY_TURN, distance });
    else return;
    if (event.key !== 'Home' && event.key.toLowerCase() !== 'f') isUntouched = false;
    event.preventDefault();
  }

  /** @param {number} x @param {number} y @param {number} distance */
  function pan(x, y, distance) {
    const step = 0.1 * distance * HALF_HEIGHT;
    const by = new Vector3().setFromMatrixColumn(camera.matrix, 0).multiplyScalar(x * step);
    by.addScaledVector(new Vector3().setFromMatrixColumn(camera.matrix, 1), y * step);
    camera.position.add(by);
    controls.target.add(by);
    controls.update();
  }

  const view = {
    camera,
    get isUntouched() {
      return isUntouched;
    },

    /** @param {number} w @param {number} h */
    resize(w, h) {
      [width, height] = [w, h];
      aim();
    },

    /**
     * Near and far enough for an arm of this size, and no farther.
     * @param {number} size
     */
    scaleTo(size) {
      camera.near = 0.02 * size;
      camera.far = 60 * size;
      controls.minDistance = 0.15 * size;
      controls.maxDistance = 20 * size;
      camera.updateProjectionMatrix();
    },

    /**
     * Look from front right, slightly above, with the points in the middle of the free part of the view.
     * @param {readonly Vector[]} points
     * @param {number} size  of the arm
     * @param {Rectangle | null} freePart  the whole view if null
     */
    fit(points, size, freePart) {
      free = freePart;
      view.scaleTo(size);
      aim();
      const part = freePart ?? { width, height };
      const tanX = (HALF_HEIGHT * FILL_WIDTH * part.width) / height;
      const tanY = (HALF_HEIGHT * FILL_HEIGHT * part.height) / height;
      const back = backwards(FROM_FRONT_RIGHT, SLIGHTLY_ABOVE);
      const right = new Vector3(0, 0, 1).cross(back).normalize();
      const up = back.clone().cross(right);
      const { x, y, z, depth } = fitCamera(points, { right, up, back }, { tanX, tanY });
      const distance = Math.max(depth, (LEAST_IN_VIEW * size) / (2 * tanY));
      controls.target
        .set(0, 0, 0)
        .addScaledVector(right, x)
        .addScaledVector(up, y)
        .addScaledVector(back, z - depth);
      lookFrom({ azimuth: FROM_FRONT_RIGHT, elevation: SLIGHTLY_ABOVE, distance });
      isUntouched = true;
      onChange();
    },

    /** @param {number} factor  above 1 goes nearer */
    zoomBy(factor) {
      const from = direction();
      const distance = Math.max(controls.minDistance, Math.min(controls.maxDistance, from.distance / factor));
      lookFrom({ ...from, distance });
    },

    dispose() {
      element.removeEventListener('keydown', onKey);
      controls.dispose();
    },
  };
  return view;
}

/** From what is looked at towards the camera. @param {number} azimuth @param {number} elevation */
const backwards = (azimuth, elevation) =>
  new Vector3(Math.cos(elevation) * Math.cos(azimuth), Math.cos(elevation) * Math.sin(azimuth), Math.sin(elevation));
