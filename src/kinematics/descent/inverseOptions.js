/**
 * What inverse kinematics is asked, checked and completed: what is missing has its default, and the seed is inside the limits.
 *
 * @import { Chain } from '../chain.js'
 *
 * @typedef {object} InverseOptions
 * @property {ArrayLike<number>} [seed]  posture to start from and stay near; else the middle of the limits, 0 where unlimited
 * @property {number} [randomSeed]
 * @property {number} [restarts]         how many more starts a search may take
 * @property {number} [positionTolerance]     m
 * @property {number} [orientationTolerance]  rad
 * @property {number} [maxIterations]    of one descent
 * @property {boolean} [descentsOnly]    do not ask the arm's solver: the answer is what descents find, near the seed or not
 */
import { requirePositive, requirePosture, requireWhole } from '../checks.js';
import { bringInside, middlePosture } from '../limits.js';

/** Arrays for each number of joints, used again and again: nothing here calls back. @type {{ seed: Float64Array, best: Float64Array }[]} */
const rooms = [];

/** @typedef {ReturnType<typeof checkedOptions>} Settings */

/**
 * @param {Chain} chain
 * @param {InverseOptions} options
 */
export function checkedOptions({ packed, dof }, options) {
  const { seed, randomSeed = 1, restarts = 200, maxIterations = 100 } = options;
  const { positionTolerance = 1e-9, orientationTolerance = 1e-9, descentsOnly = false } = options;
  const room = (rooms[dof] ??= { seed: new Float64Array(dof), best: new Float64Array(dof) });
  if (seed === undefined) {
    middlePosture(packed, room.seed);
  } else {
    requirePosture(dof, seed);
    for (let i = 0; i < dof; i++) room.seed[i] = bringInside(packed, i, seed[i]);
  }
  requirePositive('positionTolerance', positionTolerance);
  requirePositive('orientationTolerance', orientationTolerance);
  requireWhole('restarts', restarts);
  requireWhole('maxIterations', maxIterations);
  requireWhole('randomSeed', randomSeed, -Infinity);
  const { seed: inside, best } = room;
  return {
    seed: inside,
    best,
    randomSeed,
    restarts,
    maxIterations,
    positionTolerance,
    orientationTolerance,
    descentsOnly,
  };
}
