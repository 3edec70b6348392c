/**
 * A camera, as marks need it that have their size on the screen: how much of the world a pixel is, and where the eye is.
 *
 * @import { OrthographicCamera } from 'three'
 *
 * @typedef {object} Eye
 * @property {OrthographicCamera | PerspectiveCamera} camera
 * @property {number} width   of the picture, pixels
 * @property {number} height
 * @property {(point: Vector3) => number} perPixel  metres, at that point
 * @property {(point: Vector3, out: Vector3) => Vector3} towards  a unit vector from the point to the eye
 * @property {(point: Vector3, out: Vector3) => Vector3} project  x and y in pixels, y down
 */
import { PerspectiveCamera, Vector3 } from 'three';
import { toRadians } from '../model/units.js';

/**
 * @param {OrthographicCamera | PerspectiveCamera} camera
 * @param {number} width
 * @param {number} height
 * @returns {Eye}
 */
export function eyeOf(camera, width, height) {
  camera.updateMatrixWorld();
  const back = new Vector3().setFromMatrixColumn(camera.matrixWorld, 2);
  const { position } = camera;
  const isPerspective = camera instanceof PerspectiveCamera;
  const high = isPerspective ? 2 * Math.tan(toRadians(camera.fov / 2)) : camera.top - camera.bottom;
  return {
    camera,
    width,
    height,
    perPixel(point) {
      if (!isPerspective) return high / height;
      const depth = position.dot(back) - point.dot(back);
      return (high * Math.max(depth, camera.near)) / height;
    },
    towards: (point, out) => (isPerspective ? out.copy(position).sub(point).normalize() : out.copy(back)),
    project(point, out) {
      out.copy(point).project(camera);
      return out.set(((out.x + 1) / 2) * width, ((1 - out.y) / 2) * height, out.z);
    },
  };
}
