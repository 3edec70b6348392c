/**
 * Ways around obstacles, off the page's thread: a question comes as plain data, progress goes back now and then, and the answer
 * with the question's own id. Whoever asked may terminate the worker at any time.
 *
 * @import { ChainDescription } from '../kinematics/chain.js'
 * @import { Obstacle } from '../motion/clearance/obstacles.js'
 * @import { PlanOptions, planAtOnce } from '../motion/planner/planAround.js'
 *
 * @typedef {object} PlanAroundQuestion
 * @property {number} id
 * @property {ChainDescription} chain
 * @property {Float64Array} radii         of the links, m
 * @property {readonly Obstacle[]} obstacles
 * @property {Float64Array} from
 * @property {Float64Array} to
 * @property {PlanOptions} options
 *
 * @typedef {{ id: number, iterations: number } | { id: number, found: ReturnType<typeof planAtOnce> }} PlanAroundAnswer
 */
import { createChain } from '../kinematics/chain.js';
import { armBodies } from '../motion/clearance/armBodies.js';
import { createWorkcell } from '../motion/clearance/workcell.js';
import { planAround } from '../motion/planner/planAround.js';

/** So many iterations between two words of progress: some milliseconds. */
const WORD = 100;

/** @param {PlanAroundAnswer} answer */
const say = (answer) => self.postMessage(answer);

self.onmessage = ({ data }) => {
  const { id, chain, radii, obstacles, from, to, options } = /** @type {PlanAroundQuestion} */ (data);
  const cell = createWorkcell(armBodies(createChain(chain), radii), obstacles);
  const plan = planAround(cell, from, to, options);
  let turn = plan.next();
  for (; !turn.done; turn = plan.next()) {
    if (turn.value % WORD === 0) say({ id, iterations: turn.value });
  }
  say({ id, found: turn.value });
};
