/**
 * All postures for a pose, limits ignored, without their names: what a solver or a search proposes, polished on the chain
 * itself and proven by forward kinematics.
 *
 * @import { Candidates, Family } from './solvers/candidates.js'
 * @import { Chain } from './chain.js'
 * @import { Method } from './solvers/solvers.js'
 *
 * @typedef {object} Tolerances
 * @property {number} positionTolerance     m
 * @property {number} orientationTolerance  rad
 *
 * @typedef {object} EveryPosture
 * @property {Float64Array[]} postures  each once, full turns of no account
 * @property {Family[]} families
 * @property {boolean} isComplete  whether it is proven that there are no others
 * @property {Method} method
 */
import { tcpPose } from './forward.js';
import { isSlide } from './limits.js';
import { polish } from './polish.js';
import { poseDifference } from './pose.js';
import { goalFromStart } from './screws.js';
import { recognise } from './solvers/solvers.js';
import { wayBetween } from './way.js';

/** Two postures nearer than this (radians, arm lengths) are the same one, found twice. */
const SAME = 1e-8;

/** Two postures nearer than this may be. */
const NEIGHBOURS = 1e-3;

/** What rounding leaves of a pose that is met exactly: arm lengths, radians. */
const LAST_DIGIT = 2e-14;

const FULL_TURN = 2 * Math.PI;

const T = new Float64Array(16);
const difference = new Float64Array(6);

/**
 * @param {Chain} chain
 * @param {ArrayLike<number>} T_base_goal
 * @param {Float64Array} q
 * @returns {{ positionError: number, orientationError: number }}
 */
export function errorsAt(chain, T_base_goal, q) {
  poseDifference(tcpPose(chain, q, T), T_base_goal, difference);
  const [x, y, z, rx, ry, rz] = difference;
  return { positionError: Math.sqrt(x * x + y * y + z * z), orientationError: Math.sqrt(rx * rx + ry * ry + rz * rz) };
}

/**
 * Whether a posture is there, once polished.
 * @param {Chain} chain
 * @param {ArrayLike<number>} T_base_goal
 * @param {Float64Array} q  polished in place
 * @param {Tolerances} tolerances
 */
export function isThere(chain, T_base_goal, q, { positionTolerance, orientationTolerance }) {
  polish(chain, T_base_goal, q);
  const { positionError, orientationError } = errorsAt(chain, T_base_goal, q);
  return positionError <= positionTolerance && orientationError <= orientationTolerance;
}

/**
 * What the arm's solver proposes, neither polished nor proven.
 * @param {Chain} chain
 * @param {ArrayLike<number>} T_base_goal
 * @returns {Candidates | null} null for an arm that no solver knows
 */
export const proposePostures = (chain, T_base_goal) =>
  recognise(chain).solver?.solve(goalFromStart(chain, T_base_goal)) ?? null;

/**
 * @param {Chain} chain
 * @param {ArrayLike<number>} T_base_goal
 * @param {Tolerances} tolerances
 * @returns {EveryPosture | null} null for an arm that no solver knows
 */
export function solveEveryPosture(chain, T_base_goal, tolerances) {
  const { solver } = recognise(chain);
  if (!solver) return null;
  const { postures, families, isComplete } = solver.solve(goalFromStart(chain, T_base_goal));
  const proven = {
    postures: onlyOnce(
      chain,
      T_base_goal,
      postures.filter((q) => isThere(chain, T_base_goal, q, tolerances)),
    ),
    families: families.filter(({ q }) => isThere(chain, T_base_goal, q, tolerances)),
  };
  return { ...proven, isComplete, method: solver.method };
}

/**
 * Whether two postures are one solution: they agree; or they are near each other, and half-way between them the pose is met
 * to the last digit too, as between what rounding makes of a double solution (an elbow that is exactly straight).
 * @param {Chain} chain
 * @param {ArrayLike<number>} T_base_goal
 * @param {Float64Array} a
 * @param {Float64Array} b
 */
function areSame(chain, T_base_goal, a, b) {
  const way = wayBetween(chain, a, b);
  if (way < SAME) return true;
  if (way > NEIGHBOURS) return false;
  const between = a.map((value, i) => {
    const away = b[i] - value;
    return value + (isSlide(chain.packed, i) ? away : away - FULL_TURN * Math.round(away / FULL_TURN)) / 2;
  });
  const { positionError, orientationError } = errorsAt(chain, T_base_goal, between);
  return positionError <= LAST_DIGIT * chain.characteristicLength && orientationError <= LAST_DIGIT;
}

/** @param {Chain} chain @param {ArrayLike<number>} T_base_goal @param {Float64Array[]} postures @returns {Float64Array[]} */
function onlyOnce(chain, T_base_goal, postures) {
  /** @type {Float64Array[]} */
  const distinct = [];
  for (const q of postures) if (!distinct.some((other) => areSame(chain, T_base_goal, q, other))) distinct.push(q);
  return distinct;
}
