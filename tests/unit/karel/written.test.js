/** Code that is written holds no line that its language does not know, whatever things are called; and the numbers are the ones given. */
import fc from 'fast-check';
import { expect, test } from 'vitest';
import { fanucNameFault, fanucNames } from '../../../src/karel/fanucNames.js';
import { writeKarelMove } from '../../../src/karel/write/karelMove.js';
import { krlName, krlNameFault, writeKrl } from '../../../src/karel/write/krl.js';
import { writePair } from '../../../src/karel/write/pair.js';
import { writeTp } from '../../../src/karel/write/tp.js';
import { runs, SEED } from '../../helpers/property.js';
import { readWritten } from './writtenReader.js';

/** @import { NeutralMove, NeutralProgram, NeutralStep, NeutralTarget } from '../../../src/karel/write/neutral.js' */

const WRITERS = [writePair, writeTp, writeKarelMove, writeKrl];

/** Values that are hard to write: tiny, at a rounding edge, large, minus zero. */
const anyValue = fc.oneof(
  fc.double({ min: -99999.999, max: 99999.999, noNaN: true }),
  fc.double({ min: -400, max: 400, noNaN: true }),
  fc.integer({ min: -99999000, max: 99999000 }).map((half) => half / 1000 + 0.0005),
  fc.constantFrom(0, -0, -0.0001, 1e-7, -1e-300, 0.0005, -0.0005, 99999.999, -99999.999),
);
const anyText = fc.oneof(
  fc.string({ unit: 'binary', maxLength: 60 }),
  fc.constantFrom(
    ...[
      'x\nABORT',
      "'); ABORT",
      'x\r\n  9:J PR[1] 100% FINE ;',
      'a; b',
      '"; PROTECT = READ;',
      'a &',
      '--',
      '\u2028END',
    ],
    ...["it's", ';\n/END', '﹔', '\u037e', 'x\nPTP XP1', 'FOLD', 'ENDFOLD', ''],
  ),
);
const six = (/** @type {fc.Arbitrary<number>} */ value) => fc.array(value, { minLength: 6, maxLength: 6 });
/** @type {fc.Arbitrary<NeutralTarget>} */
const anyTarget = fc.record({
  joints: six(anyValue),
  position: six(anyValue),
  fanuc: fc.constantFrom('N U T, 0, 0, 0', 'F D B, -1, 0, 1', null),
  kuka: fc.constantFrom({ status: 6, turn: 27 }, { status: 0, turn: 63 }, null),
  isJoint: fc.boolean(),
});
/** @type {fc.Arbitrary<NeutralStep>} */
const anyStep = fc.oneof(
  { weight: 3, arbitrary: anyMove() },
  {
    weight: 1,
    arbitrary: fc.record({ kind: fc.constant('wait'), seconds: fc.double({ min: 0.01, max: 30, noNaN: true }) }),
  },
  {
    weight: 1,
    arbitrary: fc.record({
      kind: fc.constantFrom('output', 'input'),
      port: fc.integer({ min: 1, max: 999 }),
      value: fc.boolean(),
    }),
  },
  { weight: 1, arbitrary: fc.record({ kind: fc.constant('comment'), text: anyText }) },
);
/** @returns {fc.Arbitrary<NeutralMove>} */
function anyMove() {
  return fc
    .record({
      motion: fc.constantFrom('joint', 'linear', 'circular'),
      target: anyTarget,
      via: anyTarget,
      share: fc.integer({ min: 1, max: 100 }),
      ending: fc.oneof(
        fc.constant({ kind: 'fine' }),
        fc.record({ kind: fc.constantFrom('percent', 'distance'), value: fc.integer({ min: 1, max: 100 }) }),
      ),
      userFrame: fc.nat(3),
      tool: fc.nat(3),
      comment: anyText,
    })
    .map(
      ({ motion, via, share, ...rest }) =>
        /** @type {NeutralMove} */ ({
          ...{ kind: 'move', motion, acceleration: share, step: 0, ...rest },
          ...(motion === 'circular' && { via }),
          speed:
            motion === 'joint'
              ? { value: share, unit: '%' }
              : { value: 10 * share, unit: share % 2 ? 'mm/s' : 'deg/s' },
        }),
    );
}
/** @type {fc.Arbitrary<NeutralProgram>} */
const anyProgram = fc.record({
  name: anyText,
  robotName: anyText,
  version: anyText,
  generatedAt: fc.constantFrom('2026-07-01T12:00:00Z', '2031-12-31T23:59:59Z'),
  convention: fc.array(anyText, { maxLength: 3 }),
  slides: fc.constant(Array(6).fill(false)),
  frames: fc.constant([
    { kind: /** @type {const} */ ('user'), number: 1, name: 'x\nABORT', position: [1, 2, 3, 4, 5, 6] },
  ]),
  steps: fc.array(anyStep, { minLength: 1, maxLength: 6 }),
  notes: fc.array(
    fc.record({ severity: fc.constant(/** @type {const} */ ('note')), code: fc.constant('x'), message: anyText }),
    { maxLength: 1 },
  ),
});

