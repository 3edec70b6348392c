/**
 * A planned motion as series over its time: what plots, tables and the path in the scene are made of. Metres, radians, seconds.
 *
 * @import { Chain } from '../../kinematics/chain.js'
 * @import { Move } from '../../motion/moves.js'
 * @import { MotionPlan } from '../../motion/plan.js'
 *
 * @typedef {object} PlanSeries
 * @property {Float64Array} times    never falling; where moves meet there are two samples, of before and after
 * @property {Int16Array} moves      index of the move under way
 * @property {readonly Float64Array[]} values         one series a joint, likewise the next three
 * @property {readonly Float64Array[]} rates
 * @property {readonly Float64Array[]} accelerations
 * @property {readonly Float64Array[]} jerks
 * @property {readonly Float64Array[]} place          x y z of the TCP, seen from the world
 * @property {readonly Float64Array[]} orientation    W P R, going on past half a turn where they would jump
 * @property {Float64Array} speed     of the TCP
 * @property {Float64Array} turnSpeed
 * @property {Float64Array} manipulability  as dexterity() has it
 * @property {number} freedoms        of which the manipulability is a power of the length, where `isLinear`
 * @property {boolean} isLinear
 */
import { dexterity } from '../../kinematics/dexterity.js';
import { tcpPose } from '../../kinematics/forward.js';
import { geometricJacobian } from '../../kinematics/jacobian.js';
import { rollPitchYawOf } from '../../kinematics/orientation.js';
import { planMoment, planMomentAt } from '../../motion/planMoment.js';
import { marksOf } from './player.js';

/** s before a mark: what a rate was until then. A microsecond is what nobody sees, and many digits of any time. */
const BEFORE = 1e-6;

/** Samples between two looks at the clock. */
const SLICE = 32;

/** Samples a second, and at least and at most. */
const SAMPLES = { rate: 80, least: 400, most: 2400 };

/**
 * Evenly spread times, with those at which moves meet.
 * @param {Pick<MotionPlan, 'parts' | 'duration'>} plan
 * @param {number} count  of the evenly spread ones, 2 or more
 */
export function sampleTimes(plan, count) {
  const { duration } = plan;
  const even = Array.from({ length: count }, (_, i) => (duration * i) / (count - 1));
  const inner = marksOf(plan).slice(1, -1);
  const times = [...even, ...inner, ...inner.map((mark) => Math.max(0, mark - BEFORE))];
  return Float64Array.from(new Set(times)).sort();
}

/**
 * The times that are apart by a step, and the end.
 * @param {number} duration  s
 * @param {number} step      s
 */
export function steppedTimes(duration, step) {
  const whole = Math.floor(duration / step + 1e-9);
  const times = Array.from({ length: whole + 1 }, (_, i) => i * step);
  return Float64Array.from(duration - times[whole] > 1e-9 ? [...times, duration] : times);
}

/**
 * The arm with the tool that it has in a move, or waits with after it; undefined: with the active one.
 * @param {readonly Move[]} moves
 * @param {number} index
 * @returns {Chain | undefined}
 */
export function chainOfMove(moves, index) {
  const move = moves[index];
  return move?.kind === 'wait' ? chainOfMove(moves, index - 1) : move?.chain;
}

/**
 * The series of a planned program, as fine as plots want it, or at times of one's own.
 * @param {{ readonly plan: MotionPlan, readonly moves: readonly Move[] }} planned
 * @param {Chain} chain
 * @param {Float64Array} [times]
 */
export function seriesOf({ plan, moves }, chain, times) {
  const count = Math.round(Math.min(SAMPLES.most, Math.max(SAMPLES.least, SAMPLES.rate * plan.duration)));
  return sampleSeries(plan, times ?? sampleTimes(plan, count), (index) => chainOfMove(moves, index) ?? chain);
}

/**
 * In slices, so that the page stays awake: it yields the share that is done.
 * @param {MotionPlan} plan
 * @param {Float64Array} times
 * @param {(move: number) => Chain} chainOf  with the tool that is active in that move
 * @returns {Generator<number, PlanSeries>}
 */
export function* sampleSeries(plan, times, chainOf) {
  const { length } = times;
  const dof = plan.start.length;
  const rows = (/** @type {number} */ count) => Array.from({ length: count }, () => new Float64Array(length));
  const [values, rates, accelerations, jerks] = Array.from({ length: 4 }, () => rows(dof));
  const [place, orientation] = [rows(3), rows(3)];
  const [speed, turnSpeed, manipulability] = rows(3);
  const moves = new Int16Array(length);
  const now = planMoment(dof);
  const [T, J] = [new Float64Array(16), new Float64Array(6 * dof)];
  let [freedoms, isLinear] = [0, false];
  for (let k = 0; k < length; k++) {
    planMomentAt(plan, times[k], now);
    const chain = chainOf(now.move);
    moves[k] = now.move;
    for (let i = 0; i < dof; i++) {
      values[i][k] = now.posture[i];
      rates[i][k] = now.rates[i];
      accelerations[i][k] = now.accelerations[i];
      jerks[i][k] = now.jerks[i];
    }
    tcpPose(chain, now.posture, T);
    const angles = rollPitchYawOf(T);
    for (let i = 0; i < 3; i++) {
      place[i][k] = T[12 + i];
      orientation[i][k] = k > 0 ? nearest(angles[i], orientation[i][k - 1]) : angles[i];
    }
    geometricJacobian(chain, now.posture, J);
    [speed[k], turnSpeed[k]] = [0, 3].map((first) => lengthOf(J, now.rates, first));
    const found = dexterity(chain, now.posture);
    manipulability[k] = found.manipulability;
    [freedoms, isLinear] = [found.freedoms, found.part === 'linear'];
    if (k % SLICE === SLICE - 1) yield (k + 1) / length;
  }
  const joints = { values, rates, accelerations, jerks };
  return { times, moves, ...joints, place, orientation, speed, turnSpeed, manipulability, freedoms, isLinear };
}

/** The same angle, so many whole turns on that it is near another. @param {number} angle @param {number} other */
const nearest = (angle, other) => angle + 2 * Math.PI * Math.round((other - angle) / (2 * Math.PI));

/** How fast the TCP moves (first = 0) or turns (3). @param {Float64Array} J @param {Float64Array} rates @param {number} first */
function lengthOf(J, rates, first) {
  let sum = 0;
  for (let row = first; row < first + 3; row++) {
    let value = 0;
    for (let i = 0; i < rates.length; i++) value += J[6 * i + row] * rates[i];
    sum += value * value;
  }
  return Math.sqrt(sum);
}

/**
 * The place of a time in a series, by halving: the last sample that is not after it.
 * @param {Float64Array} times
 * @param {number} time
 */
export function indexAt(times, time) {
  let [low, high] = [0, times.length - 1];
  while (low < high) {
    const middle = (low + high + 1) >> 1;
    if (times[middle] <= time) low = middle;
    else high = middle - 1;
  }
  return low;
}

/**
 * The value of a series at a time, straight between samples.
 * @param {Float64Array} times
 * @param {Float64Array} series
 * @param {number} time
 */
export function valueAt(times, series, time) {
  const i = indexAt(times, time);
  const span = times[i + 1] - times[i];
  if (!(span > 0)) return series[i];
  const share = Math.min(1, Math.max(0, (time - times[i]) / span));
  return series[i] + share * (series[i + 1] - series[i]);
}
