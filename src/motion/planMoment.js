/**
 * Where a planned arm is at a moment, and how fast.
 *
 * @import { MotionPart, MotionPlan } from './plan.js'
 *
 * @typedef {object} PlanMoment
 * @property {Float64Array} posture
 * @property {Float64Array} rates           per second; the derivatives likewise
 * @property {Float64Array} accelerations
 * @property {Float64Array} jerks
 * @property {number} move   index of the move under way; −1 in a plan without any
 */
import { requireRoom } from '../kinematics/checks.js';
import { pathMoment, pathMomentAt } from './posturePath.js';
import { momentAt } from './timeLaw.js';

/** @param {number} dof @returns {PlanMoment} */
export const planMoment = (dof) => ({
  posture: new Float64Array(dof),
  rates: new Float64Array(dof),
  accelerations: new Float64Array(dof),
  jerks: new Float64Array(dof),
  move: -1,
});

/** Room for each number of joints. @type {ReturnType<typeof pathMoment>[]} */
const rooms = [];

/**
 * @param {MotionPlan} plan
 * @param {number} t   s; before 0 it is the beginning, after the end the end
 * @param {PlanMoment} [out]
 * @returns {PlanMoment}
 */
export function planMomentAt(plan, t, out = planMoment(plan.start.length)) {
  requireRoom(out.posture, plan.start.length);
  const part = partAt(plan.parts, t);
  if (!part) {
    out.posture.set(plan.start);
    for (const each of [out.rates, out.accelerations, out.jerks]) each.fill(0);
    out.move = -1;
    return out;
  }
  const { dof } = part.path;
  const time = Math.min(Math.max(0, t - part.begin), part.law.duration);
  const { position, rate, acceleration, jerk } = momentAt(part.law, time);
  const { posture, first, second, third } = pathMomentAt(part.path, position, (rooms[dof] ??= pathMoment(dof)));
  for (let i = 0; i < dof; i++) {
    out.posture[i] = posture[i];
    out.rates[i] = first[i] * rate;
    out.accelerations[i] = second[i] * rate * rate + first[i] * acceleration;
    out.jerks[i] = third[i] * rate ** 3 + 3 * second[i] * rate * acceleration + first[i] * jerk;
  }
  out.move = part.move;
  return out;
}

/** The last part that has begun, by halving. @param {readonly MotionPart[]} parts @param {number} t @returns {MotionPart | undefined} */
function partAt(parts, t) {
  let [low, high] = [0, parts.length - 1];
  while (low < high) {
    const middle = (low + high + 1) >> 1;
    if (parts[middle].begin <= t) low = middle;
    else high = middle - 1;
  }
  return parts[low];
}
