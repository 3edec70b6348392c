/**
 * Targets that need not be typed: the tool straight down, the tool looking at a point, the same place turned as the tool is now.
 *
 * @import { RobotDoc } from '../document.js'
 * @import { Chain } from '../../kinematics/chain.js'
 */
import { tcpPose } from '../../kinematics/forward.js';
import { compilePosture } from '../compile.js';

/** Directions that differ by less are one; sines. */
const SAME = 1e-9;

/** The tool's pose in a posture of the document. @param {RobotDoc} robot @param {Chain} chain @param {readonly number[]} posture */
export const tcpAt = (robot, chain, posture) => tcpPose(chain, compilePosture(robot, posture));

/**
 * The pose at the same place, its z axis along a direction, turned no farther than that takes.
 * @param {Float64Array} T
 * @param {readonly number[]} direction  any length but zero
 * @returns {Float64Array}
 */
export function pointedAlong(T, direction) {
  const length = Math.hypot(...direction);
  if (!(length > 0)) return T.slice();
  const to = direction.map((value) => value / length);
  const z = [T[8], T[9], T[10]];
  const axis = [z[1] * to[2] - z[2] * to[1], z[2] * to[0] - z[0] * to[2], z[0] * to[1] - z[1] * to[0]];
  const sine = Math.hypot(...axis);
  const cosine = z[0] * to[0] + z[1] * to[1] + z[2] * to[2];
  const result = T.slice();
  if (sine < SAME) {
    // along it already; or the other way round, and then the x axis stays
    if (cosine < 0) for (const k of [4, 5, 6, 8, 9, 10]) result[k] = -T[k];
    return withZ(result, to);
  }
  const u = axis.map((value) => value / sine);
  for (const column of [0, 4]) {
    const v = [T[column], T[column + 1], T[column + 2]];
    const across = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
    const along = (u[0] * v[0] + u[1] * v[1] + u[2] * v[2]) * (1 - cosine);
    for (const k of [0, 1, 2]) result[column + k] = cosine * v[k] + sine * across[k] + along * u[k];
  }
  return withZ(result, to);
}

/** With exactly this z axis, and x and y made square to it again. @param {Float64Array} T @param {readonly number[]} z */
function withZ(T, z) {
  const x = [T[0], T[1], T[2]];
  const part = x[0] * z[0] + x[1] * z[1] + x[2] * z[2];
  const square = x.map((value, k) => value - part * z[k]);
  const length = Math.hypot(...square);
  const [a, b, c] = square.map((value) => value / length);
  T.set([a, b, c], 0);
  T.set([z[1] * c - z[2] * b, z[2] * a - z[0] * c, z[0] * b - z[1] * a], 4);
  T.set(z, 8);
  return T;
}

/** The tool straight down, where it is. @param {Float64Array} T */
export const toolDown = (T) => pointedAlong(T, [0, 0, -1]);

/**
 * The tool's z axis at a point, from where the tool is.
 * @param {Float64Array} T
 * @param {readonly number[]} point  m
 * @returns {Float64Array | null} null if the tool is at the point, and no direction is one to it
 */
export function lookingAt(T, point) {
  const direction = point.map((value, k) => value - T[12 + k]);
  return Math.hypot(...direction) > SAME ? pointedAlong(T, direction) : null;
}

/** The place of one, the orientation of another. @param {Float64Array} T_place @param {Float64Array} T_turn */
export function turnedAs(T_place, T_turn) {
  const result = T_turn.slice();
  result.set(T_place.subarray(12, 15), 12);
  return result;
}

/**
 * @param {Float64Array | null} T_world_from  null: the world itself
 * @param {readonly number[]} point  seen from that frame, m
 */
export const pointInWorld = (T_world_from, point) => {
  const T = T_world_from;
  return T ? [0, 1, 2].map((i) => T[i] * point[0] + T[4 + i] * point[1] + T[8 + i] * point[2] + T[12 + i]) : point;
};

/** A right angle comes out of sines and cosines with a rounding error, which nobody has asked for. @param {number} value  in document units */
export const tidy = (value) => Number(value.toFixed(10)) + 0; // + 0: no minus zero
