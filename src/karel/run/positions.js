/**
 * Positions: frame arithmetic. R = Rz(r)·Ry(p)·Rx(w), angles in degrees, lengths in mm, as the controller has them.
 */
import { compose, invert } from '../../kinematics/pose.js';
import { poseFromRollPitchYaw, rollPitchYawOf } from '../../kinematics/orientation.js';
import { Alarm, single } from './values.js';

const DEGREE = Math.PI / (2 * 90);
export const radians = (/** @type {number} */ degrees) => degrees * DEGREE;
export const degrees = (/** @type {number} */ angle) => angle / DEGREE;

/** @param {readonly number[]} position x y z w p r … */
export const poseOf = ([x, y, z, w, p, r]) => poseFromRollPitchYaw([x, y, z], [w, p, r].map(radians));

/** @param {Float64Array} T @param {number} config */
export function positionOf(T, config) {
  const angles = rollPitchYawOf(T).map(degrees);
  return [T[12], T[13], T[14], ...angles, config, 0, 0, 0].map((value, i) => (i === 6 ? value : single(value)));
}

/** `frame : position` @param {readonly number[]} frame @param {readonly number[]} position */
export const composed = (frame, position) => positionOf(compose(poseOf(frame), poseOf(position)), position[6] ?? 0);

/** @param {readonly number[]} position */
export const inverted = (position) => positionOf(invert(poseOf(position)), position[6] ?? 0);

/** `position : vector` @param {readonly number[]} position @param {readonly number[]} vector */
export function transformed(position, [x, y, z]) {
  const T = poseOf(position);
  return [0, 1, 2].map((i) => single(T[i] * x + T[4 + i] * y + T[8 + i] * z + T[12 + i]));
}

export const cross = (/** @type {readonly number[]} */ a, /** @type {readonly number[]} */ b) =>
  [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]].map(single);
export const dot = (/** @type {readonly number[]} */ a, /** @type {readonly number[]} */ b) =>
  single(a[0] * b[0] + a[1] * b[1] + a[2] * b[2]);

/** The frame through three points: the origin, one on x, one in the xy plane; another origin may be given. @param {readonly number[][]} points */
export function frameOf([origin, onX, onXy, second = origin]) {
  const minus = (/** @type {number[]} */ a, /** @type {number[]} */ b) => [0, 1, 2].map((i) => a[i] - b[i]);
  const unit = (/** @type {number[]} */ v) => {
    const length = Math.hypot(...v);
    if (length < 1e-3) throw new Alarm('the points of FRAME lie on a line');
    return v.map((value) => value / length);
  };
  const x = unit(minus(onX, origin));
  const z = unit(cross(x, minus(onXy, origin)));
  const y = cross(z, x);
  return positionOf(Float64Array.from([...x, 0, ...y, 0, ...z, 0, second[0], second[1], second[2], 1]), 0);
}

/** The axis of a position: 0 NORMAL, 1 ORIENT, 2 APPROACH. @param {readonly number[]} position @param {number} axis */
export function axisOf(position, axis) {
  const T = poseOf(position);
  return [0, 1, 2].map((i) => single(T[4 * axis + i]));
}

/** The CONFIG word: three signed turn numbers and FLIP, LEFT, UP, FRONT. */
export const CONFIG_BITS = /** @type {Readonly<Record<string, number>>} */ ({
  CFG_FLIP: 24,
  CFG_LEFT: 25,
  CFG_UP: 26,
  CFG_FRONT: 27,
});

/** @param {string} source as 'N U T, 0, 0, 0' @returns {number | null} */
export function configOf(source) {
  const match =
    /^\s*([FN]?)\s*([LR]?)\s*([UD]?)\s*([TB]?)\s*(?:,\s*(-?\d+)\s*)?(?:,\s*(-?\d+)\s*)?(?:,\s*(-?\d+)\s*)?$/i.exec(
      source,
    );
  if (!match) return null;
  const [flip, left, up, front] = match.slice(1, 5).map((letter) => letter.toUpperCase());
  const turns = match.slice(5, 8).map((digits) => Number(digits ?? 0) & 255);
  const bits =
    (Number(flip === 'F') << 24) |
    (Number(left === 'L') << 25) |
    (Number(up === 'U') << 26) |
    (Number(front === 'T') << 27);
  return bits | turns[0] | (turns[1] << 8) | (turns[2] << 16);
}

/** @param {number} config */
export function configText(config) {
  const has = (/** @type {string} */ name) => ((config >> CONFIG_BITS[name]) & 1) === 1;
  const letters = [
    has('CFG_FLIP') ? 'F' : 'N',
    ...(has('CFG_LEFT') ? ['L'] : []),
    has('CFG_UP') ? 'U' : 'D',
    has('CFG_FRONT') ? 'T' : 'B',
  ];
  return `${letters.join(' ')}, ${[0, 8, 16].map((shift) => (config << (24 - shift)) >> 24).join(', ')}`;
}
