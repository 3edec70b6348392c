/**
 * Which solver an arm is for: the first that recognises its lines. An arm is looked at once.
 *
 * @import { Candidates } from './candidates.js'
 * @import { Chain } from '../chain.js'
 * @import { Pose } from '../pose.js'
 * @import { Screws } from '../screws.js'
 *
 * @typedef {'wrist-partition' | 'three-parallel-axes' | 'elimination' | 'search'} Method
 *   wrist-partition: the last axes meet, so place and orientation come apart (Pieper). three-parallel-axes: likewise, for axes
 *   2, 3 and 4. elimination: the general arm, by a polynomial. search: many descents, which prove nothing.
 *
 * @typedef {object} Solver
 * @property {Exclude<Method, 'search'>} method
 * @property {boolean} isQuick   microseconds, not a millisecond
 * @property {(T_start_goal: Pose) => Candidates} solve
 *
 * @typedef {object} Recognised
 * @property {Screws} screws
 * @property {Solver | null} solver   null for an arm that none of them solves
 */
import { recogniseGeneralSix, solveGeneralSix } from './general/generalSix.js';
import { screwsOf } from '../screws.js';
import { recogniseWristPartition, solveWristPartition } from './wristPartition.js';
import { recogniseThreeParallel, solveThreeParallel } from './threeParallel.js';

/**
 * @template C
 * @param {Exclude<Method, 'search'>} method
 * @param {boolean} isQuick
 * @param {(screws: Screws) => C | null} recognise
 * @param {(constants: C, T_start_goal: Pose) => Candidates} solve
 * @returns {(screws: Screws) => Solver | null}
 */
const kind = (method, isQuick, recognise, solve) => (screws) => {
  const constants = recognise(screws);
  return constants === null ? null : { method, isQuick, solve: (goal) => solve(constants, goal) };
};

const KINDS = [
  kind('wrist-partition', true, recogniseWristPartition, solveWristPartition),
  kind('three-parallel-axes', true, recogniseThreeParallel, solveThreeParallel),
  kind('elimination', false, recogniseGeneralSix, solveGeneralSix),
];

/** @type {WeakMap<Chain, Recognised>} */
const known = new WeakMap();

/** @param {Screws} screws @returns {Solver | null} */
function solverFor(screws) {
  for (const recognise of KINDS) {
    const solver = recognise(screws);
    if (solver) return solver;
  }
  return null;
}

/** @param {Chain} chain @returns {Recognised} */
export function recognise(chain) {
  let found = known.get(chain);
  if (!found) {
    const screws = screwsOf(chain);
    found = { screws, solver: solverFor(screws) };
    known.set(chain, found);
  }
  return found;
}
