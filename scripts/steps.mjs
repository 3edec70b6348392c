/**
 * Runs commands one after another, or in lanes side by side, each with its time. One that fails shows all it said; the
 * others still run, so that one look finds every fault.
 *
 * @typedef {object} Step
 * @property {string} name
 * @property {string[]} command     arguments of node
 * @property {string} [lane]        it runs beside its neighbours in other lanes, and behind those in its own
 * @property {string} [needs]       a step without which this one says nothing
 * @property {string} [problem]     why it fails before it starts
 * @property {RegExp} [summary]     the line of its output worth repeating, or its first group
 *
 * @typedef {object} Result
 * @property {string} name
 * @property {'ok' | 'failed' | 'not run'} outcome  anything but ok is a fault
 * @property {number} seconds
 * @property {string} note
 */
import { spawn } from 'node:child_process';
import { performance } from 'node:perf_hooks';

/**
 * @param {Step[]} steps
 * @param {string} cwd
 * @param {(text: string) => void} write  text as it comes, without line ends added
 * @returns {Promise<Result[]>}
 */
export async function runSteps(steps, cwd, write) {
  /** @type {Result[]} */
  const results = [];
  for (const lanes of groups(steps)) {
    const isAlone = lanes.length === 1;
    const before = [...results];
    const run = lanes.map(async (lane) => {
      /** @type {Result[]} */
      const found = [];
      for (const step of lane) {
        if (isAlone) write(`${step.name} … `);
        const { output, ...result } = await runStep(step, [...before, ...found], cwd);
        write(`${output}${isAlone ? '' : `${step.name} … `}${result.outcome}, ${result.seconds.toFixed(1)} s\n`);
        found.push(result);
      }
      return found;
    });
    results.push(...(await Promise.all(run)).flat());
  }
  return results;
}

/** Neighbours that have lanes, by lane; the others each alone. @param {Step[]} steps */
function groups(steps) {
  /** @type {Step[][][]} */
  const found = [];
  /** @type {Map<string, Step[]> | null} */
  let open = null;
  for (const step of steps) {
    if (step.lane === undefined) {
      open = null;
      found.push([[step]]);
      continue;
    }
    if (!open) found.push([]);
    open ??= new Map();
    const lane = open.get(step.lane) ?? [];
    if (lane.length === 0) found[found.length - 1].push(lane);
    lane.push(step);
    open.set(step.lane, lane);
  }
  return found;
}

/**
 * @param {Step} step
 * @param {Result[]} before
 * @param {string} cwd
 * @returns {Promise<Result & { output: string }>}  with what is to be shown
 */
async function runStep({ name, command, needs, problem, summary }, before, cwd) {
  if (needs && before.find((result) => result.name === needs)?.outcome !== 'ok') {
    return { name, outcome: 'not run', seconds: 0, note: `needs ${needs}`, output: '' };
  }
  if (problem) return { name, outcome: 'failed', seconds: 0, note: problem, output: '' };

  const start = performance.now();
  const { succeeded, output } = await run(command, cwd);
  const seconds = (performance.now() - start) / 1000;
  const found = summary && stripColours(output).match(summary);
  const note = found ? (found[1] ?? found[0]).replace(/\s+/g, ' ').trim() : '';
  return {
    name,
    outcome: succeeded ? 'ok' : 'failed',
    seconds,
    note,
    output: succeeded ? '' : `\n${output.trimEnd()}\n`,
  };
}

/**
 * @param {string[]} command
 * @param {string} cwd
 * @returns {Promise<{ succeeded: boolean, output: string }>}
 */
function run(command, cwd) {
  return new Promise((resolve) => {
    const child = spawn(process.execPath, command, { cwd, stdio: ['ignore', 'pipe', 'pipe'] });
    /** @type {Buffer[]} */
    const output = [];
    child.stdout.on('data', (chunk) => output.push(chunk));
    child.stderr.on('data', (chunk) => output.push(chunk));
    child.on('error', ({ message }) => resolve({ succeeded: false, output: message }));
    child.on('close', (status) => resolve({ succeeded: status === 0, output: Buffer.concat(output).toString() }));
  });
}

/** @param {string} text */
// eslint-disable-next-line no-control-regex
const stripColours = (text) => text.replace(/\u001b\[[0-9;]*m/g, '');
