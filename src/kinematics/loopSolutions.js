/**
 * The solutions that one elimination leads to, and whether they are all.
 *
 * @import { Elimination } from './elimination.js'
 * @import { Loop } from './loopClosure.js'
 * @import { Zero } from './circleRoots.js'
 *
 * @typedef {object} Report   of one elimination, for one pose
 * @property {number} hidden  the joint that the zeros are angles of
 * @property {Zero[]} zeros   in the order of their angles
 */
import { posturesAt } from './backSubstitution.js';
import { circleZeros } from './circleRoots.js';
import { eliminate } from './elimination.js';
import { closeLoop, freeDirection } from './loopClosure.js';

const FULL_TURN = 2 * Math.PI;

/** A polynomial that stands out of its noise by less than this says nothing. */
const SIGNAL = 10;

/**
 * Two postures nearer than this (radians, arm lengths) are one. Where a solution is double, rounding in the closed loop
 * (1e-15) is 3e-8 of a joint; two that are each 1e-6 from a singularity are ten times farther apart.
 */
const SAME = 2e-7;

/** Newton steps from a posture that should be a solution but for rounding; and from beside one that is nearly double. */
const STEPS = 12;
const STEPS_BESIDE = 40;

/** Where to start beside a nearly double solution: in widths of the cluster along the singular direction. */
const BESIDE = [4, -4, 60, -60];

/** The last pivot over the first: a posture below this is a double solution, as far as rounding lets one see. */
const SINGULAR = 1e-6;

/** @param {number} angle @returns {number} from −π to π */
export const wrapped = (angle) => angle - FULL_TURN * Math.round(angle / FULL_TURN);

/**
 * How far apart two postures are, in the joint that differs most.
 * @param {readonly boolean[]} slides
 * @param {Float64Array} a
 * @param {Float64Array} b
 */
function wayBetween(slides, a, b) {
  let most = 0;
  for (let i = 0; i < a.length; i++) {
    most = Math.max(most, Math.abs(slides[i] ? a[i] - b[i] : wrapped(a[i] - b[i])));
  }
  return most;
}

/** @param {readonly boolean[]} slides @param {Float64Array} q @param {readonly Float64Array[]} found */
function isNew(slides, q, found) {
  for (const other of found) if (wayBetween(slides, q, other) < SAME) return false;
  return true;
}

/** How far from a zero its solutions may be, in the hidden joint. @param {Zero} zero */
const reachOf = ({ width, count }) => (count > 1 ? 1e-5 : 1e-6) + 10 * width;

/**
 * @param {Elimination} elimination
 * @param {Loop} loop
 * @returns {Report | null} null if the polynomial is zero
 */
export function zerosOf(elimination, loop) {
  const { coefficients, noise, size } = eliminate(elimination, loop.lines, loop.goal);
  if (!(size > SIGNAL * noise)) return null;
  return { hidden: elimination.hidden, zeros: circleZeros(coefficients, noise) };
}

/** Whether the hidden joint is at one of the zeros. @param {Report} report @param {Float64Array} q */
export const isAtZero = ({ hidden, zeros }, q) =>
  zeros.some((zero) => Math.abs(wrapped(q[hidden] - zero.angle)) < reachOf(zero));

/** Whether every zero is known to be one. @param {Report} report */
export const isClear = ({ zeros }) => zeros.every(({ count }) => count === 1);

const direction = new Float64Array(6);

/**
 * From the zeros back to solutions. Call it right after `zerosOf`.
 * @param {Elimination} elimination
 * @param {Loop} loop
 * @param {Report} report
 * @param {Float64Array[]} found   what is known already; new solutions are added
 */
export function followZeros(elimination, loop, { hidden, zeros }, found) {
  for (const zero of zeros) {
    const isHere = (/** @type {Float64Array} */ q) => Math.abs(wrapped(q[hidden] - zero.angle)) < reachOf(zero);
    if (zero.count === 1 && found.some(isHere)) continue;
    const starts = posturesAt(elimination, loop, zero.angle);
    let isMet = false;
    for (const start of starts) {
      const q = start.slice();
      if (!addFrom(loop, q, STEPS, found)) continue;
      isMet ||= isHere(q);
    }
    if (isMet && zero.count === 1) continue;
    for (const start of starts) {
      freeDirection(loop, start, direction);
      for (const way of BESIDE) {
        const q = start.map((value, i) => value + way * (zero.width + 1e-6) * direction[i]);
        addFrom(loop, q, STEPS_BESIDE, found);
      }
    }
  }
}

/**
 * @param {Loop} loop
 * @param {Float64Array} q   changed in place, kept if it is a new solution then
 * @param {number} steps
 * @param {Float64Array[]} found
 * @returns {boolean} whether it is a solution, new or not
 */
export function addFrom(loop, q, steps, found) {
  if (!closeLoop(loop, q, steps)) return false;
  for (let i = 0; i < q.length; i++) if (!loop.slides[i]) q[i] = wrapped(q[i]);
  if (isNew(loop.slides, q, found)) found.push(q);
  return true;
}

/**
 * Zeros with others in their reach, as groups: one group's zeros and solutions cannot be told from one another.
 * @param {Zero[]} zeros
 * @returns {Zero[][]}
 */
function grouped(zeros) {
  /** @type {Zero[][]} */
  const groups = [];
  for (const zero of zeros) {
    const last = groups.at(-1)?.at(-1);
    if (last && zero.angle - last.angle < reachOf(zero) + reachOf(last)) groups.at(-1)?.push(zero);
    else groups.push([zero]);
  }
  return groups;
}

/**
 * Whether zeros and solutions correspond: as many solutions at each as it stands for, and none elsewhere. A singular posture
 * stands for two solutions.
 * @param {Report} report
 * @param {Loop} loop
 * @param {Float64Array[]} found
 */
export function isExplained({ hidden, zeros }, loop, found) {
  let count = 0;
  for (const group of grouped(zeros)) {
    const here = found.filter((q) => group.some((zero) => Math.abs(wrapped(q[hidden] - zero.angle)) < reachOf(zero)));
    const expected = group.reduce((sum, zero) => sum + zero.count, 0);
    const isEnough =
      here.length === expected ||
      here.reduce((sum, q) => sum + (freeDirection(loop, q, direction) < SINGULAR ? 2 : 1), 0) === expected;
    if (!isEnough) return false;
    count += here.length;
  }
  return count === found.length;
}
