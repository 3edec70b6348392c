/**
 * The arm as programs know it: the motion under way, how far it is, and those that were stopped. How long a motion takes, whoever
 * moves the arm says (`takeTime`); until somebody does, motions take no time. Plain data, part of the controller's memory.
 *
 * A motion that is cancelled, stopped or held comes to rest on its way: its own time slows down evenly. What a controller does then
 * is not published.
 *
 * The motion group, which is the arm, is held by one task at a time: no other may move it, nor begin a program that is to have it
 * (alarm PROG-040 of a controller).
 *
 * @typedef {{ kind: string, line?: number, [detail: string]: unknown }} MotionEffect
 *
 * @typedef {object} Motion
 * @property {number} number     from 1, in the order in which they begin
 * @property {MotionEffect} effect     as it was asked for
 * @property {number} duration   ms
 * @property {number} done       ms of its own time
 * @property {number} rate       of its own time: 1, 0 at rest
 * @property {{ time: number, done: number, rate: number, goal: number }} from   since when it has gone on evenly to the rate `goal`:
 *   what time brings is counted from there, so that it is the same however often it is asked for
 * @property {string} task       that asked for it
 * @property {boolean} [isPaused]  with its task
 * @property {'CANCEL' | 'STOP'} [ends]   what it comes to rest for
 *
 * @typedef {object} Arm
 * @property {Motion | null} motion
 * @property {Motion[]} stopped  that RESUME takes up again, the last first
 * @property {number} count      motions that have begun
 * @property {{ number: number, done: number }} last  the motion that moved the arm last, and how far it came
 * @property {{ number: number, done: number }} before  the same of the one before that
 * @property {boolean} isHeld
 * @property {string | null} holder   the task that has the motion group
 * @property {number} time       ms, of the program, when all of this was so
 */
import { Alarm } from './values.js';

/** ms in which a motion comes to rest, and goes again. A guess. */
export const STOP_TIME = 100;

/** ms; less is nothing. */
const NOTHING = 1e-6;

/** @param {string | null} [holder] @returns {Arm} */
export const newArm = (holder = null) => ({
  ...{ motion: null, stopped: [], count: 0, last: { number: 0, done: 0 }, before: { number: 0, done: 0 } },
  ...{ isHeld: false, holder, time: 0 },
});

/** @param {Arm} arm @param {MotionEffect} effect @param {number} time @param {string} task @returns {number} its number */
export function beginMotion(arm, effect, time, task) {
  advanceArm(arm, time);
  const number = ++arm.count;
  const rate = arm.isHeld ? 0 : 1;
  arm.motion = { number, effect, duration: 0, done: 0, rate, task, from: { time, done: 0, rate, goal: rate } };
  [arm.before, arm.last] = [arm.last, { number, done: 0 }];
  return number;
}

/** The motion that has just begun, or has been taken up again, takes so long from now on. @param {{ arm: Arm, time: number }} memory @param {number} milliseconds */
export function takeTime({ arm, time }, milliseconds) {
  if (!arm.motion) return;
  Object.assign(arm.motion, { duration: milliseconds, done: 0 });
  Object.assign(arm.motion.from, { time, done: 0, rate: arm.motion.rate });
  arm.last = { number: arm.motion.number, done: 0 };
  arm.time = time;
}

/** What time brings. @param {Arm} arm @param {number} time */
export function advanceArm(arm, time) {
  const { motion } = arm;
  const before = arm.time;
  arm.time = time;
  if (!motion) return;
  const goal = goalOf(arm, motion);
  if (motion.from.goal !== goal) motion.from = { time: before, done: motion.done, rate: motion.rate, goal };
  const { from } = motion;
  const milliseconds = time - from.time;
  const ramp = Math.min(Math.abs(goal - from.rate) * STOP_TIME, milliseconds);
  const rate = ramp < milliseconds ? goal : from.rate + Math.sign(goal - from.rate) * (ramp / STOP_TIME);
  const done = from.done + (ramp * (from.rate + rate)) / 2 + (milliseconds - ramp) * rate;
  motion.rate = Math.abs(rate - goal) * STOP_TIME < NOTHING ? goal : rate;
  const isOver = done > motion.duration - NOTHING;
  motion.done = isOver ? motion.duration : done;
  arm.last = { number: motion.number, done: motion.done };
  if (!isOver && !(motion.ends && motion.rate === 0)) return;
  arm.motion = null;
  if (!isOver && motion.ends === 'STOP') arm.stopped.push(motion);
}

/** @param {Arm} arm @param {Motion} motion */
const goalOf = ({ isHeld }, { ends, isPaused }) => (isHeld || isPaused || ends ? 0 : 1);

/** When the motion under way is over, or comes to rest, or is at its rate again: ms; Infinity while it stands. @param {Arm} arm */
export function nextOfArm(arm) {
  const { motion, time } = arm;
  if (!motion) return Infinity;
  const goal = goalOf(arm, motion);
  if (motion.rate !== goal) return time + Math.abs(goal - motion.rate) * STOP_TIME;
  return goal === 0 ? Infinity : time + motion.duration - motion.done;
}

/** Whether a motion is still to be waited for. @param {Arm} arm @param {number} number */
export const isUnderWay = ({ motion, stopped }, number) =>
  motion?.number === number || stopped.some((one) => one.number === number);

/** It comes to rest, and is over. @param {Arm} arm */
export function cancelMotion({ motion }) {
  if (motion) motion.ends = 'CANCEL';
}

/** It is over where it is. @param {Arm} arm */
export const endMotion = (arm) => void (arm.motion = null);

/** @param {Arm} arm @param {string} action */
export function controlMotion(arm, action) {
  const { motion } = arm;
  if (action === 'CANCEL') cancelMotion(arm);
  else if (action === 'STOP' && motion) motion.ends ??= 'STOP';
  else if (action === 'HOLD' || action === 'UNHOLD') arm.isHeld = action === 'HOLD';
  else if (action !== 'RESUME') return;
  else if (motion?.ends === 'STOP') delete motion.ends;
  else if (!motion) takeUp(arm);
}

/** @param {Arm} arm */
function takeUp(arm) {
  const motion = arm.stopped.pop();
  if (!motion) return;
  delete motion.ends;
  arm.motion = motion;
}

/** A task ends before its end: its motion comes to rest, and none is taken up again. @param {Arm} arm @param {string} task */
export function cancelMotionsOf(arm, task) {
  if (arm.motion?.task === task) cancelMotion(arm);
  arm.stopped = arm.stopped.filter((one) => one.task !== task);
}

/** A task pauses, and its motion with it; or both go on. @param {Arm} arm @param {string} task @param {boolean} isPaused */
export function pauseMotionOf({ motion }, task, isPaused) {
  if (motion?.task !== task) return;
  if (isPaused) motion.isPaused = true;
  else delete motion.isPaused;
}

/** @param {Arm} arm @param {string} task @returns {boolean} whether it has the motion group now */
export function takeGroup(arm, task) {
  arm.holder ??= task;
  return arm.holder === task;
}

/** Before a task moves the arm. @param {Arm} arm @param {string} task */
export function needGroup(arm, task) {
  if (!takeGroup(arm, task)) throw new Alarm(heldText(arm), 'motion-group');
}

/** @param {Arm} arm */
export const heldText = ({ holder }) => `${holder} holds the motion group: a controller refuses this (PROG-040)`;

/** @param {Arm} arm @param {string} task */
export function freeGroup(arm, task) {
  if (arm.holder === task) arm.holder = null;
}
