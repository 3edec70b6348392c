/**
 * Robot files: text to document, everything included (XML, schema rules, the table of a URDF, the comparison at 100 postures), and
 * what a refusal costs.
 *
 * @import { BenchRow } from './run.mjs'
 */
import { readFileSync, readdirSync } from 'node:fs';
import { readRobotFile } from '../src/io/robotFile.js';
import { median, quantile, timeEach } from './measure.mjs';

const TURNS = 15;

/** @param {string} folder @param {string} ending @returns {string[]} */
function textsIn(folder, ending) {
  const where = new URL(`../tests/fixtures/${folder}/`, import.meta.url);
  const names = readdirSync(where).filter((name) => name.endsWith(ending));
  return names.map((name) => readFileSync(new URL(name, where), 'utf8'));
}

/** @type {readonly { name: string, texts: readonly string[] }[]} */
const KINDS = [
  { name: 'robot file of ours', texts: textsIn('xml/samples', '.xml') },
  { name: 'URDF', texts: textsIn('urdf', '.urdf') },
  { name: 'rlkin', texts: textsIn('rlkin', '.xml') },
  {
    name: 'bad file, refused or opened',
    texts: ['xml/bad', 'urdf/bad', 'rlkin/bad'].flatMap((folder) => [
      ...textsIn(folder, '.xml'),
      ...textsIn(folder, '.urdf'),
    ]),
  },
];

/** @returns {BenchRow[]} */
export const bench = () =>
  KINDS.map(({ name, texts }) => {
    const times = timeEach(texts, { ours: { call: (text) => void readRobotFile(text) } }, { turns: TURNS }).ours;
    const slowest = Math.max(...times) / 1e3;
    return {
      name: `read: ${name}`,
      unit: 'ms',
      median: median(times) / 1e3,
      target: { of: 'median', atMost: 50 },
      note: `${texts.length} files; p99 ${(quantile(times, 0.99) / 1e3).toFixed(1)} ms, slowest ${slowest.toFixed(1)} ms`,
    };
  });
