/**
 * All postures of an arm whose last turning axes meet in one point, the wrist centre W (Pieper 1968): the joints before them, three
 * at most, bring W to its place (regional.js), which the wrist does not move; then the wrist turns the tool (wristTurns.js). An arm whose
 * *first* axes meet is the same arm seen from its tool: its joints in the opposite order, backwards.
 *
 * @import { Candidates, Family } from './candidates.js'
 * @import { Line, Vector } from './lines.js'
 * @import { Pose } from './pose.js'
 * @import { Regional, RegionalSolution } from './regional.js'
 * @import { Screws } from './screws.js'
 *
 * @typedef {object} WristPartition   lengths in units of `length`
 * @property {readonly Line[]} lines
 * @property {number} wrist    how many joints turn about the centre, 0 to 3
 * @property {Vector} centre
 * @property {Regional} regional
 * @property {boolean} isReversed  the lines are those of the arm seen from its tool
 * @property {Pose} homeInverse
 * @property {number} length   m
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
} from './lines.js';
import { compose, invert } from './pose.js';
import { prepareRegional, solveRegional } from './regional.js';
import { solveTurns } from './wristTurns.js';

/** Lines meet or are parallel within this: arm lengths, radians. */
const TOLERANCE = 1e-9;

/** A candidate that misses the goal by more (arm lengths, radians) is none; polishing brings a true one much nearer. */
const PLAUSIBLE = 1e-4;

/**
 * @param {Screws} screws
 * @returns {WristPartition | null}
 */
export function recogniseWristPartition({ dof, slides, axes, points, home, length: given }) {
  const length = given > 0 ? given : 1;
  /** @type {Line[]} */
  const lines = Array.from({ length: dof }, (_, i) => ({
    slides: slides[i],
    axis: [axes[3 * i], axes[3 * i + 1], axes[3 * i + 2]],
    point: [points[3 * i] / length, points[3 * i + 1] / length, points[3 * i + 2] / length],
  }));
  const tcp = /** @type {Vector} */ ([home[12] / length, home[13] / length, home[14] / length]);
  const reversed = lines.toReversed();
  const there = wristOf(lines, tcp);
  const back = wristOf(reversed, tcp);
  const isReversed = dof - back.wrist <= 3 && back.wrist > there.wrist;
  const { wrist, centre } = isReversed ? back : there;
  if (dof - wrist > 3) return null;
  const ordered = isReversed ? reversed : lines;
  const regional = prepareRegional(ordered.slice(0, dof - wrist), centre);
  return { lines: ordered, wrist, centre, regional, isReversed, homeInverse: invert(home), length };
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

/**
 * @param {WristPartition} constants
 * @param {ArrayLike<number>} T_start_goal
 * @returns {Candidates}
 */
export function solveWristPartition(constants, T_start_goal) {
  const { centre, regional, isReversed, homeInverse, length } = constants;
  // What the joints have to do together: the goal is this, done to where the tool is at home.
  const forward = compose(T_start_goal, homeInverse);
  const move = isReversed ? invert(forward) : forward;
  const R = Float64Array.of(move[0], move[1], move[2], move[4], move[5], move[6], move[8], move[9], move[10]);
  const p = /** @type {Vector} */ ([move[12] / length, move[13] / length, move[14] / length]);
  const [x, y, z] = rotate(R, centre);
  /** @type {Candidates} */
  const found = { postures: [], families: [], isComplete: true };
  for (const solution of solveRegional(regional, [x + p[0], y + p[1], z + p[2]])) {
    addOrientations(constants, solution, { R, p }, found);
  }
  return found;
}

/**
 * @param {WristPartition} constants
 * @param {RegionalSolution} regional
 * @param {{ R: Float64Array, p: Vector }} goal
 * @param {Candidates} found  added to
 */
function addOrientations(constants, { q, free, coupled }, goal, found) {
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
  const R = product(goal.R, transposed(fixed));
  const surplus = Math.max(0, turning.length - 3);
  const { angles, families } = solveTurns(axes.slice(surplus), R);
  const posture = (/** @type {number[]} */ some) => {
    const all = [...q, ...Array.from({ length: wrist }, () => 0)];
    some.forEach((angle, i) => (all[turning[surplus + i]] = angle));
    return all;
  };
  const extra = turning.slice(0, surplus);
  for (const some of angles) {
    const all = posture(some);
    if (!isNear(constants, all, goal)) continue;
    if (surplus === 0 && coupled.length === 0) found.postures.push(jointValues(constants, all));
    else found.families.push(familyOf(constants, all, surplus > 0 ? turning.concat(coupled) : coupled));
  }
  for (const { angles: some, moving } of families) {
    const all = posture(some);
    if (!isNear(constants, all, goal)) continue;
    found.families.push(familyOf(constants, all, [...moving.map((i) => turning[surplus + i]), ...extra, ...coupled]));
  }
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
 * @param {{ R: Float64Array, p: Vector }} goal
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
