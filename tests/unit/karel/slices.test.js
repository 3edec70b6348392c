/** Long texts are read, checked and made ready in pieces, so that the page can go on between them. */
import { expect, test } from 'vitest';
import { checkKarel } from '../../../src/karel/checker.js';
import { parseInSlices, parseKarel } from '../../../src/karel/parser.js';
import { linkInSlices } from '../../../src/karel/run/link.js';
import { PIECE } from '../../../src/karel/slices.js';
import { parseTp, parseTpInSlices } from '../../../src/karel/tp/parser.js';
import { listing } from './tpListing.js';

/** @template T @param {Generator<null, T>} job */
function counted(job) {
  for (let pieces = 1; ; pieces++) {
    const turn = job.next();
    if (turn.done) return { pieces, result: turn.value };
  }
}

test('a long program takes as many turns as it has pieces, and comes out the same', () => {
  const statements = 12 * PIECE;
  const lines = Array.from({ length: statements }, (_, i) => `x = x + ${i}`);
  const text = `PROGRAM long\nVAR x, never : INTEGER\nBEGIN\nx = 0\n${lines.join('\n')}\nEND long\n`;
  const read = counted(parseInSlices(text));
  expect(read.result).toEqual(parseKarel(text));
  expect(read.pieces).toBeGreaterThanOrEqual(12);
  const { tree } = read.result;
  if (tree.kind !== 'program') throw new Error('This is a program.');
  const linked = counted(linkInSlices(tree, {}));
  expect(linked.pieces).toBeGreaterThanOrEqual(2 * 12);
  expect(linked.result.analyses[0].diagnostics).toMatchObject([{ code: 'unused' }]);
  expect(linked.result.analyses[0].diagnostics).toEqual(checkKarel(tree));

  const tp = listing(lines.map((_, i) => `  R[1]=${i}`));
  const listed = counted(parseTpInSlices(tp));
  expect(listed.result).toEqual(parseTp(tp));
  expect(listed.pieces).toBeGreaterThanOrEqual(12);
});
