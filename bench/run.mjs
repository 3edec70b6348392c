/**
 * npm run bench: the benchmarks of this folder, one after another. Each file exports `bench()`, which answers with rows
 * of medians; all of them become one table and .cache/bench.json. Names on the command line pick files:
 * `npm run bench -- inverse`. A target that is missed is said to be, and fails nothing: a shared machine is too uneven.
 *
 * @typedef {object} Target
 * @property {'median' | 'ratio'} of
 * @property {number} [atLeast]
 * @property {number} [atMost]
 *
 * @typedef {object} BenchRow
 * @property {string} name
 * @property {string} unit
 * @property {number} median
 * @property {{ name: string, median: number }} [peer]  who did the same in the same run
 * @property {number} [ratio]   of the peer's median to ours, or as the note says
 * @property {Target} [target]
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

/** @param {BenchRow} row */
function isMet({ target, ...row }) {
  if (!target) return null;
  const value = row[target.of] ?? NaN;
  return value >= (target.atLeast ?? -Infinity) && value <= (target.atMost ?? Infinity);
}

/** Three digits, and no exponent. @param {number} value */
const short = (value) => (value >= 100 ? value.toFixed(0) : value.toPrecision(3));

/** @param {BenchRow} row */
function targetText({ target, unit }) {
  if (!target) return '';
  const { of, atLeast, atMost } = target;
  const bound = atLeast === undefined ? `≤ ${atMost}` : `≥ ${atLeast}`;
  return of === 'ratio' ? `${bound} ×` : `${bound} ${unit}`;
}

/** @param {BenchRow} row */
const cells = (row) => [
  row.name,
  `${short(row.median)} ${row.unit}`,
  row.peer ? `${short(row.peer.median)} ${row.unit}` : '',
  row.peer?.name ?? '',
  row.ratio === undefined ? '' : `${short(row.ratio)} ×`,
  targetText(row),
  isMet(row) === null ? '' : isMet(row) ? 'met' : 'missed',
  row.note ?? '',
];

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
  const heading = ['benchmark', 'median', 'peer', '', 'ratio', 'target', '', ''];
  console.log(formatTable([heading, ...rows.map(cells)], [1, 2, 4, 5]));
  const machine = { node: process.version, platform: process.platform, processor: cpus()[0]?.model ?? 'unknown' };
  const recorded = rows.map((row) => ({ ...row, isMet: isMet(row) }));
  mkdirSync(dirname(RECORD), { recursive: true });
  writeFileSync(RECORD, `${JSON.stringify({ date: new Date().toISOString(), machine, rows: recorded }, null, 2)}\n`);
}
