/**
 * What a pointer sees: lines of sight through pixels, and pixels of points.
 *
 * @import { Eye } from './eye.js'
 * @import { Ray, Vector } from './drag/dragRays.js'
 *
 * @typedef {object} Sight
 * @property {(x: number, y: number) => Ray} ray  pixels, y down
 * @property {(point: Vector) => [number, number]} project
 * @property {(point: Vector) => number[]} towards  a unit vector from the point to the eye
 * @property {(point: Vector) => number} perPixel   metres, there
 */
import { Vector3 } from 'three';

/** @param {Eye} eye @returns {Sight} */
export function sightOf({ camera, width, height, perPixel, towards, project }) {
  const a = new Vector3();
  const b = new Vector3();
  return {
    ray(x, y) {
      const [u, v] = [(2 * x) / width - 1, 1 - (2 * y) / height];
      a.set(u, v, -1).unproject(camera);
      b.set(u, v, 1).unproject(camera).sub(a).normalize();
      return { from: a.toArray(), along: b.toArray() };
    },
    project(point) {
      project(a.fromArray([...point]), b);
      return [b.x, b.y];
    },
    towards: (point) => towards(a.fromArray([...point]), b).toArray(),
    perPixel: (point) => perPixel(a.fromArray([...point])),
  };
}
