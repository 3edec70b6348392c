/**
 * Where the picture is taken from. Pointer, wheel, touch and keys turn, move and zoom it. It flies only where it is sent, in
 * less than half a second, and not at all where a person wants no motion.
 *
 * One camera sees in perspective and is the one that is moved; the other follows it and sees in parallel, with what is looked
 * at just as large.
 *
 * @import { Vector3 as Vector } from 'three'
 * @import { Direction, Viewpoint, ViewName } from './viewpoint.js'
 * @import { Clock } from '../model/clock.js'
 */
import { OrthographicCamera, PerspectiveCamera, Vector3 } from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { toRadians } from '../model/units.js';
import { fitCamera, fitParallel } from './fit.js';
import { DIRECTIONS, axesOf, backwards, between } from './viewpoint.js';
import { viewKey } from './viewKeys.js';

const LENS = 24; // degrees, from top to bottom
const HALF_HEIGHT = Math.tan(toRadians(LENS / 2));
/** How much of the picture's width and height the points fill: the arm alone, or a part of it that is gone near to. */
const FILL = { whole: [0.8, 0.65], part: [0.95, 0.95] };
const LEAST_IN_VIEW = 0.4; // of the arm's size: a folded arm is not blown up beyond this
const FLIGHT = 0.35; // seconds

/** @typedef {{ left: number, top: number, width: number, height: number }} Rectangle  pixels, within the host */

/**
 * @param {HTMLElement} element  that hears pointer and keys
 * @param {object} given
 * @param {Clock} given.clock
 * @param {() => boolean} given.isCalm  whether the person wants no motion
 * @param {() => void} given.onChange
 * @param {(name: ViewName | null) => void} given.onLook  a key asks for a standard view, or for the whole arm as it is seen
 */
