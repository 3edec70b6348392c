/**
 * What the decimals of a target leave open: each of its numbers may be off by as much as rounding takes it, one way or the other.
 * Seen as what it does to the tool (a twist: its place, then its turn) or to the joints.
 *
 * @import { Chain } from '../../kinematics/chain.js'
 * @import { NeutralTarget } from '../../karel/write/neutral.js'
 * @import { RobotDoc } from '../document.js'
 */
import { DECIMALS, rounded, ROUNDING } from '../../karel/write/neutral.js';
import { geometricJacobian } from '../../kinematics/jacobian.js';
import { isSliding } from '../document.js';
import { postureFromKernel } from '../compile.js';
import { toKernel } from '../units.js';
import { pendantValues } from './controllerValues.js';

const UNITS = /** @type {const} */ ({ length: 'mm', angle: 'deg' });

/** REAL and the controller's own numbers have 24 bits. @param {number} value */
const single = (value) => Math.abs(value) * 2 ** -24;

/** A last decimal that goes the other way, to the inside of a limit or beside a singular posture, is off by less than this. */
const OTHER_WAY = 1.5 * 10 ** -DECIMALS;

/**
 * Of joint values: changes of the posture, rad and m.
 * @param {RobotDoc} robot
 * @param {NeutralTarget} target
 * @param {Float64Array} q   the posture that they are of
 * @returns {Float64Array[]}
 */
export function looseJoints(robot, target, q) {
  const exact = pendantValues(robot, postureFromKernel(robot, q));
  return robot.joints.map((joint, i) => {
    // a taught posture may have other turns
    const written = Math.abs(rounded(target.joints[i]) - exact[i]);
    const off = (written < OTHER_WAY ? Math.max(written, ROUNDING) : ROUNDING) + single(exact[i]);
    // joints that are counted with this one go the other way, for their numbers stay
    return Float64Array.from(robot.joints, (other, k) => {
      const { sign, coupledTo, coupling } = other.controller;
      const share = k === i ? 1 : coupledTo === joint.id ? -coupling : 0;
      return toKernel(isSliding(other) ? 'length' : 'angle', sign * share * off, UNITS);
    });
  });
}

/**
 * Of x y z w p r: twists of the tool, m and rad.
 * @param {NeutralTarget} target
 * @param {Float64Array} T_base_user
 * @returns {Float64Array[]}
 */
export function loosePosition({ position }, T_base_user) {
  const [, , , , p, r] = position.map((value) => toKernel('angle', value, UNITS));
  // z, then y turned by R, then x turned by R and P
  const turned = [
    [Math.cos(r) * Math.cos(p), Math.sin(r) * Math.cos(p), -Math.sin(p)],
    [-Math.sin(r), Math.cos(r), 0],
    [0, 0, 1],
  ];
  return position.slice(0, 6).map((value, i) => {
    const isPlace = i < 3;
    const axis = isPlace ? [0, 1, 2].map((k) => (k === i ? 1 : 0)) : turned[i - 3];
    const off = toKernel(isPlace ? 'length' : 'angle', ROUNDING + single(value), UNITS);
    const twist = new Float64Array(6);
    for (let row = 0; row < 3; row++)
      twist[row + (isPlace ? 0 : 3)] = off * axis.reduce((sum, x, k) => sum + x * T_base_user[4 * k + row], 0);
    return twist;
  });
}

/** What changes of the posture do to the tool. @param {Chain} chain @param {Float64Array} q @param {readonly Float64Array[]} changes @returns {Float64Array[]} */
export function asTwists(chain, q, changes) {
  const J = geometricJacobian(chain, q);
  return changes.map((change) => {
    const twist = new Float64Array(6);
    for (let at = 0; at < J.length; at++) twist[at % 6] += J[at] * change[Math.floor(at / 6)];
    return twist;
  });
}

/** So many changes are paired: joints, of whose corners the worst is found. */
const MOST_PAIRED = 6;

/** Directions that the search for the worst looks in first, besides those of the changes themselves and those square to two of them. */
const DIAGONALS = [
  [1, 1, 1],
  [1, 1, -1],
  [1, -1, 1],
  [1, -1, -1],
];

/**
 * Which way each change has to go for the largest sum of all: from a direction, those that go farthest in it, whose sum is the next
 * direction, until they stay.
 * @param {readonly ArrayLike<number>[]} up     what each does one way: 3 numbers from `first` on
 * @param {readonly ArrayLike<number>[]} down   the other way
 * @param {number} first
 * @returns {{ signs: number[], size: number }}
 */
export function worstSigns(up, down, first) {
  let best = { signs: up.map(() => 1), size: 0 };
  const own = up.map((v) => [v[first], v[first + 1], v[first + 2]]);
  const square = own.slice(0, MOST_PAIRED).flatMap((a, i) => own.slice(i + 1, MOST_PAIRED).map((b) => cross(a, b)));
  const starts = [...DIAGONALS, ...own, ...square];
  for (let direction of starts) {
    for (let size = -1; ;) {
      const along = (/** @type {ArrayLike<number>} */ v) =>
        v[first] * direction[0] + v[first + 1] * direction[1] + v[first + 2] * direction[2];
      const signs = up.map((v, i) => (along(v) >= along(down[i]) ? 1 : -1));
      const sum = [0, 1, 2].map((k) => signs.reduce((all, sign, i) => all + (sign > 0 ? up : down)[i][first + k], 0));
      const next = Math.hypot(...sum);
      if (!(next > size * (1 + 1e-12))) break;
      [size, direction] = [next, sum];
      if (size > best.size) best = { signs, size };
    }
  }
  return best;
}

/** @param {readonly number[]} a @param {readonly number[]} b */
const cross = ([a, b, c], [x, y, z]) => [b * z - c * y, c * x - a * z, a * y - b * x];
