/**
 * The motions of a run on the simulated arm: each is planned when it begins, and the arm is where its plan has it at the program's
 * time, whoever looks. The plans of one moment are one value, so that stepping back puts them back.
 *
 * @import { Doc } from '../document.js'
 * @import { CodeRun } from './codeDebugger.js'
 * @import { Effect } from '../../karel/run/machine.js'
 * @import { MotionPlan } from '../../motion/plan.js'
 *
 * @typedef {{ plan: MotionPlan, start: readonly number[] }} PlannedMotion   start: in document units
 *
 * @typedef {object} MotionMark
 * @property {ReadonlyMap<number, PlannedMotion>} plans   by the motions' numbers
 * @property {number} current                             the motion that has the arm; 0: none
 * @property {readonly number[]} posture
 *
 * @typedef {{ reason: string, isRefusal?: boolean } | { missing: readonly string[], assumed?: string }} Begun   assumed: what the motion is taken to be
 */
import { endMotion, takeTime } from '../../karel/run/arm.js';
import { postureAt } from '../program/planPosture.js';
import { fromMilliseconds, toMilliseconds } from '../units.js';
import { planOfMove } from './codeMoves.js';
import { ASSUMED } from './codeOffsets.js';

/** Degrees or the document's lengths: a posture is where a motion was stopped. */
const SAME = 1e-6;

/** @param {() => Doc} docNow @param {() => CodeRun | null} runNow */
export function createCodeMotions(docNow, runNow) {
  /** @type {ReadonlyMap<number, PlannedMotion>} */
  let plans = new Map();
  /** The motion that has the arm; 0: none. */
  let current = 0;
  /** What was asked for last. @type {{ plan: MotionPlan, time: number, posture: readonly number[] } | null} */
  let known = null;

  const arm = () => runNow()?.state().arm ?? null;

  /** @param {PlannedMotion} motion @param {number} milliseconds */
  function along({ plan, start }, milliseconds) {
    const time = fromMilliseconds(Math.max(0, milliseconds));
    if (known?.plan !== plan || known.time !== time)
      known = { plan, time, posture: postureAt(docNow().robot, plan, { time, start }) };
    return known.posture;
  }

  /** Where the arm is, in the program's time; at the end of a motion, when the next has begun and has no plan. @param {number} [lag]  so many ms of the motion less */
  function posture(lag = 0) {
    const { last, before } = arm() ?? {};
    const motion = plans.get(current);
    if (!motion || !last || !before) return docNow().posture;
    if (last.number === current) return along(motion, last.done - lag);
    return before.number === current ? along(motion, before.done) : docNow().posture;
  }

  /** @param {Effect} effect @param {readonly number[]} start @returns {Begun} */
  function plan(effect, start) {
    const run = runNow();
    const motion = arm()?.motion;
    if (!run || !motion) return { missing: [] };
    const planned = planOfMove(docNow(), start, effect, run.state().system);
    if ('message' in planned) return { reason: planned.message };
    if (planned.plan.refused) return { reason: planned.plan.refused.reason, isRefusal: true };
    takeTime(run.state(), toMilliseconds(planned.plan.duration));
    plans = new Map(plans).set(motion.number, { plan: planned.plan, start });
    current = motion.number;
    return { missing: planned.missing, assumed: ASSUMED[String(effect.to)] };
  }

  return {
    posture,

    /** The document with the arm where it is in the program's time. @returns {Doc} */
    doc() {
      const doc = docNow();
      const there = posture();
      return there === doc.posture ? doc : { ...doc, posture: there };
    },

    isMoving: () => Boolean(arm()?.motion),

    /** @param {Effect} effect  of kind 'move', which has just begun */
    begin: (effect) => plan(effect, docNow().posture),

    /**
     * What was stopped goes on along its way; the arm has to be on it, or is taken to its end from where it is.
     * @returns {Begun}
     */
    resume() {
      const motion = arm()?.motion;
      const before = motion && plans.get(motion.number);
      if (!before) return { missing: [] };
      const here = docNow().posture;
      const stopped = along(before, motion.done);
      if (here.every((value, i) => Math.abs(value - stopped[i]) < SAME)) {
        current = motion.number;
        return { missing: [] };
      }
      if (motion.effect.to === 'ALONG' || motion.effect.via)
        return { reason: 'the arm is no longer on the way that was stopped, which is no plain one' };
      return plan(motion.effect, here);
    },

    /** Plans that nobody needs any longer are forgotten, once the arm is put where they end. */
    settle() {
      const now = arm();
      if (!now || now.motion || current === 0) return;
      current = 0;
      plans = new Map([...plans].filter(([number]) => now.stopped.some((one) => one.number === number)));
    },

    /** Somebody else has the arm: the motion is over where it is. */
    giveUp() {
      const now = arm();
      if (now) endMotion(now);
      current = 0;
    },

    clear() {
      plans = new Map();
      current = 0;
    },

    /** @returns {MotionMark} */
    mark: () => ({ plans, current, posture: posture() }),
    /** @param {MotionMark} mark */
    restore(mark) {
      ({ plans, current } = mark);
    },
  };
}

/** @typedef {ReturnType<typeof createCodeMotions>} CodeMotions */
