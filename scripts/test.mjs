/**
 * npm test: everything that must hold. What the browser shows, which waits more than it computes, runs beside all else. `--deep` runs the full counts on a fresh seed; DENAVIT_SEED repeats one.
 *
 * @import { Step } from './steps.mjs'
 */
import { randomInt } from 'node:crypto';
import { dirname } from 'node:path';
import { performance } from 'node:perf_hooks';
import { fileURLToPath } from 'node:url';
import { ensureDependencies } from './ensureDependencies.mjs';
import { runSteps } from './steps.mjs';
import { formatTable } from './table.mjs';

const ROOT = dirname(dirname(fileURLToPath(import.meta.url)));
const INTENDED_MINUTES = 8;
/** These make much that is soon thrown away: a larger nursery spares the collector a tenth of their time. */
const NURSERY = '--max-semi-space-size=64';
/** TypeScript 7, which takes a quarter of the time of 5; that stays for the lint and import rules, which ask it for trees. */
const TYPES = 'node_modules/typescript-native/bin/tsc';

/**
 * @param {string | undefined} noBrowser why the browser tests cannot run
 * @returns {Step[]}
 */
const steps = (noBrowser) => [
  { name: 'build', command: ['node_modules/vite/bin/vite.js', 'build', '--logLevel', 'warn'] },
  { name: 'size', command: ['scripts/size.mjs'], needs: 'build', summary: /^First load .*$/m },
  { name: 'types', lane: 'code', command: [TYPES, '-p', '.', '--singleThreaded'] },
  { name: 'lint', lane: 'code', command: [NURSERY, 'node_modules/eslint/bin/eslint.js', '.', '--max-warnings', '0'] },
  { name: 'format', lane: 'code', command: [NURSERY, 'node_modules/prettier/bin/prettier.cjs', '--check', '.'] },
  {
    name: 'imports',
    lane: 'code',
    command: [
      NURSERY,
      'node_modules/dependency-cruiser/bin/dependency-cruise.mjs',
      'src',
      '--config',
      '.dependency-cruiser.cjs',
    ],
    summary: /no dependency violations found \((.*)\)|\d+ dependency violations/,
  },
  {
    name: 'unit',
    lane: 'code',
    command: ['node_modules/vitest/vitest.mjs', 'run', '--allowOnly=false'],
    summary: /^\s*(Test Files.*\n\s*Tests.*)$/m,
  },
  {
    name: 'browser',
    lane: 'browser',
    command: ['node_modules/@playwright/test/cli.js', 'test', '--forbid-only'],
    needs: 'build',
    problem: noBrowser,
    summary: /(?:^\s+\d+ (?:failed|flaky|skipped|did not run|passed)\b.*\s*)+$/m,
  },
];

/** Looks for a browser before the steps, so that a download is seen while it runs. */
async function browserProblem() {
  try {
    const { ensureBrowser } = await import('./ensureBrowser.mjs');
    const { executablePath, version } = await ensureBrowser();
    console.log(`Browser: ${executablePath} (${version})`);
    return undefined;
  } catch (error) {
    return /** @type {Error} */ (error).message;
  }
}

async function main() {
  const deep = process.argv.includes('--deep');
  if (deep) {
    process.env.DENAVIT_DEEP = '1';
    process.env.DENAVIT_SEED ??= String(randomInt(1, 2 ** 31));
    console.log(`Full counts with DENAVIT_SEED=${process.env.DENAVIT_SEED}.`);
  }
  ensureDependencies();
  const problem = await browserProblem();
  const start = performance.now();
  const results = await runSteps(steps(problem), ROOT, (text) => process.stdout.write(text));

  const minutes = (performance.now() - start) / 60_000;
  const rows = results.map(({ name, outcome, seconds, note }) => [name, outcome, seconds.toFixed(1), note]);
  console.log(`\n${formatTable([['step', 'outcome', 'seconds', ''], ...rows], [2])}\n`);
  if (!deep && minutes > INTENDED_MINUTES) console.log(`That took longer than the ${INTENDED_MINUTES} minutes it may.`);

  const faulty = results.filter(({ outcome }) => outcome !== 'ok').map(({ name }) => name);
  console.log(
    `${faulty.length === 0 ? 'Everything holds' : `Not in order: ${faulty.join(', ')}`} (${minutes.toFixed(1)} minutes).`,
  );
  if (faulty.length > 0 && deep) console.log(`To repeat: DENAVIT_SEED=${process.env.DENAVIT_SEED} npm run test:deep`);
  process.exitCode = faulty.length === 0 ? 0 : 1;
}

try {
  await main();
} catch (error) {
  console.error(/** @type {Error} */ (error).message);
  process.exitCode = 1;
}
