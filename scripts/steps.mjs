/**
 * Runs commands one after another, or some of them side by side, each with its time. One that fails shows all it said; the
 * others still run, so that one look finds every fault.
 *
 * @typedef {object} Step
 * @property {string} name
 * @property {string[]} command     arguments of node
 * @property {boolean} [isBeside]   it runs at the same time as its neighbours that say so too
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
  for (const group of groups(steps)) {
    const isAlone = group.length === 1;
    if (isAlone) write(`${group[0].name} … `);
    const run = group.map(async (step) => {
      const { output, ...result } = await runStep(step, results, cwd);
      write(`${output}${isAlone ? '' : `${step.name} … `}${result.outcome}, ${result.seconds.toFixed(1)} s\n`);
      return result;
    });
    results.push(...(await Promise.all(run)));
  }
  return results;
}

/** Neighbours that run side by side, together; the others each alone. @param {Step[]} steps */
function groups(steps) {
  /** @type {Step[][]} */
  const found = [];
  for (const step of steps) {
    const last = found.at(-1);
    if (step.isBeside && last?.[0].isBeside) last.push(step);
    else found.push([step]);
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
