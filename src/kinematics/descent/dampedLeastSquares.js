/**
 * Damped least squares (Levenberg–Marquardt) on the finite-difference Jacobian, inside the joint limits: from one posture
 * downhill to one posture. Allocates nothing.
 *
 * What is minimised is ½ (|position error| / L)² + ½ |orientation error|², with L the chain's characteristic length; slides
 * count in units of L too. So the search is the same in every unit and at every scale.
 *
 * The damping is proportional to what is minimised (Chan & Lawrence 1988), more while steps fail; a step that does not go
 * downhill is not taken. A step follows the bend of its own way (bend.js), unless it is long: that saves one iteration in
 * four. Next to a singularity the way down is a narrow bent valley in which such a search soon stands still, just short of
 * the goal; there, and only there, it may leap: a few undamped steps, uphill or not. (Without them poses within 1e-6 of a
 * singularity take ten times the starts. The constants were chosen on generated poses of 22 arms; none matters much: damping
 * from 0.07 to 0.2, patience from 2 to 6, and 3 leaps or more differ by a tenth.)
 *
 * @import { Search } from './search.js'
 *
 * @typedef {'met' | 'rest' | 'cut'} Descent  within tolerance; nothing improves any more; iterations spent before either
 */
import { writeBend } from './bend.js';
import { solveAgain, solveCholesky } from '../cholesky.js';
import { createStep, writeDifferences, writeWork } from '../differences.js';
import { DEFAULT_STEP } from '../jacobian.js';
import { bringInside } from '../limits.js';
import { poseDifference } from '../pose.js';
import { writeNormalEquations } from './normalEquations.js';
import { copy } from './search.js';
import { shapeJacobian, shapeResidual, taskTurn } from './task.js';

const STEP = createStep(DEFAULT_STEP.forward);

const DAMPING = 0.1;
const MOST_COST = 1; // a goal many arm lengths off, as for a long slide, is not to be approached in ever smaller steps
const LEAST_DAMPING = 1e-14; // of squares of order 1: only keeps a rank-deficient system solvable
const MORE_DAMPING = 4;
const LESS_DAMPING = 0.25;

/** A step that bends by more than this (radians, arm lengths), or by more than itself, is too long to know its bend. */
const MOST_BEND = 2;

/** Standstill: so many iterations in a row leave more than this share of the least cost so far, or so many steps fail. */
const PATIENCE = { hunting: 2, settling: 4 };
const SHARE = { hunting: 0.98, settling: 1 - 1e-9 };
const TRIES = { hunting: 6, settling: 20 };

/** So near the goal (half the error squared) a standstill is most likely a bend, and so often the search may leap. */
const NEARLY_MET = 1e-8;
const LEAPS = 8;

/**
 * The residual at a posture.
 * @param {Search} search
 * @param {Float64Array} q
 * @returns {boolean} whether the task is met within tolerance; `search.cost` says how far it is
 */
function measure(search, q) {
  const { packed, work, goal, residual: r } = search;
  writeWork(packed, q, work);
  poseDifference(work.tcp, goal, r);
  const linear = r[0] * r[0] + r[1] * r[1] + r[2] * r[2];
  let turn = 0;
  if (search.task !== 'pose') {
    turn = taskTurn(search.task, search.up, work.tcp, goal, r);
    shapeResidual(search.task, search.spare, r);
  }
  const angular = r[3] * r[3] + r[4] * r[4] + r[5] * r[5];
  if (search.task === 'pose') turn = Math.sqrt(angular);
  search.cost = 0.5 * (linear * search.weight + angular);
  return Math.sqrt(linear) <= search.positionTolerance && turn <= search.orientationTolerance;
}

/**
 * The normal equations at the posture that was measured last.
 * @param {Search} search
 */
function linearise(search) {
  const { packed, work, unit, J } = search;
  writeDifferences(packed, work, STEP, J);
  shapeJacobian(search.task, search.spare, J);
  for (let i = 0; i < unit.length; i++) {
    if (unit[i] !== 1) for (let k = 6 * i; k < 6 * i + 6; k++) J[k] *= unit[i];
  }
  writeNormalEquations(search);
  if (search.isBounded) holdJoints(search);
}

