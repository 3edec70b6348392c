/**
 * Positions: frame arithmetic. R = Rz(r)·Ry(p)·Rx(w), angles in degrees, lengths in mm, as the controller has them.
 *
 * @import { Machine } from './machine.js'
 */
import { compose, invert } from '../../kinematics/pose.js';
import { poseFromRollPitchYaw, rollPitchYawOf } from '../../kinematics/orientation.js';
import { Alarm, numbers, single } from './values.js';

const HALF_TURN = 2 * 90;
const DEGREE = Math.PI / HALF_TURN;
export const radians = (/** @type {number} */ degrees) => degrees * DEGREE;
export const degrees = (/** @type {number} */ angle) => angle / DEGREE;

/** A Cartesian position has ten numbers, one of joints an axis each, nine at most. @param {unknown} position */
export const isJoints = (position) => Array.isArray(position) && position.length < 10;

/**
 * A position as one of the kind that is wanted, by the arm's kinematics where they are at hand.
 * @param {unknown} position
 * @param {string} kind
 * @param {Machine} machine
 */
export function asPosition(position, kind, { host, state }) {
  const isJoint = isJoints(position);
  if (position === undefined || isJoint === (kind === 'JOINTPOS')) return position;
  const given = numbers(position);
  if (!host.kinematics)
    throw new Alarm(
      'joints and Cartesian positions become each other by the kinematics of an arm, of which nothing is known here',
      'kinematics',
    );
  const found = isJoint
    ? host.kinematics.toPosition(given, state.system)
    : host.kinematics.toJoints(given, state.system);
  if (!found) throw new Alarm('the arm has no posture at this position', 'kinematics');
  return isJoint ? [...found.map((value, i) => (i === 6 ? value : single(value))), 0, 0, 0] : found.map(single);
}

/** @param {readonly number[]} position x y z w p r … */
export const poseOf = ([x, y, z, w, p, r]) => poseFromRollPitchYaw([x, y, z], [w, p, r].map(radians));

/** Half a turn about z is -180, about x 180, in what public suites expect of controllers. @param {Float64Array} T @param {number} config */
export function positionOf(T, config) {
  const [w, p, r] = rollPitchYawOf(T).map((angle) => single(degrees(angle)));
  const place = [T[12], T[13], T[14]].map(single);
  return [...place, w === -HALF_TURN ? HALF_TURN : w, p, r === HALF_TURN ? -HALF_TURN : r, config, 0, 0, 0];
}

/** `frame : position` @param {readonly number[]} frame @param {readonly number[]} position */
export const composed = (frame, position) => positionOf(compose(poseOf(frame), poseOf(position)), position[6] ?? 0);

/** @param {readonly number[]} position */
export const inverted = (position) => positionOf(invert(poseOf(position)), position[6] ?? 0);

/** By the manuals' words, which no controller has confirmed: in a frame's xz plane; the tool's y axis is turned round, so that it stays a right hand's. @param {readonly number[]} position @param {readonly number[]} frame @param {boolean} turns */
export function mirrored(position, frame, turns) {
  const T_frame = poseOf(frame);
  const T = compose(invert(T_frame), poseOf(position));
  T[13] = -T[13];
  if (turns) for (const i of [1, 4, 6, 9]) T[i] = -T[i];
  const whole = positionOf(compose(T_frame, T), position[6] ?? 0);
  return turns ? whole : [...whole.slice(0, 3), ...position.slice(3)];
}

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

/** The letters of a configuration, two of a kind; they are met in any order. */
const LETTERS = ['FN', 'LR', 'UD', 'TB'];

/** @param {string} source as 'N U T, 0, 0, 0' @returns {number | null} */
export function configOf(source) {
  const [letters, ...turns] = source.split(',').map((part) => part.trim());
  const given = letters.toUpperCase().split(/\s*/).filter(Boolean);
  const kinds = given.map((letter) => LETTERS.findIndex((kind) => kind.includes(letter)));
  if (kinds.includes(-1) || new Set(kinds).size < kinds.length) return null;
  if (turns.length > 3 || !turns.every((turn) => /^-?\d+$/.test(turn))) return null;
  return (
    given.reduce((bits, letter) => bits | (Number('FLUT'.includes(letter)) << (24 + 'FLUT'.indexOf(letter))), 0) |
    turns.reduce((bits, turn, i) => bits | ((Number(turn) & 255) << (8 * i)), 0)
  );
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
