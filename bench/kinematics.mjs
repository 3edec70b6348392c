/**
 * How fast the kernel is: medians of repeated blocks on the fixture postures and poses. The cold figures come from fresh
 * threads, whose code has never run: a page lives there for its first hundred solves.
 *
 * @typedef {import('./run.mjs').BenchRow} BenchRow
 * @typedef {import('../src/kinematics/chain.js').Chain} Chain
 */
import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { Worker, isMainThread, parentPort, workerData } from 'node:worker_threads';
import { createChain } from '../src/kinematics/chain.js';
import { linkFrames, tcpPose } from '../src/kinematics/forward.js';
import { inverseKinematics } from '../src/kinematics/inverse.js';
import { finiteDifferenceJacobian, geometricJacobian } from '../src/kinematics/jacobian.js';

const BLOCKS = 15;
const COLD_THREADS = 5;
const COLD_SOLVES = 100;
const COLD = 'cold solves';
const ARMS = /** @type {const} */ (['puma560', 'ur5']);

/** @param {string} name */
const readFixture = (name) =>
  JSON.parse(readFileSync(new URL(`../tests/fixtures/kinematics/${name}`, import.meta.url), 'utf8')).arms;

/** @typedef {['revolute' | 'prismatic', number, number, number, number, number, number]} JointLine */

/** @param {string} name */
function createArm(name) {
  /** @type {JointLine[]} */
  const lines = readFixture('arms.json')[name].joints;
  const joints = lines.map(([type, a, alpha, d, theta, lower, upper]) => ({ type, a, alpha, d, theta, lower, upper }));
  return createChain({ convention: 'standard', joints });
}

/** The three upper rows of a pose in a line → column-major. @param {number[]} line */
const poseOf = (line) =>
  Float64Array.from({ length: 16 }, (_, i) => (i % 4 === 3 ? Number(i === 15) : line[4 * (i % 4) + Math.floor(i / 4)]));

/** @param {number[]} values */
const median = (values) => [...values].sort((x, y) => x - y)[Math.floor(values.length / 2)];

/**
 * Nanoseconds for each call, the median of the blocks after the first few, which warm up.
 * @template T
 * @param {readonly T[]} inputs
 * @param {number} rounds  of all inputs in one block
 * @param {(input: T) => void} call
 */
function time(inputs, rounds, call) {
  const blocks = Array.from({ length: BLOCKS + 3 }, () => {
    const start = process.hrtime.bigint();
    for (let round = 0; round < rounds; round++) for (const input of inputs) call(input);
    return Number(process.hrtime.bigint() - start) / (rounds * inputs.length);
  });
  return median(blocks.slice(3));
}

/** Microseconds of every single call, in order. @template T @param {readonly T[]} inputs @param {(input: T) => void} call */
const timeEach = (inputs, call) =>
  inputs.map((input) => {
    const start = process.hrtime.bigint();
    call(input);
    return Number(process.hrtime.bigint() - start) / 1e3;
  });

/** @param {string} arm @returns {BenchRow[]} */
function benchForward(arm) {
  const chain = createArm(arm);
  /** @type {Float64Array[]} */
  const postures = readFixture('forward.json')[arm].q.map((/** @type {number[]} */ q) => Float64Array.from(q));
  const T = new Float64Array(16);
  const frames = new Float64Array(16 * (chain.dof + 1));
  const J = new Float64Array(6 * chain.dof);
  const options = { out: J };
  const geometric = time(postures, 400, (q) => void geometricJacobian(chain, q, J));
  const difference = time(postures, 400, (q) => void finiteDifferenceJacobian(chain, q, options));
  return [
    { name: `${arm}: tool pose`, unit: 'ns', median: time(postures, 400, (q) => void tcpPose(chain, q, T)) },
    {
      name: `${arm}: all link frames`,
      unit: 'ns',
      median: time(postures, 400, (q) => void linkFrames(chain, q, frames)),
    },
    { name: `${arm}: frames and geometric Jacobian`, unit: 'ns', median: geometric },
    {
      name: `${arm}: frames and forward-difference Jacobian`,
      unit: 'ns',
      median: difference,
      note: `${(difference / geometric).toFixed(2)} times the geometric one`,
    },
  ];
}

/** @param {string} arm @returns {BenchRow[]} */
function benchInverse(arm) {
  const chain = createArm(arm);
  const { reachable, unreachable } = readFixture('inverse.json')[arm];
  /** @type {Float64Array[]} */
  const goals = reachable.map(poseOf);
  const results = goals.map((goal) => inverseKinematics(chain, goal));
  const converged = results.filter(({ status }) => status === 'converged').length;
  const iterations = results.reduce((sum, result) => sum + result.iterations, 0) / results.length;
  const solves = Array.from({ length: BLOCKS }, () => timeEach(goals, (goal) => void inverseKinematics(chain, goal)));
  const each = goals.map((_, i) => median(solves.map((block) => block[i])));
  const sorted = [...each].sort((x, y) => x - y);
  const rows = [
    {
      name: `${arm}: inverse kinematics from mid-range, to 1e-9`,
      unit: 'µs',
      median: median(each),
      note: `${converged} of ${goals.length} converged, ${iterations.toFixed(1)} iterations in the mean, p99 ${sorted[Math.floor(sorted.length * 0.99)].toFixed(0)} µs`,
    },
  ];
  for (const reason of ['distance', 'geometry', 'limits']) {
    /** @type {Float64Array[]} */
    const hopeless = unreachable
      .filter((/** @type {[string, ...number[]]} */ [why]) => why === reason)
      .map((/** @type {[string, ...number[]]} */ [, ...line]) => poseOf(line));
    if (hopeless.length === 0) continue;
    const blocks = Array.from({ length: 3 }, () => timeEach(hopeless, (goal) => void inverseKinematics(chain, goal)));
    const all = blocks.flat();
    rows.push({
      name: `${arm}: a pose out of question (${reason})`,
      unit: 'µs',
      median: median(all),
      note: `at most ${Math.max(...all).toFixed(0)} µs`,
    });
  }
  return rows;
}

/** The first solves of a thread, in µs. @returns {Promise<number[]>} */
const coldSolves = () =>
  new Promise((resolve, reject) => {
    const worker = new Worker(fileURLToPath(import.meta.url), { workerData: COLD });
    worker.once('message', resolve);
    worker.once('error', reject);
  });

/** @returns {Promise<BenchRow[]>} */
async function benchCold() {
  /** @type {number[][]} */
  const threads = [];
  for (let i = 0; i < COLD_THREADS; i++) threads.push(await coldSolves());
  /** @param {number} from @param {number} to */
  const mean = (from, to) =>
    median(threads.map((times) => times.slice(from, to).reduce((sum, value) => sum + value, 0) / (to - from)));
  const note = `median of ${COLD_THREADS} fresh threads`;
  return [
    { name: 'puma560: the very first solve', unit: 'µs', median: mean(0, 1), note },
    { name: `puma560: solves 1 to ${COLD_SOLVES}, each`, unit: 'µs', median: mean(0, COLD_SOLVES), note },
  ];
}

/** @returns {Promise<BenchRow[]>} */
export async function bench() {
  return [...(await benchCold()), ...ARMS.flatMap(benchForward), ...ARMS.flatMap(benchInverse)];
}

if (!isMainThread && workerData === COLD) {
  const chain = createArm('puma560');
  /** @type {Float64Array[]} */
  const goals = readFixture('inverse.json').puma560.reachable.slice(0, COLD_SOLVES).map(poseOf);
  parentPort?.postMessage(timeEach(goals, (goal) => void inverseKinematics(chain, goal)));
}
