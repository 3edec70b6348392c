/**
 * Where the arm stands at a moment of a planned program.
 *
 * @import { RobotDoc } from '../document.js'
 * @import { Playback } from './player.js'
 * @import { MotionPlan } from '../../motion/plan.js'
 */
import { planMomentAt } from '../../motion/planMoment.js';
import { postureFromKernel } from '../compile.js';

/**
 * @param {RobotDoc} robot
 * @param {MotionPlan} plan
 * @param {Pick<Playback, 'time' | 'start'>} playback
 * @returns {readonly number[]} in document units; at the beginning the very numbers that it began with
 */
export const postureAt = (robot, plan, { time, start }) =>
  time === 0 ? start : postureFromKernel(robot, planMomentAt(plan, time).posture);
