/**
 * All postures of an arm whose last turning axes meet in one point, the wrist centre W (Pieper 1968): the joints
 * before them, three at most, bring W to its place (regional.js), which the wrist does not move; then the wrist turns
 * the tool (wristTurns.js). An arm whose *first* axes meet is the same arm seen from its tool: its joints in the
 * opposite order, backwards.
 *
 * @import { Candidates, Family } from './candidates.js'
 * @import { Line, Rotation, Vector } from '../lines.js'
 * @import { OrthoParallel } from './orthoParallel.js'
 * @import { Pose } from '../pose.js'
 * @import { Regional, RegionalSolution } from './regional.js'
 * @import { Screws } from '../screws.js'
 *
 * @typedef {object} WristPartition   lengths in units of `length`
 * @property {readonly Line[]} lines
 * @property {number} wrist    how many joints turn about the centre, 0 to 3
 * @property {Vector} centre
 * @property {Regional} regional
 * @property {boolean} isReversed  the lines are those of the arm seen from its tool
 * @property {Pose} homeInverse
 * @property {number} length   m
 * @property {OrthoParallel | null} fast   the constants of the shorter way, for arms that allow it
 */
import {
  cross,
  dot,
  footOn,
  largestDifference,
  minus,
  moved,
  nearestTo,
  norm,
  product,
  rotate,
  transposed,
  turn,
} from '../lines.js';
import { recogniseOrthoParallel, writeOrthoParallelPostures } from './orthoParallel.js';
import { compose, invert } from '../pose.js';
import { isDeficient, prepareRegional, solveRegional } from './regional.js';
import { solveTurns } from './wristTurns.js';

/** Lines meet or are parallel within this: arm lengths, radians. */
const TOLERANCE = 1e-9;

/** A candidate that misses the goal by more (arm lengths, radians) is none; polishing brings a true one much nearer. */
const PLAUSIBLE = 1e-4;

/**
 * @param {Screws} screws
 * @returns {WristPartition | null}
 */
export function recogniseWristPartition(screws) {
  const { dof, slides, axes, points, home, length: given } = screws;
  const length = given > 0 ? given : 1;
  /** @type {Line[]} */
  const lines = Array.from({ length: dof }, (_, i) => ({
    slides: slides[i],
    axis: [axes[3 * i], axes[3 * i + 1], axes[3 * i + 2]],
    point: [points[3 * i] / length, points[3 * i + 1] / length, points[3 * i + 2] / length],
  }));
  const tcp = /** @type {Vector} */ ([home[12] / length, home[13] / length, home[14] / length]);
  const ways = [partitionOf(lines, tcp), partitionOf(lines.toReversed(), tcp)];
  // The better one is the one that leaves less to the joints before the wrist.
  const best = ways[1] && ways[1].wrist > (ways[0]?.wrist ?? -1) ? 1 : 0;
  const partition = ways[best];
  if (!partition) return null;
  const fast = recogniseOrthoParallel(screws);
  return { ...partition, isReversed: best === 1, homeInverse: invert(home), length, fast };
}

/**
 * @param {readonly Line[]} lines
 * @param {Vector} tcp
 * @returns {Pick<WristPartition, 'lines' | 'wrist' | 'centre' | 'regional'> | null}
 */
function partitionOf(lines, tcp) {
  const { wrist, centre } = wristOf(lines, tcp);
  const first = lines.length - wrist;
  if (first > 3) return null;
  const regional = prepareRegional(lines.slice(0, first), centre);
  // One joint too many for the place, and the orientation has to decide which: that is not how this works, unless the
  // wrist makes up for whatever the others turn.
  const [axis, ...others] = lines.filter(({ slides }) => !slides);
  const makesUp = wrist === 3 || !axis || (wrist > 0 && others.every((line) => areParallel(line, axis)));
  if (!makesUp && isDeficient(regional)) return null;
  return { lines, wrist, centre, regional };
}

/**
 * The joints at the end of a chain whose axes meet.
 * @param {readonly Line[]} lines
 * @param {Vector} tcp
 * @returns {{ wrist: number, centre: Vector }}
 */
function wristOf(lines, tcp) {
  const last = lines.at(-1);
  const second = lines.at(-2);
  const third = lines.at(-3);
  if (!last || last.slides) return { wrist: 0, centre: tcp };
  if (!second || second.slides || areParallel(second, last)) return { wrist: 1, centre: footOn(last, tcp) };
  const centre = nearestTo(last, second);
  if (distanceTo(second, centre) > TOLERANCE) return { wrist: 1, centre };
  const isThree = third && !third.slides && !areParallel(third, second) && distanceTo(third, centre) <= TOLERANCE;
  return { wrist: isThree ? 3 : 2, centre };
}

/** @param {Line} a @param {Line} b */
const areParallel = (a, b) => norm(cross(a.axis, b.axis)) < TOLERANCE;

/** @param {Line} line @param {Vector} point */
const distanceTo = (line, point) => norm(minus(point, footOn(line, point)));

const eight = new Float64Array(48);
const ALL_EIGHT = 0xff;

/** Those of the eight that are there. @param {number} bits */
function posturesOf(bits) {
  /** @type {Float64Array[]} */
  const postures = [];
  for (let k = 0; k < 8; k++) {
    if (((bits >> k) & 1) === 0) continue;
    const q = new Float64Array(6);
    for (let i = 0; i < 6; i++) q[i] = eight[6 * k + i];
    postures.push(q);
  }
  return postures;
}

/**
 * @param {WristPartition} constants
 * @param {ArrayLike<number>} T_start_goal
 * @returns {Candidates}
 */
