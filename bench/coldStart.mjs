/**
 * The first solves of a fresh process, whose code has never run: pages live there.
 * @import { BenchRow } from './run.mjs'
 */
import { execFileSync } from 'node:child_process';
import { fileURLToPath } from 'node:url';
import { createChain } from '../src/kinematics/chain.js';
import { inverseKinematics } from '../src/kinematics/inverse.js';
import { isMain } from '../scripts/isMain.mjs';
import { TOLERANCE, middleOf, reachablePoses, readArm } from './arms.mjs';
import { BEST_CLAMPS, createClosedChain } from './closedChain.mjs';
import { median } from './measure.mjs';

const ARM = 'puma560';
const PROCESSES = 5;
const SOLVES = 100;

/** Microseconds of each of the first solves. @param {string} who @returns {number[]} */
function solveCold(who) {
  const arm = readArm(ARM);
  const goals = reachablePoses(ARM).slice(0, SOLVES);
  const seed = middleOf(arm);
  const options = { seed, positionTolerance: TOLERANCE, orientationTolerance: TOLERANCE };
  const peer = createClosedChain(arm, BEST_CLAMPS);
  const start = performance.now();
  const chain = createChain(arm);
  const created = performance.now() - start;
  const times = goals.map((goal) => {
    const begin = performance.now();
    if (who === 'peer') peer(goal, seed);
    else inverseKinematics(chain, goal, { ...options, descentsOnly: who === 'search' });
    return (performance.now() - begin) * 1e3;
  });
  return [created * 1e3, ...times];
}

/** @param {readonly number[]} values */
const mean = (values) => values.reduce((sum, value) => sum + value, 0) / values.length;

/** @returns {BenchRow[]} */
export function bench() {
  const file = fileURLToPath(import.meta.url);
  /** @type {Record<string, number[][]>} */
  const runs = { search: [], whole: [], peer: [] };
  for (let k = 0; k < PROCESSES; k++) {
    for (const who of Object.keys(runs)) {
      runs[who].push(JSON.parse(execFileSync(process.execPath, [file, who], { encoding: 'utf8' })));
    }
  }
  /** @param {string} name @param {string} ours @param {number} from @param {number} to @returns {BenchRow} */
  const row = (name, ours, from, to) => {
    const of = (/** @type {string} */ who) => median(runs[who].map((times) => mean(times.slice(from, to))));
    const note = `median of ${PROCESSES} fresh processes`;
    const peer = { name: 'closed-chain-ik', median: of('peer') };
    return {
      name: `cold start, ${ARM}: ${name}`,
      unit: 'µs',
      median: of(ours),
      peer,
      ratio: of('peer') / of(ours),
      note,
    };
  };
  return [
    row('the first solve', 'search', 1, 2),
    row('solves 2 to 10, each', 'search', 2, 11),
    row(`solves 11 to ${SOLVES}, each`, 'search', 11, SOLVES + 1),
    row(`solves 1 to ${SOLVES}, each`, 'search', 1, SOLVES + 1),
    row(`solves 1 to ${SOLVES}, each, whole call`, 'whole', 1, SOLVES + 1),
  ];
}

if (isMain(import.meta.url)) console.log(JSON.stringify(solveCold(process.argv[2])));
