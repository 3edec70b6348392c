/**
 * All solutions of an arm of six joints, whatever its geometry, and of one of five: the last resort after the closed forms.
 *
 * An elimination (elimination.js) leaves a polynomial in the angle of one joint, whose real zeros are found with proof
 * (circleRoots.js), and each of which is followed back to a posture and polished on the closed loop. There are up to sixteen
 * eliminations. When an arm is recognised they are tried on a few postures, and put in order; for a pose the next is taken
 * only if the one before has left a doubt: a zero that led nowhere, or zeros so near to one another that noise hides whether
 * they are two, one or none. Solutions are collected from all, and the list is complete if the zeros of any one elimination
 * and the solutions correspond one to one.
 *
 * An arm of five joints gets a sixth, skew to all others, and the solutions wanted are those where it stands at zero.
 *
 * @import { Candidates } from '../candidates.js'
 * @import { Elimination } from './elimination.js'
 * @import { Loop } from './loopClosure.js'
 * @import { Report } from './loopSolutions.js'
 * @import { Screws } from '../../screws.js'
 *
 * @typedef {object} GeneralSix
 * @property {Screws} screws
 * @property {Float64Array} lines  8 · 6, lengths in arm lengths
 * @property {readonly boolean[]} slides
 * @property {readonly Elimination[]} eliminations  the best first
 */
import { fitCircle, SAMPLES } from './circleFit.js';
import { DQ, linesOf, loopProduct, writeGoalMotion } from './dualQuaternion.js';
import { prepareElimination } from './elimination.js';
import { familiesAmong } from './loopFamilies.js';
import {
  addFrom,
  followZeros,
  isAtZero,
  isClear,
  isExplained,
  lookBeside,
  mergeSame,
  mostZeros,
  zerosOf,
} from './loopSolutions.js';
import { createRandom } from '../../random.js';

const JOINTS = 6;

/** @typedef {readonly [Elimination['order'], number]} OrderAndCount */
/** The more exact ones, and those for arms of which few neighbours are skew. @type {readonly (readonly OrderAndCount[])[]} */
const ORDERS = [
  [
    ['before', 6],
    ['after', 6],
  ],
  [['between', 4]],
];

/** Postures that the eliminations are tried on. More make a better choice, and a slower first solution. */
const TRIALS = 3;

/** Eliminations that are kept. */
const KEPT = 6;

/** What a trial costs: a solution lost weighs more than a doubt, and that more than digits, by which the zeros are known. */
const COST = { lost: 1000, doubt: 30 };

/** A sixth joint at zero, up to this (radians): the goal may have been typed with six decimals. */
const STANDS_STILL = 2e-6;

/** Where all are in doubt, so many are followed nevertheless: those that allow fewest zeros. */
const SECOND_LOOKS = 3;

/** Where no elimination says anything, postures are looked for from so many starts. */
const STARTS = 60;
const SEARCH_STEPS = 60;

/**
 * The virtual joint of an arm of five, seen from its home and in arm lengths: nowhere in particular.
 * @param {Screws} screws
 * @returns {Float64Array} 8
 */
function virtualLine({ home, length }) {
  const [x, y, z] = [0.48, 0.6, 0.64];
  const [u, v, w] = [home[12] / length + 0.31, home[13] / length - 0.43, home[14] / length + 0.59];
  return Float64Array.of(0, x, y, z, 0, v * z - w * y, w * x - u * z, u * y - v * x);
}

/** @param {readonly boolean[]} slides @param {() => number} random @returns {Float64Array} */
const anyPosture = (slides, random) => Float64Array.from(slides, (slide) => (2 * random() - 1) * (slide ? 1 : Math.PI));

/**
 * How an elimination does: the less the better; Infinity if it says nothing.
 * @param {Elimination} elimination
 * @param {Pick<Loop, 'lines' | 'slides'>} arm
 * @returns {number}
 */
function costOf(elimination, { lines, slides }) {
  const random = createRandom(1);
  const goal = new Float64Array(DQ);
  let cost = 0;
  let hasWorked = false;
  for (let k = 0; k < TRIALS; k++) {
    const q = anyPosture(slides, random);
    const loop = { lines, slides, goal };
    loopProduct(loop, q, goal);
    const report = zerosOf(elimination, loop);
    if (!report) return Infinity;
    if (!isClear(report)) cost += COST.doubt;
    if (!isAtZero(report, q)) cost += COST.lost;
    if (!hasWorked) {
      /** @type {Float64Array[]} */
      const found = [];
      followZeros(elimination, loop, report, found);
      hasWorked = isExplained(report, loop, found);
      if (!hasWorked) cost += COST.doubt;
    }
    cost += report.zeros.reduce((worst, { width }) => Math.max(worst, Math.log10(width)), -16);
  }
  return hasWorked ? cost : Infinity;
}

/**
 * Those that hide different joints in front: what is doubtful for one joint is hardly so for another.
 * @param {Elimination[]} eliminations  the best first
 */
