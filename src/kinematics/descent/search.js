/**
 * What a search for a posture works with: the question, where it is, and room for what it computes on the way
 * (dampedLeastSquares.js).
 *
 * @import { Chain } from '../chain.js'
 * @import { Work } from '../differences.js'
 * @import { Packed } from '../packed.js'
 * @import { Pose } from '../pose.js'
 * @import { TaskName } from './task.js'
 *
 * @typedef {object} Search
 * @property {Packed} packed
 * @property {number} length      the characteristic length
 * @property {number} weight      of a square metre against a square radian: 1 / length²
 * @property {Float64Array} unit  per joint: radians or metres in one unit of the step
 * @property {Pose} goal          seen from the origin of the chain's `start`, as Work is
 * @property {number} positionTolerance
 * @property {number} orientationTolerance
 * @property {number} finest      the smaller of the two tolerances: radians, arm lengths
 * @property {number} maxIterations
 * @property {boolean} isBounded  whether the limits hold
 * @property {boolean} turnsBack  whether a joint that would go past its limit may come in again full turns away, where it has room
 * @property {TaskName} task
 * @property {ArrayLike<number>} up  the upright that tasks speak of (task.js)
 * @property {number} spare       weight of what the task leaves free
 * @property {boolean} isSettling  to the very bottom, instead of on to the next start as soon as it is slow
 * @property {Float64Array} q     where the search is
 * @property {number} cost        what is minimised, at q
 * @property {number} iterations  in all descents so far
 * @property {Work} work
 * @property {Float64Array} J   6 · n, metres and radians; a slide's per unit
 * @property {Float64Array} H   JᵀJ, weighted, its lower triangle row by row; a joint that a limit holds is out of it
 * @property {Float64Array} gradient   of less cost, likewise
 * @property {Float64Array} step
 * @property {Float64Array} bend
 * @property {Float64Array} trial
 * @property {Float64Array} lowest   where the cost was least in this descent
 * @property {Float64Array} residual   metres and radians
 */
import { createWork } from '../differences.js';
import { isSlide } from '../limits.js';

/**
 * One search for each number of joints, used again and again: allocating its arrays takes longer than most solves. Nothing
 * in this folder calls back, so no two searches are ever under way.
 * @type {Search[]}
 */
const searches = [];

const UP = [0, 0, 1];

/** @param {Packed} packed @param {number} dof @returns {Search} */
const allocateSearch = (packed, dof) => ({
  packed,
  length: 1,
  weight: 1,
  unit: new Float64Array(dof),
  goal: new Float64Array(16),
  positionTolerance: 0,
  orientationTolerance: 0,
  finest: 0,
  maxIterations: 0,
  isBounded: true,
  turnsBack: true,
  task: 'pose',
  up: UP,
  spare: 0,
  isSettling: false,
  q: new Float64Array(dof),
  cost: Infinity,
  iterations: 0,
  work: createWork(dof),
  J: new Float64Array(6 * dof),
  H: new Float64Array(dof * dof),
  gradient: new Float64Array(dof),
  step: new Float64Array(dof),
  bend: new Float64Array(dof),
  trial: new Float64Array(dof),
  lowest: new Float64Array(dof),
  residual: new Float64Array(6),
});

/**
 * A search for the whole pose, inside the limits. It is good until the next one is prepared.
 * @param {Chain} chain
 * @param {ArrayLike<number>} T_base_goal
 * @param {{ positionTolerance: number, orientationTolerance: number, maxIterations: number }} options
 * @returns {Search}
 */
export function prepareSearch({ packed, dof, characteristicLength }, T_base_goal, options) {
  const search = (searches[dof] ??= allocateSearch(packed, dof));
  search.packed = packed;
  search.length = characteristicLength;
  search.weight = 1 / characteristicLength ** 2;
  for (let i = 0; i < dof; i++) search.unit[i] = isSlide(packed, i) ? characteristicLength : 1;
  copy(T_base_goal, search.goal);
  for (let k = 12; k < 15; k++) search.goal[k] -= packed.start[k];
  search.positionTolerance = options.positionTolerance;
  search.orientationTolerance = options.orientationTolerance;
  search.finest = Math.min(options.positionTolerance / characteristicLength, options.orientationTolerance);
  search.maxIterations = options.maxIterations;
  search.isBounded = true;
  search.turnsBack = true;
  search.task = 'pose';
  search.up = UP;
  search.spare = 0;
  search.isSettling = false;
  search.iterations = 0;
  return search;
}

/** The method of typed arrays takes longer for so few. @param {ArrayLike<number>} from @param {Float64Array} to */
export function copy(from, to) {
  for (let i = 0; i < to.length; i++) to[i] = from[i];
}
