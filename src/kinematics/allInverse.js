/**
 * All inverse-kinematics solutions of a pose: every posture that takes the tool there, what people call it, whether it is
 * inside the limits and by how much; and whether the list is known to be complete. Postures that are not isolated points are
 * families, and named as such.
 *
 * @import { Chain } from './chain.js'
 * @import { EveryPosture } from './everyPosture.js'
 * @import { Family } from './solvers/candidates.js'
 * @import { FanucConfiguration, KukaStatusTurn, PostureName } from './postureNames.js'
 * @import { Method } from './solvers/solvers.js'
 * @import { Tolerances } from './poseErrors.js'
 * @import { LimitMargin } from './turns.js'
 *
 * @typedef {object} AllInverseOptions
 * @property {number} [positionTolerance]     m
 * @property {number} [orientationTolerance]  rad
 * @property {ArrayLike<number>} [seed]       full turns are chosen near it, and solutions are sorted by their way from it
 * @property {boolean} [onlyWithinLimits]     leave out what is outside
 * @property {number} [randomSeed]            of the search, for an arm that has no better method
 *
 * @typedef {object} Solution
 * @property {Float64Array} q   full turns taken so that it is inside the limits if it can be
 * @property {boolean} withinLimits
 * @property {LimitMargin | null} limitMargin  null if no joint has two limits
 * @property {number} positionError     m, of q by forward kinematics
 * @property {number} orientationError  rad
 * @property {PostureName} name
 * @property {FanucConfiguration} fanuc
 * @property {KukaStatusTurn} kuka
 *
 * @typedef {object} AllSolutions
 * @property {Solution[]} solutions
 * @property {(Family & { withinLimits: boolean })[]} families  `withinLimits` of the member that is given
 * @property {boolean} complete   whether it is proven that there is nothing else
 * @property {Method} method
 */
import { requirePosture, requirePositive, requireWhole } from './checks.js';
import { solveEveryPosture } from './everyPosture.js';
import { fanucConfiguration, kukaStatusTurn, namePosture, prepareNames } from './postureNames.js';
import { requirePose } from './pose.js';
import { errorsAt } from './poseErrors.js';
import { onlyOnce } from './sameSolution.js';
import { searchEveryPosture } from './searchEvery.js';
import { recognise } from './solvers/solvers.js';
import { limitMarginOf, writeBestTurns } from './turns.js';
import { wayFrom } from './way.js';

/** @type {WeakMap<Chain, ReturnType<typeof prepareNames>>} */
const knownNames = new WeakMap();

/** An arm is looked at once. @param {Chain} chain */
function namesFor(chain) {
  let names = knownNames.get(chain);
  if (!names) {
    const { start } = chain.packed;
    names = prepareNames(recognise(chain).screws, [start[2], start[6], start[10]]); // the root's vertical, seen from `start`
    knownNames.set(chain, names);
  }
  return names;
}

/**
 * By the arm's solver; or by a search where there is none, and where the solver itself is not sure that it has them all, as
 * next to several singularities at once.
 * @param {Chain} chain
 * @param {ArrayLike<number>} goal
 * @param {Tolerances & { randomSeed: number }} settings
 * @returns {EveryPosture}
 */
function everyPosture(chain, goal, settings) {
  const solved = solveEveryPosture(chain, goal, settings);
  if (!solved) return searchEveryPosture(chain, goal, settings);
  const { isComplete } = solved;
  const postures = onlyOnce(chain, goal, solved.postures, settings, isComplete);
  if (isComplete || solved.families.length > 0) return { ...solved, postures };
  const searched = searchEveryPosture(chain, goal, settings);
  const all = onlyOnce(chain, goal, [...postures, ...searched.postures], settings, false);
  return { ...solved, postures: all, families: searched.families };
}

/**
 * @param {Chain} chain
 * @param {ArrayLike<number>} T_base_goal
 * @param {AllInverseOptions} [options]
 * @returns {AllSolutions}
 */
export function allInverseKinematics(chain, T_base_goal, options = {}) {
  const { positionTolerance = 1e-9, orientationTolerance = 1e-9, randomSeed = 1, seed } = options;
  const { onlyWithinLimits = false } = options;
  requirePositive('positionTolerance', positionTolerance);
  requirePositive('orientationTolerance', orientationTolerance);
  requireWhole('randomSeed', randomSeed, -Infinity);
  if (seed) requirePosture(chain.dof, seed);
  const goal = requirePose(T_base_goal, 'the goal');
  const settings = { positionTolerance, orientationTolerance, randomSeed };
  const { postures, families, isComplete, method } = everyPosture(chain, goal, settings);

  const names = namesFor(chain);
  const solutions = postures.map((q) => {
    const withinLimits = writeBestTurns(chain, q, seed);
    return {
      q,
      withinLimits,
      limitMargin: limitMarginOf(chain, q),
      ...errorsAt(chain, goal, q),
      name: namePosture(names, q),
      fanuc: fanucConfiguration(names, q),
      kuka: kukaStatusTurn(names, q),
    };
  });
  if (seed) solutions.sort((a, b) => wayFrom(chain, seed, a.q) - wayFrom(chain, seed, b.q));
  return {
    solutions: onlyWithinLimits ? solutions.filter(({ withinLimits }) => withinLimits) : solutions,
    families: families.map((family) => ({ ...family, withinLimits: writeBestTurns(chain, family.q, seed) })),
    complete: isComplete,
    method,
  };
}