export function solveWristPartition(constants, T_start_goal) {
  const { centre, regional, isReversed, homeInverse, length, fast } = constants;
  if (fast) {
    const bits = writeOrthoParallelPostures(fast, T_start_goal, eight);
    if (bits <= ALL_EIGHT) return { postures: posturesOf(bits), families: [], isComplete: true };
  }
  // What the joints have to do together: the goal is this, done to where the tool is at home.
  const forward = compose(T_start_goal, homeInverse);
  const move = isReversed ? invert(forward) : forward;
  const R = [move[0], move[1], move[2], move[4], move[5], move[6], move[8], move[9], move[10]];
  const p = /** @type {Vector} */ ([move[12] / length, move[13] / length, move[14] / length]);
  const [x, y, z] = rotate(R, centre);
  const P = /** @type {Vector} */ ([x + p[0], y + p[1], z + p[2]]);
  const found = allOrientations(constants, solveRegional(regional, P), { R, p });
  const onAxis = found.postures.length === 0 && constants.wrist < 3 ? broughtToAxis(regional, P) : null;
  // So near to axis 1 the place tells little of the angle; with fewer than six joints the orientation tells it.
  return onAxis ? allOrientations(constants, solveRegional(regional, onAxis), { R, p }) : found;
}

/**
 * @param {Regional} regional
 * @param {Vector} P
 * @returns {Vector | null}  the point of the first axis that P is all but on, if so
 */
function broughtToAxis({ before, joints }, P) {
  const first = before ?? joints[0];
  if (!first || first.slides) return null;
  const foot = footOn(first, P);
  const distance = norm(minus(P, foot));
  return distance > 0 && distance < PLAUSIBLE ? foot : null;
}

/**
 * @param {WristPartition} constants
 * @param {readonly RegionalSolution[]} places
 * @param {{ R: Rotation, p: Vector }} goal
 * @returns {Candidates}
 */
function allOrientations(constants, places, goal) {
  /** @type {Candidates} */
  const found = { postures: [], families: [], isComplete: true };
  for (const place of places) {
    const isProven = addOrientations(constants, place, goal, found);
    // Where joints move together there may be more families than the one that a member was taken of.
    found.isComplete &&= isProven && !place.isTurning;
  }
  return found;
}

/**
 * @param {WristPartition} constants
 * @param {RegionalSolution} place
 * @param {{ R: Rotation, p: Vector }} goal
 * @param {Candidates} found  added to
 * @returns {boolean} whether it is proven that there are no others
 */
function addOrientations(constants, { q, free, coupled, isTurning }, goal, found) {
  const { lines, wrist } = constants;
  const first = lines.length - wrist;
  let fixed = turn([0, 0, 1], 0);
  /** @type {number[]} */
  const turning = [];
  /** @type {Vector[]} */
  const axes = [];
  lines.forEach((line, i) => {
    if (i >= first || free.includes(i)) {
      turning.push(i);
      axes.push(rotate(fixed, line.axis));
    } else if (!line.slides) {
      fixed = product(fixed, turn(line.axis, q[i]));
    }
  });
  const { angles, families, isComplete } = solveTurns(axes, product(goal.R, transposed(fixed)));
  const together = isTurning && coupled.some((i) => !lines[i].slides) ? coupled.concat(turning) : coupled;
  for (const { angles: some, moving } of [...angles.map((each) => ({ angles: each, moving: [] })), ...families]) {
    const all = [...q, ...Array.from({ length: wrist }, () => 0)];
    some.forEach((angle, i) => (all[turning[i]] = angle));
    if (!isNear(constants, all, goal)) continue;
    const joints = [...moving.map((i) => turning[i]), ...together];
    if (joints.length === 0) found.postures.push(jointValues(constants, all));
    else found.families.push(familyOf(constants, all, joints));
  }
  return isComplete;
}

/**
 * @param {WristPartition} constants
 * @param {number[]} q
 * @param {number[]} moving
 * @returns {Family}
 */
function familyOf(constants, q, moving) {
  const { lines, wrist, isReversed } = constants;
  const n = lines.length;
  const joints = [...new Set(moving)].map((i) => (isReversed ? n - 1 - i : i)).sort((a, b) => a - b);
  const isWrist = !isReversed && joints.every((i) => i >= n - wrist);
  const isShoulder = !isReversed && joints[0] === 0 && joints.every((i) => i === 0 || i >= n - wrist);
  return { kind: isWrist ? 'wrist' : isShoulder ? 'shoulder' : 'other', q: jointValues(constants, q), joints };
}

/** As the arm counts them. @param {WristPartition} constants @param {number[]} q */
function jointValues({ lines, isReversed, length }, q) {
  const scaled = q.map((value, i) => (lines[i].slides ? value * length : value));
  return Float64Array.from(isReversed ? scaled.reverse().map((value) => -value) : scaled);
}

/**
 * Whether a posture comes anywhere near the goal: fewer than six joints meet few goals.
 * @param {WristPartition} constants
 * @param {number[]} q
 * @param {{ R: Rotation, p: Vector }} goal
 */
function isNear({ lines }, q, { R, p }) {
  let rotation = turn([0, 0, 1], 0);
  /** @type {Vector} */
  let point = [0, 0, 0];
  for (let i = lines.length - 1; i >= 0; i--) {
    point = moved(lines[i], q[i], point);
    if (!lines[i].slides) rotation = product(turn(lines[i].axis, q[i]), rotation);
  }
  const miss = minus(point, p);
  return Math.sqrt(dot(miss, miss)) < PLAUSIBLE && largestDifference(rotation, R) < PLAUSIBLE;
}
