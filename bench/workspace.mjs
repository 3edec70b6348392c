/**
 * The workspace: places a second in one thread, sections at 0.5 mm with their boundary, the time to the first picture, and
 * the memory of the answer.
 *
 * @import { BenchRow } from './run.mjs'
 * @import { Arm } from './arms.mjs'
 */
import { performance } from 'node:perf_hooks';
import { createChain } from '../src/kinematics/chain.js';
import { transferable, workspaceJob } from '../src/workspace/jobs.js';
import { createSampler } from '../src/workspace/sampler.js';
import { FIVE_ARMS, readArm } from './arms.mjs';
import { median } from './measure.mjs';

/** A tool beside all axes, so that every joint moves the TCP. */
const TOOL = Float64Array.of(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0.05, 0.03, 0.1, 1);

/** So few at a time that most slices are not interrupted. */
const SLICE = 8192;
const SLICES = 400;
const RUNS = 3;

/** @returns {BenchRow[]} */
function sampling() {
  const places = new Float32Array(3 * SLICE);
  return FIVE_ARMS.map((name) => {
    const sampler = createSampler(createChain({ ...readArm(name), tool: TOOL }));
    for (let slice = 0; slice < SLICES / 2; slice++) sampler.fill(slice * SLICE, places); // to be compiled
    const times = Array.from({ length: SLICES }, (_, slice) => {
      const start = performance.now();
      sampler.fill(slice * SLICE, places);
      return performance.now() - start;
    });
    return {
      name: `places sampled, six joints that move the TCP: ${name}`,
      unit: 'M/s',
      median: SLICE / median(times) / 1e3,
      target: { of: /** @type {const} */ ('median'), atLeast: 12 },
    };
  });
}

/**
 * @param {string} name
 * @param {Arm} arm
 * @param {object} options
 * @returns {BenchRow[]}
 */
function section(name, arm, options) {
  /** @type {number[]} */
  const firsts = [];
  /** @type {number[]} */
  const wholes = [];
  let note = '';
  for (let run = 0; run < RUNS; run++) {
    const start = performance.now();
    const work = workspaceJob(arm, { kind: 'section', options });
    let step = work.next();
    firsts.push(performance.now() - start);
    while (!step.done) step = work.next();
    wholes.push(performance.now() - start);
    const bytes = [...transferable(step.value)].reduce((sum, { byteLength }) => sum + byteLength, 0);
    const found = step.value.kind === 'section' ? step.value.section : null;
    if (found) {
      note = `${found.sides}, ${found.cells.columns} × ${found.cells.rows} cells, ${found.area.toFixed(6)} m² ± ${found.areaError.toExponential(0)}, ${(bytes / 1e6).toFixed(0)} MB`;
    }
  }
  return [
    {
      name: `section at 0.5 mm: ${name}`,
      unit: 'ms',
      median: median(wholes),
      note,
    },
    {
      name: `first picture: ${name}`,
      unit: 'ms',
      median: median(firsts),
      target: { of: /** @type {const} */ ('median'), atMost: 200 },
    },
  ];
}

/**
 * The volume as the page asks for it first.
 * @param {string} name
 * @param {Arm} arm
 * @param {number} cell  m
 * @returns {BenchRow[]}
 */
function volume(name, arm, cell) {
  /** @type {number[]} */
  const firsts = [];
  /** @type {number[]} */
  const wholes = [];
  let note = '';
  for (let run = 0; run < RUNS; run++) {
    const before = process.memoryUsage().arrayBuffers;
    let most = before;
    const start = performance.now();
    const work = workspaceJob(arm, { kind: 'volume', options: { cell } });
    let step = work.next();
    firsts.push(performance.now() - start);
    while (!step.done) {
      step = work.next();
      most = Math.max(most, process.memoryUsage().arrayBuffers);
    }
    wholes.push(performance.now() - start);
    const bytes = [...transferable(step.value)].reduce((sum, { byteLength }) => sum + byteLength, 0);
    if (step.value.kind !== 'volume') continue;
    const { voxels, summary } = step.value;
    note = `${summary?.count} cubes, ${voxels.volume.toFixed(2)} m³ ± ${voxels.volumeError.toFixed(2)}; ${megabytes(most - before)} while at work, ${megabytes(bytes)} found`;
  }
  return [
    { name: `volume in cubes of ${1000 * cell} mm: ${name}`, unit: 'ms', median: median(wholes), note },
    {
      name: `first picture of the volume: ${name}`,
      unit: 'ms',
      median: median(firsts),
      target: { of: /** @type {const} */ ('median'), atMost: 200 },
    },
  ];
}

/** @param {number} bytes */
const megabytes = (bytes) => `${(bytes / 1e6).toFixed(1)} MB`;

/** @returns {BenchRow[]} */
export const bench = () => [
  ...sampling(),
  ...section('puma560', readArm('puma560'), {}),
  ...section('planar 2R', readArm('planar2r'), {}),
  ...section('ur5', readArm('ur5'), {}),
  ...volume('puma560', readArm('puma560'), 0.05),
  ...volume('ur5', readArm('ur5'), 0.05),
];