test('whatever it is asked to write, every line is one that the languages know, and joint values are the ones given', () => {
  fc.assert(
    fc.property(anyProgram, anyText, (program, programName) => {
      const moves = program.steps.flatMap((step) => (step.kind === 'move' ? [step] : []));
      for (const write of WRITERS) {
        const lines = write(program, { programName }).files.flatMap(readWritten);
        if (write !== writeTp && write !== writePair) continue;
        const written = lines.filter((line) => /^[JLC] /.test(line)).map((line) => line[0]);
        expect(written).toEqual(moves.map(({ motion }) => ({ joint: 'J', linear: 'L', circular: 'C' })[motion]));
      }
      const filled = writePair(program, { programName }).files.flatMap(readWritten);
      const values = filled.flatMap((line) => / joints\[\d\] = (.*)$/.exec(line)?.slice(1) ?? []).map(Number);
      const wanted = moves
        .flatMap(({ via, target }) => (via ? [via, target] : [target]))
        .flatMap(({ isJoint, fanuc, joints }) => (isJoint || fanuc === null ? joints : []));
      expect(values).toHaveLength(wanted.length);
      // Half a thousandth, and what a double costs beside 100 000.
      for (const [i, value] of values.entries())
        expect(Math.abs(value - wanted[i])).toBeLessThanOrEqual(0.0005 + 1e-11);
    }),
    { seed: SEED, numRuns: runs(100) },
  );
});

test.for([
  ['pick', null],
  ['Pick_2', null],
  ['a', null],
  ['pick_part', 'at most 8 letters'],
  ['2fast', 'at most 8 letters'],
  ['a b', 'at most 8 letters'],
  ['', 'at most 8 letters'],
  ['begin', 'is a word of KAREL'],
  ['status', 'something of its own'],
])('as the name of a FANUC program, %j is taken as it is or refused', ([name, reason]) => {
  const fault = fanucNameFault(/** @type {string} */ (name), ['status']);
  if (reason === null) {
    expect(fault).toBeNull();
    expect(fanucNames(/** @type {string} */ (name)).karel).toBe(name?.toLowerCase());
  } else expect(fault).toContain(reason);
});

test.for([
  ['Pick_part', null],
  ['_x', null],
  ['a'.repeat(24), null],
  ['a'.repeat(25), 'at most 24 letters'],
  ['1st', 'no digit first'],
  ['Größe', 'at most 24 letters'],
  ['loop', 'is a word of KRL'],
])('as the name of a KRL program, %j is taken as it is or refused', ([name, reason]) => {
  const fault = krlNameFault(/** @type {string} */ (name));
  if (reason === null) expect([fault, krlName(/** @type {string} */ (name))]).toEqual([null, name]);
  else expect(fault).toContain(reason);
});

test('a wait that a language has no decimals for is told, and what it becomes', () => {
  const program = (/** @type {number} */ seconds) => ({
    ...{ name: 'p', robotName: 'r', version: '1', generatedAt: '2026-07-01T12:00:00Z', convention: [], slides: [] },
    ...{ frames: [], steps: [{ kind: /** @type {const} */ ('wait'), seconds }] },
  });
  const told = (/** @type {typeof writeTp} */ write, /** @type {number} */ seconds) =>
    write(program(seconds)).notes.find(({ code }) => code === 'wait')?.message;
  for (const write of [writeTp, writePair])
    expect(told(write, 0.125)).toBe('Waits have 2 decimals of a second: 0.125 s becomes 0.13 s.');
  expect(told(writeKarelMove, 0.125)).toBeUndefined();
  expect(told(writeKarelMove, 0.0004)).toContain('0.0004 s becomes 0 s');
  for (const write of WRITERS) expect(told(write, 0.25)).toBeUndefined();
});