function varied(eliminations) {
  const firsts = new Map(eliminations.toReversed().map((elimination) => [elimination.hidden, elimination]));
  const isFirst = (/** @type {Elimination} */ elimination) => firsts.get(elimination.hidden) === elimination;
  return [...eliminations.filter(isFirst), ...eliminations.filter((elimination) => !isFirst(elimination))];
}

/**
 * Takes milliseconds, once for an arm.
 * @param {Screws} screws
 * @returns {GeneralSix | null} null for other than five or six joints, and for special arms that every elimination fails on
 */
export function recogniseGeneralSix(screws) {
  if (screws.dof !== JOINTS && screws.dof !== JOINTS - 1) return null;
  const isFive = screws.dof === JOINTS - 1;
  const lines = new Float64Array(DQ * JOINTS);
  lines.set(linesOf(screws));
  if (isFive) lines.set(virtualLine(screws), DQ * screws.dof);
  const slides = Object.freeze(isFive ? [...screws.slides, false] : [...screws.slides]);
  const even = fitCircle(new Float64Array(SAMPLES).fill(1));
  if (!even) return null;
  /** @type {{ elimination: Elimination, cost: number }[]} */
  const useful = [];
  for (const orders of ORDERS) {
    if (useful.length >= KEPT) break;
    for (const [order, count] of orders) {
      for (let first = 0; first < count; first++) {
        const elimination = prepareElimination(lines, slides, order, first, even);
        const cost = elimination ? costOf(elimination, { lines, slides }) : Infinity;
        if (elimination && cost < Infinity) useful.push({ elimination, cost });
      }
    }
  }
  useful.sort((a, b) => a.cost - b.cost);
  const eliminations = varied(useful.map(({ elimination }) => elimination)).slice(0, KEPT);
  return eliminations.length === 0 ? null : { screws, lines, slides, eliminations };
}

/**
 * Solutions of the closed loop, of every joint that it has.
 * @param {readonly Elimination[]} eliminations
 * @param {Loop} loop
 * @returns {{ found: Float64Array[], isComplete: boolean }}
 */
function solveLoop(eliminations, loop) {
  /** @type {Float64Array[]} */
  const found = [];
  /** @type {Report[]} */
  const reports = [];
  /** @type {{ elimination: Elimination, report: Report }[]} */
  const unclear = [];
  for (const elimination of eliminations) {
    const report = zerosOf(elimination, loop);
    if (!report) continue;
    reports.push(report);
    if (!isClear(report)) unclear.push({ elimination, report });
    else if (followsFully(elimination, loop, report, found)) return { found, isComplete: true };
  }
  unclear.sort((a, b) => mostZeros(a.report) - mostZeros(b.report) || 0);
  for (const { elimination, report } of unclear.slice(0, SECOND_LOOKS)) {
    zerosOf(elimination, loop); // for what is remembered of it
    if (followsFully(elimination, loop, report, found)) return { found, isComplete: true };
  }
  if (reports.length === 0) searchFrom(STARTS, loop, found);
  mergeSame(loop, found);
  return { found, isComplete: reports.some((report) => isExplained(report, loop, found, true)) };
}

/**
 * @param {Elimination} elimination
 * @param {Loop} loop
 * @param {Report} report
 * @param {Float64Array[]} found  new solutions are added
 * @returns {boolean} whether these are all
 */
function followsFully(elimination, loop, report, found) {
  followZeros(elimination, loop, report, found);
  if (isExplained(report, loop, found)) return true;
  lookBeside(loop, found);
  return isExplained(report, loop, found, true);
}

/** @param {number} starts @param {Loop} loop @param {Float64Array[]} found */
function searchFrom(starts, loop, found) {
  const random = createRandom(2);
  for (let k = 0; k < starts; k++) addFrom(loop, anyPosture(loop.slides, random), SEARCH_STEPS, found);
}

/**
 * @param {GeneralSix} constants
 * @param {ArrayLike<number>} T_start_goal
 * @returns {Candidates}
 */
export function solveGeneralSix({ screws, lines, slides, eliminations }, T_start_goal) {
  const loop = { lines, slides, goal: new Float64Array(DQ) };
  writeGoalMotion(screws, T_start_goal, loop.goal);
  const { found, isComplete } = solveLoop(eliminations, loop);
  const { dof, length } = screws;
  const wanted = dof === JOINTS ? found : found.filter((q) => Math.abs(q[JOINTS - 1]) < STANDS_STILL);
  const inMetres = (/** @type {Float64Array} */ q) =>
    q.map((value, i) => (slides[i] ? value * length : value)).slice(0, dof);
  if (isComplete) return { postures: wanted.map(inMetres), families: [], isComplete };
  const { isolated, families } = familiesAmong(loop, wanted);
  return {
    postures: isolated.map(inMetres),
    families: families.map((family) => ({ ...family, q: inMetres(family.q) })),
    isComplete,
  };
}
