/**
 * All solutions of a pose: what the arm's solver takes, and the whole call, which polishes, proves, names and sorts them. What
 * a solver proposes is judged like everything else; the posture that a pose was made of must be among it.
 *
 * @import { BenchRow } from './run.mjs'
 * @import { Arm } from './arms.mjs'
 */
import { allInverseKinematics } from '../src/kinematics/allInverse.js';
import { createChain } from '../src/kinematics/chain.js';
import { recogniseOrthoParallel, writeOrthoParallelPostures } from '../src/kinematics/solvers/orthoParallel.js';
import { goalFromStart, screwsOf } from '../src/kinematics/screws.js';
import { recognise } from '../src/kinematics/solvers/solvers.js';
import { isThere, judgePose, reachablePoses, reachablePostures, readArm } from './arms.mjs';
import { median, quantile, timeCalls, timeEach } from './measure.mjs';

const FULL_TURN = 2 * Math.PI;

/** @param {ArrayLike<number>} a @param {ArrayLike<number>} b */
const isSame = (a, b) =>
  Array.from(a).every((value, i) => Math.abs(value - b[i] - FULL_TURN * Math.round((value - b[i]) / FULL_TURN)) < 1e-4);

/**
 * @param {string} name
 * @param {readonly Float64Array[]} goals
 * @param {(goal: Float64Array) => readonly ArrayLike<number>[]} solve
 */
function judge(name, goals, solve) {
  const arm = readArm(name);
  const made = reachablePostures(name);
  let [count, right, complete] = [0, 0, 0];
  goals.forEach((goal, k) => {
    const postures = solve(goal);
    count += postures.length;
    right += postures.filter((q) => isThere(judgePose(arm, q), goal)).length;
    if (postures.some((q) => isSame(q, made[k]))) complete++;
  });
  const mean = (count / goals.length).toFixed(2);
  return `${mean} in the mean, ${right} of ${count} right, the one it was made of among them ${complete} of ${goals.length} times`;
}

/** @returns {BenchRow[]} */
function orthoParallel() {
  const name = 'kuka_kr6_r900';
  const chain = createChain(readArm(name));
  const arm = recogniseOrthoParallel(screwsOf(chain));
  if (!arm) throw new Error(`${name} is not recognised.`);
  const goals = reachablePoses(name);
  const out = new Float64Array(48);
  const { postures } = timeCalls(goals, { postures: (goal) => void writeOrthoParallelPostures(arm, goal, out) });
  const solve = (/** @type {Float64Array} */ goal) => {
    const bits = writeOrthoParallelPostures(arm, goalFromStart(chain, goal), out);
    return [0, 1, 2, 3, 4, 5, 6, 7].filter((k) => bits & (1 << k)).map((k) => out.slice(6 * k, 6 * k + 6));
  };
  const note = judge(name, goals, solve);
  return [
    {
      name: `all solutions, ortho-parallel arm: ${name}`,
      unit: 'µs',
      median: postures / 1e3,
      target: { of: 'median', atMost: 1 },
      note,
    },
  ];
}

/**
 * @param {string} kind
 * @param {string} name
 * @param {number} count of goals
 * @param {number} atMost  µs
 * @returns {BenchRow[]}
 */
function bySolver(kind, name, count, atMost) {
  const chain = createChain(readArm(name));
  const { solver } = recognise(chain);
  if (!solver) throw new Error(`No solver knows ${name}.`);
  const goals = reachablePoses(name).slice(0, count);
  const seen = goals.map((goal) => goalFromStart(chain, goal));
  const rounds = atMost < 100 ? 20 : 1;
  const { postures } = timeEach(seen, { postures: { call: (goal) => void solver.solve(goal), rounds } }, { turns: 5 });
  return [
    {
      name: `all solutions, ${kind}: ${name}`,
      unit: 'µs',
      median: median(postures),
      target: { of: 'median', atMost },
      note: `${judge(name, goals, (goal) => solver.solve(goalFromStart(chain, goal)).postures)}; p99 ${quantile(postures, 0.99).toFixed(0)} µs`,
    },
  ];
}

/** @param {string} name @param {number} count @returns {BenchRow} */
function wholeCall(name, count) {
  const chain = createChain(readArm(name));
  const goals = reachablePoses(name).slice(0, count);
  const { whole } = timeEach(
    goals,
    { whole: { call: (goal) => void allInverseKinematics(chain, goal) } },
    { turns: 3 },
  );
  const solve = (/** @type {Float64Array} */ goal) => allInverseKinematics(chain, goal).solutions.map(({ q }) => q);
  const note = `${allInverseKinematics(chain, goals[0]).method}; ${judge(name, goals, solve)}`;
  return { name: `all solutions, the whole call: ${name}`, unit: 'µs', median: median(whole), note };
}

/** @returns {BenchRow[]} */
export const bench = () => [
  ...orthoParallel(),
  ...bySolver('three parallel axes', 'ur5', 200, 5),
  ...bySolver('general arm', 'kinova_mico', 60, 2000),
  wholeCall('kuka_kr6_r900', 200),
  wholeCall('ur5', 200),
  wholeCall('stanford', 200),
  wholeCall('kinova_mico', 40),
];
