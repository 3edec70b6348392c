/**
 * The weight of the built page: what the first load fetches may be at most 250 kB and everything together 800 kB, as
 * brotli at its best quality. Source maps are not counted, since a browser fetches them only for a developer.
 */
import { existsSync, readFileSync, readdirSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { brotliCompressSync, constants, gzipSync } from 'node:zlib';
import { firstLoad } from './firstLoad.mjs';
import { isMain } from './isMain.mjs';
import { formatTable } from './table.mjs';

export const FIRST_LOAD_LIMIT = 250_000;
export const TOTAL_LIMIT = 800_000;

/** @typedef {{ path: string, raw: number, gzip: number, brotli: number, first: boolean }} FileSize */

/**
 * @param {string} dist the built folder
 * @returns {{ sizes: FileSize[], faults: string[] }}
 */
export function measure(dist) {
  if (!existsSync(join(dist, 'index.html')))
    throw new Error('There is no built page in dist; run "npm run build" first.');
  const { files, faults } = firstLoad(dist);
  const sizes = readdirSync(dist, { recursive: true, withFileTypes: true })
    .filter((entry) => entry.isFile() && !entry.name.endsWith('.map'))
    .map((entry) => join(entry.parentPath, entry.name).slice(join(dist, '/').length).replaceAll('\\', '/'))
    .map((path) => ({ path, ...weigh(readFileSync(join(dist, path))), first: files.includes(path) }))
    .sort((x, y) => Number(y.first) - Number(x.first) || y.brotli - x.brotli);

  const first = total(sizes.filter((size) => size.first)).brotli;
  const all = total(sizes).brotli;
  if (first > FIRST_LOAD_LIMIT)
    faults.push(`The first load is ${first} bytes brotli; at most ${FIRST_LOAD_LIMIT} are allowed.`);
  if (all > TOTAL_LIMIT) faults.push(`The built folder is ${all} bytes brotli; at most ${TOTAL_LIMIT} are allowed.`);
  return { sizes, faults };
}

/** @param {Buffer} content */
function weigh(content) {
  const params = {
    [constants.BROTLI_PARAM_QUALITY]: constants.BROTLI_MAX_QUALITY,
    [constants.BROTLI_PARAM_SIZE_HINT]: content.length,
  };
  const brotli = brotliCompressSync(content, { params }).length;
  return { raw: content.length, gzip: gzipSync(content, { level: 9 }).length, brotli };
}

/** @param {FileSize[]} sizes */
function total(sizes) {
  const sum = (/** @type {'raw' | 'gzip' | 'brotli'} */ key) => sizes.reduce((bytes, size) => bytes + size[key], 0);
  return { raw: sum('raw'), gzip: sum('gzip'), brotli: sum('brotli') };
}

/** @param {number} bytes */
const kilobytes = (bytes) => (bytes / 1000).toFixed(1);

function main() {
  const { sizes, faults } = measure(join(dirname(dirname(fileURLToPath(import.meta.url))), 'dist'));
  /** @param {string} name @param {{ raw: number, gzip: number, brotli: number }} size @param {string} note */
  const row = (name, { raw, gzip, brotli }, note) => [name, kilobytes(raw), kilobytes(gzip), kilobytes(brotli), note];
  const first = total(sizes.filter((size) => size.first));
  const all = total(sizes);
  const table = [
    ['file', 'kB', 'gzip', 'brotli', 'fetched'],
    ...sizes.map((size) => row(size.path, size, size.first ? 'first' : 'when needed')),
    row('first load', first, ''),
    row('everything', all, ''),
  ];
  console.log(formatTable(table, [1, 2, 3]));
  const [firstOf, allOf] = [FIRST_LOAD_LIMIT, TOTAL_LIMIT].map(kilobytes);
  console.log(
    `\nFirst load ${kilobytes(first.brotli)} of ${firstOf} kB brotli, everything ${kilobytes(all.brotli)} of ${allOf}.`,
  );
  for (const fault of faults) console.error(fault);
  process.exitCode = faults.length > 0 ? 1 : 0;
}

if (isMain(import.meta.url)) {
  try {
    main();
  } catch (error) {
    console.error(/** @type {Error} */ (error).message);
    process.exitCode = 1;
  }
}
