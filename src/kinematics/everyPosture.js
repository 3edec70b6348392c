/**
 * All postures for a pose, limits ignored, without their names: what a solver or a search proposes, polished on the chain
 * itself and proven by forward kinematics.
 *
 * @import { Candidates, Family } from './solvers/candidates.js'
 * @import { Chain } from './chain.js'
 * @import { Method } from './solvers/solvers.js'
 * @import { Tolerances } from './poseErrors.js'
 *
 * @typedef {object} EveryPosture
 * @property {Float64Array[]} postures  full turns of no account; what rounding makes of a double one may be two (sameSolution.js)
 * @property {Family[]} families
 * @property {boolean} isComplete  whether it is proven that there are no others
 * @property {Method} method
 */
import { polish } from './polish.js';
import { isWithin } from './poseErrors.js';
import { goalFromStart } from './screws.js';
import { recognise } from './solvers/solvers.js';

/**
 * Whether a posture is there, once polished.
 * @param {Chain} chain
 * @param {ArrayLike<number>} T_base_goal
 * @param {Float64Array} q  polished in place
 * @param {Tolerances} tolerances
 */
export function isThere(chain, T_base_goal, q, tolerances) {
  polish(chain, T_base_goal, q);
  return isWithin(chain, T_base_goal, q, tolerances);
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
    postures: postures.filter((q) => isThere(chain, T_base_goal, q, tolerances)),
    families: families.filter(({ q }) => isThere(chain, T_base_goal, q, tolerances)),
  };
  return { ...proven, isComplete, method: solver.method };
}
