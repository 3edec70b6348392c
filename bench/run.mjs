/**
 * npm run bench: the benchmarks of this folder, one after another. Each file exports `bench()`, which answers with rows
 * of medians; all of them become one table and .cache/bench.json. Names on the command line pick files:
 * `npm run bench -- inverse`. Nothing is compared with a limit: a shared machine is too uneven for that.
 *
 * @typedef {object} BenchRow
 * @property {string} name
 * @property {string} unit
 * @property {number} median
 * @property {string} [note]
 */
import { mkdirSync, readdirSync, writeFileSync } from 'node:fs';
import { cpus } from 'node:os';
import { dirname, join } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { ensureDependencies } from '../scripts/ensureDependencies.mjs';
import { formatTable } from '../scripts/table.mjs';

const HERE = dirname(fileURLToPath(import.meta.url));
const RECORD = join(HERE, '..', '.cache', 'bench.json');

/**
 * @param {string[]} wanted parts of file names; none means all
 * @returns {string[]}
 */
function benchFiles(wanted) {
  return readdirSync(HERE)
    .filter((name) => name.endsWith('.mjs') && name !== 'run.mjs')
    .filter((name) => wanted.length === 0 || wanted.some((part) => name.includes(part)))
    .sort();
}

/**
 * @param {string} file
 * @returns {Promise<BenchRow[]>} none when the file is only a helper
 */
async function runFile(file) {
  const module = await import(pathToFileURL(join(HERE, file)).href);
  if (module.bench === undefined) return [];
  console.error(`${file} …`);
  return await module.bench();
}

ensureDependencies();
const wanted = process.argv.slice(2);
const files = benchFiles(wanted);
/** @type {(BenchRow & { file: string })[]} */
const rows = [];
for (const file of files) rows.push(...(await runFile(file)).map((row) => ({ file, ...row })));

if (rows.length === 0) {
  console.error(`No benchmark ${wanted.length > 0 ? `matches ${wanted.join(', ')}` : 'is in bench/'}.`);
  process.exitCode = 1;
} else {
  const body = rows.map(({ name, median, unit, note }) => [name, median.toPrecision(4), unit, note ?? '']);
  console.log(formatTable([['benchmark', 'median', 'unit', ''], ...body], [1]));
  const machine = { node: process.version, platform: process.platform, processor: cpus()[0]?.model ?? 'unknown' };
  mkdirSync(dirname(RECORD), { recursive: true });
  writeFileSync(RECORD, `${JSON.stringify({ date: new Date().toISOString(), machine, rows }, null, 2)}\n`);
}
