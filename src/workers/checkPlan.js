/**
 * Whether a planned motion keeps clear, off the page's thread: a question comes as plain data, progress goes back now and then,
 * and the answer with the question's own id. Whoever asked may terminate the worker at any time.
 *
 * @import { ChainDescription } from '../kinematics/chain.js'
 * @import { PlanTouch } from '../motion/clearance/checkPlan.js'
 * @import { Obstacle } from '../motion/clearance/obstacles.js'
 * @import { MotionPart } from '../motion/plan.js'
 *
 * @typedef {object} CheckPlanQuestion
 * @property {readonly ChainDescription[]} chains   the arm with each tool that it has in the program
 * @property {readonly number[]} chainOf  each move's, by its place among them
 * @property {readonly number[]} radii    of the links, m
 * @property {readonly Obstacle[]} obstacles
 * @property {readonly MotionPart[]} parts
 * @property {number} margin   m
 *
 * @typedef {{ id: number, progress: number } | { id: number, found: PlanTouch[] }} CheckPlanAnswer
 */
import { createChain } from '../kinematics/chain.js';
import { armBodies } from '../motion/clearance/armBodies.js';
import { checkPlan } from '../motion/clearance/checkPlan.js';
import { createWorkcell } from '../motion/clearance/workcell.js';

/** @param {CheckPlanAnswer} answer */
const say = (answer) => self.postMessage(answer);

self.onmessage = ({ data }) => {
  const { id, chains, chainOf, radii, obstacles, parts, margin } = /** @type {CheckPlanQuestion & { id: number }} */ (
    data
  );
  const cells = chains.map((chain) => createWorkcell(armBodies(createChain(chain), radii), obstacles));
  const check = checkPlan((move) => cells[chainOf[move]], { parts: [...parts] }, { margin });
  let turn = check.next();
  for (; !turn.done; turn = check.next()) say({ id, progress: turn.value });
  say({ id, found: turn.value });
};
