/**
 * What a solver for all postures hands to allInverse.js, which polishes, checks, names and sorts. Every solver has two
 * functions: `recogniseX(screws)` returns the constants of an arm it can solve, or null; `solveX(constants, T_start_goal)`
 * returns candidates.
 *
 * @typedef {object} Family   postures that all reach the goal and are not isolated points
 * @property {'wrist' | 'shoulder' | 'other'} kind
 *   wrist: two turning axes of the wrist are in line, and only the sum of their angles counts. shoulder: the wrist centre is
 *   on the first axis. other: any other redundancy.
 * @property {Float64Array} q   one of them
 * @property {readonly number[]} joints  indices of the joints that move along it
 *
 * @typedef {object} Candidates
 * @property {Float64Array[]} postures  each once, limits ignored, full turns of no account; near enough for a few Newton steps
 * @property {Family[]} families
 * @property {boolean} isComplete  whether it is proven that there are no other solutions
 */

/** Where there are no solutions, and that is proven. @returns {Candidates} */
export const noCandidates = () => ({ postures: [], families: [], isComplete: true });
