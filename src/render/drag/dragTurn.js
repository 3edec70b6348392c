/**
 * A pointer that turns something about an axis. Seen well enough from above, the angle is the one between the pointer's
 * place in the plane across the axis and where it began; seen from the side, where that plane is a line, what is under the
 * pointer goes along its tangent on the screen.
 *
 * @import { Vector } from './dragRays.js'
 * @import { Sight } from '../sight.js'
 */
import { across, angleAbout, cross, dot, minus, plus, unwrap } from './dragRays.js';

/** The least sine between the line of sight and the plane across the axis, for the plane to be used. */
const FROM_ABOVE = 0.3;

const SMALL = 1e-4;

/**
 * @param {object} begin
 * @param {Vector} begin.centre  on the axis
 * @param {Vector} begin.axis    a unit vector
 * @param {Vector} begin.point   what was taken hold of
 * @param {Sight} begin.sight
 * @param {number} begin.x       pixels
 * @param {number} begin.y
 * @returns {(sight: Sight, x: number, y: number) => number | null}  the angle since then, over as many turns as it took
 */
export function beginTurn({ centre, axis, point, sight, x: x0, y: y0 }) {
  const zero = across(axis);
  // the plane goes through the point, so that the point stays under the pointer
  const middle = plus(centre, dot(axis, minus(point, centre)), axis);
  const start = angleAbout(sight.ray(x0, y0), middle, axis, zero);
  if (start !== null && Math.abs(dot(axis, sight.towards(point))) > FROM_ABOVE) {
    let last = start;
    return (now, x, y) => {
      const angle = angleAbout(now.ray(x, y), middle, axis, zero);
      if (angle === null) return null;
      last = unwrap(angle, last);
      return last - start;
    };
  }
  const tangent = cross(axis, minus(point, middle));
  const [from, to] = [sight.project(plus(point, -SMALL, tangent)), sight.project(plus(point, SMALL, tangent))];
  const [u, v] = [(to[0] - from[0]) / (2 * SMALL), (to[1] - from[1]) / (2 * SMALL)];
  const square = u * u + v * v;
  return (_, x, y) => (square < 1 ? null : ((x - x0) * u + (y - y0) * v) / square);
}
