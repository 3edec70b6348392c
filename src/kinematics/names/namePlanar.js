/**
 * The elbow of an arm that works in one plane: two or more turning axes, all parallel (a planar arm, a SCARA).
 *
 * @import { Line, Vector } from '../lines.js'
 *
 * @typedef {object} PlanarArm
 * @property {number} first    the joint that turns the upper arm, from 0
 * @property {number} second   the joint of the elbow
 * @property {number} sense    of it, against the first: 1 or −1
 * @property {number} aim      the direction of the upper arm against level at joint value 0, about the first axis
 * @property {number} bend     the angle of the forearm against the upper arm at joint value 0
 * @property {number} upper    m
 * @property {number} fore     m
 * @property {boolean} isUpright  whether the plane stands, so that the elbow is up or down and not right or left
 * @property {number} side     1 if the first axis points up, −1 if down
 */
import { along, cross, dot, minus, norm, squareTo, unit } from '../lines.js';

/** Directions that differ by less (radians) are one, and so are points (arm lengths). */
const SAME = 1e-9;

/** The plane stands if its normal is nearer to level than to upright. */
const HALF_WAY = Math.SQRT1_2;

/**
 * @param {readonly Line[]} lines
 * @param {Vector} tcp
 * @param {number} length
 * @param {ArrayLike<number>} up
 * @returns {PlanarArm | null}
 */
export function planarArm(lines, tcp, length, up) {
  const turning = lines.flatMap(({ slides }, i) => (slides ? [] : [i]));
  const [first, second, third] = turning;
  if (second === undefined) return null;
  const axis = lines[first].axis;
  const isSquare = (/** @type {Line} */ line, /** @type {number} */ i) =>
    norm(cross(axis, line.axis)) < SAME || (line.slides && i < first);
  if (!lines.every(isSquare)) return null;
  const hand = third === undefined ? tcp : lines[third].point;
  const flat = (/** @type {Vector} */ v) => along(v, -dot(v, axis), axis);
  const upperArm = flat(minus(lines[second].point, lines[first].point));
  const forearm = flat(minus(hand, lines[second].point));
  const [upper, fore] = [norm(upperArm), norm(forearm)];
  if (upper < SAME * length || fore < SAME * length) return null;
  const height = dot(axis, up);
  const isUpright = Math.abs(height) < HALF_WAY;
  const level = isUpright ? unit(cross(/** @type {Vector} */ (Array.from(up)), axis)) : squareTo(axis)[0];
  return {
    first,
    second,
    sense: Math.sign(dot(axis, lines[second].axis)),
    aim: Math.atan2(dot(axis, cross(level, upperArm)), dot(level, upperArm)),
    bend: Math.atan2(dot(axis, cross(upperArm, forearm)), dot(upperArm, forearm)),
    upper,
    fore,
    isUpright,
    side: Math.sign(height),
  };
}
