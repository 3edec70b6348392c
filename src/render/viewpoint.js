/**
 * Where a picture may be taken from: directions with names, and the way from one to another.
 *
 * @import { Vector3 as Vector } from 'three'
 *
 * @typedef {{ azimuth: number, elevation: number }} Direction  from what is looked at to the camera, radians; azimuth from x
 * @typedef {Direction & { distance: number, target: Vector }} Viewpoint
 * @typedef {'home' | 'front' | 'back' | 'left' | 'right' | 'top' | 'bottom'} ViewName
 */
import { Vector3 } from 'three';
import { toRadians } from '../model/units.js';

/** Straight down the world's z a camera would not know where up is. */
export const STEEPEST = Math.PI / 2 - 1e-5;

/** @param {number} azimuth @param {number} elevation @returns {Direction} */
const from = (azimuth, elevation) => ({ azimuth: toRadians(azimuth), elevation: toRadians(elevation) });

/** Front is from −y, so that x goes to the right; the others follow as on a drawing. @type {Record<ViewName, Direction>} */
export const DIRECTIONS = {
  home: from(-68, 19), // from front right, slightly above
  front: from(-90, 0),
  back: from(90, 0),
  left: from(180, 0),
  right: from(0, 0),
  top: from(-90, 90),
  bottom: from(-90, -90),
};

/** @param {Direction} direction @returns {Vector} a unit vector towards the camera */
export function backwards({ azimuth, elevation }) {
  const steep = Math.max(-STEEPEST, Math.min(STEEPEST, elevation));
  return new Vector3(Math.cos(steep) * Math.cos(azimuth), Math.cos(steep) * Math.sin(azimuth), Math.sin(steep));
}

/** @param {Direction} direction */
export function axesOf(direction) {
  const back = backwards(direction);
  const right = new Vector3(0, 0, 1).cross(back).normalize();
  return { right, up: back.clone().cross(right), back };
}

/**
 * A share of the way between two, gently at both ends; turning the shorter way.
 * @param {Viewpoint} a
 * @param {Viewpoint} b
 * @param {number} share  0 … 1
 * @returns {Viewpoint}
 */
export function between(a, b, share) {
  if (share >= 1) return b;
  const eased = share * share * (3 - 2 * share);
  const turn = b.azimuth - a.azimuth;
  const shorter = turn - 2 * Math.PI * Math.round(turn / (2 * Math.PI));
  return {
    azimuth: a.azimuth + eased * shorter,
    elevation: a.elevation + eased * (b.elevation - a.elevation),
    distance: a.distance * (b.distance / a.distance) ** eased,
    target: a.target.clone().lerp(b.target, eased),
  };
}
