/**
 * Inverse kinematics against closed-chain-ik, to 1e-6 m and 1e-6 rad: the same poses, the same first postures, by turns. Ours
 * is the search on the finite-difference Jacobian alone, as the peer's; what the whole call takes, which also asks the arm's
 * solver for the solution that is nearest to the seed, is reported beside it.
 *
 * @import { BenchRow } from './run.mjs'
 * @import { Arm } from './arms.mjs'
 */
import { createChain } from '../src/kinematics/chain.js';
import { inverseKinematics } from '../src/kinematics/inverse.js';
import { createRandom } from '../src/kinematics/random.js';
import {
  FIVE_ARMS,
  TOLERANCE,
  isSolved,
  middleOf,
  reachablePoses,
  reachablePostures,
  readArm,
  unreachablePoses,
} from './arms.mjs';
import { BEST_CLAMPS, NO_CLAMPS, createClosedChain } from './closedChain.mjs';
import { geometricMean, median, quantile, timeEach } from './measure.mjs';

const PEER = 'closed-chain-ik';
const TOLERANCES = { positionTolerance: TOLERANCE, orientationTolerance: TOLERANCE };
const NEAR = 0.1; // rad or m

/** @typedef {{ goal: Float64Array, seed: Float64Array }} Question */

/** @param {string} name @returns {Question[]} */
function farQuestions(name) {
  const seed = middleOf(readArm(name));
  return reachablePoses(name).map((goal) => ({ goal, seed }));
}

/** The seed within 0.1 rad or 0.1 m of a solution, and inside the limits. @param {string} name @returns {Question[]} */
function nearQuestions(name) {
  const { joints } = readArm(name);
  const random = createRandom(7);
  const postures = reachablePostures(name);
  return reachablePoses(name).map((goal, k) => ({
    goal,
    seed: postures[k].map((value, i) =>
      Math.min(joints[i].upper, Math.max(joints[i].lower, value + NEAR * (2 * random() - 1))),
    ),
  }));
}

/**
 * How many questions were answered rightly.
 * @param {Arm} arm
 * @param {readonly Question[]} questions
 * @param {(question: Question) => ArrayLike<number> | null} solve
 */
const countSolved = (arm, questions, solve) =>
  questions.filter((question) => {
    const q = solve(question);
    return q !== null && isSolved(arm, q, question.goal);
  }).length;

/** @param {string} name @param {readonly Question[]} questions */
function contest(name, questions) {
  const arm = readArm(name);
  const chain = createChain(arm);
  const clamped = createClosedChain(arm, BEST_CLAMPS);
  const unclamped = createClosedChain(arm, NO_CLAMPS);
  /** @type {Record<string, (question: Question) => ArrayLike<number> | null>} */
  const solvers = {
    search: ({ goal, seed }) => inverseKinematics(chain, goal, { seed, descentsOnly: true, ...TOLERANCES }).q,
    whole: ({ goal, seed }) => inverseKinematics(chain, goal, { seed, ...TOLERANCES }).q,
    clamped: ({ goal, seed }) => clamped(goal, seed),
    unclamped: ({ goal, seed }) => unclamped(goal, seed),
  };
  const rounds = { search: 4, whole: 2, clamped: 1, unclamped: 1 };
  const contestants = Object.entries(rounds).map(([solver, count]) => [
    solver,
    { call: (/** @type {Question} */ question) => void solvers[solver](question), rounds: count },
  ]);
  const times = timeEach(questions, Object.fromEntries(contestants), { turns: 4 });
  const solved = (/** @type {string} */ solver) => countSolved(arm, questions, solvers[solver]);
  const iterations = questions.map(
    ({ goal, seed }) => inverseKinematics(chain, goal, { seed, descentsOnly: true, ...TOLERANCES }).iterations,
  );
  return { times, solved, iterations: median(iterations) };
}

/**
 * @param {string} title
 * @param {(name: string) => Question[]} questionsOf
 * @param {number} atLeast  times the peer's speed
 * @returns {BenchRow[]}
 */
function compare(title, questionsOf, atLeast) {
  /** @type {Record<string, number[]>} */
  const medians = { search: [], whole: [], clamped: [], unclamped: [] };
  const rows = FIVE_ARMS.map((name) => {
    const questions = questionsOf(name);
    const { times, solved, iterations } = contest(name, questions);
    for (const solver of Object.keys(medians)) medians[solver].push(median(times[solver]));
    const [ours, theirs] = [median(times.search), median(times.clamped)];
    return {
      name: `${title}: ${name}`,
      unit: 'µs',
      median: ours,
      peer: { name: PEER, median: theirs },
      ratio: theirs / ours,
      note:
        `solved ${solved('search')} of ${questions.length}, whole call ${solved('whole')}, peer ${solved('clamped')}; ` +
        `${iterations} iterations; p99 ${quantile(times.search, 0.99).toFixed(0)} µs, peer's ${quantile(times.clamped, 0.99).toFixed(0)} µs`,
    };
  });
  const mean = Object.fromEntries(Object.entries(medians).map(([solver, values]) => [solver, geometricMean(values)]));
  /** @param {string} words @param {string} ours @param {string} theirs @param {BenchRow['target']} [target] @returns {BenchRow} */
  const meanRow = (words, ours, theirs, target) => ({
    name: `${title}: geometric mean${words}`,
    unit: 'µs',
    median: mean[ours],
    peer: { name: PEER, median: mean[theirs] },
    ratio: mean[theirs] / mean[ours],
    ...(target && { target }),
  });
  return [
    ...rows,
    meanRow('', 'search', 'clamped', { of: 'ratio', atLeast }),
    meanRow(', peer without clamps', 'search', 'unclamped', { of: 'ratio', atLeast }),
    meanRow(', whole call: the solution nearest to the seed', 'whole', 'clamped'),
  ];
}

/** @returns {BenchRow[]} */
function unreachable() {
  /** @type {number[]} */
  const all = [];
  const rows = FIVE_ARMS.map((name) => {
    const chain = createChain(readArm(name));
    const goals = unreachablePoses(name);
    const { ours } = timeEach(
      goals,
      { ours: { call: (goal) => void inverseKinematics(chain, goal, TOLERANCES) } },
      { turns: 3, warmUp: 1 },
    );
    all.push(...ours);
    const converged = goals.filter((goal) => inverseKinematics(chain, goal, TOLERANCES).status === 'converged').length;
    const note = `${converged} of ${goals.length} called converged, at most ${Math.max(...ours).toFixed(0)} µs`;
    return { name: `a pose out of question: ${name}`, unit: 'µs', median: median(ours), note };
  });
  return [
    ...rows,
    {
      name: 'a pose out of question: all arms',
      unit: 'µs',
      median: median(all),
      target: { of: 'median', atMost: 500 },
    },
  ];
}

/** @returns {BenchRow[]} */
export const bench = () => [
  ...compare('inverse kinematics from mid-range', farQuestions, 60),
  ...compare('tracking', nearQuestions, 20),
  ...unreachable(),
];
