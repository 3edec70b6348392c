/**
 * Planning and sampling of motion: 1,000 linear moves of 300 mm by a Puma 560, each alone, with the proof that the tool keeps to
 * the line within 0.01 mm and 0.01°; and a minute of a program at 250 Hz.
 * @import { BenchRow } from './run.mjs'
 * @import { Move } from '../src/motion/moves.js'
 */
import { performance } from 'node:perf_hooks';
import { createChain } from '../src/kinematics/chain.js';
import { tcpPose } from '../src/kinematics/forward.js';
import { createRandom } from '../src/kinematics/random.js';
import { planMotion } from '../src/motion/plan.js';
import { planMoment, planMomentAt } from '../src/motion/planMoment.js';
import { readArm } from './arms.mjs';
import { median } from './measure.mjs';

const MOVES = 1000;
const LENGTH = 0.3; // m
const ROUNDS = 5;
const SECONDS = 60;
const RATE = 250; // Hz

const chain = createChain(readArm('puma560'));
const limits = { rates: new Float64Array(6).fill(4), accelerations: new Float64Array(6).fill(20) };

/** @param {Float64Array} T_base_tcp @returns {Move} */
const line = (T_base_tcp) => ({
  kind: 'linear',
  T_base_tcp,
  speed: 0.25,
  turnSpeed: 1.5,
  acceleration: 1,
  ending: { kind: 'fine' },
});

/** Postures within the limits and lines from there that can be gone along. */
function tasks() {
  const random = createRandom(560);
  /** @type {{ start: Float64Array, moves: Move[] }[]} */
  const found = [];
  while (found.length < MOVES) {
    const start = Float64Array.from(chain.joints, ({ lower, upper }) => lower + (upper - lower) * random());
    const T = tcpPose(chain, start);
    const [z, angle] = [2 * random() - 1, 2 * Math.PI * random()];
    const across = Math.sqrt(1 - z * z);
    [across * Math.cos(angle), across * Math.sin(angle), z].forEach((x, k) => (T[12 + k] += LENGTH * x));
    const moves = [line(T)];
    if (planMotion(chain, start, moves, limits).refused === null) found.push({ start, moves });
  }
  return found;
}

/** @param {() => void} run  milliseconds, the median of some rounds after one to warm up */
function milliseconds(run) {
  run();
  return median(
    Array.from({ length: ROUNDS }, () => {
      const begin = performance.now();
      run();
      return performance.now() - begin;
    }),
  );
}

/** @returns {BenchRow[]} */
export function bench() {
  const asked = tasks();
  let slices = [0];
  const planning = milliseconds(() => {
    slices = asked.map(({ start, moves }) => {
      const begin = performance.now();
      planMotion(chain, start, moves, limits);
      return performance.now() - begin;
    });
  });
  const [{ start, moves }] = asked;
  const back = line(tcpPose(chain, start));
  const program = Array.from({ length: 200 }, (_, k) => (k % 2 === 0 ? moves[0] : back));
  const plan = planMotion(chain, start, program, limits);
  const out = planMoment(chain.dof);
  const sampling = milliseconds(() => {
    for (let k = 0; k < SECONDS * RATE; k++) planMomentAt(plan, k / RATE, out);
  });
  return [
    {
      name: `motion: planning ${MOVES} lines of ${1000 * LENGTH} mm, Puma 560`,
      unit: 'ms',
      median: planning,
      target: { of: 'median', atMost: 3000 },
      note: `the longest ${Math.max(...slices).toFixed(1)} ms`,
    },
    {
      name: `motion: sampling ${SECONDS} s of a program at ${RATE} Hz`,
      unit: 'ms',
      median: sampling,
      note: `${plan.parts.length} moves, ${plan.duration.toFixed(0)} s`,
    },
  ];
}
