/**
 * Ways around obstacles: the planar problems whose truth is known, and a Puma 560 among ten obstacles. Times are of whole
 * searches; a search that finds nothing spends all its iterations.
 *
 * @import { BenchRow } from './run.mjs'
 * @import { Obstacle } from '../src/motion/clearance/obstacles.js'
 */
import { readFileSync } from 'node:fs';
import { performance } from 'node:perf_hooks';
import { createChain } from '../src/kinematics/chain.js';
import { createRandom } from '../src/kinematics/random.js';
import { armBodies } from '../src/motion/clearance/armBodies.js';
import { touchOnWay } from '../src/motion/clearance/clearWay.js';
import { createWorkcell } from '../src/motion/clearance/workcell.js';
import { planAtOnce } from '../src/motion/planner/planAround.js';
import { readArm } from './arms.mjs';
import { median } from './measure.mjs';

const DEGREE = Math.PI / 180;
const PLANAR = JSON.parse(readFileSync(new URL('../tests/fixtures/motion/planar.json', import.meta.url), 'utf8'));

/** Obstacles, and problems that the straight way does not solve. */
const OBSTACLES = 10;
const PROBLEMS = 20;

/** Iterations of a search. */
const MOST = 10_000;

/** @param {() => unknown} run */
function timed(run) {
  const start = performance.now();
  const answer = run();
  return { answer, ms: performance.now() - start };
}

/** @returns {BenchRow[]} */
function planar() {
  /** @type {Record<string, number[]>} */
  const times = { found: [], 'not-found': [] };
  /** @type {Record<string, number>} */
  const iterations = { found: 0, 'not-found': 0 };
  for (const { links, capsule_radius: r, limits_deg, obstacles_xyr, start_deg, goal_deg } of PLANAR) {
    const [lower, upper] = limits_deg.map((/** @type {number} */ limit) => limit * DEGREE);
    const joints = links.map((/** @type {number} */ a) => ({
      type: /** @type {const} */ ('revolute'),
      a,
      alpha: 0,
      d: 0,
      theta: 0,
      lower,
      upper,
    }));
    /** @type {Obstacle[]} */
    const obstacles = obstacles_xyr.map((/** @type {number[]} */ [x, y, radius]) => ({
      kind: 'sphere',
      centre: [x, y, 0],
      radius,
    }));
    const cell = createWorkcell(armBodies(createChain({ convention: 'standard', joints }), [r, r]), obstacles);
    const radians = (/** @type {number[]} */ values) => values.map((value) => value * DEGREE);
    const { answer, ms } = timed(() => planAtOnce(cell, radians(start_deg), radians(goal_deg), { iterations: MOST }));
    const { status, iterations: spent } = /** @type {{ status: string, iterations: number }} */ (answer);
    times[status].push(ms);
    iterations[status] = Math.max(iterations[status], spent);
  }
  return Object.entries(times).map(([status, ms]) => ({
    name: `a way around circles, two joints: ${status}`,
    unit: 'ms',
    median: median(ms),
    target: { of: /** @type {const} */ ('median'), atMost: 1000 },
    note: `${ms.length} of ${PLANAR.length} problems, at most ${Math.max(...ms).toFixed(0)} ms and ${iterations[status]} of ${MOST} iterations`,
  }));
}

/** @returns {BenchRow[]} */
function sixJoints() {
  const random = createRandom(560);
  const description = readArm('puma560');
  const chain = createChain(description);
  const bodies = armBodies(chain, [0.08, 0.07, 0.06, 0.05, 0.04, 0.04]);
  const within = (/** @type {number} */ low, /** @type {number} */ high) => low + random() * (high - low);
  /** @type {{ found: number, tried: number, ms: number[], looks: number[] }} */
  const outcome = { found: 0, tried: 0, ms: [], looks: [] };
  while (outcome.tried < PROBLEMS) {
    /** @type {Obstacle[]} */
    const obstacles = Array.from({ length: OBSTACLES }, () => ({
      kind: 'sphere',
      centre: [within(-0.9, 0.9), within(-0.9, 0.9), within(-0.5, 0.9)],
      radius: within(0.06, 0.15),
    }));
    const cell = createWorkcell(bodies, obstacles);
    const [from, to] = [0, 1].map(() => chain.joints.map(({ lower, upper }) => within(lower, upper)));
    if (touchOnWay(cell, from, from) || touchOnWay(cell, to, to) || !touchOnWay(cell, from, to)) continue;
    outcome.tried++;
    const { answer, ms } = timed(() => planAtOnce(cell, from, to));
    outcome.ms.push(ms);
    if (/** @type {{ status: string }} */ (answer).status === 'found') outcome.found++;
  }
  return [
    {
      name: `a way around ${OBSTACLES} spheres: puma560`,
      unit: 'ms',
      median: median(outcome.ms),
      note: `${outcome.found} of ${PROBLEMS} found, at most ${Math.max(...outcome.ms).toFixed(0)} ms`,
    },
  ];
}

export const bench = () => [...planar(), ...sixJoints()];