/**
 * A joint at a limit that it would go past is taken out of the normal equations.
 * @param {Search} search
 */
function holdJoints({ packed: { lower, upper }, q, H, gradient }) {
  const n = q.length;
  for (let i = 0; i < n; i++) {
    const value = q[i];
    if (value > lower[i] && value < upper[i]) continue;
    const isHeld = (value <= lower[i] && gradient[i] <= 0) || (value >= upper[i] && gradient[i] >= 0);
    if (!isHeld) continue;
    for (let j = 0; j < n; j++) H[Math.max(i, j) * n + Math.min(i, j)] = 0;
    H[i * n + i] = 1;
    gradient[i] = 0;
  }
}

/**
 * Solve (JᵀJ + damping) step = gradient, let the step follow its bend, and write where it goes into `search.trial`. A step
 * so short that its square is within tolerance arrives without.
 * @param {Search} search
 * @param {number} damping
 * @returns {boolean}
 */
function writeTrial(search, damping) {
  const { packed, task, isBounded, turnsBack, q, trial, weight, J, H, gradient, step, bend, unit } = search;
  if (!solveCholesky(H, gradient, step, damping)) return false;
  if (task === 'pose') {
    const straight = squareOf(step);
    if (straight > search.finest) {
      writeBend(J, weight, step, gradient, bend);
      solveAgain(bend, bend);
      const square = squareOf(bend);
      if (square < straight && square < MOST_BEND * MOST_BEND) {
        for (let i = 0; i < q.length; i++) step[i] += bend[i];
      }
    }
  }
  const { lower, upper } = packed;
  for (let i = 0; i < q.length; i++) {
    const value = q[i] + step[i] * unit[i];
    const isInside = value >= lower[i] && value <= upper[i];
    if (isInside || !isBounded) trial[i] = value;
    else trial[i] = turnsBack ? bringInside(packed, i, value) : value < lower[i] ? lower[i] : upper[i];
  }
  return true;
}

/** @param {Float64Array} values */
function squareOf(values) {
  let sum = 0;
  for (let i = 0; i < values.length; i++) sum += values[i] * values[i];
  return sum;
}

/**
 * From `search.q` downhill; `search.q` and `search.cost` are the lowest it came to.
 * @param {Search} search
 * @returns {Descent}
 */
export function descend(search) {
  const { q, trial, lowest, isSettling, maxIterations } = search;
  const share = isSettling ? SHARE.settling : SHARE.hunting;
  const patience = isSettling ? PATIENCE.settling : PATIENCE.hunting;
  const mostTries = isSettling ? TRIES.settling : TRIES.hunting;
  const leastDamping = isSettling ? 0 : DAMPING;
  let leaps = isSettling ? 0 : LEAPS;
  let isMet = measure(search, q);
  let least = Infinity; // cost of all
  let bar = Infinity; // likewise, since the last leap
  let slow = 0;
  let damping = DAMPING;
  /** @type {Descent} */
  let end = 'cut';
  copy(q, lowest);
  for (let iteration = 0; ; iteration++) {
    if (isMet && search.spare === 0) return 'met';
    const { cost } = search;
    if (cost < least) {
      least = cost;
      copy(q, lowest);
    }
    if (iteration === maxIterations) break;
    slow = cost > share * bar ? slow + 1 : 0;
    bar = Math.min(bar, cost);

    search.iterations++;
    linearise(search);
    let isBetter = false;
    for (let tries = 0; slow < patience && tries < mostTries && !isBetter; tries++) {
      if (!writeTrial(search, damping * Math.min(cost, MOST_COST) + LEAST_DAMPING)) break;
      isMet = measure(search, trial);
      isBetter = isMet || search.cost < cost;
      damping = isBetter ? Math.max(leastDamping, damping * LESS_DAMPING) : damping * MORE_DAMPING;
    }
    if (!isBetter) {
      const canLeap = cost < NEARLY_MET && leaps-- > 0 && writeTrial(search, LEAST_DAMPING);
      if (!canLeap) {
        end = 'rest';
        break;
      }
      isMet = measure(search, trial);
      bar = Infinity;
      slow = 0;
      damping = DAMPING;
    }
    copy(trial, q);
  }
  copy(lowest, q);
  search.cost = least;
  return end;
}
