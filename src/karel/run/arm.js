/**
 * The arm as programs know it: the motion under way, how far it is, and those that were stopped. How long a motion takes, whoever
 * moves the arm says (`takeTime`); until somebody does, motions take no time. Plain data, part of the controller's memory.
 *
 * A motion that is cancelled, stopped or held comes to rest on its way: its own time slows down evenly. What a controller does then
 * is not published.
 *
 * @typedef {{ kind: string, line?: number, [detail: string]: unknown }} MotionEffect
 *
 * @typedef {object} Motion
 * @property {number} number     from 1, in the order in which they begin
 * @property {MotionEffect} effect     as it was asked for
 * @property {number} duration   ms
 * @property {number} done       ms of its own time
 * @property {number} rate       of its own time: 1, 0 at rest
 * @property {'CANCEL' | 'STOP'} [ends]   what it comes to rest for
 *
 * @typedef {object} Arm
 * @property {Motion | null} motion
 * @property {Motion[]} stopped  that RESUME takes up again, the last first
 * @property {number} count      motions that have begun
 * @property {{ number: number, done: number }} last  the motion that moved the arm last, and how far it came
 * @property {boolean} isHeld
 * @property {number} time       ms, of the program, when all of this was so
 */

/** ms in which a motion comes to rest, and goes again. A guess. */
export const STOP_TIME = 100;

/** ms; less is nothing. */
const NOTHING = 1e-6;

/** @returns {Arm} */
export const newArm = () => ({
  ...{ motion: null, stopped: [], count: 0, last: { number: 0, done: 0 } },
  ...{ isHeld: false, time: 0 },
});

/** @param {Arm} arm @param {MotionEffect} effect @param {number} time @returns {number} its number */
export function beginMotion(arm, effect, time) {
  advanceArm(arm, time);
  const number = ++arm.count;
  arm.motion = { number, effect, duration: 0, done: 0, rate: arm.isHeld ? 0 : 1 };
  arm.last = { number, done: 0 };
  return number;
}

/** The motion that has just begun, or has been taken up again, takes so long from now on. @param {{ arm: Arm, time: number }} memory @param {number} milliseconds */
export function takeTime({ arm, time }, milliseconds) {
  if (!arm.motion) return;
  Object.assign(arm.motion, { duration: milliseconds, done: 0 });
  arm.last = { number: arm.motion.number, done: 0 };
  arm.time = time;
}

/** What time brings. @param {Arm} arm @param {number} time */
export function advanceArm(arm, time) {
  const { motion } = arm;
  const milliseconds = time - arm.time;
  arm.time = time;
  if (!motion) return;
  const goal = goalOf(arm, motion);
  const ramp = Math.min(Math.abs(goal - motion.rate) * STOP_TIME, milliseconds);
  const rate = ramp < milliseconds ? goal : motion.rate + Math.sign(goal - motion.rate) * (ramp / STOP_TIME);
  const done = motion.done + (ramp * (motion.rate + rate)) / 2 + (milliseconds - ramp) * rate;
  motion.rate = Math.abs(rate - goal) * STOP_TIME < NOTHING ? goal : rate;
  const isOver = done > motion.duration - NOTHING;
  motion.done = isOver ? motion.duration : done;
  arm.last = { number: motion.number, done: motion.done };
  if (!isOver && !(motion.ends && motion.rate === 0)) return;
  arm.motion = null;
  if (!isOver && motion.ends === 'STOP') arm.stopped.push(motion);
}

/** @param {Arm} arm @param {Motion} motion */
const goalOf = ({ isHeld }, { ends }) => (isHeld || ends ? 0 : 1);

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
