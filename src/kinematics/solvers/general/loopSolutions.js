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
import { closeLoop, freeDirection, gapAt } from './loopClosure.js';

const FULL_TURN = 2 * Math.PI;

/** A polynomial that stands out of its noise by less than this says nothing. */
const SIGNAL = 10;

/** Two postures nearer than this (radians, arm lengths) are one. */
const SAME = 1e-8;

/**
 * Where a solution is double, or worse, rounding leaves room for many postures around it that close the loop nearly as well.
 * Two postures nearer than this are one if the posture half-way closes the loop too, but for so many times what they leave
 * open. (Two that are each 1e-6 from a singularity leave 1e-13 open half-way between them, and 1e-15 themselves.)
 */
const PERHAPS_SAME = 0.02;
const HALF_WAY = 4;
const ROUNDING = 5e-16;

/**
 * Newton's method also comes to rest between two solutions, where the Jacobian is singular. So a posture that leaves more open
 * than this, which is more than rounding does, is none if one that leaves less is near it.
 */
const LOOSE = 1e-14;

/** Where a zero leads nowhere, so many of its starts get a second chance. */
const RETRIES = 2;

/** Newton steps from a posture that should be a solution but for rounding; and from beside one that is nearly double. */
const STEPS = 12;
const STEPS_BESIDE = 40;

/** Where to start beside a nearly double solution, along the singular direction: near it and ever less near. */
const BESIDE = [1, -1, 30, -30, 1000, -1000];
const NEAR = 1e-5;

/** The last pivot over the first: a posture below this may be a double solution, or has another one beside it. */
const SINGULAR = 1e-6;
const NEARLY_SINGULAR = 1e-3;

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

const between = new Float64Array(6);

/**
 * @param {Loop} loop
 * @param {Float64Array} q
 * @param {Float64Array} other
 */
function isSame(loop, q, other) {
  const way = wayBetween(loop.slides, q, other);
  if (way < SAME || way > PERHAPS_SAME) return way < SAME;
  for (let i = 0; i < q.length; i++) {
    between[i] = other[i] + (loop.slides[i] ? q[i] - other[i] : wrapped(q[i] - other[i])) / 2;
  }
  return gapAt(loop, between) <= HALF_WAY * Math.max(gapAt(loop, q), gapAt(loop, other), ROUNDING);
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

/** How many zeros there may be. @param {Report} report */
export const mostZeros = ({ zeros }) => zeros.reduce((sum, { count }) => sum + count, 0);

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
      if (addFrom(loop, q, STEPS, found) && isHere(q)) isMet = true;
    }
    if (isMet) continue;
    for (const start of starts.slice(0, RETRIES)) {
      freeDirection(loop, start, direction);
      addBeside(loop, start, 4 * zero.width + NEAR, found);
    }
  }
}

/**
 * Beside a nearly singular solution there is another one, or it is double: which, is seen by starting there.
 * @param {Loop} loop
 * @param {Float64Array[]} found  new solutions are added
 */
export function lookBeside(loop, found) {
  for (const q of found.slice()) {
    if (freeDirection(loop, q, direction) > NEARLY_SINGULAR) continue;
    closeLoop(loop, q, STEPS, 0);
    addBeside(loop, q.slice(), NEAR, found, gapAt(loop, q) > LOOSE ? 2 : 1);
  }
  mergeSame(loop, found);
  dropRests(loop, found);
}

/** Of places between solutions only the solutions stay. @param {Loop} loop @param {Float64Array[]} found  changed in place */
function dropRests(loop, found) {
  const exact = found.filter((q) => gapAt(loop, q) <= LOOSE);
  const isRest = (/** @type {Float64Array} */ q) =>
    !exact.includes(q) && exact.some((other) => wayBetween(loop.slides, q, other) < PERHAPS_SAME);
  for (let i = found.length - 1; i >= 0; i--) if (isRest(found[i])) found.splice(i, 1);
}

/** Postures may have moved on to where others are. @param {Loop} loop @param {Float64Array[]} found  changed in place */
export function mergeSame(loop, found) {
  for (let i = found.length - 1; i > 0; i--) {
    const same = found.findIndex((other, j) => j < i && isSame(loop, found[i], other));
    if (same < 0) continue;
    if (gapAt(loop, found[i]) < gapAt(loop, found[same])) found[same].set(found[i]);
    found.splice(i, 1);
  }
}

/**
 * @param {Loop} loop
 * @param {Float64Array} q
 * @param {number} way   along `direction`, radians or arm lengths of the joint that moves most
 * @param {Float64Array[]} found
 * @param {number} [wanted]  how many are enough: there is one on either side of a place between two
 */
function addBeside(loop, q, way, found, wanted = 1) {
  const { length } = found;
  for (const share of BESIDE) {
    const start = q.map((value, i) => value + share * way * direction[i]);
    addFrom(loop, start, STEPS_BESIDE, found, 0);
    if (found.length >= length + wanted) return;
  }
}

/**
 * @param {Loop} loop
 * @param {Float64Array} q   changed in place, kept if it is a new solution then
 * @param {number} steps
 * @param {Float64Array[]} found
 * @param {number} [grain]  as for closeLoop
 * @returns {boolean} whether it is a solution, new or not
 */
export function addFrom(loop, q, steps, found, grain) {
  if (!closeLoop(loop, q, steps, grain)) return false;
  for (let i = 0; i < q.length; i++) if (!loop.slides[i]) q[i] = wrapped(q[i]);
  const known = found.find((other) => isSame(loop, q, other));
  if (!known) found.push(q);
  else if (gapAt(loop, q) < gapAt(loop, known)) known.set(q);
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
 * Whether zeros and solutions correspond: as many solutions at each as it stands for, and none elsewhere.
 * @param {Report} report
 * @param {Loop} loop
 * @param {Float64Array[]} found
 * @param {boolean} [areDoubles]  whether singular postures stand for two, and loose ones count: when `lookBeside` has found no others
 */
export function isExplained({ hidden, zeros }, loop, found, areDoubles = false) {
  let count = 0;
  for (const group of grouped(zeros)) {
    const here = found.filter((q) => group.some((zero) => Math.abs(wrapped(q[hidden] - zero.angle)) < reachOf(zero)));
    if (!areDoubles && here.some((q) => gapAt(loop, q) > LOOSE)) return false;
    const expected = group.reduce((sum, zero) => sum + zero.count, 0);
    const weight = (/** @type {Float64Array} */ q) => (freeDirection(loop, q, direction) < SINGULAR ? 2 : 1);
    const isEnough =
      here.length === expected || (areDoubles && here.reduce((sum, q) => sum + weight(q), 0) === expected);
    if (!isEnough) return false;
    count += here.length;
  }
  return count === found.length;
}
