/** Long texts are read, checked and made ready in pieces, so that the page can go on between them. */
import { expect, test } from 'vitest';
import { checkKarel } from '../../../src/karel/checker.js';
import { parseInSlices, parseKarel } from '../../../src/karel/parser.js';
import { linkInSlices } from '../../../src/karel/run/link.js';
import { PIECE } from '../../../src/karel/slices.js';
import { parseTp, parseTpInSlices } from '../../../src/karel/tp/parser.js';
import { writeKarelMove, writeKarelMoveInSlices } from '../../../src/karel/write/karelMove.js';
import { writeKrl, writeKrlInSlices } from '../../../src/karel/write/krl.js';
import { writePair, writePairInSlices } from '../../../src/karel/write/pair.js';
import { writeTp, writeTpInSlices } from '../../../src/karel/write/tp.js';
import { listing } from './tpListing.js';

/** @import { NeutralProgram } from '../../../src/karel/write/neutral.js' */

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

test('a long program is written in as many turns, in every language, and comes out the same', () => {
  const six = [1, 2, 3, 4, 5, 6];
  /** @type {NeutralProgram} */
  const program = {
    ...{ name: 'long', robotName: 'Arm', version: '0.1.0', generatedAt: '2026-07-01T12:00:00Z', convention: [] },
    ...{ slides: six.map(() => false), frames: [] },
    steps: Array.from({ length: 3 * PIECE }, (_, step) => ({
      ...{
        kind: 'move',
        motion: 'joint',
        speed: { value: 20, unit: '%' },
        acceleration: 100,
        ending: { kind: 'fine' },
      },
      ...{ target: { joints: six, position: six, fanuc: null, kuka: null, isJoint: true } },
      ...{ userFrame: 0, tool: 0, step },
    })),
  };
  for (const [inSlices, atOnce] of /** @type {const} */ ([
    [writePairInSlices, writePair],
    [writeTpInSlices, writeTp],
    [writeKarelMoveInSlices, writeKarelMove],
    [writeKrlInSlices, writeKrl],
  ])) {
    const { pieces, result } = counted(inSlices(program));
    expect(result).toEqual(atOnce(program));
    expect(pieces).toBeGreaterThan(3);
  }
});