export function createView(element, { clock, isCalm, onChange, onLook }) {
  const camera = new PerspectiveCamera(LENS, 1, 0.01, 100);
  const parallel = new OrthographicCamera();
  camera.up.set(0, 0, 1);
  camera.position.set(1, -3, 1.2);
  const controls = new OrbitControls(camera, element);
  controls.enableDamping = false;
  controls.update();
  let width = 1;
  let height = 1;
  let isParallel = false;
  /** @type {Rectangle | null} */
  let free = null;
  let isUntouched = true; // since it was last fitted
  /** Counts what a flight would be overtaken by. */
  let course = 0;
  /** Where a flight goes to, until it is there. @type {Viewpoint | null} */
  let bound = null;
  const noticed = { position: new Vector3(), target: new Vector3() };
  controls.addEventListener('start', onTouch);
  controls.addEventListener('change', notice);
  // The controls find a step of a millimetre not worth a word; for an arm of 20 mm it is.
  const { ownerDocument } = element;
  controls.addEventListener('start', () => ownerDocument.addEventListener('pointermove', notice));
  controls.addEventListener('end', () => ownerDocument.removeEventListener('pointermove', notice));
  element.addEventListener('wheel', notice, { passive: true });
  element.addEventListener('keydown', onKey);

  function onTouch() {
    isUntouched = false;
    bound = null;
    course++;
  }

  function notice() {
    if (noticed.position.equals(camera.position) && noticed.target.equals(controls.target)) return;
    noticed.position.copy(camera.position);
    noticed.target.copy(controls.target);
    follow();
    onChange();
  }

  /** The camera that sees in parallel goes where the other one is. */
  function follow() {
    const high = camera.position.distanceTo(controls.target) * HALF_HEIGHT;
    const wide = (high * width) / height;
    Object.assign(parallel, { left: -wide, right: wide, top: high, bottom: -high, near: -camera.far, far: camera.far });
    parallel.position.copy(camera.position);
    parallel.quaternion.copy(camera.quaternion);
    parallel.updateProjectionMatrix();
  }

  /** Shift the picture so that what the camera looks at is in the middle of the free part. */
  function aim() {
    camera.aspect = width / height;
    for (const each of [camera, parallel]) {
      if (free) {
        const [x, y] = [free.left + free.width / 2 - width / 2, free.top + free.height / 2 - height / 2];
        each.setViewOffset(width, height, -x, -y, width, height);
      } else each.clearViewOffset();
    }
    camera.updateProjectionMatrix();
    follow();
  }

  /** @returns {Viewpoint} */
  function viewpoint() {
    const { x, y, z } = camera.position.clone().sub(controls.target);
    return {
      azimuth: Math.atan2(y, x),
      elevation: Math.atan2(z, Math.hypot(x, y)),
      distance: Math.hypot(x, y, z),
      target: controls.target.clone(),
    };
  }

  /** @param {Viewpoint} to */
  function stand({ target, distance, ...direction }) {
    controls.target.copy(target);
    camera.position.copy(backwards(direction)).multiplyScalar(distance).add(target);
    controls.update();
    notice();
  }

  /** @param {Viewpoint} to @param {boolean} flies */
  function goTo(to, flies) {
    const own = ++course;
    bound = flies && !isCalm() ? to : null;
    if (!bound) {
      stand(to);
      return;
    }
    const start = viewpoint();
    const begun = clock.now();
    const go = () => {
      if (own !== course) return;
      const share = (clock.now() - begun) / FLIGHT;
      stand(between(start, to, share));
      if (share < 1) clock.onFrame(go);
      else bound = null;
    };
    clock.onFrame(go);
  }

  /** @param {KeyboardEvent} event */
  function onKey(event) {
    if (event.ctrlKey || event.altKey || event.metaKey) return;
    const act = viewKey(event);
    if (!act) return;
    event.preventDefault();
    if ('look' in act) {
      onLook(act.look);
      return;
    }
    onTouch();
    const now = viewpoint();
    if ('zoom' in act) {
      const distance = Math.max(controls.minDistance, Math.min(controls.maxDistance, now.distance / act.zoom));
      stand({ ...now, distance });
    } else if ('turn' in act) {
      stand({ ...now, azimuth: now.azimuth + act.turn[0], elevation: now.elevation + act.turn[1] });
    } else {
      const { right, up } = axesOf(now);
      const step = now.distance * HALF_HEIGHT;
      now.target.addScaledVector(right, act.pan[0] * step).addScaledVector(up, act.pan[1] * step);
      stand(now);
    }
  }

  const view = {
    get camera() {
      return isParallel ? parallel : camera;
    },
    get isUntouched() {
      return isUntouched;
    },
    viewpoint,

    /** From there at once, as if by hand. One that sees nothing of the arm is no place. @param {Viewpoint} there */
    standAt(there) {
      if (there.target.length() > controls.maxDistance) return;
      onTouch();
      stand(there);
    },

    /** @param {boolean} seesParallel */
    project(seesParallel) {
      if (isParallel === seesParallel) return;
      isParallel = seesParallel;
      onChange();
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
      follow();
    },

    /**
     * The points in the middle of the free part of the view.
     * @param {readonly Vector[]} points
     * @param {number} size  of the arm
     * @param {object} how
     * @param {Rectangle | null} how.free  the whole view if null
     * @param {ViewName | Direction | null} how.from  as it is seen now, or will be after a flight, if null
     * @param {boolean} how.flies
     * @param {'whole' | 'part'} [how.fill]
     */
    fit(points, size, { free: freePart, from, flies, fill = 'whole' }) {
      free = freePart;
      view.scaleTo(size);
      aim();
      const part = free ?? { width, height };
      const tanX = (HALF_HEIGHT * FILL[fill][0] * part.width) / height;
      const tanY = (HALF_HEIGHT * FILL[fill][1] * part.height) / height;
      const direction = typeof from === 'string' ? DIRECTIONS[from] : (from ?? bound ?? viewpoint());
      const axes = axesOf(direction);
      const { x, y, z, depth } = (isParallel ? fitParallel : fitCamera)(points, axes, { tanX, tanY });
      const distance = Math.max(depth, fill === 'whole' ? (LEAST_IN_VIEW * size) / (2 * tanY) : 0);
      const target = new Vector3()
        .addScaledVector(axes.right, x)
        .addScaledVector(axes.up, y)
        .addScaledVector(axes.back, z - depth);
      const { azimuth, elevation } = direction;
      goTo({ azimuth, elevation, distance, target }, flies);
      isUntouched = true;
      onChange();
    },

    /** Whether all points are in the picture as it is, or will be after a flight. @param {readonly Vector[]} points */
    hasAll(points) {
      const { target, distance, azimuth, elevation } = bound ?? viewpoint();
      const { right, up, back } = axesOf({ azimuth, elevation });
      const middle = new Vector3().copy(target);
      const part = free ?? { width, height };
      return points.every((point) => {
        const from = new Vector3().copy(point).sub(middle);
        const depth = isParallel ? distance : distance - from.dot(back);
        const [x, y] = [Math.abs(from.dot(right)), Math.abs(from.dot(up))];
        const half = (HALF_HEIGHT * depth) / height;
        return depth > 0 && x <= half * part.width && y <= half * part.height;
      });
    },

    /** Whether it stands where no hand could take it: the arm is of a wholly other size than when it was last looked at. */
    get isOutOfRange() {
      const { distance } = bound ?? viewpoint();
      return distance < 0.99 * controls.minDistance || distance > 1.01 * controls.maxDistance;
    },

    /** What was free of the view when it was last fitted. */
    get free() {
      return free;
    },

    /** Back to where it once stood. @param {Viewpoint & { free: Rectangle | null }} to */
    returnTo({ free: freePart, ...to }) {
      free = freePart;
      aim();
      goTo(to, true);
      onChange();
      isUntouched = true;
    },

    dispose() {
      course++;
      element.removeEventListener('keydown', onKey);
      element.removeEventListener('wheel', notice);
      ownerDocument.removeEventListener('pointermove', notice);
      controls.dispose();
    },
  };
  return view;
}
