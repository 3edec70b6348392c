/**
 * What is known of a motion program in time: the question that was asked, and the answer as far as it has come.
 *
 * @import { Doc, MotionProgramDoc } from '../document.js'
 * @import { StepIssue } from './motionPlan.js'
 * @import { Assumption } from './motionLimits.js'
 * @import { PlanSeries } from './planSeries.js'
 * @import { MotionPlan } from '../../motion/plan.js'
 * @import { JointLimits, Move } from '../../motion/moves.js'
 *
 * @typedef {object} Question
 * @property {Doc} doc   where the arm stands in it is of no account
 * @property {MotionProgramDoc} program
 * @property {readonly number[]} start  the posture that the program begins with, in document units
 *
 * @typedef {object} Planned
 * @property {MotionPlan} plan
 * @property {readonly Move[]} moves
 * @property {readonly number[]} steps  of each move: its index in the program
 * @property {JointLimits} limits
 * @property {readonly Assumption[]} assumptions  what nobody has said, and was taken for granted
 *
 * @typedef {object} Planning
 * @property {Question} question
 * @property {number | null} progress   share that is done; null: nothing is under way
 * @property {Planned | null} planned   null: not yet, or never, if there are issues
 * @property {PlanSeries | null} series  of what is planned, a moment later
 * @property {readonly StepIssue[]} issues  why there is nothing to plan
 * @property {boolean} isGivenUp        by whoever did not want to wait
 */
export {};
