/**
 * Where the tool is wanted while a part of its handle is dragged: the pose at which it was taken, moved along an axis, in a
 * plane, across the line of sight, or turned about an axis.
 *
 * @import { HandlePart } from './handleParts.js'
 * @import { Vector } from './dragRays.js'
 * @import { Sight } from '../sight.js'
 *
 * @typedef {(sight: Sight, x: number, y: number, snaps: boolean) => Float64Array | null} GoalAt
 *   null where the pointer tells nothing
 */
import { poseFromRotationVector } from '../../kinematics/orientations/axisAngle.js';
import { compose } from '../../kinematics/pose.js';
import { alongAxis, dot, minus, onPlane, plus, snap } from './dragRays.js';
import { beginTurn } from './dragTurn.js';

/**
 * @param {object} begin
 * @param {HandlePart} begin.part
 * @param {Float64Array} begin.T_world_tcp
 * @param {readonly Vector[]} begin.axes  unit vectors
 * @param {Vector} begin.point     on the part: what was taken hold of
 * @param {number} begin.farthest  m; a pointer near the horizon asks for no more
 * @param {{ metres: number, radians: number }} begin.step  of a drag that snaps
 * @param {Sight} begin.sight
 * @param {number} begin.x
 * @param {number} begin.y
 * @returns {GoalAt | null} null if the part cannot be dragged as it is seen
 */
export function beginGoal({ part, T_world_tcp, axes, point, farthest, step, sight, x, y }) {
  const { kind, axis: k } = part;
  const centre = [...T_world_tcp.subarray(12, 15)];
  /** @param {Vector} by */
  const moved = (by) => {
    const length = Math.hypot(...by);
    const share = length > farthest ? farthest / length : 1;
    const T = T_world_tcp.slice();
    for (let i = 0; i < 3; i++) T[12 + i] += by[i] * share;
    return T;
  };

  if (kind === 'turn') {
    const axis = axes[k];
    const turnTo = beginTurn({ centre, axis, point, sight, x, y });
    return (now, px, py, snaps) => {
      const angle = turnTo(now, px, py);
      return angle === null ? null : turned(T_world_tcp, axis, snaps ? snap(angle, step.radians) : angle);
    };
  }
  if (kind === 'move') {
    const start = alongAxis(sight.ray(x, y), centre, axes[k]);
    if (start === null) return null;
    return (now, px, py, snaps) => {
      const at = alongAxis(now.ray(px, py), centre, axes[k]);
      if (at === null) return null;
      const way = at - start;
      return moved(plus([0, 0, 0], snaps ? snap(way, step.metres) : way, axes[k]));
    };
  }
  const normal = kind === 'plane' ? axes[k] : sight.towards(centre);
  const start = onPlane(sight.ray(x, y), centre, normal);
  if (start === null) return null;
  return (now, px, py, snaps) => {
    const at = onPlane(now.ray(px, py), centre, normal);
    if (at === null) return null;
    const way = minus(at, start);
    return moved(snaps ? snappedAlong(way, axes, step.metres) : way);
  };
}

/**
 * Turned about an axis through its own origin.
 * @param {Float64Array} T
 * @param {Vector} axis  a unit vector
 * @param {number} angle
 */
export function turned(T, axis, angle) {
  const R = poseFromRotationVector([0, 0, 0], axis.map((value) => value * angle)); // prettier-ignore
  const next = compose(R, T);
  next.set(T.subarray(12, 15), 12);
  return next;
}

/** In whole steps along each of the axes. @param {Vector} way @param {readonly Vector[]} axes @param {number} step */
const snappedAlong = (way, axes, step) =>
  axes.reduce((/** @type {Vector} */ sum, axis) => plus(sum, snap(dot(way, axis), step), axis), [0, 0, 0]);
