/**
 * How far a row of the table is built up into a frame, and where that is to go: four motions, one after the other.
 *
 * @import { RobotDoc } from '../document.js'
 * @import { BuildUp } from '../session.js'
 */
import { isSliding } from '../document.js';
import { ROW_MOTIONS } from './rowMotions.js';

export const MOTIONS = 4;
const SECONDS = 1; // for a motion,
const SECONDS_OF_NOTHING = 0.3; // and for one that moves nothing

/** @param {number} joint @returns {BuildUp} */
export const buildOf = (joint) => ({ joint, at: 0, goal: 0 });

/** Whether it is on its way. @param {BuildUp} build */
export const isMoving = ({ at, goal }) => at < goal;

/** The next motion; what is still under way is done at once. @param {BuildUp} build @returns {BuildUp} */
export const forward = ({ joint, goal }) => ({
  joint,
  at: Math.ceil(goal),
  goal: Math.min(MOTIONS, Math.ceil(goal) + 1),
});

/** Before the last motion, or before the one that is under way. @param {BuildUp} build @returns {BuildUp} */
export function back({ joint, at }) {
  const before = Math.max(0, Math.ceil(at) - 1);
  return { joint, at: before, goal: before };
}

/** All the way, from the beginning if it is done already. @param {BuildUp} build @returns {BuildUp} */
export const play = ({ joint, at }) => ({ joint, at: at >= MOTIONS ? 0 : at, goal: MOTIONS });

/** @param {BuildUp} build @returns {BuildUp} */
export const pause = ({ joint, at }) => ({ joint, at, goal: at });

/** The motion that is under way, or was the last; null before the first. @param {BuildUp} build */
export function motionNow(build) {
  const { at } = build;
  if (isMoving(build)) return Math.floor(at);
  return at <= 0 ? null : Math.ceil(at) - 1;
}

/**
 * What a motion moves by, in the units of the document: the row's number and, where the joint moves it, the joint value.
 * @param {RobotDoc} robot
 * @param {readonly number[]} posture
 * @param {number} joint
 * @param {number} index  0 … 3, in the order of the convention
 */
export function motionAmount({ convention, joints }, posture, joint, index) {
  const motion = ROW_MOTIONS[convention][index];
  const row = joints[joint];
  const isVariable = motion.field === (isSliding(row) ? 'd' : 'theta');
  return { ...motion, isVariable, amount: row[motion.field] + (isVariable ? posture[joint] : 0) };
}

/**
 * After so much time. A motion never runs over into the next within one step, so that each is seen at its end.
 * @param {BuildUp} build
 * @param {number} seconds
 * @param {(index: number) => number} amountOf  what each motion moves by
 * @returns {BuildUp}
 */
export function after(build, seconds, amountOf) {
  const { joint, at, goal } = build;
  if (!isMoving(build)) return build;
  const index = Math.floor(at);
  const whole = amountOf(index) === 0 ? SECONDS_OF_NOTHING : SECONDS;
  return { joint, at: Math.min(goal, index + 1, at + seconds / whole), goal };
}

/** The motion under way done, for those who want nothing to move. @param {BuildUp} build @returns {BuildUp} */
export const stepped = (build) =>
  isMoving(build) ? { ...build, at: Math.min(build.goal, Math.floor(build.at) + 1) } : build;
