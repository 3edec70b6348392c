/**
 * What moves while a button of the pendant is held: one step, or on and on by the page's clock until it is let go. Each press
 * is one step to undo. Whatever may have taken the hand off (the key, the pointer, the window, the page) stops it at once.
 *
 * @import { Page } from '../page.js'
 * @import { RobotDoc } from '../../model/document.js'
 * @import { JogPress, JogStop } from '../../model/jog/jog.js'
 *
 * @typedef {{ readonly joint: number } | { readonly axis: number }} Way
 * @typedef {{ stop: JogStop | null, isSlow: boolean, isTilting: boolean }} Progress
 */
import { compilePosture, postureFromKernel, compileRobot } from '../../model/compile.js';
import { beginJog, jogFurther, jogJoint, withoutLimits } from '../../model/jog/jog.js';
import { jogFramePose } from '../../model/jog/jogFrame.js';
import { PENDANT_UNITS, mostTurnIn, rateOf, stepOf } from '../../model/jog/jogChoices.js';
import { isSliding } from '../../model/document.js';
import { jointNumbers } from './jointNumbers.js';
import { memo } from '../../model/memo.js';
import { convertAngle, convertLength, fromKernel } from '../../model/units.js';
import { newGesture } from '../page.js';

/** A picture that comes later than this (seconds) does not make the arm leap. */
const LONGEST_FRAME = 0.1;

/**
 * @param {Page} page
 * @param {(progress: Progress) => void} onProgress
 */
export function createJogMotion(page, onProgress) {
  const { store, derived, clock } = page;
  const choices = () => store.state.session.jog;
  const keepsLimits = () => store.state.session.numbers.keepsLimits;
  const freeChain = memo((/** @type {RobotDoc} */ robot) => compileRobot(withoutLimits(robot)));
  const chainNow = () => {
    const { doc } = store.state;
    return keepsLimits() ? derived.chain(doc) : freeChain(doc.robot);
  };

  /** @type {{ way: Way, sign: 1 | -1, gesture: string, then: number, press: JogPress | null, posture: readonly number[] } | null} */
  let held = null;

  /** @param {Way} way @param {number} seconds  0: a step */
  function amountOf(way, seconds) {
    const isTurn = 'axis' in way ? way.axis > 2 : !isSliding(store.state.doc.robot.joints[way.joint]);
    return seconds === 0 ? stepOf(choices(), isTurn) : rateOf(choices(), isTurn) * seconds;
  }

  /** A step as it was typed, in the document's unit, so that ten of 0.1° make one degree. @param {number} joint */
  function jointStepOf(joint) {
    const { joints, units } = jointNumbers(store.state).robot(store.state.doc);
    const { step, turn } = choices();
    return isSliding(joints[joint])
      ? convertLength(step, PENDANT_UNITS.length, units.length)
      : convertAngle(turn, PENDANT_UNITS.angle, units.angle);
  }

  /** @param {NonNullable<typeof held>} now @param {number} seconds  0: a step */
  function go(now, seconds) {
    const { doc } = store.state;
    const { robot, posture } = doc;
    const { way, sign, gesture } = now;
    if ('joint' in way) {
      const numbers = jointNumbers(store.state);
      const shown = numbers.robot(doc);
      const joint = shown.joints[way.joint];
      const before = numbers.values(doc)[way.joint];
      const quantity = isSliding(joint) ? 'length' : 'angle';
      const amount = seconds === 0 ? jointStepOf(way.joint) : fromKernel(quantity, amountOf(way, seconds), shown.units);
      const { value, isStopped } = jogJoint(joint, before, sign * amount, keepsLimits());
      if (value !== before) store.dispatch({ ...numbers.command(doc, way.joint, value), gesture });
      now.posture = store.state.doc.posture;
      return {
        stop: isStopped ? { why: /** @type {const} */ ('limit'), joint: way.joint } : null,
        isSlow: false,
        isTilting: false,
      };
    }
    const chain = chainNow();
    if (!now.press) {
      const q = compilePosture(robot, posture);
      now.press = beginJog(chain, q, jogFramePose(chain, q, choices().frame, derived.user(doc)), way.axis);
    }
    const before = now.press;
    const amount = sign * amountOf(way, seconds);
    const press = jogFurther(chain, before, amount, seconds === 0 ? undefined : mostTurnIn(seconds));
    now.press = press;
    if (press.travelled !== before.travelled) {
      // What did not move keeps its digits.
      const found = postureFromKernel(robot, press.q);
      const next = posture.map((value, i) => (press.q[i] === before.q[i] ? value : found[i]));
      store.dispatch({ type: 'set-posture', posture: next, gesture });
    }
    now.posture = store.state.doc.posture;
    const { stop, isTilting } = press;
    return { stop, isTilting, isSlow: !stop && press.travelled !== before.travelled + amount };
  }

  /** @param {Progress} progress */
  function tell(progress) {
    const { stop: end } = progress;
    const { posture } = store.state.doc;
    store.dispatch({ type: 'show', change: { jogEnd: end && { ...end, posture } } });
    onProgress(progress);
  }

  function onFrame() {
    if (!held) return;
    // Somebody else has moved the arm, or undone: it is theirs.
    if (store.state.doc.posture !== held.posture) return stop();
    const now = clock.now();
    const seconds = Math.min(LONGEST_FRAME, now - held.then);
    held.then = now;
    if (seconds > 0) {
      const progress = go(held, seconds);
      tell(progress);
      if (progress.stop) return stop();
    }
    clock.onFrame(onFrame);
  }

  /** @param {Way} way @param {1 | -1} sign @param {boolean} [isByStep] */
  function press(way, sign, isByStep = choices().isByStep) {
    stop();
    const { posture } = store.state.doc;
    held = { way, sign, gesture: newGesture(), then: clock.now(), press: null, posture };
    store.dispatch({ type: 'show', change: { heldJoint: 'joint' in way ? way.joint : null } });
    tell({ stop: null, isSlow: false, isTilting: false });
    if (!isByStep) return clock.onFrame(onFrame);
    tell(go(held, 0));
  }

  function stop() {
    if (!held) return;
    held = null;
    store.dispatch({ type: 'end-gesture' });
    store.dispatch({ type: 'show', change: { heldJoint: null } });
  }

  return {
    press,
    stop,
    get isHeld() {
      return held !== null;
    },
  };
}
