/**
 * Where a picture is taken from, as numbers that can be kept and sent: azimuth and elevation in degrees, distance, what is looked
 * at (x, y, z) in metres, and how many times as wide as high the picture is.
 *
 * @import { Viewpoint } from './viewpoint.js'
 */
import { Vector3 } from 'three';
import { toDegrees, toRadians } from '../model/units.js';

/** @param {Viewpoint} viewpoint @param {number} aspect @returns {readonly number[]} */
export const cameraNumbers = ({ azimuth, elevation, distance, target }, aspect) => [
  ...[toDegrees(azimuth), toDegrees(elevation)],
  ...[distance, target.x, target.y, target.z, aspect],
];

/**
 * Everything that was seen is seen: where the picture is narrower, from farther away.
 * @param {readonly number[]} numbers
 * @param {number} aspect  of this picture
 * @returns {Viewpoint}
 */
export const fromCameraNumbers = ([azimuth, elevation, distance, x, y, z, before], aspect) => ({
  azimuth: toRadians(azimuth),
  elevation: toRadians(elevation),
  distance: distance * Math.max(1, before / aspect),
  target: new Vector3(x, y, z),
});
